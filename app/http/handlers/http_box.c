/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The simulated box over HTTP: a page stands for the person at it. It needs a session, and no
 * authority, which no user of a real one needs.
 */
#include "interface/app/handlers.h"

#include "bsp_bench.h"
#include "http/call/box_order.h"
#include "http/call/http_act.h"
#include "http/call/http_login_gate.h"
#include "http/call/http_reply.h"
#include "interface/app/messages.h"

#include <stdio.h>

#define UM_PER_MM 1000.0
#define MDEG_PER_DEG 1000.0
#define ORDER_SIZE (BOX_ORDER_SIZE + 16U) /* With the number of a page. */

/* NULL: there is none that takes orders. */
static const char *box_of(const http_server_t *server)
{
    return bsp_bench_is_offered() ? server->identity.box : NULL;
}

static const char *axis_in(const robot_t *robot, uint32_t slot)
{
    const char *name = NULL;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        name = (robot->axes[i].slot == slot) ? robot->axes[i].name : name;
    }
    return name;
}

static cJSON *new_slots(const robot_t *robot, const bsp_bench_t *seen)
{
    cJSON *slots = cJSON_CreateArray();
    for (uint32_t i = 0U; i < CARD_SLOT_COUNT; i++) {
        const bsp_bench_slot_t *slot = &seen->slots[i];
        const json_box_slot_t also = {
            .slot = i,
            .axis = (slot->has_axis != 0U) ? axis_in(robot, i) : NULL,
            .card_type = box_order_word("plug", slot->card_type),
            .card_fault = box_order_word("card_fault", slot->card_fault),
            .encoder_fault = box_order_word("encoder_fault", slot->encoder_fault),
            .motor_fault = box_order_word("motor_fault", slot->motor_fault),
            .switch_fault = box_order_word("switch_fault", slot->switch_fault)};
        (void)cJSON_AddItemToArray(slots, json_box_slot(&also));
    }
    return slots;
}

static cJSON *new_point(const bsp_bench_point_t *point)
{
    const json_box_point_t also = {.x_mm = point->x_um / UM_PER_MM,
                                   .y_mm = point->y_um / UM_PER_MM,
                                   .depth_mm = point->depth_um / UM_PER_MM};
    return json_box_point(&also);
}

static cJSON *new_image(const bsp_bench_needle_t *needle)
{
    const json_box_image_t also = {.number = needle->image,
                                   .age_ms = needle->image_age_ms,
                                   .place = new_point(&needle->image_place)};
    return json_box_image(&also);
}

/* NULL without tissue. */
static cJSON *new_needle(const bsp_bench_needle_t *needle)
{
    if (needle->is_seen == 0U) {
        return NULL;
    }
    cJSON *way = cJSON_CreateArray();
    for (uint32_t i = 0U; i < BSP_BENCH_WAY; i++) {
        (void)cJSON_AddItemToArray(way, new_point(&needle->way[i]));
    }
    const json_box_needle_t also = {
        .surface_mm = needle->surface_um / UM_PER_MM,
        .turn_deg = needle->turn_mdeg / MDEG_PER_DEG,
        .lag_deg = needle->lag_mdeg / MDEG_PER_DEG,
        .way = way,
        .target = (needle->has_target != 0U) ? new_point(&needle->target) : NULL,
        .image = (needle->image != 0U) ? new_image(needle) : NULL,
        .curvature = (uint32_t)needle->curvature_per_km,
        .torsion_deg = (uint32_t)needle->torsion_deg,
        .images_period_ms = needle->images_period_ms,
        .images_delay_ms = needle->images_delay_ms,
        .images_noise_um = (uint32_t)needle->images_noise_um};
    return json_box_needle(&also);
}

int http_box_show(http_server_t *server, const http_call_t *call)
{
    const char *box = box_of(server);
    bsp_bench_t seen;
    if (box == NULL) {
        return http_reply_refuse(call->connection, PROBLEM_NO_BOX);
    }
    if (!bsp_bench_look(box, &seen)) {
        return http_reply_refuse(call->connection, PROBLEM_BOX_SILENT);
    }
    const json_box_t also = {.name = box,
                             .is_pedal_pressed = seen.is_pedal_pressed,
                             .pedal_holder = seen.pedal_holder,
                             .is_button_pressed = seen.is_button_pressed,
                             .button_holder = seen.button_holder,
                             .is_hand_pressed = seen.is_hand_pressed,
                             .hand_holder = seen.hand_holder,
                             .grip_mn = seen.grip_mn,
                             .layers = seen.layers,
                             .force_hand = box_order_word("force_hand", seen.force_hand),
                             .force_needle = box_order_word("force_needle", seen.force_needle),
                             .is_estop_pulled = seen.is_estop_pulled,
                             .is_scanner_active = seen.is_scanner_active,
                             .is_lamp_alive = seen.is_lamp_alive,
                             .is_lamp_may_move = seen.is_lamp_may_move,
                             .is_lamp_moving = seen.is_lamp_moving,
                             .is_lamp_fault = seen.is_lamp_fault,
                             .gate = box_order_word("gate", seen.gate),
                             .probe = box_order_word("probe", seen.is_probe_free),
                             .needle = new_needle(&seen.needle),
                             .slots = new_slots(exchange_robot(server->exchange), &seen)};
    return http_reply_object(call->connection, 200, json_box(&also));
}

static bsp_bench_result_t give(const http_server_t *server, const http_call_t *call,
                               const box_order_t *order)
{
    char text[ORDER_SIZE];
    if (!order->is_of_page) {
        return bsp_bench_order(server->identity.box, order->words);
    }
    (void)snprintf(text, sizeof text, "%s %u", order->words, (unsigned)call->page);
    return bsp_bench_order(server->identity.box, text);
}

static void note(http_server_t *server, const http_call_t *call, const box_order_t *order)
{
    char text[ORDER_SIZE + 32U];
    session_t session;
    if (http_login_gate_find(server, call->connection, &session)) {
        (void)snprintf(text, sizeof text, "ordered of the simulated box: %s.", order->words);
        http_notes_write(&server->notes, NOTE_BOX, session.account.name, text);
    }
}

/* To hold what this page holds, or to drop what it does not, is nothing new. */
static bool is_news(const http_server_t *server, const http_call_t *call, const box_order_t *order)
{
    const request_box_order_t *body = &call->body.order_box;
    bsp_bench_t seen;
    if (!order->is_of_page || !bsp_bench_look(server->identity.box, &seen)) {
        return true;
    }
    const uint32_t holder = body->has_pedal    ? seen.pedal_holder
                            : body->has_button ? seen.button_holder
                                               : seen.hand_holder;
    return (holder == call->page) == order->is_safe;
}

/**
 * Gives an order, and answers what there is to see then. Returns the status sent.
 *
 * @satisfies SWR-HTTP-039
 * @satisfies SWR-HTTP-057
 */
int http_box_order(http_server_t *server, const http_call_t *call)
{
    const request_box_order_t *body = &call->body.order_box;
    box_order_t order;
    if (box_of(server) == NULL) {
        return http_reply_refuse(call->connection, PROBLEM_NO_BOX);
    }
    const box_order_verdict_t verdict = box_order_write(body, &order);
    if (verdict != BOX_ORDER_WRITTEN) {
        return http_act_refuse_choice(call, verdict == BOX_ORDER_EXCESS, order.place);
    }
    /* Orders faster than the log would push other notes out. */
    if (!order.is_safe && http_notes_are_behind(&server->notes)) {
        return http_reply_refuse(call->connection, PROBLEM_BUSY);
    }
    const bool is_new = is_news(server, call, &order);
    switch (give(server, call, &order)) {
    case BSP_BENCH_DONE:
        if (is_new) {
            note(server, call, &order);
        }
        return http_box_show(server, call);
    case BSP_BENCH_REFUSED:
        return http_reply_refuse(call->connection,
                                 order.is_of_page ? PROBLEM_BOX_HELD : PROBLEM_BOX_REFUSED);
    case BSP_BENCH_SILENT:
    default:
        return http_reply_refuse(call->connection, PROBLEM_BOX_SILENT);
    }
}

int http_box_keep(http_server_t *server, const http_call_t *call)
{
    static const box_order_t keep = {.words = "keep", .is_of_page = true};
    if (box_of(server) == NULL) {
        return http_reply_refuse(call->connection, PROBLEM_NO_BOX);
    }
    return (give(server, call, &keep) == BSP_BENCH_DONE)
               ? http_box_show(server, call)
               : http_reply_refuse(call->connection, PROBLEM_BOX_SILENT);
}

/* A page that does not hold it has nothing to drop, and nothing is logged. */
static bool drop(http_server_t *server, const http_call_t *call, uint32_t holder,
                 const box_order_t *order)
{
    if (holder != call->page) {
        return true;
    }
    note(server, call, order);
    return give(server, call, order) == BSP_BENCH_DONE;
}

int http_box_drop(http_server_t *server, const http_call_t *call)
{
    static const box_order_t pedal = {.words = "pedal drop", .is_of_page = true};
    static const box_order_t button = {.words = "button drop", .is_of_page = true};
    static const box_order_t hand = {.words = "hand drop", .is_of_page = true};
    const char *box = box_of(server);
    bsp_bench_t seen;
    if (box == NULL) {
        return http_reply_refuse(call->connection, PROBLEM_NO_BOX);
    }
    const bool is_done = bsp_bench_look(box, &seen) &&
                         drop(server, call, seen.pedal_holder, &pedal) &&
                         drop(server, call, seen.button_holder, &button) &&
                         drop(server, call, seen.hand_holder, &hand);
    return is_done ? http_box_show(server, call)
                   : http_reply_refuse(call->connection, PROBLEM_BOX_SILENT);
}

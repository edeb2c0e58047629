/* SPDX-License-Identifier: Apache-2.0 */
#include "supervisor/status_line.h"

#include "charts/card_link_chart.h"
#include "charts/estop_latch_chart.h"
#include "charts/pedal_gate_chart.h"
#include "exchange/exchange_peers.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"
#include "robot/robot_cards.h"
#include "safety/permit.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#define PEDAL_FAULT "FAULT"
#define NOT_READ "NOT READ"

/** @satisfies SWR-EVENT-032 */
static bool is_unread(const snapshot_t *snapshot, box_input_t input)
{
    return (snapshot->unread_inputs & permit_input(input)) != 0U;
}

static const char *pedal_word(const snapshot_t *snapshot)
{
    if (is_unread(snapshot, BOX_INPUT_PEDAL)) {
        return NOT_READ;
    }
    switch (snapshot->pedal) {
    case PEDAL_GATE_STATE_UNPROVEN:
        return "unproven";
    case PEDAL_GATE_STATE_RELEASED:
        return "released";
    case PEDAL_GATE_STATE_CLOSING:
        return "closing";
    case PEDAL_GATE_STATE_PRESSED:
        return "pressed";
    case PEDAL_GATE_STATE_OPENING:
        return "opening";
    default:
        return PEDAL_FAULT;
    }
}

static const char *estop_word(const snapshot_t *snapshot)
{
    if (is_unread(snapshot, BOX_INPUT_ESTOP)) {
        return NOT_READ;
    }
    switch (snapshot->estop) {
    case ESTOP_LATCH_STATE_CLEAR:
        return "clear";
    case ESTOP_LATCH_STATE_PULLED:
        return "PULLED";
    default:
        return "latched";
    }
}

/* The reason to be shown first, of all axes; PERMIT_REASON_COUNT when every axis may be driven. */
static uint32_t first_reason(const snapshot_t *snapshot)
{
    uint32_t reasons = 0U;
    uint32_t reason = 0U;

    for (uint32_t i = 0U; i < snapshot->axis_count; i++) {
        reasons |= snapshot->axes[i].permit_reasons;
    }
    while ((reason < PERMIT_REASON_COUNT) && ((reasons & (1U << reason)) == 0U)) {
        reason++;
    }
    return reason;
}

static void add_permit(status_parts_t *parts, const snapshot_t *snapshot)
{
    const uint32_t reason = first_reason(snapshot);
    char words[STATUS_PART_SIZE];

    if (reason == PERMIT_REASON_COUNT) {
        status_parts_add(parts, STATUS_GOOD, "motion permitted");
        return;
    }
    (void)snprintf(words, sizeof words, "%s", permit_reason_name((int32_t)reason));
    for (char *letter = words; *letter != '\0'; letter++) {
        *letter = (*letter == '_') ? ' ' : (char)tolower((unsigned char)*letter);
    }
    status_parts_add(parts, STATUS_PLAIN, "no motion: %s", words);
}

static void add_inputs(status_parts_t *parts, const snapshot_t *snapshot)
{
    const char *const pedal = pedal_word(snapshot);
    const bool is_pulled = snapshot->estop == (uint32_t)ESTOP_LATCH_STATE_PULLED;
    const bool is_clear = snapshot->estop == (uint32_t)ESTOP_LATCH_STATE_CLEAR;
    const status_tone_t latched = is_clear ? STATUS_PLAIN : STATUS_NOTE;

    const bool is_pedal_bad = (strcmp(pedal, PEDAL_FAULT) == 0) || (strcmp(pedal, NOT_READ) == 0);

    status_parts_add(parts, is_pedal_bad ? STATUS_BAD : STATUS_PLAIN, "pedal %s", pedal);
    status_parts_add(parts, is_pulled ? STATUS_BAD : latched, "e-stop %s", estop_word(snapshot));
}

/* Number of the cards of the robot that answer. */
static void add_links(status_parts_t *parts, const robot_t *robot, const snapshot_t *snapshot)
{
    uint32_t named = 0U;
    uint32_t live = 0U;

    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        const bool is_named = robot_cards_type(robot, slot) != (uint32_t)CARD_TYPE_NONE;
        const bool is_live = snapshot->cards[slot].link == (uint32_t)CARD_LINK_STATE_LIVE;
        named += is_named ? 1U : 0U;
        live += (is_named && is_live) ? 1U : 0U;
    }
    status_parts_add(parts, (live < named) ? STATUS_BAD : STATUS_PLAIN, "links %u/%u",
                     (unsigned)live, (unsigned)named);
}

/**
 * @satisfies SWR-SUP-005
 * @satisfies SWR-BOX-044
 */
static void add_time(status_parts_t *parts, const loop_figures_t *loop, bool is_silent)
{
    const unsigned percent = is_silent ? 0U : ((loop->speed_permille + 5U) / 10U);

    if (loop->speedup > 1U) {
        status_parts_add(parts, STATUS_PLAIN, "fast time %u %%", percent);
    } else if (loop->is_elastic != 0U) {
        status_parts_add(parts, STATUS_PLAIN, "elastic time %u %%", percent);
    } else {
        status_parts_add(parts, STATUS_PLAIN, "real time %u %%, loop p99 %u us, worst %u us",
                         percent, (unsigned)loop->wake_p99_us, (unsigned)loop->wake_worst_us);
    }
}

/* State of a program in words; "ok" when there is no trouble. */
static const char *program_word(process_group_t *group, const exchange_t *exchange, uint32_t member)
{
    const bool is_silent = process_group_is_silent(group, exchange, (member_t)member);

    if (group->runs_already[member]) {
        return "not ours";
    }
    if (group->members[member].pid == 0) {
        return "RESTARTING";
    }
    return is_silent ? "SILENT" : "ok";
}

/* Those that are well stand together, at the end; `well` gets their names. A recorder that runs
 * and cannot write is none of them: its part says that already.
 *
 * @satisfies SWR-SUP-300 */
static void add_programs(status_parts_t *parts, const exchange_t *exchange, process_group_t *group,
                         bool is_recorder_failing, char *well, size_t size)
{
    well[0] = '\0';
    for (uint32_t i = 0U; i < FAMILY_SIZE; i++) {
        const char *const name = group->members[i].name;
        const char *const word = (name != NULL) ? program_word(group, exchange, i) : "";
        const size_t used = strlen(well);

        const bool is_well = strcmp(word, "ok") == 0;

        if (is_well && is_recorder_failing && (i == (uint32_t)MEMBER_RECORDER)) {
            /* It is said beside the cycles that are not recorded. */
        } else if (is_well) {
            (void)snprintf(&well[used], size - used, "%s ", name);
        } else if (name != NULL) {
            status_parts_add(parts, group->runs_already[i] ? STATUS_PLAIN : STATUS_BAD, "%s %s",
                             name, word);
        } else {
            /* The board has no program here. */
        }
    }
}

/** @satisfies SWR-SUP-012 */
static void add_gap(status_parts_t *parts, const snapshot_t *snapshot)
{
    if (snapshot->unrecorded != 0U) {
        status_parts_add(parts, STATUS_BAD, "%u cycles NOT RECORDED%s",
                         (unsigned)snapshot->unrecorded,
                         (snapshot->is_recorder_failing != 0U) ? ", recorder CANNOT WRITE" : "");
    }
}

/** @satisfies SWR-AUTH-018 */
static void add_request(status_parts_t *parts, const exchange_t *exchange,
                        const snapshot_t *snapshot)
{
    char title[EXCHANGE_TITLE_SIZE];

    if (snapshot->request_left_us != 0U) {
        exchange_title(exchange, (command_source_t)snapshot->requester, snapshot->requester_peer,
                       title);
        status_parts_add(parts, STATUS_NOTE, "%s asks for the button, %u s left", title,
                         (unsigned)((snapshot->request_left_us + 999999U) / 1000000U));
    }
}

/** @satisfies SWR-AUTH-018 */
static void add_authority(status_parts_t *parts, const exchange_t *exchange,
                          const snapshot_t *snapshot)
{
    const uint32_t cycles = snapshot->cycle - snapshot->held_since_cycle;
    char title[EXCHANGE_TITLE_SIZE];

    if (snapshot->holder_peer == 0U) {
        status_parts_add(parts, STATUS_PLAIN, "nobody commands");
    } else {
        exchange_title(exchange, (command_source_t)snapshot->holder, snapshot->holder_peer, title);
        status_parts_add(parts, STATUS_PLAIN, "commanded by %s for %u s", title,
                         (unsigned)(cycles / (1000000U / LIMIT_CYCLE_US)));
    }
}

/* Ports of the file of ports that are not open or not answered.
 *
 * @satisfies SWR-SUP-010 */
static void add_unreached(status_parts_t *parts, const exchange_t *exchange)
{
    exchange_ports_t ports;

    if (!exchange_read_ports(exchange, &ports)) {
        return;
    }
    for (uint32_t i = 0U; i < ports.count; i++) {
        const exchange_port_t *port = &ports.ports[i];
        char place[IGTL_PLACE_SIZE];

        if ((port->state == (uint32_t)EXCHANGE_PORT_CALLING) ||
            (port->state == (uint32_t)EXCHANGE_PORT_WAITING)) {
            igtl_port_place(port->address, (uint16_t)port->number, place);
            status_parts_add(parts, STATUS_NOTE, "%s %s not connected", port->name, place);
        }
    }
}

void status_line_take(status_parts_t *parts, const exchange_t *exchange, process_group_t *group)
{
    char well[STATUS_PART_SIZE];
    snapshot_t snapshot;
    loop_figures_t loop;
    const bool is_running = exchange_read_snapshot(exchange, &snapshot);

    parts->count = 0U;
    if (is_running) {
        status_parts_add(parts, STATUS_PLAIN, "%s", workphase_name((int32_t)snapshot.workphase));
        add_permit(parts, &snapshot);
        add_inputs(parts, &snapshot);
        status_parts_add_lateness(parts, &snapshot);
        add_gap(parts, &snapshot);
        status_parts_add_room(parts, snapshot.recording_left_min);
        add_request(parts, exchange, &snapshot);
    } else {
        status_parts_add(parts, STATUS_PLAIN, "starting");
    }
    const bool is_recorder_failing =
        is_running && (snapshot.is_recorder_failing != 0U) && (snapshot.unrecorded != 0U);
    add_programs(parts, exchange, group, is_recorder_failing, well, sizeof well);
    if (is_running) {
        add_links(parts, exchange_robot(exchange), &snapshot);
        add_authority(parts, exchange, &snapshot);
    }
    add_unreached(parts, exchange);
    if (exchange_read_loop(exchange, &loop)) {
        add_time(parts, &loop, process_group_is_silent(group, exchange, MEMBER_CONTROL));
    }
    if (well[0] != '\0') {
        status_parts_add(parts, STATUS_PLAIN, "%sok", well);
    }
}

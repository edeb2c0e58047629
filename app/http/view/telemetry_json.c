/* SPDX-License-Identifier: Apache-2.0 */
#include "http/view/telemetry_json.h"

#include "common/card_protocol.h"
#include "common/clock.h"
#include "common/drive_terms.h"
#include "common/utc_text.h"
#include "http/view/alarm_json.h"
#include "http/view/telemetry_units.h"
#include "interface/app/messages.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"
#include "robot/robot_cards.h"
#include "robot/robot_damage.h"

#include <arpa/inet.h>
#include <stddef.h>
#include <stdio.h>

#define UM_PER_MM 1000.0
#define US_PER_S 1000000.0
#define CYCLES_PER_MS (1000U / LIMIT_CYCLE_US)

typedef struct {
    uint32_t bit;
    const char *name;
} flag_t;

static cJSON *new_counts(const stage_figures_t *stage)
{
    cJSON *counts = cJSON_CreateArray();
    for (uint32_t i = 0U; i < LIMIT_LOOP_BARS; i++) {
        (void)cJSON_AddItemToArray(counts, cJSON_CreateNumber((double)stage->counts[i]));
    }
    return counts;
}

static cJSON *new_stages(const loop_figures_t *loop)
{
    cJSON *stages = cJSON_CreateArray();
    for (uint32_t i = 0U; i < LOOP_STAGE_COUNT; i++) {
        const stage_figures_t *stage = &loop->stages[i];
        const json_stage_t also = {.name = loop_stage_name((int32_t)i),
                                   .says = loop_stage_text((int32_t)i),
                                   .counts = new_counts(stage)};
        (void)cJSON_AddItemToArray(stages, json_stage(stage, &also));
    }
    return stages;
}

static cJSON *new_loop(const telemetry_view_t *view)
{
    const json_loop_t also = {.rights = json_rights(&view->loop),
                              .stages = new_stages(&view->loop)};
    return json_loop(&view->loop, &view->snapshot, &also);
}

/* Control that does not come says nothing of its speed either. */
#define STILL_MS 2000U

static cJSON *new_time(const telemetry_view_t *view)
{
    uint32_t speed_permille = (view->age_ms < STILL_MS) ? view->loop.speed_permille : 0U;
    const json_time_t also = {.speed_percent = (double)speed_permille / 10.0};
    return json_time(&view->loop, &also);
}

static cJSON *new_faults(uint32_t status)
{
    static const flag_t faults[] = {{CARD_STATUS_DRIVER_FAULT, "driver fault"},
                                    {CARD_STATUS_WATCHDOG, "watchdog tripped"},
                                    {CARD_STATUS_HOT, "too hot"},
                                    {CARD_STATUS_OVERSPEED, "overspeed"},
                                    {CARD_STATUS_GUARD, "position guard"},
                                    {CARD_STATUS_POWER_BAD, "bad supply"}};
    cJSON *list = cJSON_CreateArray();
    for (size_t i = 0; i < (sizeof faults / sizeof faults[0]); i++) {
        if ((status & faults[i].bit) != 0U) {
            (void)cJSON_AddItemToArray(list, cJSON_CreateString(faults[i].name));
        }
    }
    return list;
}

/* In the order of card_type_t; one that no card has is none. */
static const char *card_type_name(uint32_t type)
{
    static const char *const names[] = {"none",           "pwm",   "non_pwm", "sensor",
                                        "high_frequency", "analog"};
    return (type < (sizeof names / sizeof names[0])) ? names[type] : names[CARD_TYPE_NONE];
}

static cJSON *new_converters(const snapshot_card_t *card)
{
    cJSON *list = cJSON_CreateArray();

    if (card->card_type == (uint32_t)CARD_TYPE_NONE) {
        return list;
    }
    for (uint32_t i = 0U; i < CARD_ADC_WORDS; i++) {
        const uint32_t word = card->adc_words[i];
        (void)cJSON_AddItemToArray(list, cJSON_CreateNumber((double)(word >> 16U)));
        (void)cJSON_AddItemToArray(list, cJSON_CreateNumber((double)(word & 0xFFFFU)));
    }
    return list;
}

static void add_card(cJSON *cards, const telemetry_view_t *view, uint32_t slot, const char *axis)
{
    const snapshot_card_t *card = &view->snapshot.cards[slot];
    const json_card_t also = {.slot = slot,
                              .axis = axis,
                              .faults = new_faults(card->status),
                              .type = card_type_name(card->card_type),
                              .converters = new_converters(card)};
    (void)cJSON_AddItemToArray(cards, json_card(card, &also));
}

/* Those of the axes in their order, then what else is named or has answered. */
static cJSON *new_cards(const telemetry_view_t *view)
{
    const robot_t *robot = view->robot;
    cJSON *cards = cJSON_CreateArray();
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        add_card(cards, view, robot->axes[i].slot, robot->axes[i].name);
    }
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        const bool has_answered = view->snapshot.cards[slot].card_type != (uint32_t)CARD_TYPE_NONE;
        if ((robot_cards_axis(robot, slot) == ROBOT_AXIS_MAX) &&
            (has_answered || robot_cards_has_sensor(robot, slot))) {
            add_card(cards, view, slot, NULL);
        }
    }
    return cards;
}

static cJSON *new_forces(const telemetry_view_t *view)
{
    cJSON *forces = cJSON_CreateArray();
    for (uint32_t i = 0U; (i < ROBOT_FORCE_CHANNELS) && (view->robot->force.is_there != 0U); i++) {
        const json_force_t also = {.channel = force_channel_id_name((int32_t)i)};
        (void)cJSON_AddItemToArray(forces, json_force(&view->snapshot.forces[i], &also));
    }
    return forces;
}

static const char *text_or_null(const char *text)
{
    return (text[0] == '\0') ? NULL : text;
}

const char *telemetry_json_dialect(uint32_t dialect)
{
    static const char *const dialects[EXCHANGE_DIALECTS] = {"brp-2013", "brp-2021", "crtk"};
    return dialects[dialect];
}

static cJSON *new_port(const exchange_port_t *port)
{
    static const char *const states[EXCHANGE_PORT_STATES] = {"listening", "calling", "waiting",
                                                             "connected"};
    const struct in_addr place = {.s_addr = htonl(port->address)};
    char dotted[INET_ADDRSTRLEN] = "?";
    char address[INET_ADDRSTRLEN + sizeof ":4294967295"];

    (void)inet_ntop(AF_INET, &place, dotted, (socklen_t)sizeof dotted);
    (void)snprintf(address, sizeof address, "%s:%u", dotted, (unsigned)port->number);
    const json_port_t also = {.name = port->name,
                              .dialect = telemetry_json_dialect(port->dialect),
                              .address = address,
                              .state = states[port->state],
                              .again_ms = port->again_ms,
                              .peers = port->peers,
                              .waiting = port->waiting,
                              .troubles = port->troubles,
                              .trouble = text_or_null(port->trouble)};
    return json_port(&also);
}

cJSON *telemetry_json_ports(const telemetry_view_t *view)
{
    cJSON *ports = cJSON_CreateArray();
    for (uint32_t i = 0U; i < view->ports.count; i++) {
        (void)cJSON_AddItemToArray(ports, new_port(&view->ports.ports[i]));
    }
    return ports;
}

cJSON *telemetry_json_authority(const telemetry_view_t *view)
{
    const snapshot_t *snapshot = &view->snapshot;
    const bool is_held = snapshot->holder_peer != 0U;
    const bool is_asked = snapshot->requester_peer != 0U;
    const double held_us =
        (double)(snapshot->cycle - snapshot->held_since_cycle) * (double)LIMIT_CYCLE_US;
    const json_authority_t also = {
        .source = is_held ? command_source_name((int32_t)snapshot->holder) : NULL,
        .name = text_or_null(view->holder),
        .age_s = is_held ? (held_us / US_PER_S) : 0.0,
        .requester = is_asked ? command_source_name((int32_t)snapshot->requester) : NULL,
        .requester_name = text_or_null(view->requester),
        .left_s = (double)snapshot->request_left_us / US_PER_S};
    return json_authority(snapshot, &also);
}

cJSON *telemetry_json_status(const telemetry_identity_t *identity, const telemetry_view_t *view)
{
    char utc[UTC_TEXT_SIZE];
    char protocol[CARD_PROTOCOL_SIZE];
    const bool are_own = view->cards->dialect == (uint32_t)CARD_DIALECT_OWN;
    utc_text_write(clock_utc_us(), utc);
    card_protocol_write(view->cards->dialect, protocol);
    const json_processes_t processes = {.igtl = view->is_running[EXCHANGE_IGTL],
                                        .recorder = view->is_running[EXCHANGE_RECORDER]};
    const json_status_t also = {.authority = telemetry_json_authority(view),
                                .alarms = alarm_json_list(view),
                                .needle = alarm_json_needle(view),
                                .age_ms = view->age_ms,
                                .utc = utc,
                                .boot_id = identity->boot_id,
                                .version = identity->version,
                                .build_id = identity->build_id,
                                .card_protocol = protocol,
                                .cards_accepted = are_own ? NULL : view->cards->accepted,
                                .robot = view->robot->name,
                                .box = identity->box,
                                .time = new_time(view),
                                .loop = new_loop(view),
                                .cards = new_cards(view),
                                .forces = new_forces(view),
                                .counts = json_counts(&view->loop, &view->snapshot),
                                .processes = json_processes(&processes),
                                .ports = telemetry_json_ports(view)};
    return json_status(&view->snapshot, &also);
}

static cJSON *new_permit(const telemetry_view_t *view, uint32_t index, const cJSON *alarms)
{
    const snapshot_t *snapshot = &view->snapshot;
    const snapshot_axis_t *axis = &snapshot->axes[index];
    const json_permit_t also = {.since_ms =
                                    (snapshot->cycle - axis->permit_since_cycle) / CYCLES_PER_MS};
    cJSON *permit = json_permit(axis, &also);

    alarm_json_name_reasons(alarms, view->robot->axes[index].name, permit);
    return permit;
}

static cJSON *new_axis(const telemetry_view_t *view, uint32_t index, const cJSON *alarms)
{
    const axis_config_t *config = &view->robot->axes[index];
    const snapshot_axis_t *axis = &view->snapshot.axes[index];
    const json_axis_t also = {.name = config->name,
                              .unit = telemetry_units_name(config),
                              .minimum = telemetry_units_position(config, config->minimum_ticks),
                              .maximum = telemetry_units_position(config, config->maximum_ticks),
                              .minimum_ticks = config->minimum_ticks,
                              .maximum_ticks = config->maximum_ticks,
                              .output_percent = drive_terms_percent(config, axis),
                              .permit = new_permit(view, index, alarms)};
    return json_axis(axis, config, &also);
}

static cJSON *new_robot_axis(const axis_config_t *axis)
{
    const json_robot_axis_t reported = {
        .name = axis->name,
        .unit = telemetry_units_name(axis),
        .slot = axis->slot,
        .homing = (axis->home_method == (uint8_t)HOME_BY_SWITCH) ? "switch" : "place",
        .minimum = telemetry_units_position(axis, axis->minimum_ticks),
        .maximum = telemetry_units_position(axis, axis->maximum_ticks),
        .speed_per_s = telemetry_units_position(axis, axis->speed_ticks_per_s)};
    return json_robot_axis(&reported);
}

static cJSON *new_poses(const robot_t *robot)
{
    cJSON *poses = cJSON_CreateArray();
    for (uint32_t i = 0U; i < POSE_NAME_COUNT; i++) {
        if (robot_has_pose(robot, i)) {
            (void)cJSON_AddItemToArray(poses, cJSON_CreateString(pose_name_name((int32_t)i)));
        }
    }
    return poses;
}

cJSON *telemetry_json_robot(const telemetry_view_t *view)
{
    const robot_t *robot = view->robot;
    char checksum[9];
    cJSON *axes = cJSON_CreateArray();
    (void)snprintf(checksum, sizeof checksum, "%08x", (unsigned)robot->crc);
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        (void)cJSON_AddItemToArray(axes, new_robot_axis(&robot->axes[i]));
    }
    const json_robot_t reported = {.name = robot->name,
                                   .checksum = checksum,
                                   .slots = CARD_SLOT_COUNT,
                                   .axes = axes,
                                   .poses = new_poses(robot)};
    return json_robot(&reported);
}

cJSON *telemetry_json_motors(const telemetry_view_t *view)
{
    cJSON *axes = cJSON_CreateArray();
    cJSON *alarms = alarm_json_list(view);
    for (uint32_t i = 0U; i < view->robot->axis_count; i++) {
        (void)cJSON_AddItemToArray(axes, new_axis(view, i, alarms));
    }
    cJSON_Delete(alarms);
    const json_motors_t also = {.age_ms = view->age_ms, .axes = axes};
    return json_motors(&view->snapshot, &also);
}

/* NULL when it is not known, or there is nothing of which it could be. */
static cJSON *new_origin(const snapshot_t *snapshot, uint32_t is_there, const origin_t *origin)
{
    const double age_us = (double)(snapshot->cycle - origin->cycle) * (double)LIMIT_CYCLE_US;
    const json_origin_t reported = {.source = command_source_name((int32_t)origin->source),
                                    .peer = origin->peer,
                                    .name = origin->title,
                                    .age_s = age_us / US_PER_S};
    return ((is_there != 0U) && origin->is_known) ? json_origin(&reported) : NULL;
}

static cJSON *new_probe(const telemetry_view_t *view)
{
    const robot_t *robot = view->robot;
    cJSON *lengths = cJSON_CreateArray();
    for (uint32_t i = 0U; i < robot->probe_length_count; i++) {
        const double length_mm = telemetry_units_length(view->snapshot.probe_nm[i]);
        const json_probe_length_t reported = {
            .name = robot->probe_names[i],
            .length_mm = (view->snapshot.has_probe != 0U) ? &length_mm : NULL,
            .minimum_mm = telemetry_units_length(robot->probe_minimum.length_nm[i]),
            .maximum_mm = telemetry_units_length(robot->probe_maximum.length_nm[i])};
        (void)cJSON_AddItemToArray(lengths, json_probe_length(&reported));
    }
    return lengths;
}

static cJSON *new_proposals(const telemetry_view_t *view)
{
    const snapshot_t *snapshot = &view->snapshot;
    const origins_t *origins = &view->origins;
    const json_proposals_t also = {
        .registration_by = new_origin(snapshot, snapshot->has_proposed_registration,
                                      &origins->proposed_registration),
        .entry_by = new_origin(snapshot, snapshot->has_proposed_entry, &origins->proposed_entry),
        .target_by =
            new_origin(snapshot, snapshot->has_proposed_target, &origins->proposed_target)};
    return json_proposals(snapshot, &also);
}

static cJSON *new_membrane(const snapshot_membrane_t *membrane)
{
    const double found_mm = (double)membrane->found_um / UM_PER_MM;
    const bool is_found = membrane->state == (uint32_t)MEMBRANE_FOUND;
    const json_membrane_t reported = {.depth_mm = (double)membrane->depth_um / UM_PER_MM,
                                      .found_mm = is_found ? &found_mm : NULL,
                                      .state = membrane_state_name((int32_t)membrane->state)};
    return json_membrane(&reported);
}

/* NULL of a robot without a force sensor. */
static cJSON *new_membranes(const telemetry_view_t *view)
{
    const snapshot_membranes_t *const shown = &view->snapshot.membranes;
    const bool is_running = shown->sight != (uint32_t)MEMBRANE_SIGHT_OFF;
    const double depth_mm = (double)shown->depth_um / UM_PER_MM;
    const double least_fall_mn = (double)shown->least_fall_mn;
    if (view->robot->force.is_there == 0U) {
        return NULL;
    }
    cJSON *expected = cJSON_CreateArray();
    for (uint32_t i = 0U; (i < shown->count) && (i < LIMIT_MEMBRANES_MOST); i++) {
        (void)cJSON_AddItemToArray(expected, new_membrane(&shown->membranes[i]));
    }
    const json_membranes_t reported = {.expected = expected,
                                       .left = shown->left,
                                       .unexpected = shown->unexpected,
                                       .sight = membrane_sight_name((int32_t)shown->sight),
                                       .says = membrane_sight_text((int32_t)shown->sight),
                                       .depth_mm = is_running ? &depth_mm : NULL,
                                       .least_fall_mn = is_running ? &least_fall_mn : NULL};
    return json_membranes(&reported);
}

cJSON *telemetry_json_targeting(const telemetry_view_t *view)
{
    const snapshot_t *snapshot = &view->snapshot;
    const bool is_distance_true =
        (snapshot->has_target != 0U) && (snapshot->pose_status == (uint32_t)STATUS_OK);
    const double distance_mm =
        telemetry_units_distance(&snapshot->scanner_treatment, &snapshot->scanner_target);
    const json_targeting_t also = {
        .age_ms = view->age_ms,
        .distance_mm = is_distance_true ? &distance_mm : NULL,
        .registration_by =
            new_origin(snapshot, snapshot->is_registered, &view->origins.registration),
        .target_by = new_origin(snapshot, snapshot->has_target, &view->origins.target),
        .entry_by = new_origin(snapshot, snapshot->has_entry, &view->origins.entry),
        .probe = new_probe(view),
        .membranes = new_membranes(view),
        .proposals = new_proposals(view)};
    return json_targeting(snapshot, &also);
}

cJSON *telemetry_json_event(const robot_t *robot, const log_entry_t *entry)
{
    char subject[EVENT_TEXT_SIZE];
    char utc[UTC_TEXT_SIZE];
    event_text_subject(robot, &entry->event, subject, sizeof subject);
    utc_text_write(entry->utc_us, utc);
    const json_log_entry_t also = {.utc = utc, .text = entry->text, .subject = subject};
    return json_log_entry(&entry->event, &also);
}

cJSON *telemetry_json_state(const telemetry_identity_t *identity, const telemetry_view_t *view)
{
    const json_robot_state_t state = {.status = telemetry_json_status(identity, view),
                                      .motors = telemetry_json_motors(view),
                                      .targeting = telemetry_json_targeting(view)};
    return json_robot_state(&state);
}

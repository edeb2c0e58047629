/* SPDX-License-Identifier: Apache-2.0 */
#include "telemetry_json.h"

#include "chart_names.h"
#include "event_text.h"
#include "names.h"
#include "permit.h"
#include "telemetry_units.h"

#include <stddef.h>

/* A cycle lasts 1000 us. */
#define CYCLES_PER_MS 1U

typedef struct {
    uint32_t bit;
    const char *name;
} flag_t;

static void add_flag(cJSON *object, const char *name, uint32_t value)
{
    (void)cJSON_AddBoolToObject(object, name, (value != 0U) ? 1 : 0);
}

static void add_number(cJSON *object, const char *name, double value)
{
    (void)cJSON_AddNumberToObject(object, name, value);
}

static void add_text(cJSON *object, const char *name, const char *text)
{
    (void)cJSON_AddStringToObject(object, name, text);
}

static void add_named(cJSON *object, const char *key, const char *name, const char *text)
{
    cJSON *named = cJSON_AddObjectToObject(object, key);
    add_text(named, "name", name);
    add_text(named, "text", text);
}

static cJSON *new_view(const telemetry_view_t *view)
{
    cJSON *object = cJSON_CreateObject();
    add_number(object, "cycle", view->snapshot.cycle);
    add_number(object, "age_ms", (double)view->age_ms);
    return object;
}

static void add_loop(cJSON *object, const telemetry_view_t *view)
{
    const loop_figures_t *figures = &view->loop;
    cJSON *loop = cJSON_AddObjectToObject(object, "loop");
    add_text(loop, "state", chart_loop_guard_state_name(view->snapshot.loop));
    add_number(loop, "cycles", (double)figures->cycles);
    add_number(loop, "overruns", figures->overruns);
    add_number(loop, "wake_p50_us", figures->wake_p50_us);
    add_number(loop, "wake_p99_us", figures->wake_p99_us);
    add_number(loop, "wake_p999_us", figures->wake_p999_us);
    add_number(loop, "wake_worst_us", figures->wake_worst_us);
    add_number(loop, "step_p99_us", figures->step_p99_us);
    add_number(loop, "step_worst_us", figures->step_worst_us);
    add_number(loop, "second_worst_us", figures->second_worst_us);
    cJSON *rights = cJSON_AddObjectToObject(loop, "rights");
    add_flag(rights, "fifo", figures->rights & EXCHANGE_RIGHT_FIFO);
    add_flag(rights, "core", figures->rights & EXCHANGE_RIGHT_CORE);
    add_flag(rights, "memory", figures->rights & EXCHANGE_RIGHT_MEMORY);
}

/* Control that does not come says nothing of its speed either. */
#define STILL_MS 2000U

static void add_time(cJSON *object, const telemetry_view_t *view)
{
    const loop_figures_t *figures = &view->loop;
    uint32_t speed_permille = (view->age_ms < STILL_MS) ? figures->speed_permille : 0U;
    cJSON *time = cJSON_AddObjectToObject(object, "time");
    add_flag(time, "is_elastic", figures->is_elastic);
    add_number(time, "slowness", figures->slowness);
    add_number(time, "speed_percent", (double)speed_permille / 10.0);
}

static void add_card_faults(cJSON *card, uint32_t status)
{
    static const flag_t faults[] = {{CARD_STATUS_DRIVER_FAULT, "driver fault"},
                                    {CARD_STATUS_WATCHDOG, "watchdog tripped"},
                                    {CARD_STATUS_HOT, "too hot"},
                                    {CARD_STATUS_OVERSPEED, "overspeed"},
                                    {CARD_STATUS_GUARD, "position guard"},
                                    {CARD_STATUS_POWER_BAD, "bad supply"}};
    cJSON *list = cJSON_AddArrayToObject(card, "faults");
    for (size_t i = 0; i < (sizeof(faults) / sizeof(faults[0])); i++) {
        if ((status & faults[i].bit) != 0U) {
            (void)cJSON_AddItemToArray(list, cJSON_CreateString(faults[i].name));
        }
    }
}

static void add_cards(cJSON *object, const snapshot_t *snapshot)
{
    cJSON *cards = cJSON_AddArrayToObject(object, "cards");
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const axis_config_t *axis = &robot_neuro.axes[i];
        const snapshot_card_t *card = &snapshot->cards[axis->slot];
        cJSON *item = cJSON_CreateObject();
        add_number(item, "slot", axis->slot);
        add_text(item, "axis", axis->name);
        add_text(item, "link", chart_card_link_state_name(card->link));
        add_number(item, "age_cycles", card->age_cycles);
        add_number(item, "frame_errors", card->frame_errors);
        add_card_faults(item, card->status);
        (void)cJSON_AddItemToArray(cards, item);
    }
}

static void add_counts(cJSON *object, const telemetry_view_t *view)
{
    cJSON *counts = cJSON_AddObjectToObject(object, "counts");
    add_number(counts, "events", view->snapshot.events);
    add_number(counts, "events_lost", view->snapshot.events_lost);
    add_number(counts, "overruns", view->snapshot.overruns);
    add_number(counts, "cycles_lost", view->loop.cycles_lost);
}

cJSON *telemetry_json_status(const telemetry_identity_t *identity, const telemetry_view_t *view)
{
    const snapshot_t *snapshot = &view->snapshot;
    cJSON *status = new_view(view);
    add_text(status, "boot_id", identity->boot_id);
    add_text(status, "build_id", identity->build_id);
    add_text(status, "robot", robot_neuro.name);
    if (identity->box != NULL) {
        add_text(status, "box", identity->box);
    } else {
        (void)cJSON_AddNullToObject(status, "box");
    }
    add_named(status, "workphase", workphase_name((int32_t)snapshot->workphase),
              workphase_text((int32_t)snapshot->workphase));
    add_named(status, "next_step", next_step_name((int32_t)snapshot->next_step),
              next_step_text((int32_t)snapshot->next_step));
    add_text(status, "order", chart_workphases_order_name(snapshot->order));
    add_text(status, "pedal", chart_pedal_gate_state_name(snapshot->pedal));
    add_text(status, "estop", chart_estop_latch_state_name(snapshot->estop));
    add_flag(status, "is_scanner_active", snapshot->is_scanner_active);
    add_flag(status, "is_homed", snapshot->is_homed);
    add_flag(status, "is_registered", snapshot->is_registered);
    add_flag(status, "has_target", snapshot->has_target);
    add_time(status, view);
    add_loop(status, view);
    add_cards(status, snapshot);
    add_counts(status, view);
    cJSON *processes = cJSON_AddObjectToObject(status, "processes");
    add_flag(processes, "igtl", view->is_running[EXCHANGE_IGTL] ? 1U : 0U);
    add_flag(processes, "recorder", view->is_running[EXCHANGE_RECORDER] ? 1U : 0U);
    return status;
}

static void add_permit(cJSON *item, const snapshot_t *snapshot, const snapshot_axis_t *axis)
{
    cJSON *permit = cJSON_AddObjectToObject(item, "permit");
    add_flag(permit, "allowed", (axis->permit_reasons == 0U) ? 1U : 0U);
    add_number(permit, "speed_cap_percent", axis->speed_cap_percent);
    add_number(permit, "since_ms", (snapshot->cycle - axis->permit_since_cycle) / CYCLES_PER_MS);
    cJSON *reasons = cJSON_AddArrayToObject(permit, "reasons");
    for (uint32_t i = 0U; i < PERMIT_REASON_COUNT; i++) {
        if ((axis->permit_reasons & (UINT32_C(1) << i)) != 0U) {
            cJSON *reason = cJSON_CreateObject();
            add_text(reason, "name", permit_reason_name((int32_t)i));
            add_text(reason, "text", permit_reason_text((int32_t)i));
            (void)cJSON_AddItemToArray(reasons, reason);
        }
    }
}

static void add_position(cJSON *item, const axis_config_t *config, const snapshot_axis_t *axis)
{
    add_number(item, "position", telemetry_units_position(config, axis->position_ticks));
    add_number(item, "setpoint", telemetry_units_position(config, axis->setpoint_ticks));
    add_number(item, "target", telemetry_units_position(config, axis->target_ticks));
    add_number(item, "speed", telemetry_units_speed(config, axis->speed_ticks_per_s_q8));
    add_number(item, "minimum", telemetry_units_position(config, config->minimum_ticks));
    add_number(item, "maximum", telemetry_units_position(config, config->maximum_ticks));
    add_number(item, "position_ticks", axis->position_ticks);
    add_number(item, "setpoint_ticks", axis->setpoint_ticks);
    add_number(item, "target_ticks", axis->target_ticks);
    add_number(item, "minimum_ticks", config->minimum_ticks);
    add_number(item, "maximum_ticks", config->maximum_ticks);
}

static cJSON *new_axis(const snapshot_t *snapshot, uint32_t index)
{
    const axis_config_t *config = &robot_neuro.axes[index];
    const snapshot_axis_t *axis = &snapshot->axes[index];
    cJSON *item = cJSON_CreateObject();
    add_text(item, "name", config->name);
    add_text(item, "unit", telemetry_units_name(config));
    add_position(item, config, axis);
    add_text(item, "power", chart_axis_power_name(axis->power));
    add_text(item, "reference", chart_axis_reference_name(axis->reference));
    add_text(item, "stall", chart_stall_watchdog_state_name(axis->stall));
    add_flag(item, "at_lower_switch", axis->limit_switches & CARD_LIMIT_LOWER);
    add_flag(item, "at_upper_switch", axis->limit_switches & CARD_LIMIT_UPPER);
    add_flag(item, "is_driven", axis->drive_mode);
    add_permit(item, snapshot, axis);
    return item;
}

cJSON *telemetry_json_motors(const telemetry_view_t *view)
{
    cJSON *motors = new_view(view);
    cJSON *axes = cJSON_AddArrayToObject(motors, "axes");
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        (void)cJSON_AddItemToArray(axes, new_axis(&view->snapshot, i));
    }
    return motors;
}

static void add_pose(cJSON *object, const char *name, uint32_t is_valid, const rigid_t *pose)
{
    if (is_valid == 0U) {
        (void)cJSON_AddNullToObject(object, name);
        return;
    }
    double matrix[16];
    telemetry_units_matrix(pose, matrix);
    (void)cJSON_AddItemToObject(object, name, cJSON_CreateDoubleArray(matrix, 16));
}

static void add_point(cJSON *object, const char *name, uint32_t is_valid, const point_t *point)
{
    if (is_valid == 0U) {
        (void)cJSON_AddNullToObject(object, name);
        return;
    }
    double coordinates[3];
    telemetry_units_point(point, coordinates);
    (void)cJSON_AddItemToObject(object, name, cJSON_CreateDoubleArray(coordinates, 3));
}

cJSON *telemetry_json_targeting(const telemetry_view_t *view)
{
    const snapshot_t *snapshot = &view->snapshot;
    cJSON *targeting = new_view(view);
    const uint32_t is_pose_true = (snapshot->pose_status == (uint32_t)STATUS_OK) ? 1U : 0U;
    add_pose(targeting, "zframe_treatment", snapshot->is_homed, &snapshot->zframe_treatment);
    add_pose(targeting, "scanner_treatment", is_pose_true, &snapshot->scanner_treatment);
    add_pose(targeting, "registration", snapshot->is_registered, &snapshot->scanner_zframe);
    add_pose(targeting, "target", snapshot->has_target, &snapshot->scanner_target);
    if ((snapshot->has_target != 0U) && (is_pose_true != 0U)) {
        add_number(
            targeting, "distance_mm",
            telemetry_units_distance(&snapshot->scanner_treatment, &snapshot->scanner_target));
    } else {
        (void)cJSON_AddNullToObject(targeting, "distance_mm");
    }
    cJSON *proposals = cJSON_AddObjectToObject(targeting, "proposals");
    add_pose(proposals, "registration", snapshot->has_proposed_registration,
             &snapshot->proposed_registration);
    add_point(proposals, "entry_mm", snapshot->has_proposed_entry, &snapshot->proposed_entry);
    add_point(proposals, "target_mm", snapshot->has_proposed_target, &snapshot->proposed_target);
    add_flag(proposals, "is_reachable", snapshot->is_proposal_reachable);
    add_pose(proposals, "desired", snapshot->is_proposal_reachable & is_pose_true,
             &snapshot->scanner_desired);
    return targeting;
}

cJSON *telemetry_json_event(const event_t *event)
{
    char subject[EVENT_TEXT_SIZE];
    char sentence[EVENT_TEXT_SIZE];
    event_text_subject(event, subject, sizeof(subject));
    event_text_sentence(event, sentence, sizeof(sentence));
    cJSON *entry = cJSON_CreateObject();
    add_number(entry, "number", event->number);
    add_number(entry, "cycle", event->cycle);
    add_text(entry, "name", event_id_name((int32_t)event->id));
    add_text(entry, "text", sentence);
    add_text(entry, "severity", event_severity_name((int32_t)event->severity));
    add_text(entry, "subject", subject);
    add_number(entry, "value", event->value);
    add_text(entry, "cause", event_cause_name((int32_t)event->cause));
    add_number(entry, "peer", event->peer);
    return entry;
}

cJSON *telemetry_json_state(const telemetry_identity_t *identity, const telemetry_view_t *view)
{
    cJSON *state = cJSON_CreateObject();
    (void)cJSON_AddItemToObject(state, "status", telemetry_json_status(identity, view));
    (void)cJSON_AddItemToObject(state, "motors", telemetry_json_motors(view));
    (void)cJSON_AddItemToObject(state, "targeting", telemetry_json_targeting(view));
    return state;
}

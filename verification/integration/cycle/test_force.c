/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a force is believed only after its zero was taken with the needle out and
 * everything at rest, it is doubted by name, and no motion that follows no force waits for it.
 */
#include "integration/support/by_hand.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "base/seal.h"
#include "limits/requirement_limits.h"
#include "robot/robot_bench2.h"
#include "robot/robot_prostate.h"

#include <stddef.h>

#define HAND FORCE_CHANNEL_HAND
#define NEEDLE FORCE_CHANNEL_NEEDLE
#define CARD 3U
#define SETTLED_CYCLES 200U
#define TREMBLE_N 0.02 /* Two counts, of which the largest of some are four times as many. */
#define TREMBLE 8U
#define RESTED_CYCLES 500U
#define NOT_ZEROED force_doubt_bit(FORCE_DOUBT_NOT_ZEROED)

static rig_t rig;

/* Cells that measure at once, and almost exactly: one that does not tremble is doubted. */
static void calm_cells(void)
{
    sim_phantom_file_t phantom = rig.box.force.phantom;
    for (uint32_t i = 0U; i < (uint32_t)SIM_CELLS; i++) {
        phantom.cells[i] = (sim_load_cell_config_t){.noise_n = TREMBLE_N};
    }
    phantom.cells[NEEDLE].noise_n = BY_HAND_QUIET_N; /* What stands still is not called stuck. */
    box_force_lay(&rig.box.force, &phantom);
}

void setUp(void)
{
    rig_start_robot_homed(&rig, rig_short_prostate());
    calm_cells();
    rig_cycles(&rig, RESTED_CYCLES);
    rig_forget(&rig);
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static const snapshot_force_t *shown(force_channel_id_t channel)
{
    return &rig.outputs.snapshot.forces[channel];
}

/* Number of times that `id` was reported of `channel`, with this value. */
static uint32_t reported(event_id_t id, force_channel_id_t channel, int32_t value)
{
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        const event_t *const event = &rig.events[i];
        const bool is_it = (event->id == (uint32_t)id) && (event->subject == (uint32_t)channel) &&
                           (event->value == value);
        count += is_it ? 1U : 0U;
    }
    return count;
}

static uint32_t ask(void)
{
    const command_t zero = {.kind = (uint32_t)COMMAND_ZERO_FORCE,
                            .source = (uint32_t)COMMAND_SOURCE_HTTP,
                            .peer = RIG_PAGE};
    return rig_command(&rig, zero).status;
}

static void zero(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, ask());
    rig_cycles(&rig, LIMIT_FORCE_ZERO_CYCLES + 1U);
}

static void begin_zeroed(void)
{
    zero();
    TEST_ASSERT_EQUAL_HEX32(0U, shown(HAND)->doubts);
    TEST_ASSERT_EQUAL_HEX32(0U, shown(NEEDLE)->doubts);
    rig_forget(&rig);
}

static void jog(uint32_t axis, int32_t to_ticks)
{
    const command_t command = {.kind = (uint32_t)COMMAND_JOG,
                               .as.jog = {.axis = axis, .to_ticks = to_ticks}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
    rig_press(&rig);
}

static void enter_manual(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
}

void test_SWR_FORCE_577_forces_noise_and_doubts_are_shown(void)
{
    TEST_ASSERT_EQUAL_HEX32(NOT_ZEROED, shown(HAND)->doubts);
    TEST_ASSERT_UINT32_WITHIN(TREMBLE, 1970U, shown(HAND)->reading);
    TEST_ASSERT_UINT32_WITHIN(TREMBLE, 1780U, shown(NEEDLE)->reading);
    rig_box(&rig, "force hand 2083");
    rig_box(&rig, "force needle 1893");
    rig_cycles(&rig, SETTLED_CYCLES);
    TEST_ASSERT_INT32_WITHIN(1, 1000, shown(HAND)->force_mn);
    TEST_ASSERT_INT32_WITHIN(1, 1000, shown(NEEDLE)->force_mn);
}

void test_SWR_FORCE_572_zeroing_is_shown_and_reported(void)
{
    rig_box(&rig, "force hand 1980");
    rig_box(&rig, "force needle 1780");
    rig_cycles(&rig, 2U);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, ask());
    rig_cycles(&rig, LIMIT_FORCE_ZERO_CYCLES - 1U);
    TEST_ASSERT_EQUAL_UINT32(1U, shown(HAND)->is_zeroing);
    TEST_ASSERT_EQUAL_UINT32(1U, shown(NEEDLE)->is_zeroing);
    TEST_ASSERT_EQUAL_HEX32(NOT_ZEROED, shown(HAND)->doubts);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, shown(HAND)->is_zeroing);
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_TOO_QUIET), shown(HAND)->doubts);
    TEST_ASSERT_EQUAL_INT32(0, shown(NEEDLE)->force_mn);
    TEST_ASSERT_EQUAL_INT32(88, shown(HAND)->zero_mn);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_ZEROED, HAND, 88));
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_ZEROED, NEEDLE, 0));
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_DOUBTED, HAND, FORCE_DOUBT_TOO_QUIET));
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_DOUBTED, NEEDLE, FORCE_DOUBT_TOO_QUIET));
}

void test_SWR_FORCE_573_what_is_armed_or_moves_refuses_it(void)
{
    enter_manual();
    jog(PROSTATE_AXIS_ROTATION, 2000);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_AT_REST, ask());
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_AT_REST, ask());
}

void test_SWR_FORCE_573_a_pressed_pedal_refuses_it(void)
{
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_AT_REST, ask());
    rig_release(&rig);
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, ask());
}

void test_SWR_FORCE_573_an_axis_that_counts_refuses_it(void)
{
    rig_box(&rig, "motor 1 runs");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_AT_REST, ask());
}

void test_SWR_FORCE_573_a_needle_that_is_in_refuses_it(void)
{
    enter_manual();
    jog(PROSTATE_AXIS_INSERTION, 20000);
    (void)rig_finish(&rig, 20000U);
    rig_release(&rig);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NEEDLE_IN, ask());
}

void test_SWR_FORCE_573_before_homing_nothing_is_zeroed(void)
{
    rig_start_robot(&rig, &robot_prostate);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    enter_manual();
    rig_cycles(&rig, RESTED_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NEEDLE_IN, ask());
}

void test_SWR_FORCE_573_a_silent_card_refuses_it(void)
{
    rig_box(&rig, "card 3 silent");
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_HARDWARE_NOT_READY, ask());
}

void test_SWR_FORCE_573_a_robot_without_a_sensor_refuses_it(void)
{
    rig_start_robot_homed(&rig, &robot_bench2);
    rig_cycles(&rig, RESTED_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_FORCE_SENSOR, ask());
    TEST_ASSERT_EQUAL_HEX32(0U, shown(HAND)->doubts);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_FORCE_DOUBTED));
}

void test_SWR_FORCE_573_only_its_workphases_obey_it(void)
{
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, ask());
}

void test_SWR_FORCE_574_what_is_armed_meanwhile_ends_it(void)
{
    enter_manual();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, ask());
    rig_cycles(&rig, LIMIT_FORCE_ZERO_CYCLES / 2U);
    jog(PROSTATE_AXIS_ROTATION, 2000);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_NOT_ZEROED, HAND, FORCE_ZERO_END_MOVED));
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_NOT_ZEROED, NEEDLE, FORCE_ZERO_END_MOVED));
    TEST_ASSERT_EQUAL_HEX32(NOT_ZEROED, shown(HAND)->doubts);
}

void test_SWR_FORCE_574_a_wire_that_breaks_ends_it(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, ask());
    rig_cycles(&rig, LIMIT_FORCE_ZERO_CYCLES / 2U);
    rig_box(&rig, "force hand 0");
    rig_cycles(&rig, LIMIT_FORCE_ZERO_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_NOT_ZEROED, HAND, FORCE_ZERO_END_UNREAD));
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_ZEROED, NEEDLE, 0));
    TEST_ASSERT_EQUAL_HEX32(0U, shown(NEEDLE)->doubts);
}

void test_SWR_FORCE_570_a_load_at_the_zeroing_is_reported(void)
{
    begin_zeroed();
    rig_box(&rig, "force needle 1600");
    rig_cycles(&rig, 2U);
    zero();
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_NOT_ZEROED, NEEDLE, FORCE_ZERO_END_WANDERED));
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_DOUBTED, NEEDLE, FORCE_DOUBT_ZERO_WANDERED));
    TEST_ASSERT_EQUAL_HEX32(NOT_ZEROED | force_doubt_bit(FORCE_DOUBT_ZERO_WANDERED),
                            shown(NEEDLE)->doubts);
}

/* The needle is out: it can be zeroed anew. */
void test_SWR_FORCE_610_an_old_zero_is_doubted_once_the_needle_is_out_at_rest(void)
{
    begin_zeroed();
    enter_manual();
    jog(PROSTATE_AXIS_INSERTION, 20000);
    (void)rig_finish(&rig, 20000U);
    rig.controller.force.sealed.zero_cycles = LIMIT_FORCE_ZERO_AGE_CYCLES;
    controller_seal(&rig.controller);
    rig_cycles(&rig, SETTLED_CYCLES);
    TEST_ASSERT_EQUAL_HEX32(0U, shown(HAND)->doubts);
    rig_release(&rig);
    const command_t retract = {.kind = (uint32_t)COMMAND_RETRACT};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, retract).status);
    rig_press(&rig);
    (void)rig_finish(&rig, 40000U);
    rig_release(&rig);
    rig_cycles(&rig, SETTLED_CYCLES);
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_ZERO_OLD), shown(HAND)->doubts);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_DOUBTED, HAND, FORCE_DOUBT_ZERO_OLD));
    zero();
    TEST_ASSERT_EQUAL_HEX32(0U, shown(HAND)->doubts);
}

/* The hand pushes and the needle is pulled; the hand trembles, so that it is not stuck. */
static void pull_in(void)
{
    rig_box(&rig, "force needle 1610");
    for (uint32_t i = 0U; i < (LIMIT_FORCE_PAIR_CYCLES + SETTLED_CYCLES); i += 50U) {
        rig_box(&rig, ((i % 100U) == 0U) ? "force hand 2100" : "force hand 2102");
        rig_cycles(&rig, 50U);
    }
}

/* So slow that it is a row of bursts. */
void test_SWR_FORCE_569_a_needle_pulled_in_is_doubted_however_slow_it_is_driven(void)
{
    command_t slow = {.kind = (uint32_t)COMMAND_VELOCITY,
                      .as.velocity = {.axes = 1UL << PROSTATE_AXIS_INSERTION, .time_ms = 4000U}};
    slow.as.velocity.speeds_ticks_per_s[PROSTATE_AXIS_INSERTION] = 500;
    begin_zeroed();
    enter_manual();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, slow).status);
    rig_press(&rig);
    rig_cycles(&rig, 500U);
    pull_in();
    TEST_ASSERT_EQUAL_UINT32(1U,
                             reported(EVENT_FORCE_DOUBTED, NEEDLE, FORCE_DOUBT_NEEDLE_PULLED_IN));
}

void test_SWR_FORCE_564_reports_that_do_not_come_make_the_force_stale(void)
{
    begin_zeroed();
    rig_box(&rig, "card 3 silent");
    while (rig.controller.links[CARD].sealed.age_cycles < (LIMIT_FORCE_STALE_CYCLES - 1U)) {
        rig_cycle(&rig);
    }
    TEST_ASSERT_EQUAL_HEX32(0U, shown(HAND)->doubts);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_STALE), shown(HAND)->doubts);
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_STALE), shown(NEEDLE)->doubts);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_DOUBTED, HAND, FORCE_DOUBT_STALE));
}

void test_SWR_FORCE_564_a_short_silence_ends_by_itself(void)
{
    begin_zeroed();
    rig_box(&rig, "card 3 silent");
    while (shown(HAND)->doubts == 0U) {
        rig_cycle(&rig);
    }
    rig_box(&rig, "card 3 normal");
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_HEX32(0U, shown(HAND)->doubts);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_FORCE_BELIEVED) / ROBOT_FORCE_CHANNELS);
}

void test_SWR_FORCE_563_a_lost_card_has_to_be_zeroed_anew(void)
{
    begin_zeroed();
    rig_box(&rig, "card 3 silent");
    rig_cycles(&rig, LIMIT_LINK_AGE_CYCLES + 2U);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_DOUBTED, HAND, FORCE_DOUBT_NOT_ZEROED));
    rig_box(&rig, "card 3 normal");
    rig_cycles(&rig, 50U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_cycles(&rig, 5U);
    TEST_ASSERT_EQUAL_HEX32(NOT_ZEROED, shown(HAND)->doubts);
}

void test_SWR_FORCE_569_a_load_on_hand_and_free_needle_is_doubted(void)
{
    begin_zeroed();
    rig_box(&rig, "force hand 2100");
    rig_box(&rig, "force needle 1600");
    rig_cycles(&rig, LIMIT_FORCE_PAIR_CYCLES + SETTLED_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(1U,
                             reported(EVENT_FORCE_DOUBTED, HAND, FORCE_DOUBT_FREE_NEEDLE_LOADED));
    TEST_ASSERT_EQUAL_UINT32(1U,
                             reported(EVENT_FORCE_DOUBTED, NEEDLE, FORCE_DOUBT_FREE_NEEDLE_LOADED));
}

void test_SWR_FORCE_569_a_needle_pulled_in_is_doubted_only_while_it_goes_in(void)
{
    begin_zeroed();
    enter_manual();
    jog(PROSTATE_AXIS_INSERTION, 20000);
    rig_cycles(&rig, 500U);
    pull_in();
    TEST_ASSERT_EQUAL_UINT32(1U,
                             reported(EVENT_FORCE_DOUBTED, NEEDLE, FORCE_DOUBT_NEEDLE_PULLED_IN));
}

void test_SWR_FORCE_569_a_needle_that_is_held_in_is_possible(void)
{
    begin_zeroed();
    enter_manual();
    jog(PROSTATE_AXIS_INSERTION, 20000);
    (void)rig_finish(&rig, 20000U);
    rig_box(&rig, "force hand 2100");
    rig_box(&rig, "force needle 1610");
    rig_cycles(&rig, LIMIT_FORCE_PAIR_CYCLES + SETTLED_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_FORCE_DOUBTED));
}

/* As a broken wire, both channels. */
static void break_wires(void)
{
    rig_box(&rig, "force hand 0");
    rig_box(&rig, "force needle 4095");
    rig_cycles(&rig, 5U);
    TEST_ASSERT_NOT_EQUAL_HEX32(0U, shown(HAND)->doubts);
    TEST_ASSERT_NOT_EQUAL_HEX32(0U, shown(NEEDLE)->doubts);
}

static void retract_from(int32_t depth_ticks)
{
    const command_t retract = {.kind = (uint32_t)COMMAND_RETRACT};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, retract).status);
    rig_release(&rig);
    rig_press(&rig);
    (void)rig_finish(&rig, 40000U);
    TEST_ASSERT_LESS_THAN_INT32(depth_ticks, rig_position(&rig, PROSTATE_AXIS_INSERTION));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DONE));
    rig_release(&rig);
}

static void insert_by_jog(void)
{
    enter_manual();
    jog(PROSTATE_AXIS_INSERTION, 20000);
    (void)rig_finish(&rig, 20000U);
    rig_release(&rig);
    rig_forget(&rig);
}

void test_SWR_FORCE_575_a_doubtful_force_bars_no_retraction(void)
{
    begin_zeroed();
    insert_by_jog();
    break_wires();
    retract_from(1000);
}

void test_SWR_FORCE_575_a_lost_sensor_card_bars_no_retraction(void)
{
    begin_zeroed();
    insert_by_jog();
    rig_box(&rig, "card 3 silent");
    rig_cycles(&rig, LIMIT_LINK_AGE_CYCLES + 2U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_LOST));
    retract_from(1000);
}

void test_SWR_FORCE_575_a_force_that_breaks_in_a_motion_does_not_end_it(void)
{
    begin_zeroed();
    enter_manual();
    jog(PROSTATE_AXIS_INSERTION, 20000);
    rig_cycles(&rig, 200U);
    break_wires();
    rig_box(&rig, "card 3 silent");
    (void)rig_finish(&rig, 20000U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DONE));
    TEST_ASSERT_INT32_WITHIN(20, 20000, rig_position(&rig, PROSTATE_AXIS_INSERTION));
}

void test_SWR_FORCE_575_homing_needs_no_force(void)
{
    rig_start_robot(&rig, rig_short_prostate());
    rig_box(&rig, "card 3 silent");
    break_wires();
    rig_home(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
}

void test_SWR_FORCE_576_damaged_memory_is_not_zeroed(void)
{
    begin_zeroed();
    ((uint8_t *)&rig.controller.force.sealed.channels[NEEDLE].zero_q16)[1] ^= 4U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_HEX32(NOT_ZEROED, shown(HAND)->doubts & NOT_ZEROED);
    TEST_ASSERT_EQUAL_HEX32(NOT_ZEROED, shown(NEEDLE)->doubts & NOT_ZEROED);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_DOUBTED, NEEDLE, FORCE_DOUBT_NOT_ZEROED));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_LOST));
}

void test_SWR_FORCE_576_damaged_readings_of_a_zeroing_are_found(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, ask());
    rig_cycles(&rig, 5U);
    rig.controller.force.readings[HAND].sum ^= 4U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, shown(HAND)->is_zeroing);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_LOST));
}

void test_SWR_FORCE_576_a_damaged_table_of_the_sensor_leaves_no_force_and_stops_nothing(void)
{
    begin_zeroed();
    insert_by_jog();
    rig.robot.force.channels[HAND].mn_per_count_q16 ^= 4;
    rig_cycles(&rig, CARD_SLOT_COUNT);
    TEST_ASSERT_EQUAL_HEX32(NOT_ZEROED, shown(HAND)->doubts & NOT_ZEROED);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FORCE_DOUBTED, HAND, FORCE_DOUBT_NOT_ZEROED));
    retract_from(1000);
    rig_cycles(&rig, RESTED_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MEMORY_DAMAGED, ask());
}

/* Which the axis' encoder says at once; at rest, as a person holds it. */
void test_SWR_FORCE_574_a_needle_that_is_in_ends_it(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, ask());
    rig_cycles(&rig, LIMIT_FORCE_ZERO_CYCLES / 2U);
    rig.controller.axes[PROSTATE_AXIS_INSERTION].sealed.encoder.position_ticks += 20000;
    controller_seal(&rig.controller);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U,
                             reported(EVENT_FORCE_NOT_ZEROED, HAND, (int32_t)FORCE_ZERO_END_MOVED));
}

void test_SWR_FORCE_577_another_card_without_an_axis_is_no_force_sensor(void)
{
    static robot_t robot;
    robot = robot_prostate;
    robot.sensor_slots |= 1U << 8U;
    robot.seal = seal_of(SEAL_START, (const uint8_t *)&robot, offsetof(robot_t, seal));
    rig_start_robot(&rig, &robot);
    calm_cells();
    rig_cycles(&rig, SETTLED_CYCLES);
    TEST_ASSERT_UINT32_WITHIN(TREMBLE, 1970U, shown(HAND)->reading);
    TEST_ASSERT_EQUAL_HEX32(NOT_ZEROED, shown(HAND)->doubts);
}

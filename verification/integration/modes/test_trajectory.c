/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a trajectory that was sent and judged row by row is an armed order like any
 * other: driven under the pedal alone, each point in its time, reported at its end, replayed bit by
 * bit. On the simulated box, whose true positions are looked at.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unit/support/contract_trap.h"
#include "unity.h"

#include "controller/controller.h"
#include "replay/verify/replay.h"
#include "robot/robot_neuro.h"

#include <string.h>

#define LONG_CYCLES 30000U
#define WAY 600 /* The yaw of thesis 5.3: 0 to 600 ticks. */

static rig_t rig;
static uint32_t sum;
static trajectory_row_t row;

/* Free of its switch; homing leaves it there. */
static int32_t begin_ticks(void)
{
    return robot_neuro.axes[NEURO_AXIS_YAW].target_maximum_ticks;
}

void setUp(void)
{
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    memset(&row, 0, sizeof row);
    for (uint32_t i = 0U; i < rig.robot.axis_count; i++) {
        row.ticks[i] = rig_position(&rig, i);
    }
    row.ticks[NEURO_AXIS_YAW] = begin_ticks();
    sum = 0U;
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static answer_t list(command_kind_t kind, uint32_t argument)
{
    return rig_command(&rig, commands_of_number(kind, argument));
}

static answer_t send_row(uint32_t index, uint32_t time_ms)
{
    command_t command = {.kind = (uint32_t)COMMAND_LIST_ROW,
                         .as.row = {.index = index, .time_ms = time_ms}};
    (void)memcpy(command.as.row.ticks, row.ticks, sizeof row.ticks);
    (void)memcpy(command.as.row.speeds_ticks_per_s, row.speeds_ticks_per_s,
                 sizeof row.speeds_ticks_per_s);
    row.time_ms = time_ms;
    sum = trajectory_list_crc(sum, &row);
    return rig_command(&rig, command);
}

static void expect_row(uint32_t index, uint32_t time_ms, status_t status)
{
    TEST_ASSERT_EQUAL_UINT32(status, send_row(index, time_ms).status);
}

/* From where the yaw begins by -WAY in 3 s, with speed through the middle, and back in 4 s. */
static void send_list(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, list(COMMAND_LIST_BEGIN, 4U).status);
    expect_row(0U, 0U, STATUS_OK);
    row.ticks[NEURO_AXIS_YAW] -= WAY / 2;
    row.speeds_ticks_per_s[NEURO_AXIS_YAW] = -(WAY / 3);
    expect_row(1U, 1500U, STATUS_OK);
    row.ticks[NEURO_AXIS_YAW] -= WAY / 2;
    row.speeds_ticks_per_s[NEURO_AXIS_YAW] = 0;
    expect_row(2U, 3000U, STATUS_OK);
    row.ticks[NEURO_AXIS_YAW] += WAY;
    expect_row(3U, 7000U, STATUS_OK);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, list(COMMAND_LIST_END, sum).status);
}

static void expect_run(status_t status)
{
    const answer_t answer = list(COMMAND_RUN_TRAJECTORY, sum);
    TEST_ASSERT_EQUAL_UINT32(status, answer.status);
    TEST_ASSERT_EQUAL_UINT32((status == STATUS_OK) ? 0U : 1U, answer.is_final);
}

static void run_until(uint32_t time_us)
{
    for (uint32_t i = 0U; (i < LONG_CYCLES) && (rig.outputs.snapshot.trajectory_time_us < time_us);
         i++) {
        rig_cycle(&rig);
    }
    TEST_ASSERT_EQUAL_UINT32(time_us, rig.outputs.snapshot.trajectory_time_us);
}

static int32_t yaw(void)
{
    return rig.outputs.snapshot.axes[NEURO_AXIS_YAW].position_ticks;
}

void test_SWR_TRAJ_014_a_trajectory_is_driven_in_its_time_and_reported_at_its_end(void)
{
    const int32_t start = begin_ticks();
    send_list();
    TEST_ASSERT_EQUAL_UINT32(4U, rig.outputs.snapshot.trajectory_rows);
    TEST_ASSERT_EQUAL_HEX32(sum, rig.outputs.snapshot.trajectory_crc);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_TRAJECTORY_HELD));
    expect_run(STATUS_OK);
    const int32_t stands = yaw();
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_INT32(stands, yaw());
    rig_press(&rig);
    run_until(1500000U);
    TEST_ASSERT_INT32_WITHIN(30, start - (WAY / 2), yaw());
    run_until(3000000U);
    TEST_ASSERT_INT32_WITHIN(30, start - WAY, yaw());
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, LONG_CYCLES).kind);
    TEST_ASSERT_INT32_WITHIN(2, start, yaw());
    TEST_ASSERT_EQUAL_UINT32(3U, rig.outputs.snapshot.trajectory_row);
}

void test_SWR_MODE_006_of_a_trajectory_the_time_of_its_list_is_shown(void)
{
    const snapshot_t *const shown = &rig.outputs.snapshot;
    send_list();
    expect_run(STATUS_OK);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(MODE_TRAJECTORY, shown->mode);
    TEST_ASSERT_EQUAL_UINT32(0U, shown->done_per_mille);
    TEST_ASSERT_EQUAL_UINT32(7000U, shown->left_ms);
    run_until(1500000U);
    TEST_ASSERT_EQUAL_UINT32(214U, shown->done_per_mille);
    TEST_ASSERT_EQUAL_UINT32(5500U, shown->left_ms);
    run_until(7000000U);
    TEST_ASSERT_EQUAL_UINT32(1000U, shown->done_per_mille);
    TEST_ASSERT_EQUAL_UINT32(0U, shown->left_ms);
}

/* It has no time of its own, but a way to its row. */
void test_SWR_MODE_006_of_a_list_of_one_row_its_way_is_shown(void)
{
    const snapshot_t *const shown = &rig.outputs.snapshot;
    row.ticks[NEURO_AXIS_YAW] -= WAY / 20;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, list(COMMAND_LIST_BEGIN, 1U).status);
    expect_row(0U, 0U, STATUS_OK);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, list(COMMAND_LIST_END, sum).status);
    expect_run(STATUS_OK);
    rig_press(&rig);
    TEST_ASSERT_LESS_THAN_UINT32(1000U, shown->done_per_mille);
    TEST_ASSERT_NOT_EQUAL_UINT32(0U, shown->left_ms);
}

void test_SWR_TRAJ_014_at_its_end_it_may_be_run_again(void)
{
    send_list();
    for (uint32_t i = 0U; i < 2U; i++) {
        expect_run(STATUS_OK);
        rig_press(&rig);
        TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, LONG_CYCLES).kind);
        rig_release(&rig);
    }
}

void test_SWR_TRAJ_014_the_pedal_pauses_it_and_it_goes_on_from_there(void)
{
    const int32_t start = begin_ticks();
    send_list();
    expect_run(STATUS_OK);
    rig_press(&rig);
    run_until(1000000U);
    rig_release(&rig);
    const int32_t paused = yaw();
    const uint32_t time_us = rig.outputs.snapshot.trajectory_time_us;
    rig_cycles(&rig, 3000U);
    TEST_ASSERT_INT32_WITHIN(3, paused, yaw());
    TEST_ASSERT_EQUAL_UINT32(time_us, rig.outputs.snapshot.trajectory_time_us);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, LONG_CYCLES).kind);
    TEST_ASSERT_INT32_WITHIN(2, start, yaw());
}

void test_SWR_TRAJ_014_stop_ends_it_and_leaves_the_list(void)
{
    send_list();
    expect_run(STATUS_OK);
    rig_press(&rig);
    run_until(1000000U);
    rig_forget(&rig);
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DISCARDED));
    TEST_ASSERT_EQUAL_UINT32(4U, rig.outputs.snapshot.trajectory_rows);
    expect_run(STATUS_WRONG_WORKPHASE);
}

void test_SWR_MODE_060_beside_a_trajectory_no_axis_is_enabled_and_a_homing_ends_it(void)
{
    const command_t home = {.kind = (uint32_t)COMMAND_HOME_AXIS,
                            .as.axis = {.axis = NEURO_AXIS_LATERAL}};
    send_list();
    expect_run(STATUS_OK);
    rig_press(&rig);
    run_until(1000000U);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_AT_REST,
                             list(COMMAND_ENABLE_AXIS, NEURO_AXIS_LATERAL).status);
    rig_cycles(&rig, 10U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_ENABLED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_ORDER_DISCARDED));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, home).status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DISCARDED));
    rig_cycles(&rig, 500U);
    const int32_t stands = yaw();
    rig_cycles(&rig, 500U);
    TEST_ASSERT_INT32_WITHIN(1, stands, yaw()); /* The pedal is pressed, but from before. */
    TEST_ASSERT_EQUAL_UINT32(4U, rig.outputs.snapshot.trajectory_rows);
}

void test_SWR_TRAJ_013_what_is_armed_is_not_changed(void)
{
    send_list();
    expect_run(STATUS_OK);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_AT_REST, list(COMMAND_LIST_BEGIN, 0U).status);
    expect_row(4U, 8000U, STATUS_NOT_AT_REST);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_AT_REST, list(COMMAND_LIST_END, sum).status);
    TEST_ASSERT_EQUAL_UINT32(4U, rig.outputs.snapshot.trajectory_rows);
}

void test_SWR_TRAJ_013_a_connection_of_navigation_sends_one_if_it_commands(void)
{
    command_t command = {.kind = (uint32_t)COMMAND_LIST_BEGIN,
                         .source = (uint32_t)COMMAND_SOURCE_IGTL,
                         .peer = RIG_CONNECTION + 1U,
                         .as.list_begin = {.count = 2U}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_AUTHORITY, rig_command(&rig, command).status);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.controller.mode.sealed.list.total);
    rig_leave(&rig);
    command.peer = RIG_CONNECTION;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
    TEST_ASSERT_EQUAL_UINT32(2U, rig.controller.mode.sealed.list.total);
    TEST_ASSERT_EQUAL_UINT32(TRAJECTORY_SOURCE_IGTL, rig.controller.mode.sealed.list.source);
}

void test_SWR_TRAJ_013_out_of_manual_nothing_is_taken(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_PLANNING).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, list(COMMAND_LIST_BEGIN, 4U).status);
}

void test_SWR_TRAJ_001_a_refused_row_is_named_and_nothing_is_held(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OUT_OF_RANGE,
                             list(COMMAND_LIST_BEGIN, LIMIT_TRAJECTORY_ROWS + 1U).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, list(COMMAND_LIST_BEGIN, 2U).status);
    expect_row(0U, 0U, STATUS_OK);
    row.ticks[NEURO_AXIS_YAW] = rig.robot.axes[NEURO_AXIS_YAW].maximum_ticks + 1;
    const answer_t answer = send_row(1U, 1000U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_AXIS_LIMIT, answer.status);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_YAW, answer_axis(&answer));
    TEST_ASSERT_EQUAL_UINT32(1U, answer_as_limit(&answer)->is_maximum);
    TEST_ASSERT_EQUAL_UINT32(STATUS_TRAJECTORY_ORDER, list(COMMAND_LIST_END, sum).status);
    expect_run(STATUS_TRAJECTORY_EMPTY);
}

void test_SWR_TRAJ_001_it_is_emptied_when_that_is_asked_for(void)
{
    send_list();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, list(COMMAND_LIST_BEGIN, 0U).status);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.trajectory_rows);
    expect_run(STATUS_TRAJECTORY_EMPTY);
}

void test_SWR_TRAJ_012_a_row_that_is_damaged_ends_it_by_name(void)
{
    send_list();
    expect_run(STATUS_OK);
    rig_press(&rig);
    run_until(1000000U);
    rig_forget(&rig);
    rig.controller.rows[2].ticks[NEURO_AXIS_YAW] ^= 1;
    const answer_t answer = rig_finish(&rig, LONG_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MEMORY_DAMAGED, answer.status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
}

static replay_t replay;
static cycle_record_t record;
static cycle_known_t known;

/* From a checkpoint of this cycle, whose rows are `rows`. */
static void begin_replay(const trajectory_row_t *rows)
{
    known = (cycle_known_t){.is_whole = true, .rows = (const uint8_t *)rows};
    replay_init(&replay);
    record.kind = (uint32_t)CYCLE_RECORD_CHECKPOINT;
    record.cycle = rig.controller.sealed.cycle;
    record.rows = rig.controller.mode.sealed.list.count;
    memcpy(record.body.checkpoint, &rig.controller, CONTROLLER_CHECKPOINT_BYTES);
    TEST_ASSERT_TRUE(replay_take(&replay, &robot_neuro, &record, &known));
    record.kind = (uint32_t)CYCLE_RECORD_CYCLE;
}

/* One more cycle; false: its replay differs. */
static bool is_replayed_cycle(void)
{
    record.cycle = rig.controller.sealed.cycle;
    rig_cycle(&rig);
    record.body.cycle.inputs = rig.inputs;
    record.body.cycle.outputs = rig.outputs;
    return replay_take(&replay, &robot_neuro, &record, &known);
}

/* A recording may begin in the middle of a run. */
void test_SWR_TRAJ_014_the_list_is_part_of_the_state_that_is_replayed(void)
{
    send_list();
    expect_run(STATUS_OK);
    rig_press(&rig);
    run_until(1000000U);
    begin_replay(rig.controller.rows);
    for (uint32_t i = 0U; i < 3000U; i++) {
        TEST_ASSERT_TRUE(is_replayed_cycle());
    }
    TEST_ASSERT_EQUAL_UINT64(3000U, replay.replayed);
}

/* A checkpoint has rows as they came: the fate of one afterwards is not known. */
void test_SWR_TRAJ_014_a_row_that_was_damaged_differs_in_the_cycle_that_finds_it(void)
{
    static trajectory_row_t sent[LIMIT_TRAJECTORY_ROWS];
    send_list();
    expect_run(STATUS_OK);
    rig_press(&rig);
    run_until(1000000U);
    memcpy(sent, rig.controller.rows, sizeof sent);
    rig.controller.rows[2].ticks[NEURO_AXIS_YAW] ^= 1;
    rig_forget(&rig);
    begin_replay(sent);
    while (is_replayed_cycle()) {
        TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
        TEST_ASSERT_LESS_THAN_UINT32(LONG_CYCLES, replay.replayed);
    }
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
    begin_replay(rig.controller.rows);
    for (uint32_t i = 0U; i < 100U; i++) {
        TEST_ASSERT_TRUE(is_replayed_cycle());
    }
}

/* 10 ms from row to row, to and fro by a tick. */
void test_SWR_TRAJ_001_the_longest_list_is_held_and_its_last_row_driven_to(void)
{
    const uint32_t last = LIMIT_TRAJECTORY_ROWS - 1U;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, list(COMMAND_LIST_BEGIN, LIMIT_TRAJECTORY_ROWS).status);
    for (uint32_t i = 0U; i <= last; i++) {
        row.ticks[NEURO_AXIS_YAW] = begin_ticks() - (((i % 200U) == 199U) ? 1 : 0);
        expect_row(i, i * 10U, STATUS_OK);
    }
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, list(COMMAND_LIST_END, sum).status);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_TRAJECTORY_ROWS, rig.outputs.snapshot.trajectory_rows);
    expect_run(STATUS_OK);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    TEST_ASSERT_EQUAL_UINT32(last, rig.outputs.snapshot.trajectory_row);
    TEST_ASSERT_EQUAL_UINT32(last * 10000U, rig.outputs.snapshot.trajectory_time_us);
}

/* Those of a file, at the begin of a run. */
static trajectory_row_t kept[3];

static solution_t hold(int32_t way, uint32_t *refused)
{
    for (uint32_t i = 0U; i < 3U; i++) {
        kept[i] = row;
        kept[i].time_ms = i * 1000U;
    }
    kept[1].ticks[NEURO_AXIS_YAW] += way;
    controller_init(&rig.controller, &rig.robot);
    return controller_hold(&rig.controller, &rig.robot, kept, 3U, refused);
}

void test_SWR_TRAJ_020_a_list_of_a_file_is_held_from_the_first_cycle_on_and_reported(void)
{
    uint32_t refused = 7U;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, hold(-10, &refused).status);
    rig_forget(&rig);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_TRAJECTORY_HELD));
    TEST_ASSERT_EQUAL_UINT32(3U, rig.outputs.snapshot.trajectory_rows);
    TEST_ASSERT_EQUAL_UINT32(TRAJECTORY_SOURCE_FILE, rig.outputs.snapshot.trajectory_source);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_TRAJECTORY_HELD));
}

void test_SWR_TRAJ_020_one_that_is_refused_is_not_held_and_its_row_is_named(void)
{
    uint32_t refused = 7U;
    const solution_t judged = hold(rig.robot.axes[NEURO_AXIS_YAW].maximum_ticks, &refused);
    TEST_ASSERT_NOT_EQUAL_UINT32(STATUS_OK, judged.status);
    TEST_ASSERT_EQUAL_UINT8(NEURO_AXIS_YAW, judged.axis);
    TEST_ASSERT_EQUAL_UINT32(1U, refused);
    rig_forget(&rig);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_TRAJECTORY_HELD));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.trajectory_rows);
}

void test_SWR_TRAJ_020_once_a_cycle_was_run_none_is_taken(void)
{
    uint32_t refused = 0U;
    EXPECT_CONTRACT("controller", 102U,
                    (void)controller_hold(&rig.controller, &rig.robot, kept, 1U, &refused));
}

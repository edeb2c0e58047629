/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: main gives each cycle its inputs: the state of the recorder, of the computer and
 * of the cards; the watchdogs are kicked by punctual cycles only. Each case runs main in a child.
 */
#include "unity.h"
#include "control/figures.h"
#include "mock_bsp.h"
#include "mock_computer.h"
#include "mock_controller.h"
#include "mock_list_file.h"
#include "mock_realtime.h"
#include "unit/support/control_world.inc"

#define RECORDED 4U /* of which so many cycles are recorded, after a checkpoint. */
#define WITH_LIST 11
#define SPEEDUP 10U

void setUp(void)
{
    begin_control();
}

void tearDown(void)
{
    end_control();
}

void test_SWR_TRAJ_020_a_trajectory_that_is_refused_is_reported_and_nothing_starts(void)
{
    list_count = WITH_LIST;
    const int status = control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_TRUE(WIFEXITED(status));
    TEST_ASSERT_EQUAL_INT(EXIT_CANNOT_START, WEXITSTATUS(status));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, "control: the trajectory list, line 3: no.\n"), said);
    TEST_ASSERT_EQUAL_UINT32(0U, record->count);
}

void test_SWR_BSP_006_the_watchdogs_hear_of_each_whole_punctual_cycle(void)
{
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32(LAST_CYCLE + 1U, record->kicks);
    TEST_ASSERT_EQUAL_HEX32(BSP_LAMP_ALIVE, record->lamps);
    record->kicks = 0U;
    (void)control_ends(BY_CONTRACT, 0);
    TEST_ASSERT_EQUAL_UINT32(LAST_CYCLE, record->kicks);
}

void test_SWR_BSP_006_the_watchdogs_hear_nothing_of_late_cycles(void)
{
    late_ns = CYCLE_NS;
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32(0U, record->kicks);
    expect_off(2U);
}

/* Each of those ends before the next one is due. */
void test_SWR_BSP_006_a_cycle_that_began_too_late_is_not_reported(void)
{
    late_ns = UINT64_C(1000) * (LIMIT_OVERRUN_US - LIMIT_CYCLE_US + 1U);
    is_late_at_times = true;
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32((LAST_CYCLE / 2U) + 1U, record->kicks);
}

void test_SWR_CTRL_012_frames_leave_in_the_cycle_that_made_them(void)
{
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32(LAST_CYCLE + 1U + 2U, record->count);
    for (uint32_t cycle = 0U; cycle <= LAST_CYCLE; cycle++) {
        TEST_ASSERT_EQUAL_UINT32(100U + cycle, record->heard[cycle].lowest_sequence);
    }
    TEST_ASSERT_EQUAL_UINT32(1U, record->most_under_way);
}

void test_SWR_REC_019_elastic_time_waits_once_for_a_dead_recorder_and_goes_on(void)
{
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT64(UINT64_C(1000) * LIMIT_RECORDER_ANSWER_CLOCK_US, record->stood_ns);
    TEST_ASSERT_EQUAL_UINT32((LAST_CYCLE + 1U) - RECORDED, record->cycles_lost);
    expect_off(2U);
}

void test_SWR_REC_019_real_time_waits_for_nobody(void)
{
    is_elastic = false;
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT64(0U, record->stood_ns);
    TEST_ASSERT_EQUAL_UINT32((LAST_CYCLE + 1U) - RECORDED, record->cycles_lost);
    TEST_ASSERT_EQUAL_UINT32(LAST_CYCLE + 1U, record->kicks);
}

void test_SWR_REC_033_the_controller_is_informed_that_the_recorder_cannot_write(void)
{
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32(0U, record->is_recorder_failing);
    record->stood_ns = 0U;
    exchange_note_recorder(segment, true, 0U);
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32(1U, record->is_recorder_failing);
    TEST_ASSERT_EQUAL_UINT32(LAST_CYCLE + 1U, record->cycles_lost);
    TEST_ASSERT_EQUAL_UINT64(0U, record->stood_ns);
}

void test_SWR_REC_050_the_controller_is_informed_that_there_is_no_black_box(void)
{
    exchange_note_recorder(segment, true, 0U);
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32(1U, record->lacks_black_box);
}

void test_SWR_REC_036_the_controller_is_informed_how_long_the_disk_lasts(void)
{
    exchange_note_recording_left(segment, 25U);
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32(25U, record->recording_left_min);
}

void test_SWR_REC_022_what_is_recorded_again_begins_with_the_state_and_reports_of_the_gap(void)
{
    static cycle_record_t taken;
    char error[200] = "";
    uint32_t dropped = 0U;
    is_elastic = false;
    read_in = 10U;
    (void)control_ends(BY_SIGNAL, SIGTERM);
    exchange_t *const reader = exchange_open(name, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(reader, error);
    TEST_ASSERT_FALSE(exchange_repair_cycles(reader, &dropped));
    TEST_ASSERT_TRUE(exchange_take_cycle(reader, &taken));
    TEST_ASSERT_EQUAL_UINT32(CYCLE_RECORD_CHECKPOINT, taken.kind);
    TEST_ASSERT_EQUAL_UINT32(read_in + 1U, taken.cycle);
    TEST_ASSERT_TRUE(exchange_take_cycle(reader, &taken));
    TEST_ASSERT_EQUAL_UINT32(CYCLE_RECORD_CYCLE, taken.kind);
    TEST_ASSERT_EQUAL_UINT32(read_in + 1U, taken.cycle);
    TEST_ASSERT_EQUAL_UINT32((read_in + 1U) - RECORDED, taken.body.cycle.inputs.cycles_lost);
    exchange_close(reader);
}

static void expect_reported(uint32_t lacks)
{
    loop_figures_t reported = {0};
    const int status = control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_INT(0, WEXITSTATUS(status));
    TEST_ASSERT_EQUAL_HEX32(lacks, record->unfit);
    TEST_ASSERT_TRUE(exchange_read_loop(segment, &reported));
    TEST_ASSERT_EQUAL_HEX32(LACKS, reported.computer); /* Which is shown in both cases. */
}

void test_SWR_LOOP_007_on_a_real_board_the_controller_is_informed_what_the_computer_lacks(void)
{
    is_simulated = false;
    expect_reported(LACKS);
}

void test_SWR_LOOP_007_a_simulated_board_does_without(void)
{
    expect_reported(0U);
}

void test_SWR_CHECK_007_only_a_real_boards_computer_is_kept_from_deep_sleep(void)
{
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32(0U, record->awake);
    is_simulated = false;
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32(1U, record->awake);
}

void test_SWR_BOX_042_in_fast_time_programs_are_silent_by_the_worlds_time(void)
{
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32((LAST_CYCLE + 1U) * LIMIT_CYCLE_US, record->silent_us);
    speedup = SPEEDUP;
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32(((LAST_CYCLE + 1U) * LIMIT_CYCLE_US) / SPEEDUP, record->silent_us);
}

void test_SWR_BOX_043_only_in_fast_time_control_gives_its_priority_back(void)
{
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32(0U, record->ways_given);
    speedup = SPEEDUP;
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32(1U, record->ways_given);
}

void test_SWR_BOX_044_the_figures_have_the_speedup(void)
{
    loop_figures_t reported = {0};
    speedup = SPEEDUP;
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_TRUE(exchange_read_loop(segment, &reported));
    TEST_ASSERT_EQUAL_UINT32(SPEEDUP, reported.speedup);
}

static void expect_accepted(const char *person, uint32_t is_accepted, const char *expected)
{
    dialect = CARD_DIALECT_AIM32;
    accepted = person;
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32(CARD_DIALECT_AIM32, record->dialect);
    TEST_ASSERT_EQUAL_UINT32(is_accepted, record->is_dialect_accepted);
    TEST_ASSERT_EQUAL_UINT32(CARD_DIALECT_AIM32, exchange_cards(segment)->dialect);
    TEST_ASSERT_EQUAL_STRING(person, exchange_cards(segment)->accepted);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, expected), said);
}

void test_SWR_NI_012_who_accepts_cards_without_protections_is_said_and_reported_to_the_controller(
    void)
{
    expect_accepted("A. Engineer, 2026-11-23", 1U,
                    "watchdog, echo, sequence or CRC; accepted by: A. Engineer, 2026-11-23.\n");
    expect_accepted("", 0U, "accepted by: nobody, and nothing moves.\n");
}

void test_SWR_NI_012_nothing_is_said_of_cards_that_protect_themselves(void)
{
    (void)control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_UINT32(CARD_DIALECT_OWN, record->dialect);
    TEST_ASSERT_NULL(strstr(said, "accepted by"));
}

void test_SWR_LOOP_005_cycles_are_counted_by_how_long_each_stage_took(void)
{
    static figures_t counted;
    static const uint64_t steps_us[] = {0U, 1U, 2U, 3U, 4U, 2047U, 2048U, 5000U};
    static const uint32_t bars[] = {0U, 1U, 2U, 2U, 3U, 11U, 12U, 12U};
    loop_figures_t reported = {0};
    uint32_t expected[LIMIT_LOOP_BARS] = {0};
    (void)memset(&counted, 0, sizeof counted);
    for (uint32_t i = 0U; i < (sizeof bars / sizeof bars[0]); i++) {
        const uint64_t took_ns[LOOP_STAGE_COUNT] = {[LOOP_STAGE_STEP] = steps_us[i] * 1000U};
        expected[bars[i]]++;
        figures_add(&counted, took_ns);
        figures_publish(&counted, &reported);
    }
    TEST_ASSERT_EQUAL_UINT32_ARRAY(expected, reported.stages[LOOP_STAGE_STEP].counts,
                                   LIMIT_LOOP_BARS);
    TEST_ASSERT_EQUAL_UINT32(5000U, reported.stages[LOOP_STAGE_STEP].worst_us);
    TEST_ASSERT_EQUAL_UINT32(8U, reported.stages[LOOP_STAGE_WAKE].counts[0]);
    TEST_ASSERT_EQUAL_UINT32(0U, reported.stages[LOOP_STAGE_PUBLISH].worst_us);
}

/* Each second one is late, and what comes after waking up takes as long in each. */
void test_SWR_LOOP_001_a_late_wake_up_is_named_in_the_cycle_that_it_made_late(void)
{
    late_ns = UINT64_C(1000) * (LIMIT_OVERRUN_US - LIMIT_CYCLE_US + 1U);
    is_late_at_times = true;
    cards_ns = UINT64_C(300000);
    (void)control_ends(BY_SIGNAL, SIGTERM);
    for (uint32_t i = 0U; i < 2U; i++) {
        const bool is_late = record->elapsed_us[i] > LIMIT_OVERRUN_US;
        TEST_ASSERT_EQUAL_UINT32(is_late ? LOOP_STAGE_WAKE : LOOP_STAGE_CARDS,
                                 record->late_stage[i]);
    }
    TEST_ASSERT_NOT_EQUAL_UINT32(record->elapsed_us[0], record->elapsed_us[1]);
}

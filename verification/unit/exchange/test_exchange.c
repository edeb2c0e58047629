/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: control publishes without waiting for a reader; what a reader gets is whole, and
 * a segment that is not what it should be is refused.
 */
#include "unity.h"

#include "exchange/exchange.h"
#include "exchange/exchange_segment.h"
#include "robot/robot_neuro.h"

#include "unit/support/exchange_world.h"

#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static snapshot_t snapshot;
static snapshot_t copy;

void setUp(void)
{
    exchange_world_init();
}

void tearDown(void)
{
    exchange_world_end();
}

static void fill(snapshot_t *to, uint32_t value)
{
    uint32_t words[sizeof(snapshot_t) / sizeof(uint32_t)];

    for (size_t i = 0U; i < (sizeof(words) / sizeof(words[0])); i++) {
        words[i] = value;
    }
    (void)memcpy(to, words, sizeof(*to));
}

static bool is_whole(const snapshot_t *from)
{
    uint32_t words[sizeof(snapshot_t) / sizeof(uint32_t)];
    bool is_same = true;

    (void)memcpy(words, from, sizeof(*from));
    for (size_t i = 1U; i < (sizeof(words) / sizeof(words[0])); i++) {
        is_same = is_same && (words[i] == words[0]);
    }
    return is_same;
}

void test_SWR_REC_030_a_run_is_called_by_the_time_at_which_its_exchange_was_created(void)
{
    const uint64_t before = exchange_run(control);

    TEST_ASSERT_EQUAL_UINT64(before, exchange_run(reader));
    TEST_ASSERT_TRUE(before > UINT64_C(1000000));
    exchange_world_end();
    exchange_world_init();
    TEST_ASSERT_TRUE(exchange_run(control) != before);
}

void test_SWR_REC_031_every_view_knows_that_control_has_ended(void)
{
    TEST_ASSERT_FALSE(exchange_has_control_ended(reader));
    exchange_note_control_ended(control);
    TEST_ASSERT_TRUE(exchange_has_control_ended(reader));
}

static void *publish_snapshots(void *unused)
{
    snapshot_t mine;

    (void)unused;
    for (uint32_t i = 1U; i <= ROUNDS; i++) {
        fill(&mine, i);
        exchange_publish_snapshot(control, &mine);
    }
    return NULL;
}

void test_SWR_EXCH_001_a_snapshot_read_while_another_is_written_is_never_torn(void)
{
    pthread_t writer;
    uint32_t newest = 0U;

    TEST_ASSERT_EQUAL_INT(0, pthread_create(&writer, NULL, publish_snapshots, NULL));
    while (newest < ROUNDS) {
        if (exchange_read_snapshot(reader, &copy)) {
            TEST_ASSERT_TRUE(is_whole(&copy));
            TEST_ASSERT_TRUE(copy.cycle >= newest);
            newest = copy.cycle;
        }
    }
    (void)pthread_join(writer, NULL);
    TEST_ASSERT_EQUAL_UINT32(ROUNDS, newest);
}

void test_SWR_EXCH_001_there_is_no_snapshot_before_the_first_one(void)
{
    TEST_ASSERT_FALSE(exchange_read_snapshot(reader, &copy));
    fill(&snapshot, 7U);
    exchange_publish_snapshot(control, &snapshot);
    TEST_ASSERT_TRUE(exchange_read_snapshot(reader, &copy));
    TEST_ASSERT_EQUAL_MEMORY(&snapshot, &copy, sizeof(copy));
}

void test_SWR_EXCH_001_a_writer_that_died_while_writing_leaves_the_snapshot_before_readable(void)
{
    for (uint32_t i = 1U; i <= 5U; i++) {
        fill(&snapshot, i);
        exchange_publish_snapshot(control, &snapshot);
    }
    control->segment->control.snapshots[5U % SEGMENT_SNAPSHOTS].sequence |= 1U;
    TEST_ASSERT_TRUE(exchange_read_snapshot(reader, &copy));
    TEST_ASSERT_EQUAL_UINT32(5U, copy.cycle);
}

void test_SWR_EXCH_001_a_reader_gives_up_when_the_newest_snapshot_stays_half_written(void)
{
    fill(&snapshot, 1U);
    exchange_publish_snapshot(control, &snapshot);
    control->segment->control.snapshots[0].sequence |= 1U;
    TEST_ASSERT_FALSE(exchange_read_snapshot(reader, &copy));
}

void test_SWR_EXCH_001_loop_figures_come_back_whole(void)
{
    const loop_figures_t figures = {
        .cycles = UINT64_C(5000000000), .rights = 5U, .wake_worst_us = 77U, .cycles_lost = 3U};
    loop_figures_t read = {0};

    TEST_ASSERT_FALSE(exchange_read_loop(reader, &read));
    exchange_publish_loop(control, &figures);
    TEST_ASSERT_TRUE(exchange_read_loop(reader, &read));
    TEST_ASSERT_EQUAL_MEMORY(&figures, &read, sizeof(read));
    control->segment->control.loop_sequence |= 1U;
    TEST_ASSERT_FALSE(exchange_read_loop(reader, &read));
}

void test_SWR_LIFE_002_a_replaced_process_is_reported_once(void)
{
    exchange_note_replaced(control, EXCHANGE_IGTL);
    exchange_note_replaced(control, EXCHANGE_IGTL);
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_take_replaced(reader, EXCHANGE_HTTP));
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_take_replaced(reader, EXCHANGE_IGTL));
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_take_replaced(reader, EXCHANGE_IGTL));
}

void test_SWR_HTTP_007_the_port_for_stops_is_noted_for_the_next_run(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_stop_port(reader));
    exchange_note_stop_port(reader, 40000U);
    TEST_ASSERT_EQUAL_UINT32(40000U, exchange_stop_port(control));
}

void test_SWR_EXCH_003_a_checkpoint_request_is_taken_once(void)
{
    TEST_ASSERT_FALSE(exchange_take_checkpoint_request(control));
    exchange_request_checkpoint(reader);
    exchange_request_checkpoint(reader);
    TEST_ASSERT_TRUE(exchange_take_checkpoint_request(control));
    TEST_ASSERT_FALSE(exchange_take_checkpoint_request(control));
}

void test_SWR_PACK_014_a_request_to_end_is_taken_once(void)
{
    TEST_ASSERT_FALSE(exchange_take_end_request(control));
    exchange_request_end(reader);
    exchange_request_end(reader);
    TEST_ASSERT_FALSE(exchange_take_checkpoint_request(control));
    TEST_ASSERT_TRUE(exchange_take_end_request(control));
    TEST_ASSERT_FALSE(exchange_take_end_request(control));
}

void test_SWR_EXCH_003_each_process_beats_its_own_counter(void)
{
    exchange_beat(reader, EXCHANGE_HTTP);
    exchange_beat(reader, EXCHANGE_HTTP);
    exchange_beat(control, EXCHANGE_CONTROL);
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_beats(control, EXCHANGE_HTTP));
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_beats(reader, EXCHANGE_CONTROL));
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_beats(reader, EXCHANGE_SUPERVISOR));
}

void test_SWR_EXCH_003_a_protected_reader_cannot_write_what_control_writes(void)
{
    const pid_t child = fork();
    int status = 0;

    if (child == 0) {
        exchange_protect(reader, EXCHANGE_HTTP);
        exchange_beat(reader, EXCHANGE_IGTL);
        exchange_publish_snapshot(reader, &snapshot); /* Ends this process. */
        _exit(0);
    }
    TEST_ASSERT_EQUAL_INT(child, waitpid(child, &status, 0));
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_beats(control, EXCHANGE_IGTL));
    TEST_ASSERT_FALSE(WIFEXITED(status) && (WEXITSTATUS(status) == 0));
    TEST_ASSERT_FALSE(exchange_read_snapshot(control, &copy));
}

static void expect_refusal(const char *because)
{
    TEST_ASSERT_NULL(exchange_open(exchange_name, error, sizeof(error)));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, because), error);
}

void test_SWR_EXCH_004_a_segment_of_another_layout_is_refused(void)
{
    control->segment->header.layout++;
    expect_refusal("layout of another build");
    control->segment->header.layout--;
    exchange_t *again = exchange_open(exchange_name, error, sizeof(error));
    TEST_ASSERT_NOT_NULL(again);
    exchange_close(again);
}

void test_SWR_EXCH_004_a_segment_of_another_size_is_refused(void)
{
    const segment_header_t header = control->segment->header;
    const off_t sizes[] = {0, (off_t)segment_bytes(LANE) + 1, (off_t)segment_bytes(LANE + 1U),
                           (off_t)segment_bytes(EXCHANGE_CYCLES_MOST) + 1};

    for (size_t i = 0U; i < (sizeof sizes / sizeof sizes[0]); i++) {
        TEST_ASSERT_EQUAL_INT(0, ftruncate(control->file, sizes[i]));
        expect_refusal((i == 0U) ? "size of another build" : "of another build");
        TEST_ASSERT_EQUAL_INT(0, ftruncate(control->file, (off_t)segment_bytes(LANE)));
        control->segment->header = header;
    }
}

void test_SWR_EXCH_004_a_segment_that_is_not_an_exchange_is_refused(void)
{
    control->segment->header.magic = 0U;
    expect_refusal("is not an exchange");
}

void test_SWR_EXCH_004_a_missing_segment_is_refused_with_what_to_do(void)
{
    TEST_ASSERT_NULL(exchange_open("test-exchange-missing", error, sizeof(error)));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "start the program boresight"), error);
    TEST_ASSERT_NULL(exchange_open("a/b", error, sizeof(error)));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "cannot name an exchange"), error);
    TEST_ASSERT_NULL(exchange_create("", 64U, error, sizeof(error)));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "cannot name an exchange"), error);
}

void test_SWR_EXCH_004_the_segment_of_a_living_creator_is_not_replaced(void)
{
    TEST_ASSERT_NULL(exchange_create(exchange_name, 64U, error, sizeof(error)));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "already runs"), error);
}

void test_SWR_EXCH_004_the_segment_of_a_dead_creator_is_replaced(void)
{
    char second[48];
    int status = 0;

    (void)snprintf(second, sizeof(second), "%s-second", exchange_name);
    const pid_t child = fork();
    if (child == 0) {
        exchange_t *dying = exchange_create(second, 64U, error, sizeof(error));
        exchange_publish_snapshot(dying, &snapshot);
        _exit(0);
    }
    TEST_ASSERT_EQUAL_INT(child, waitpid(child, &status, 0));
    TEST_ASSERT_EQUAL_INT(0, status);
    exchange_t *successor = exchange_create(second, 64U, error, sizeof(error));
    TEST_ASSERT_NOT_NULL_MESSAGE(successor, error);
    TEST_ASSERT_FALSE(exchange_read_snapshot(successor, &copy));
    exchange_close(successor);
}

void test_SWR_ROBOT_015_readers_see_the_robot_that_control_drives(void)
{
    const robot_t *const seen = exchange_robot(reader);
    TEST_ASSERT_EQUAL_UINT32(0U, seen->axis_count);
    exchange_publish_robot(control, &robot_neuro);
    TEST_ASSERT_EQUAL_MEMORY(&robot_neuro, seen, sizeof *seen);
}

void test_SWR_ROBOT_015_no_reader_can_change_the_robot(void)
{
    exchange_publish_robot(control, &robot_neuro);
    const pid_t child = fork();
    if (child == 0) {
        exchange_protect(reader, EXCHANGE_HTTP);
        exchange_publish_robot(reader, &robot_neuro); /* Ends this process. */
        _exit(0);
    }
    int status = 0;
    TEST_ASSERT_EQUAL_INT(child, waitpid(child, &status, 0));
    TEST_ASSERT_FALSE(WIFEXITED(status) && (WEXITSTATUS(status) == 0));
    TEST_ASSERT_EQUAL_UINT32(robot_neuro.axis_count, exchange_robot(control)->axis_count);
}

static long faults(void)
{
    struct rusage usage;

    (void)getrusage(RUSAGE_THREAD, &usage);
    return usage.ru_minflt;
}

/* The creator has written each page; the other view has touched none. */
void test_SWR_ARM_007_pages_that_were_touched_are_as_they_were_and_written_without_a_fault(void)
{
    const size_t page = (size_t)sysconf(_SC_PAGESIZE);
    uint8_t *const ours = (uint8_t *)&control->segment->control;
    volatile uint8_t *const theirs = (volatile uint8_t *)&reader->segment->control;

    for (size_t at = 0U; at < sizeof(segment_control_t); at += page) {
        ours[at] = (uint8_t)((at / page) % 251U);
    }
    exchange_touch(reader);
    const long before = faults();
    for (size_t at = 0U; at < sizeof(segment_control_t); at += page) {
        TEST_ASSERT_EQUAL_UINT8((at / page) % 251U, theirs[at]);
        theirs[at] = 0U;
    }
    TEST_ASSERT_EQUAL_INT64(before, faults());
}

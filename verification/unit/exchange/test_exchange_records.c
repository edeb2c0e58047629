/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: events, cycles, rows of trajectories and notes are read whole and in order, and
 * what was overwritten or found no room is counted.
 */
#include "unity.h"

#include "exchange/exchange.h"
#include "exchange/exchange_cycles.h"
#include "exchange/exchange_files.h"
#include "exchange/exchange_notes.h"
#include "exchange/exchange_rows.h"
#include "exchange/exchange_segment.h"

#include "unit/support/exchange_world.h"

#include <pthread.h>
#include <string.h>

void setUp(void)
{
    exchange_world_init();
}

void tearDown(void)
{
    exchange_world_end();
}

#define UTC_US UINT64_C(1790000000000000)

static void push_events(uint32_t from, uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        const event_t event = {.number = from + i, .cycle = (from + i) * 3U, .value = (int32_t)i};
        exchange_push_event(control, &event, UTC_US + from + i);
    }
}

void test_SWR_EXCH_003_events_are_read_in_order_by_several_readers(void)
{
    exchange_event_t events[8];
    uint32_t first = 0U;
    uint32_t second = 0U;
    uint32_t lost = 0U;

    push_events(0U, 5U);
    TEST_ASSERT_EQUAL_UINT32(3U, exchange_read_events(reader, &first, events, 3U, &lost));
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_read_events(reader, &first, events, 3U, &lost));
    TEST_ASSERT_EQUAL_UINT32(4U, events[1].event.number);
    TEST_ASSERT_EQUAL_UINT32(5U, exchange_read_events(reader, &second, events, 8U, &lost));
    TEST_ASSERT_EQUAL_UINT32(0U, events[0].event.number);
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_read_events(reader, &second, events, 8U, &lost));
    TEST_ASSERT_EQUAL_UINT32(0U, lost);
}

void test_SWR_EVENT_013_an_event_is_read_with_the_time_of_its_publication(void)
{
    exchange_event_t event;
    uint32_t next = 1U;
    uint32_t lost = 0U;

    push_events(0U, 2U);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_read_events(reader, &next, &event, 1U, &lost));
    TEST_ASSERT_EQUAL_UINT64(UTC_US + 1U, event.utc_us);
}

void test_SWR_EXCH_020_what_the_recorder_writes_is_known_to_others(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_file(reader, EXCHANGE_FILE_RECORDING));
    exchange_note_file(control, EXCHANGE_FILE_RECORDING, 7U);
    exchange_note_file(control, EXCHANGE_FILE_LOG, 8U);
    exchange_note_file(control, EXCHANGE_FILE_LOG_BEFORE, 6U);
    TEST_ASSERT_EQUAL_UINT32(7U, exchange_file(reader, EXCHANGE_FILE_RECORDING));
    TEST_ASSERT_EQUAL_UINT32(8U, exchange_file(reader, EXCHANGE_FILE_LOG));
    TEST_ASSERT_EQUAL_UINT32(6U, exchange_file(reader, EXCHANGE_FILE_LOG_BEFORE));
}

void test_SWR_EXCH_020_no_level_was_set_before_the_first(void)
{
    exchange_log_level_t level;

    TEST_ASSERT_FALSE(exchange_read_log_level(reader, &level));
}

void test_SWR_EXCH_020_a_level_hides_nothing_critical_and_no_name_writes_a_line(void)
{
    exchange_log_level_t level = {.severity = 1U, .by = "eve"};

    exchange_set_log_level(reader, &level);
    TEST_ASSERT_TRUE(exchange_read_log_level(control, &level));
    TEST_ASSERT_EQUAL_UINT32(1U, level.severity);
    TEST_ASSERT_EQUAL_STRING("eve", level.by);
    level.severity = 9U;
    (void)memset(level.by, 'x', sizeof level.by);
    level.by[1] = '\n';
    level.by[2] = '\x1b';
    exchange_set_log_level(reader, &level);
    TEST_ASSERT_TRUE(exchange_read_log_level(control, &level));
    TEST_ASSERT_EQUAL_UINT32(EVENT_SEVERITY_CRITICAL, level.severity);
    TEST_ASSERT_EQUAL_STRING("x??xxxxxxxxxxxxxxxxxxxxxxxxxxxx", level.by);
    control->segment->others.log_level_seal.sequence |= 1U; /* It died there. */
    TEST_ASSERT_FALSE(exchange_read_log_level(control, &level));
}

void test_SWR_EXCH_003_exactly_a_full_event_ring_loses_nothing_and_one_more_loses_one(void)
{
    static exchange_event_t events[EXCHANGE_EVENTS];
    uint32_t next = 0U;
    uint32_t lost = 0U;

    push_events(0U, EXCHANGE_EVENTS);
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_EVENTS,
                             exchange_read_events(reader, &next, events, EXCHANGE_EVENTS, &lost));
    TEST_ASSERT_EQUAL_UINT32(0U, lost);
    push_events(EXCHANGE_EVENTS, EXCHANGE_EVENTS + 1U);
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_EVENTS,
                             exchange_read_events(reader, &next, events, EXCHANGE_EVENTS, &lost));
    TEST_ASSERT_EQUAL_UINT32(1U, lost);
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_EVENTS + 1U, events[0].event.number);
}

void test_SWR_EXCH_003_an_event_overwritten_while_it_is_read_counts_as_lost(void)
{
    exchange_event_t events[4];
    uint32_t next = 0U;
    uint32_t lost = 0U;

    push_events(0U, 3U);
    control->segment->control.events[1].sequence |= 1U;
    control->segment->control.events[2].event.event.number = 2U + EXCHANGE_EVENTS;
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_read_events(reader, &next, events, 4U, &lost));
    TEST_ASSERT_EQUAL_UINT32(2U, lost);
    TEST_ASSERT_EQUAL_UINT32(3U, next);
}

void test_SWR_EXCH_003_a_reader_ahead_of_the_ring_gets_nothing(void)
{
    exchange_event_t events[4];
    uint32_t next = 10U;
    uint32_t lost = 0U;

    push_events(0U, 3U);
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_read_events(reader, &next, events, 4U, &lost));
    TEST_ASSERT_EQUAL_UINT32(0U, lost);
}

static void *push_many_events(void *unused)
{
    (void)unused;
    push_events(0U, ROUNDS);
    return NULL;
}

void test_SWR_EXCH_003_each_event_is_either_read_or_counted_as_lost(void)
{
    pthread_t writer;
    uint32_t next = 0U;
    uint32_t lost = 0U;
    uint32_t received = 0U;

    TEST_ASSERT_EQUAL_INT(0, pthread_create(&writer, NULL, push_many_events, NULL));
    while (next < ROUNDS) {
        exchange_event_t events[16];
        const uint32_t count = exchange_read_events(reader, &next, events, 16U, &lost);
        for (uint32_t i = 0U; i < count; i++) {
            TEST_ASSERT_EQUAL_UINT32(events[i].event.number * 3U, events[i].event.cycle);
        }
        received += count;
    }
    (void)pthread_join(writer, NULL);
    TEST_ASSERT_EQUAL_UINT32(ROUNDS, received + lost);
}

static controller_t controller;
static controller_outputs_t outputs;
static cycle_record_t checkpoint;
static trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS];

/* In a checkpoint that control pushes now. */
static void note_rows(void)
{
    TEST_ASSERT_TRUE(exchange_push_checkpoint(control, &controller));
    TEST_ASSERT_TRUE(exchange_take_cycle(reader, &checkpoint));
}

/* A cycle in which the list has got so many rows, of a list that was begun in it or before. */
static void come(uint32_t count, bool is_begun)
{
    for (uint32_t i = controller.mode.sealed.list.count; i < count; i++) {
        controller.rows[i].time_ms++;
        controller.rows[i].crc = i;
    }
    controller.mode.sealed.list.count = count;
    outputs.answer_count = 2U;
    outputs.answers[0] = (answer_t){.command = COMMAND_LIST_ROW, .kind = ANSWER_ACCEPTED};
    outputs.answers[1] = (answer_t){.command = is_begun ? COMMAND_LIST_BEGIN : COMMAND_LIST_ROW,
                                    .kind = ANSWER_ACCEPTED};
    exchange_publish_rows(control, &controller, &outputs);
}

void test_SWR_TRAJ_018_of_rows_that_wait_one_is_taken_in_a_cycle(void)
{
    const command_t sent = {.source = (uint32_t)COMMAND_SOURCE_HTTP, .kind = COMMAND_LIST_ROW};
    command_t taken[4];

    for (uint32_t i = 0U; i < 3U; i++) {
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, exchange_send_command(reader, &sent));
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, 4U));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_take_commands(control, taken, 4U));
}

void test_SWR_TRAJ_016_rows_are_there_for_any_checkpoint_after_they_have_come(void)
{
    come(2U, true);
    come(LIMIT_TRAJECTORY_ROWS, false);
    note_rows();
    TEST_ASSERT_EQUAL_UINT32(LIMIT_TRAJECTORY_ROWS, checkpoint.rows);
    TEST_ASSERT_TRUE(exchange_read_rows(reader, &checkpoint, rows));
    TEST_ASSERT_EQUAL_MEMORY(controller.rows, rows, sizeof rows);
}

void test_SWR_TRAJ_016_what_has_come_is_not_looked_at_again(void)
{
    come(3U, true);
    controller.rows[1].crc = 77U; /* Damage is no row that has come. */
    come(4U, false);
    note_rows();
    TEST_ASSERT_TRUE(exchange_read_rows(reader, &checkpoint, rows));
    TEST_ASSERT_EQUAL_UINT32(1U, rows[1].crc);
    TEST_ASSERT_EQUAL_UINT32(3U, rows[3].crc);
}

void test_SWR_TRAJ_016_of_a_list_that_is_replaced_there_are_none_any_more(void)
{
    come(3U, true);
    note_rows();
    come(5U, false);
    TEST_ASSERT_TRUE(exchange_read_rows(reader, &checkpoint, rows)); /* It has only grown. */
    controller.mode.sealed.list.count = 0U;
    come(4U, true);
    TEST_ASSERT_FALSE(exchange_read_rows(reader, &checkpoint, rows));
    note_rows();
    TEST_ASSERT_EQUAL_UINT32(4U, checkpoint.rows);
    TEST_ASSERT_TRUE(exchange_read_rows(reader, &checkpoint, rows));
    TEST_ASSERT_EQUAL_MEMORY(controller.rows, rows, 4U * sizeof rows[0]);
}

void test_SWR_TRAJ_016_a_list_that_is_lost_or_damaged_has_none(void)
{
    come(3U, true);
    note_rows();
    controller.mode.sealed.list.count = UINT32_MAX;
    outputs.answer_count = 0U;
    exchange_publish_rows(control, &controller, &outputs);
    TEST_ASSERT_FALSE(exchange_read_rows(reader, &checkpoint, rows));
    note_rows();
    TEST_ASSERT_EQUAL_UINT32(0U, checkpoint.rows);
    TEST_ASSERT_TRUE(exchange_read_rows(reader, &checkpoint, rows));
    checkpoint.rows = LIMIT_TRAJECTORY_ROWS + 1U;
    TEST_ASSERT_FALSE(exchange_read_rows(reader, &checkpoint, rows));
    controller.mode.sealed.list.count = 0U;
}

void test_SWR_MODE_004_where_a_trajectory_begins_is_read_while_there_is_one(void)
{
    trajectory_row_t start;
    controller.mode.sealed.list.count = 0U;
    come(2U, true);
    TEST_ASSERT_TRUE(exchange_read_start(reader, &start));
    TEST_ASSERT_EQUAL_MEMORY(&controller.rows[0], &start, sizeof start);
    controller.mode.sealed.list.count = 0U;
    outputs.answer_count = 0U;
    exchange_publish_rows(control, &controller, &outputs);
    TEST_ASSERT_FALSE(exchange_read_start(reader, &start));
}

void test_SWR_EXCH_019_the_last_notes_are_kept(void)
{
    exchange_note_t note;

    TEST_ASSERT_FALSE(exchange_read_note(control, 0U, &note));
    TEST_ASSERT_FALSE(exchange_read_note(control, 1U, &note));
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_newest_note(control));
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_write_note(reader, NOTE_LOGIN, "anna", "logged in."));
    TEST_ASSERT_TRUE(exchange_read_note(control, 1U, &note));
    TEST_ASSERT_EQUAL_UINT32(NOTE_LOGIN, note.kind);
    TEST_ASSERT_EQUAL_STRING("anna", note.who);
    TEST_ASSERT_EQUAL_STRING("logged in.", note.text);
    for (uint32_t i = 1U; i < LIMIT_NOTES_KEPT; i++) {
        TEST_ASSERT_EQUAL_UINT32(i + 1U, exchange_write_note(reader, NOTE_LOGOUT, "b", "c"));
    }
    TEST_ASSERT_TRUE(exchange_read_note(control, 1U, &note));
    (void)exchange_write_note(reader, NOTE_LOGOUT, "b", "c");
    TEST_ASSERT_FALSE(exchange_read_note(control, 1U, &note));
    TEST_ASSERT_TRUE(exchange_read_note(control, LIMIT_NOTES_KEPT + 1U, &note));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_NOTES_KEPT + 1U, exchange_newest_note(control));
}

void test_SWR_EXCH_019_a_note_has_its_ends_and_no_control_characters(void)
{
    char letters[EXCHANGE_NOTE_TEXT_SIZE + 1U];
    exchange_note_t note;

    (void)memset(letters, 'x', sizeof letters - 1U);
    letters[sizeof letters - 1U] = '\0';
    (void)exchange_write_note(reader, NOTE_OPERATOR, letters, letters);
    TEST_ASSERT_TRUE(exchange_read_note(control, 1U, &note));
    TEST_ASSERT_EQUAL_size_t(EXCHANGE_NOTE_WHO_SIZE - 1U, strlen(note.who));
    TEST_ASSERT_EQUAL_size_t(EXCHANGE_NOTE_TEXT_SIZE - 1U, strlen(note.text));
    (void)exchange_write_note(reader, NOTE_OPERATOR, "a\nb", "\x1b[2J\x7f\xc3\xa4\r\n");
    TEST_ASSERT_TRUE(exchange_read_note(control, 2U, &note));
    TEST_ASSERT_EQUAL_STRING("a b", note.who);
    TEST_ASSERT_EQUAL_STRING(" [2J \xc3\xa4  ", note.text);
}

void test_SWR_EXCH_019_what_is_not_whole_is_not_handed_over(void)
{
    segment_note_t *slot = &reader->segment->others.notes[1];
    exchange_note_t note;

    (void)exchange_write_note(reader, NOTE_LOGIN, "anna", "logged in.");
    slot->seal.sequence++;
    TEST_ASSERT_FALSE(exchange_read_note(control, 1U, &note));
    slot->seal.sequence++;
    slot->note.text[0] = 'x';
    TEST_ASSERT_FALSE(exchange_read_note(control, 1U, &note));
    (void)exchange_write_note(reader, NOTE_KIND_COUNT, "anna", "logged in.");
    TEST_ASSERT_FALSE(exchange_read_note(control, 2U, &note));
}

void test_SWR_EVENT_010_an_event_is_reported_in_the_words_of_its_note(void)
{
    char text[256];
    event_t event = {.id = EVENT_NOTE, .subject = NOTE_LOGIN, .value = 1};

    TEST_ASSERT_FALSE(exchange_send_note(control, &event, text, sizeof text));
    (void)exchange_write_note(reader, NOTE_LOGIN, "anna", "logged in as operator.");
    (void)exchange_write_note(reader, NOTE_LOGIN_REFUSED, "?", "was refused.");
    (void)exchange_write_note(reader, NOTE_OPERATOR, "anna", "logged out.");
    TEST_ASSERT_TRUE(exchange_send_note(control, &event, text, sizeof text));
    TEST_ASSERT_EQUAL_STRING("anna: logged in as operator.", text);
    event = (event_t){.id = EVENT_LOGIN_REFUSED, .subject = NOTE_LOGIN_REFUSED, .value = 2};
    TEST_ASSERT_TRUE(exchange_send_note(control, &event, text, sizeof text));
    TEST_ASSERT_EQUAL_STRING("?: was refused.", text);
    event = (event_t){.id = EVENT_NOTE, .subject = NOTE_OPERATOR, .value = 3};
    TEST_ASSERT_TRUE(exchange_send_note(control, &event, text, sizeof text));
    TEST_ASSERT_EQUAL_STRING("Note of anna: logged out.", text);
    event.subject = (uint32_t)NOTE_LOGOUT;
    TEST_ASSERT_FALSE(exchange_send_note(control, &event, text, sizeof text));
    event = (event_t){.id = EVENT_AXIS_HOMED, .subject = NOTE_OPERATOR, .value = 3};
    TEST_ASSERT_FALSE(exchange_send_note(control, &event, text, sizeof text));
}

/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: each note of the server comes into the log once, in their order, whatever is
 * refused on the way. */
#include "unity.h"

#include "exchange/exchange.h"
#include "exchange/exchange_notes.h"
#include "exchange/exchange_segment.h"
#include "http/pages/command_client.h"
#include "http/pages/http_notes.h"
#include "http/login/session_store.h"

#include <stdio.h>
#include <unistd.h>

#define COMMANDS 16U
#define REPEATED_AFTER 10U
#define NOW_MS UINT64_C(1000000)

static exchange_t *control;
static exchange_t *server;
static char name[32];
static char error[256];
static command_client_t client;
static http_notes_t notes;
static command_t taken[COMMANDS];
static uint32_t events;

void setUp(void)
{
    (void)snprintf(name, sizeof name, "test-http-notes-%d", (int)getpid());
    control = exchange_create(name, 64U, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(control, error);
    server = exchange_open(name, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(server, error);
    (void)exchange_write_note(server, NOTE_LOGIN, "earlier", "logged in.");
    command_client_init(&client, server);
    http_notes_init(&notes, server, &client);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, COMMANDS));
    events = 0U;
}

void tearDown(void)
{
    exchange_close(server);
    exchange_close(control);
}

/* Ticks, and expects that this note is asked for; 0: none. */
static void expect_asked(uint32_t number)
{
    http_notes_tick(&notes);
    const uint32_t count = exchange_take_commands(control, taken, COMMANDS);
    TEST_ASSERT_EQUAL_UINT32((number != 0U) ? 1U : 0U, count);
    if (number != 0U) {
        TEST_ASSERT_EQUAL_UINT32(COMMAND_NOTE, taken[0].kind);
        TEST_ASSERT_EQUAL_UINT32(0U, taken[0].peer);
        TEST_ASSERT_EQUAL_INT32(number, taken[0].as.note.number);
    }
}

/* Control has an event of what it was asked for last. */
static void log_it(void)
{
    const bool is_refusal = taken[0].as.note.note == (uint32_t)NOTE_LOGIN_REFUSED;
    const event_t event = {.number = events,
                           .id = (uint32_t)(is_refusal ? EVENT_LOGIN_REFUSED : EVENT_NOTE),
                           .subject = taken[0].as.note.note,
                           .value = taken[0].as.note.number};
    exchange_push_event(control, &event, 0U);
    events++;
}

void test_SWR_SESS_020_notes_are_logged_one_after_the_other(void)
{
    expect_asked(0U);
    http_notes_write(&notes, NOTE_LOGIN, "anna", "logged in.");
    http_notes_write(&notes, NOTE_LOGIN_REFUSED, "bert", "login refused.");
    expect_asked(2U);
    TEST_ASSERT_EQUAL_UINT32(NOTE_LOGIN, taken[0].as.note.note);
    expect_asked(0U);
    log_it();
    expect_asked(3U);
    TEST_ASSERT_EQUAL_UINT32(NOTE_LOGIN_REFUSED, taken[0].as.note.note);
    log_it();
    expect_asked(0U);
}

void test_SWR_SESS_020_what_a_stop_has_refused_is_asked_for_again(void)
{
    http_notes_write(&notes, NOTE_LOGOUT, "anna", "logged out.");
    expect_asked(2U);
    for (uint32_t i = 1U; i < REPEATED_AFTER; i++) {
        expect_asked(0U);
    }
    expect_asked(2U);
    log_it();
    expect_asked(0U);
}

void test_SWR_LIFE_002_who_was_replaced_is_logged_once(void)
{
    exchange_note_t note;
    http_notes_report_replaced(&notes);
    expect_asked(0U);
    exchange_note_replaced(control, EXCHANGE_IGTL);
    http_notes_report_replaced(&notes);
    http_notes_report_replaced(&notes);
    expect_asked(2U);
    TEST_ASSERT_EQUAL_UINT32(NOTE_REPLACED, taken[0].as.note.note);
    TEST_ASSERT_TRUE(exchange_read_note(server, 2U, &note));
    TEST_ASSERT_EQUAL_STRING("igtl", note.who);
    TEST_ASSERT_EQUAL_STRING("gave no sign of life for 10 s and was replaced, 1 time.", note.text);
    log_it();
    expect_asked(0U);
}

static void damage_lane(void)
{
    control->segment->others.lanes[COMMAND_SOURCE_IGTL].head += 100U;
    TEST_ASSERT_EQUAL_UINT32(0U, exchange_take_commands(control, taken, COMMANDS));
}

static void expect_damage(uint32_t number, const char *text)
{
    exchange_note_t note;
    expect_asked(number);
    TEST_ASSERT_EQUAL_UINT32(NOTE_DAMAGED, taken[0].as.note.note);
    TEST_ASSERT_TRUE(exchange_read_note(server, number, &note));
    TEST_ASSERT_EQUAL_STRING("igtl", note.who);
    TEST_ASSERT_EQUAL_STRING(text, note.text);
    log_it();
}

void test_SWR_EXCH_024_a_damaged_lane_is_reported_at_once_and_then_in_sums(void)
{
    http_notes_report_damage(&notes, NOW_MS);
    expect_asked(0U);
    damage_lane();
    http_notes_report_damage(&notes, NOW_MS);
    expect_damage(2U, "command lane damaged 1 time since the start; commands in it were dropped.");
    damage_lane();
    damage_lane();
    http_notes_report_damage(&notes, NOW_MS + LIMIT_DAMAGE_PAUSE_MS - 1U);
    expect_asked(0U);
    http_notes_report_damage(&notes, NOW_MS + LIMIT_DAMAGE_PAUSE_MS);
    expect_damage(3U, "command lane damaged 3 times since the start; commands in it were dropped.");
    http_notes_report_damage(&notes, NOW_MS + (2U * LIMIT_DAMAGE_PAUSE_MS));
    expect_asked(0U);
}

void test_SWR_EXCH_024_a_note_of_damage_that_was_damaged_itself_is_written_again(void)
{
    damage_lane();
    http_notes_report_damage(&notes, NOW_MS);
    control->segment->others.notes[2].note.text[0] = 'x';
    expect_asked(0U);
    http_notes_report_damage(&notes, NOW_MS + LIMIT_DAMAGE_PAUSE_MS);
    expect_damage(3U, "command lane damaged 1 time since the start; commands in it were dropped.");
    http_notes_report_damage(&notes, NOW_MS + (2U * LIMIT_DAMAGE_PAUSE_MS));
    expect_asked(0U);
}

void test_SWR_SESS_020_what_is_overwritten_is_passed_over(void)
{
    for (uint32_t i = 0U; i <= LIMIT_NOTES_KEPT; i++) {
        http_notes_write(&notes, NOTE_LOGOUT, "anna", "logged out.");
    }
    expect_asked(0U);
    expect_asked(3U);
}

void test_SWR_EVENT_012_what_somebody_wrote_is_logged_by_who_asks(void)
{
    TEST_ASSERT_EQUAL_UINT32(2U, http_notes_keep(&notes, "anna", "Turned.", NOW_MS));
    http_notes_write(&notes, NOTE_LOGOUT, "anna", "logged out.");
    expect_asked(0U);
    expect_asked(3U);
}

void test_SWR_EVENT_012_somebody_writes_one_note_in_a_while(void)
{
    TEST_ASSERT_EQUAL_UINT32(2U, http_notes_keep(&notes, "anna", "One.", NOW_MS));
    TEST_ASSERT_EQUAL_UINT32(
        0U, http_notes_keep(&notes, "bert", "Two.", NOW_MS + LIMIT_NOTE_PAUSE_MS - 1U));
    TEST_ASSERT_EQUAL_UINT32(3U,
                             http_notes_keep(&notes, "bert", "Two.", NOW_MS + LIMIT_NOTE_PAUSE_MS));
}

void test_SWR_HTTP_038_who_orders_faster_than_is_logged_is_seen(void)
{
    for (uint32_t i = 0U; i < LIMIT_NOTES_KEPT / 2U; i++) {
        http_notes_write(&notes, NOTE_BOX, "anna", "ordered of the simulated box: scanner on.");
    }
    TEST_ASSERT_FALSE(http_notes_are_behind(&notes));
    http_notes_write(&notes, NOTE_BOX, "anna", "ordered of the simulated box: scanner on.");
    TEST_ASSERT_TRUE(http_notes_are_behind(&notes));
    expect_asked(2U);
    log_it();
    expect_asked(3U);
    TEST_ASSERT_FALSE(http_notes_are_behind(&notes));
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: whatever a neighbour has written into the part of the segment that every process
 * may write, nothing is carried out that no process has sent, and once it has gone all works again,
 * whether the other processes live on or were started anew. The fields that may be written are in
 * the table that is made from the segment's declaration.
 */
#include "unity.h"

#include "exchange/exchange.h"
#include "exchange/exchange_files.h"
#include "exchange/exchange_notes.h"
#include "exchange/exchange_peers.h"
#include "exchange/exchange_segment.h"
#include "interface/segment_fields.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define WORDS_OF_EACH 24U /* Singly, of the first and of the last element. */
#define ROUNDS_OF_EACH 40U
#define ROUNDS_OF_ALL 400U

typedef struct {
    const char *name;
    size_t place;
    size_t size;
    size_t count;
} field_t;

#define FIELD(name, count)                                                                         \
    {#name, offsetof(segment_others_t, name), sizeof(((segment_others_t *)NULL)->name), (count)},
static const field_t fields[] = {SEGMENT_OTHERS_FIELDS(FIELD)};
#define FIELDS (sizeof fields / sizeof fields[0])

static const uint32_t extremes[] = {0U, 1U, 0x80000000U, UINT32_MAX};
#define EXTREMES (sizeof extremes / sizeof extremes[0])

static char name[32];
static char error[256];
static exchange_t *control;
static exchange_t *igtl;
static exchange_t *http;
static exchange_t *recorder;
static uint32_t next_event;
static uint32_t command_id;
static uint64_t chance;
static char scene[96];

static exchange_t *open_one(void)
{
    exchange_t *opened = exchange_open(name, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(opened, error);
    return opened;
}

static void open_all(void)
{
    igtl = open_one();
    http = open_one();
    recorder = open_one();
}

static void close_all(void)
{
    exchange_close(igtl);
    exchange_close(http);
    exchange_close(recorder);
}

void setUp(void)
{
    (void)snprintf(name, sizeof name, "test-exchange-damage-%d", (int)getpid());
    control = exchange_create(name, 64U, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(control, error);
    open_all();
    next_event = 0U;
    command_id = 0U;
    chance = UINT64_C(88172645463325252);
}

void tearDown(void)
{
    close_all();
    exchange_close(control);
}

static uint32_t random_word(void)
{
    chance ^= chance << 13U;
    chance ^= chance >> 7U;
    chance ^= chance << 17U;
    return (uint32_t)(chance >> 16U);
}

/* --- what is done with an exchange, and how it is when it works --- */

static void answer(const command_t *command)
{
    const answer_t accepted = {.id = command->id,
                               .source = command->source,
                               .command = command->kind,
                               .asked = command->as.workphase.workphase,
                               .kind = (uint32_t)ANSWER_ACCEPTED,
                               .workphase = command->as.workphase.workphase};
    (void)exchange_push_answer(control, &accepted);
}

static void check_command(exchange_t *asker, command_source_t source, workphase_t workphase)
{
    const command_t command = {.id = ++command_id,
                               .source = (uint32_t)source,
                               .kind = (uint32_t)COMMAND_WORKPHASE,
                               .as.workphase = {.workphase = (uint32_t)workphase}};
    command_t taken[2];
    answer_t reported;

    TEST_ASSERT_EQUAL_MESSAGE(STATUS_OK, exchange_send_command(asker, &command), scene);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(1U, exchange_take_commands(control, taken, 2U), scene);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&command, &taken[0], sizeof command, scene);
    TEST_ASSERT_FALSE_MESSAGE(exchange_take_answer(asker, source, &reported), scene);
    answer(&taken[0]);
    TEST_ASSERT_TRUE_MESSAGE(exchange_take_answer(asker, source, &reported), scene);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(command.id, reported.id, scene);
    TEST_ASSERT_FALSE_MESSAGE(exchange_take_answer(asker, source, &reported), scene);
}

static void check_stop(workphase_t workphase)
{
    const uint32_t number = exchange_request_stop(http, workphase);
    command_t taken[2];
    answer_t reported;

    TEST_ASSERT_FALSE_MESSAGE(exchange_read_stop_answer(http, number, &reported), scene);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(1U, exchange_take_commands(control, taken, 2U), scene);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(workphase, taken[0].as.workphase.workphase, scene);
    answer(&taken[0]);
    TEST_ASSERT_TRUE_MESSAGE(exchange_read_stop_answer(http, number, &reported), scene);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(workphase, reported.workphase, scene);
}

static void check_note(void)
{
    exchange_note_t note;
    const uint32_t newest = exchange_newest_note(http);
    const uint32_t number = exchange_write_note(http, NOTE_OPERATOR, "anna", "Turned.");

    TEST_ASSERT_EQUAL_UINT32_MESSAGE(newest + 1U, number, scene);
    TEST_ASSERT_TRUE_MESSAGE(exchange_read_note(control, number, &note), scene);
    TEST_ASSERT_EQUAL_STRING_MESSAGE("Turned.", note.text, scene);
}

static void check_order(void)
{
    const exchange_order_t order = {
        .kind = (uint32_t)EXCHANGE_ORDER_KEEP_ALIVE, .number = 21U, .is_on = 1U};
    exchange_order_t taken;
    status_t status = STATUS_BUSY;
    const uint32_t id = exchange_give_order(http, &order);

    TEST_ASSERT_FALSE_MESSAGE(exchange_read_order_answer(http, id, &status), scene);
    TEST_ASSERT_TRUE_MESSAGE(exchange_take_order(igtl, &taken), scene);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(21U, taken.number, scene);
    exchange_answer_order(igtl, &taken, STATUS_OK);
    TEST_ASSERT_FALSE_MESSAGE(exchange_take_order(igtl, &taken), scene);
    TEST_ASSERT_TRUE_MESSAGE(exchange_read_order_answer(http, id, &status), scene);
    TEST_ASSERT_EQUAL_MESSAGE(STATUS_OK, status, scene);
}

static void check_tables(void)
{
    static const exchange_ports_t ports = {.count = 1U, .ports = {{.name = "slicer"}}};
    static const exchange_peers_t peers = {.count = 1U, .peers = {{.number = 21U}}};
    static const exchange_log_level_t level = {.severity = 1U, .by = "eve"};
    exchange_ports_t read_ports;
    exchange_peers_t read_peers;
    exchange_log_level_t read_level;

    exchange_publish_ports(igtl, &ports);
    exchange_publish_peers(igtl, COMMAND_SOURCE_IGTL, &peers);
    exchange_publish_peers(http, COMMAND_SOURCE_HTTP, &peers);
    exchange_set_log_level(http, &level);
    TEST_ASSERT_TRUE_MESSAGE(exchange_read_ports(http, &read_ports), scene);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&ports, &read_ports, sizeof ports, scene);
    for (uint32_t i = 0U; i < COMMAND_SOURCE_COUNT; i++) {
        TEST_ASSERT_TRUE_MESSAGE(exchange_read_peers(http, (command_source_t)i, &read_peers),
                                 scene);
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&peers, &read_peers, sizeof peers, scene);
    }
    TEST_ASSERT_TRUE_MESSAGE(exchange_read_log_level(recorder, &read_level), scene);
    TEST_ASSERT_EQUAL_MEMORY_MESSAGE(&level, &read_level, sizeof level, scene);
}

static void check_numbers(void)
{
    for (uint32_t i = 0U; i < EXCHANGE_FILES; i++) {
        exchange_note_file(recorder, (exchange_file_t)i, 7U + i);
        TEST_ASSERT_EQUAL_UINT32_MESSAGE(7U + i, exchange_file(http, (exchange_file_t)i), scene);
    }
    exchange_note_logged(recorder, next_event);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(next_event, exchange_logged(recorder), scene);
    exchange_note_stop_port(http, 40000U);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(40000U, exchange_stop_port(http), scene);
    for (uint32_t i = 0U; i < EXCHANGE_PROCESS_COUNT; i++) {
        const exchange_process_t process = (exchange_process_t)i;
        const uint32_t beats = exchange_beats(control, process);
        exchange_beat(recorder, process);
        TEST_ASSERT_NOT_EQUAL_UINT32_MESSAGE(beats, exchange_beats(control, process), scene);
        exchange_note_replaced(recorder, process);
        TEST_ASSERT_EQUAL_UINT32_MESSAGE(1U, exchange_take_replaced(http, process), scene);
    }
}

static void check_requests(void)
{
    TEST_ASSERT_FALSE_MESSAGE(exchange_take_checkpoint_request(control), scene);
    exchange_request_checkpoint(recorder);
    TEST_ASSERT_TRUE_MESSAGE(exchange_take_checkpoint_request(control), scene);
    TEST_ASSERT_FALSE_MESSAGE(exchange_take_end_request(control), scene);
    exchange_request_end(http);
    TEST_ASSERT_TRUE_MESSAGE(exchange_take_end_request(control), scene);
    TEST_ASSERT_FALSE_MESSAGE(exchange_take_end_request(control), scene);
}

static void check_event(void)
{
    const event_t event = {.number = next_event, .id = (uint32_t)EVENT_ESTOP_PULLED};
    exchange_event_t read;
    uint32_t next = next_event;
    uint32_t lost = 0U;

    exchange_push_event(control, &event, 0U);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(1U, exchange_read_events(http, &next, &read, 1U, &lost),
                                     scene);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(next_event, read.event.number, scene);
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, lost, scene);
    next_event++;
}

static void check_all(void)
{
    check_command(igtl, COMMAND_SOURCE_IGTL, WORKPHASE_START_UP);
    check_command(http, COMMAND_SOURCE_HTTP, WORKPHASE_START_UP);
    check_stop(WORKPHASE_STOP);
    check_stop(WORKPHASE_EMERGENCY);
    check_command(igtl, COMMAND_SOURCE_IGTL, WORKPHASE_STOP);
    check_note();
    check_order();
    check_tables();
    check_numbers();
    check_requests();
    check_event();
}

/* --- damage, and what the processes do in a turn --- */

/* Nothing of what lies about from before is carried out or believed: a stop is, which does no harm.
 */
static void check_turn(void)
{
    command_t taken[4];
    answer_t reported;
    exchange_order_t order;

    for (uint32_t i = 0U; i < 2U; i++) {
        const uint32_t count = exchange_take_commands(control, taken, 4U);
        for (uint32_t j = 0U; j < count; j++) {
            TEST_ASSERT_EQUAL_UINT32_MESSAGE(COMMAND_WORKPHASE, taken[j].kind, scene);
            TEST_ASSERT_GREATER_OR_EQUAL_UINT32_MESSAGE(WORKPHASE_STOP,
                                                        taken[j].as.workphase.workphase, scene);
            TEST_ASSERT_EQUAL_UINT32_MESSAGE(COMMAND_SOURCE_HTTP, taken[j].source, scene);
            answer(&taken[j]);
        }
        TEST_ASSERT_FALSE_MESSAGE(exchange_take_answer(igtl, COMMAND_SOURCE_IGTL, &reported),
                                  scene);
        TEST_ASSERT_FALSE_MESSAGE(exchange_take_answer(http, COMMAND_SOURCE_HTTP, &reported),
                                  scene);
        TEST_ASSERT_FALSE_MESSAGE(exchange_take_end_request(control), scene);
        (void)exchange_take_checkpoint_request(control);
    }
    for (uint32_t i = 0U; i < EXCHANGE_PROCESS_COUNT; i++) {
        TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, exchange_take_replaced(http, (exchange_process_t)i),
                                         scene);
    }
    if (exchange_take_order(igtl, &order)) { /* That of before, after a restart. */
        TEST_ASSERT_EQUAL_UINT32_MESSAGE(21U, order.number, scene);
        exchange_answer_order(igtl, &order, STATUS_NO_ANSWER);
    }
    TEST_ASSERT_FALSE_MESSAGE(exchange_take_order(igtl, &order), scene);
}

/* The note, or nothing. */
static void check_believed(void)
{
    for (uint32_t i = 0U; i < EXCHANGE_FILES; i++) {
        const uint32_t file = exchange_file(http, (exchange_file_t)i);
        TEST_ASSERT_TRUE_MESSAGE((file == 0U) || (file == (7U + i)), scene);
    }
    const uint32_t port = exchange_stop_port(http);
    TEST_ASSERT_TRUE_MESSAGE((port == 0U) || (port == 40000U), scene);
    const uint32_t logged = exchange_logged(recorder);
    TEST_ASSERT_TRUE_MESSAGE((logged == 0U) || (logged == (next_event - 1U)), scene);
}

static void overwrite(const field_t *field, size_t place, uint32_t word)
{
    unsigned char *bytes = (unsigned char *)&control->segment->others;

    (void)memcpy(&bytes[field->place + place], &word, sizeof word);
}

static void go_on(void)
{
    check_turn();
    check_believed();
    check_all();
}

static void go_on_anew(void)
{
    close_all();
    open_all();
    go_on();
}

static void each_field(void (*go)(const field_t *field))
{
    check_all();
    for (size_t i = 0U; i < FIELDS; i++) {
        go(&fields[i]);
    }
}

static void damage_word(const field_t *field, size_t place)
{
    for (size_t i = 0U; i < EXTREMES; i++) {
        (void)snprintf(scene, sizeof scene, "%s, byte %zu, 0x%08X", field->name, place,
                       (unsigned)extremes[i]);
        overwrite(field, place, extremes[i]);
        go_on();
        overwrite(field, place, extremes[i]);
        go_on_anew();
    }
}

static void damage_words(const field_t *field)
{
    const size_t element = field->size / field->count;
    const size_t words = element / sizeof(uint32_t);

    for (size_t i = 0U; (i < words) && (i < WORDS_OF_EACH); i++) {
        damage_word(field, i * sizeof(uint32_t));
        if (field->count > 1U) {
            damage_word(field, (field->size - element) + (i * sizeof(uint32_t)));
        }
    }
}

static void damage_whole(const field_t *field)
{
    for (size_t i = 0U; i < EXTREMES; i++) {
        for (size_t anew = 0U; anew < 2U; anew++) {
            (void)snprintf(scene, sizeof scene, "%s, all of it 0x%08X", field->name,
                           (unsigned)extremes[i]);
            for (size_t place = 0U; place < field->size; place += sizeof(uint32_t)) {
                overwrite(field, place, extremes[i]);
            }
            ((anew == 1U) ? go_on_anew : go_on)();
        }
    }
}

static void damage_by_chance(const field_t *field)
{
    for (uint32_t i = 0U; i < ROUNDS_OF_EACH; i++) {
        (void)snprintf(scene, sizeof scene, "%s, round %u", field->name, (unsigned)i);
        for (size_t place = 0U; place < field->size; place += sizeof(uint32_t)) {
            overwrite(field, place, random_word());
        }
        (((i % 2U) == 1U) ? go_on_anew : go_on)();
    }
}

void test_SWR_EXCH_022_each_word_of_each_field_may_hold_an_extreme(void)
{
    each_field(damage_words);
}

void test_SWR_EXCH_022_each_field_may_hold_an_extreme(void)
{
    each_field(damage_whole);
}

void test_SWR_EXCH_022_each_field_may_hold_anything(void)
{
    each_field(damage_by_chance);
}

/* An index near to what it was is worse than one far away. */
void test_SWR_EXCH_021_an_index_may_be_a_little_wrong(void)
{
    check_all();
    for (uint32_t by = 0U; by < (4U * EXCHANGE_ANSWERS); by++) {
        for (uint32_t lane = 0U; lane < COMMAND_SOURCE_COUNT; lane++) {
            (void)snprintf(scene, sizeof scene, "lane %u by %u", (unsigned)lane, (unsigned)by);
            control->segment->others.lanes[lane].head += by - (2U * EXCHANGE_ANSWERS);
            control->segment->others.answered[lane].tail += by - (2U * EXCHANGE_ANSWERS);
            for (uint32_t i = 0U; i < (SEGMENT_COMMANDS / 4U); i++) {
                command_t taken[4];
                TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, exchange_take_commands(control, taken, 4U),
                                                 scene);
            }
            (((by % 2U) == 1U) ? go_on_anew : go_on)();
        }
    }
}

static void damage_all(void)
{
    const uint32_t kind = random_word() % (EXTREMES + 2U);
    const size_t every = (random_word() % 3U == 0U) ? 1U : (1U + (random_word() % 200U));

    for (size_t i = 0U; i < FIELDS; i++) {
        for (size_t place = 0U; place < fields[i].size; place += sizeof(uint32_t)) {
            if ((random_word() % every) == 0U) {
                overwrite(&fields[i], place, (kind < EXTREMES) ? extremes[kind] : random_word());
            }
        }
    }
}

void test_SWR_EXCH_022_all_fields_may_hold_anything_at_once(void)
{
    check_all();
    for (uint32_t i = 0U; i < ROUNDS_OF_ALL; i++) {
        (void)snprintf(scene, sizeof scene, "round %u", (unsigned)i);
        damage_all();
        ((random_word() % 2U == 0U) ? go_on_anew : go_on)();
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
/** @file The board support of the simulated control box: bsp.h at the control end of its wire. */
#include "bsp.h"

#include "limits/requirement_limits.h"
#include "sim/wire.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

/* Samples in a row without a sign of life after which the inputs are not believed. */
#define STALE_SAMPLES 10U
#define NS_PER_US UINT64_C(1000)
#define NS_PER_S UINT64_C(1000000000)

static wire_port_t port;
static box_time_t board_time;
static uint32_t last_beat;
static uint32_t beat_age;
static uint64_t elastic_us; /* Elastic time as control lives in it. */
static uint64_t paced_ns;   /* When, in the world's time, the last sleep was to end. */
static bool was_answered;
static bsp_exchange_t begun; /* As it is without any answer. */
static bool is_begun;        /* It went to the box, and was not ended. */

static void identify(bsp_identity_t *identity)
{
    const wire_t *wire = port.wire;

    *identity =
        (bsp_identity_t){.board = "sim",
                         .abilities = BSP_HAS_EDGE_LATCH | BSP_HAS_DRIVES_OFF | BSP_HAS_LAMPS,
                         .power_on = wire_load(&wire->power_on),
                         .was_used = wire_load(&wire->is_used) != 0U,
                         .robot_crc = wire_load(&wire->robot_crc),
                         .is_elastic = board_time.is_elastic,
                         .is_simulated = true,
                         .slowness = board_time.slowness,
                         .speedup = board_time.speedup,
                         .sample_error_us = LIMIT_SAMPLE_ERROR_SIM_US};
}

bool bsp_open(const char *address, bsp_identity_t *identity, char *error, uint32_t error_size)
{
    if (!wire_attach(&port, address, WIRE_END_CONTROL, error, error_size)) {
        return false;
    }
    last_beat = wire_load(&port.wire->beat);
    beat_age = 0U;
    board_time = (box_time_t){.is_elastic = wire_load(&port.wire->is_elastic) != 0U,
                              .slowness = wire_load(&port.wire->slowness),
                              .speedup = wire_load(&port.wire->speedup)};
    elastic_us = wire_load_time(port.wire);
    paced_ns = wire_now_ns();
    was_answered = true;
    is_begun = false;
    begun = (bsp_exchange_t){0};
    identify(identity);
    wire_store(&port.wire->is_off, 0U);
    wire_store(&port.wire->openings, wire_load(&port.wire->openings) + 1U);
    return true;
}

/*
 * In elastic time no side is late, and the box may take long: it is given up after so many looks,
 * of which a pause of the machine is one. A box that was given up is not waited for any longer than
 * in real time.
 */
static bool await_patiently(const uint32_t *word, uint32_t number)
{
    const uint32_t timeout_us = LIMIT_EXCHANGE_TIMEOUT_US;
    const uint32_t looks = was_answered ? ((LIMIT_ELASTIC_ANSWER_CLOCK_US / timeout_us) + 1U) : 1U;
    bool is_answered = false;

    for (uint32_t i = 0U; (i < looks) && !is_answered; i++) {
        is_answered = wire_await(word, number, timeout_us);
    }
    was_answered = is_answered;
    return is_answered;
}

static bool await_reply(uint64_t deadline_ns)
{
    const uint32_t number = wire_load(&port.wire->request);

    if (board_time.is_elastic) {
        return await_patiently(&port.wire->reply, number);
    }
    const uint64_t now_ns = bsp_now_ns();
    const uint64_t left_us = (deadline_ns > now_ns) ? ((deadline_ns - now_ns) / NS_PER_US) : 0U;
    return wire_await(&port.wire->reply, number, (uint32_t)(left_us * board_time.slowness));
}

static void set_results(uint32_t slots, bsp_slot_result_t result)
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if ((slots & (1U << slot)) != 0U) {
            begun.results[slot] = (uint8_t)result;
        }
    }
}

static void ask(uint32_t send, const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES])
{
    wire_t *wire = port.wire;

    wire->send = send;
    wire->wanted_us = elastic_us;
    (void)memcpy(wire->frames, frames, sizeof wire->frames);
    wire_store(&wire->request, wire_load(&wire->request) + 1U);
    if (board_time.speedup == 1U) { /* Else the box is woken once in a cycle, by the call. */
        wire_wake_box(wire);
    }
}

static void begin(uint32_t send, const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES])
{
    begun = (bsp_exchange_t){.started_ns = bsp_now_ns()};
    is_begun = wire_load(&port.wire->request) == wire_load(&port.wire->reply);
    set_results(send, is_begun ? BSP_SLOT_LATE : BSP_SLOT_NOT_IDLE);
    if (is_begun) {
        ask(send, frames);
    }
}

void bsp_start(uint32_t send, const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES])
{
    wire_store(&port.wire->is_used, 1U);
    begin(send, frames);
}

static void collect(uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES])
{
    const wire_t *wire = port.wire;
    const uint32_t answered = wire->received & wire->send;

    set_results(wire->send, BSP_SLOT_NO_ANSWER);
    set_results(answered, BSP_SLOT_OK);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if ((answered & (1U << slot)) != 0U) {
            (void)memcpy(received[slot], wire->replies[slot], CARD_FRAME_BYTES);
            begun.sampled_ns[slot] = wire->replied_us * NS_PER_US;
        }
    }
    begun.received = answered;
    begun.finished_ns = wire->replied_us * NS_PER_US;
}

static void finish(bool is_answered, uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                   bsp_exchange_t *result)
{
    if (is_answered) {
        collect(received);
    }
    *result = begun;
    begun = (bsp_exchange_t){0};
    is_begun = false;
}

void bsp_finish(uint64_t deadline_ns, uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                bsp_exchange_t *result)
{
    if (begun.started_ns != 0U) {
        begun.finished_ns = deadline_ns;
    }
    finish(is_begun && await_reply(deadline_ns), received, result);
}

static bool is_frame_begun(const uint8_t bytes[CARD_FRAME_BYTES])
{
    const uint32_t word = ((uint32_t)bytes[0] << 24U) | ((uint32_t)bytes[1] << 16U) |
                          ((uint32_t)bytes[2] << 8U) | bytes[3];
    return word == CARD_FRAME_START;
}

static uint32_t encode_off(uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES])
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        const card_command_t off = {.slot = slot, .axis_id = CARD_NO_AXIS};
        card_frame_encode_command(&off, frames[slot]);
    }
    return (1U << CARD_SLOT_COUNT) - 1U;
}

/*
 * A card ignores the frames: their sequence does not continue any. So they clear no fault, and
 * nothing has moved by them. No cycle waits for the answer yet: a pause of the machine before it is
 * no fault of the box, in real time neither.
 */
bool bsp_self_test(char *error, uint32_t error_size)
{
    uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
    uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
    bsp_exchange_t result;

    begin(encode_off(frames), (const uint8_t(*)[CARD_FRAME_BYTES])frames);
    finish(is_begun && await_patiently(&port.wire->reply, wire_load(&port.wire->request)), received,
           &result);
    if (result.results[0] > (uint8_t)BSP_SLOT_NO_ANSWER) {
        (void)snprintf(error, error_size,
                       "the simulated control box does not exchange frames; start it again.");
        return false;
    }
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (((result.received & (1U << slot)) != 0U) && !is_frame_begun(received[slot])) {
            (void)snprintf(error, error_size,
                           "the card in slot %u does not answer with a frame; start the simulated "
                           "control box again.",
                           (unsigned)slot);
            return false;
        }
    }
    return true;
}

void bsp_sample_inputs(bsp_inputs_t *inputs)
{
    const uint32_t beat = wire_load(&port.wire->beat);

    *inputs = (bsp_inputs_t){.sampled_ns = bsp_now_ns(),
                             .levels = wire_load(&port.wire->inputs),
                             .dropped = wire_take(&port.wire->dropped),
                             .valid = BSP_IN_ALL};
    /* Counted in samples, not in time: when the whole machine pauses, nothing grows old. */
    beat_age = (beat == last_beat) ? (beat_age + 1U) : 0U;
    last_beat = beat;
    if (beat_age >= STALE_SAMPLES) {
        beat_age = STALE_SAMPLES;
        *inputs = (bsp_inputs_t){.sampled_ns = inputs->sampled_ns};
    }
}

void bsp_set_lamps(uint32_t lamps)
{
    wire_store(&port.wire->lamps, lamps);
}

void bsp_drives_off(void)
{
    if (port.wire != NULL) {
        wire_store(&port.wire->is_off, 1U);
        wire_wake_box(port.wire);
    }
}

void bsp_kick(void)
{
    /* The box has no watchdog but those of its cards. */
}

uint64_t bsp_now_ns(void)
{
    return board_time.is_elastic ? (elastic_us * NS_PER_US) : (wire_now_ns() / board_time.slowness);
}

uint64_t bsp_reached_ns(void)
{
    return wire_load_time(port.wire) * NS_PER_US;
}

static void sleep_until_world_ns(uint64_t world_ns)
{
    const struct timespec deadline = {.tv_sec = (time_t)(world_ns / NS_PER_S),
                                      .tv_nsec = (long)(world_ns % NS_PER_S)};

    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, NULL) == EINTR) {
    }
}

/* While control sleeps, the box exchanges what was begun at the time before and comes to the next
 * one. */
static uint32_t call_box(uint64_t time_us)
{
    wire_t *wire = port.wire;
    const uint32_t number = wire_load(&wire->call) + 1U;

    wire->called_us = time_us;
    wire_store(&wire->call, number);
    wire_wake_box(wire);
    return number;
}

/* The world's clock only sets the pace. A call more than one sleep late begins anew: time never
 * hurries to catch up. */
static void keep_pace(uint64_t sleep_ns)
{
    const uint64_t now_ns = wire_now_ns();

    paced_ns += sleep_ns;
    paced_ns = ((paced_ns + sleep_ns) < now_ns) ? now_ns : paced_ns;
    if (paced_ns > now_ns) {
        sleep_until_world_ns(paced_ns);
    }
}

/** @satisfies SWR-BOX-040 */
static void sleep_elastic(uint64_t deadline_us)
{
    if (deadline_us > elastic_us) {
        const uint32_t number = call_box(deadline_us);
        keep_pace(((deadline_us - elastic_us) * NS_PER_US * board_time.slowness) /
                  wire_pace(port.wire));
        (void)await_patiently(&port.wire->come, number);
        elastic_us = deadline_us;
    }
    /* A box that was left alone has gone on. */
    const uint64_t box_us = wire_load_time(port.wire);
    elastic_us = (box_us > elastic_us) ? box_us : elastic_us;
}

void bsp_sleep_until_ns(uint64_t deadline_ns)
{
    if (board_time.is_elastic) {
        sleep_elastic(deadline_ns / NS_PER_US);
    } else {
        sleep_until_world_ns(deadline_ns * board_time.slowness);
    }
}

void bsp_stand_still_ns(uint64_t world_ns)
{
    const struct timespec nap = {.tv_sec = (time_t)(world_ns / NS_PER_S),
                                 .tv_nsec = (long)(world_ns % NS_PER_S)};

    wire_store(&port.wire->waits, wire_load(&port.wire->waits) + 1U);
    (void)clock_nanosleep(CLOCK_MONOTONIC, 0, &nap, NULL);
}

void bsp_close(void)
{
    wire_close(&port, WIRE_END_CONTROL);
}

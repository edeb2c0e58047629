/* SPDX-License-Identifier: Apache-2.0 */
/** @file The board support of the simulated control box: bsp.h at the control end of its wire. */
#include "bsp.h"

#include "limits/requirement_limits.h"
#include "sim/wire.h"

#include <errno.h>
#include <string.h>
#include <time.h>

/* Samples in a row without a sign of life after which the inputs are not believed. */
#define STALE_SAMPLES 10U
#define NS_PER_US UINT64_C(1000)
#define NS_PER_S UINT64_C(1000000000)

static wire_port_t port;
static bsp_time_t board_time;
static bsp_power_on_t power_on;
static uint32_t last_beat;
static uint32_t beat_age;
static uint64_t elastic_us; /* Elastic time as control lives in it. */
static uint64_t paced_ns;   /* When, in the world's time, the last sleep was to end. */
static bool was_answered;

bool bsp_open(const char *name, char *error, uint32_t error_size)
{
    if (!wire_attach(&port, name, WIRE_END_CONTROL, error, error_size)) {
        return false;
    }
    last_beat = wire_load(&port.wire->beat);
    beat_age = 0U;
    board_time = (bsp_time_t){.is_elastic = wire_load(&port.wire->is_elastic) != 0U,
                              .slowness = wire_load(&port.wire->slowness)};
    power_on = (bsp_power_on_t){.id = wire_load(&port.wire->power_on),
                                .was_used = wire_load(&port.wire->is_used) != 0U};
    elastic_us = wire_load_time(port.wire);
    paced_ns = wire_now_ns();
    was_answered = true;
    wire_store(&port.wire->openings, wire_load(&port.wire->openings) + 1U);
    return true;
}

/*
 * In elastic time the box may take long, as nobody is late: it is given up after so many looks, of
 * which a pause of the machine is one. A box that was given up is not waited for any longer than in
 * real time.
 */
static bool await_reply(uint32_t number, uint32_t timeout_us)
{
    if (!board_time.is_elastic) {
        return wire_await(&port.wire->reply, number, timeout_us * board_time.slowness);
    }
    bool is_answered = false;
    const uint32_t looks = was_answered ? ((LIMIT_ELASTIC_PATIENCE_US / timeout_us) + 1U) : 1U;
    for (uint32_t i = 0U; (i < looks) && !is_answered; i++) {
        is_answered = wire_await(&port.wire->reply, number, timeout_us);
    }
    was_answered = is_answered;
    return is_answered;
}

uint32_t bsp_exchange(uint32_t send, const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                      uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES], uint32_t timeout_us)
{
    wire_t *wire = port.wire;
    const uint32_t number = wire_load(&wire->request) + 1U;

    wire_store(&wire->is_used, 1U);
    wire->send = send;
    wire->wanted_us = elastic_us;
    (void)memcpy(wire->frames, frames, sizeof wire->frames);
    wire_store(&wire->request, number);
    wire_wake_box(wire);
    if (!await_reply(number, timeout_us)) {
        return 0U;
    }
    const uint32_t answered = wire->received & send;
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if ((answered & (1U << slot)) != 0U) {
            (void)memcpy(received[slot], wire->replies[slot], CARD_FRAME_BYTES);
        }
    }
    return answered;
}

bsp_inputs_t bsp_sample_inputs(void)
{
    const uint32_t beat = wire_load(&port.wire->beat);
    const uint32_t unsafe =
        (wire_load(&port.wire->inputs) ^ WIRE_SAFE_INPUTS) | wire_take(&port.wire->latched);
    const uint32_t inputs = unsafe ^ WIRE_SAFE_INPUTS;

    /* Counted in samples, not in time: when the whole machine pauses, nothing grows old. */
    beat_age = (beat == last_beat) ? (beat_age + 1U) : 0U;
    last_beat = beat;
    if (beat_age >= STALE_SAMPLES) {
        beat_age = STALE_SAMPLES;
        return (bsp_inputs_t){.estop_open = true, .has_button = true, .treatment_stopped = true};
    }
    return (bsp_inputs_t){.pedal_a = (inputs & WIRE_INPUT_PEDAL_A) != 0U,
                          .pedal_b = (inputs & WIRE_INPUT_PEDAL_B) != 0U,
                          .estop_open = (inputs & WIRE_INPUT_ESTOP_OPEN) != 0U,
                          .scanner_active = (inputs & WIRE_INPUT_SCANNER) != 0U,
                          .has_button = true,
                          .confirm_pressed = (inputs & WIRE_INPUT_CONFIRM) != 0U,
                          .dose_reached = (inputs & WIRE_INPUT_DOSE) != 0U,
                          .treatment_stopped = (inputs & WIRE_INPUT_TREATMENT_STOP) != 0U};
}

uint32_t bsp_robot_crc(void)
{
    return wire_load(&port.wire->robot_crc);
}

bsp_power_on_t bsp_power_on(void)
{
    return power_on;
}

bsp_time_t bsp_time(void)
{
    return board_time;
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

/* The world's clock only sets the pace. Who comes more than one sleep late begins anew: time never
 * hurries to catch up. */
static void sleep_elastic(uint64_t deadline_us)
{
    const uint64_t now_ns = wire_now_ns();

    if (deadline_us > elastic_us) {
        const uint64_t sleep_ns = (deadline_us - elastic_us) * NS_PER_US * board_time.slowness;
        paced_ns += sleep_ns;
        paced_ns = ((paced_ns + sleep_ns) < now_ns) ? now_ns : paced_ns;
        sleep_until_world_ns(paced_ns);
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

void bsp_close(void)
{
    wire_close(&port, WIRE_END_CONTROL);
}

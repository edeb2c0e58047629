/* SPDX-License-Identifier: Apache-2.0 */
/** @file The board support of the simulated control box: bsp.h at the control end of its wire. */
#include "bsp.h"

#include "wire.h"

#include <string.h>

/* Samples in a row without a sign of life after which the inputs are not believed. */
#define STALE_SAMPLES 10U

static wire_port_t port;
static uint32_t last_beat;
static uint32_t beat_age;

bool bsp_open(const char *name, char *error, uint32_t error_size)
{
    if (!wire_attach(&port, name, WIRE_END_CONTROL, error, error_size)) {
        return false;
    }
    last_beat = wire_load(&port.wire->beat);
    beat_age = 0U;
    return true;
}

uint32_t bsp_exchange(uint32_t send, const uint8_t frames[ROBOT_SLOT_COUNT][CARD_FRAME_BYTES],
                      uint8_t received[ROBOT_SLOT_COUNT][CARD_FRAME_BYTES], uint32_t timeout_us)
{
    wire_t *wire = port.wire;
    const uint32_t number = wire_load(&wire->request) + 1U;

    wire->send = send;
    (void)memcpy(wire->frames, frames, sizeof wire->frames);
    wire_store(&wire->request, number);
    wire_wake_box(wire);
    if (!wire_await(&wire->reply, number, timeout_us * wire->slowness)) {
        return 0U;
    }
    const uint32_t answered = wire->received & send;
    for (uint32_t slot = 0U; slot < ROBOT_SLOT_COUNT; slot++) {
        if ((answered & (1U << slot)) != 0U) {
            (void)memcpy(received[slot], wire->replies[slot], CARD_FRAME_BYTES);
        }
    }
    return answered;
}

bsp_inputs_t bsp_sample_inputs(void)
{
    const uint32_t beat = wire_load(&port.wire->beat);
    const uint32_t inputs = wire_load(&port.wire->inputs);

    /* Counted in samples, not in time: when the whole machine pauses, nothing grows old. */
    beat_age = (beat == last_beat) ? (beat_age + 1U) : 0U;
    last_beat = beat;
    if (beat_age >= STALE_SAMPLES) {
        beat_age = STALE_SAMPLES;
        return (bsp_inputs_t){
            .pedal_a = false, .pedal_b = false, .estop_open = true, .scanner_active = false};
    }
    return (bsp_inputs_t){.pedal_a = (inputs & WIRE_INPUT_PEDAL_A) != 0U,
                          .pedal_b = (inputs & WIRE_INPUT_PEDAL_B) != 0U,
                          .estop_open = (inputs & WIRE_INPUT_ESTOP_OPEN) != 0U,
                          .scanner_active = (inputs & WIRE_INPUT_SCANNER) != 0U};
}

uint64_t bsp_now_ns(void)
{
    return wire_box_now_ns(port.wire);
}

void bsp_sleep_until_ns(uint64_t deadline_ns)
{
    wire_box_sleep_until_ns(port.wire, deadline_ns);
}

void bsp_close(void)
{
    wire_close(&port, WIRE_END_CONTROL);
}

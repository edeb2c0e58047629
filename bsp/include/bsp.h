/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Board support: everything the control process may ask of the box around it. One implementation is
 * linked per board: bsp/sim (the simulated control box, another process).
 */
#ifndef BORESIGHT_BSP_H
#define BORESIGHT_BSP_H

#include "card/card.h"
#include "card/card_frame.h"

#include <stdbool.h>
#include <stdint.h>

/** The digital inputs, sampled once per cycle. */
typedef struct {
    bool pedal_a; /**< Channel A is closed (pressed). */
    bool pedal_b;
    bool estop_open;        /**< The e-stop chain is open (pulled). */
    bool scanner_active;    /**< The scanner acquires. */
    bool has_button;        /**< The box has a button for the operator. */
    bool confirm_pressed;   /**< It is pressed. */
    bool dose_reached;      /**< The gate of the treatment says so; false without one. */
    bool treatment_stopped; /**< The same. */
} bsp_inputs_t;

/** How the board's time passes beside the world's. */
typedef struct {
    /** It waits for control: a cycle passes when control asks for the next exchange, so nobody is
     * late because the machine paused. Never on a real board. */
    bool is_elastic;
    uint32_t slowness; /**< It passes so many times slower, at best; 1 on a real board. */
} bsp_time_t;

/** One power-on of the box. */
typedef struct {
    uint32_t id; /**< Another one each time the box is switched on; never 0. */
    /** Before bsp_open() frames were exchanged in it, so axes may have moved. */
    bool was_used;
} bsp_power_on_t;

/**
 * Opens the board. `error` receives one sentence that says what to do.
 *
 * @return false when the board is not there
 */
bool bsp_open(const char *name, char *error, uint32_t error_size);

/**
 * Exchanges all frames at once, full duplex, and returns after at most `timeout_us`. Bit n of
 * `send` selects slot n.
 *
 * @return bit n set: `received[n]` holds the 256 bytes that came back from slot n
 */
uint32_t bsp_exchange(uint32_t send, const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                      uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES], uint32_t timeout_us);

/**
 * Samples the digital inputs: each as unsafe (pedal open, e-stop open, scanner active, button
 * released, dose reached, treatment stopped) as it was at any time since the sample before; the
 * board latches pulses, however short. When the board does not answer: pedal and button released,
 * e-stop open, treatment stopped.
 *
 * @satisfies SWR-ESTOP-004
 */
bsp_inputs_t bsp_sample_inputs(void);

/**
 * The power-on in which the board was opened.
 *
 * @satisfies SWR-STORE-001
 */
bsp_power_on_t bsp_power_on(void);

/** CRC of the description of the robot that the board belongs to; 0 when the board cannot tell. */
uint32_t bsp_robot_crc(void);

/** How the time of bsp_now_ns() passes. */
bsp_time_t bsp_time(void);

/** The board's monotonic time, ns. Elastic time stands still between two sleeps. */
uint64_t bsp_now_ns(void);

/** The time that the board itself has come to, ns: it stands still while the board does. */
uint64_t bsp_reached_ns(void);

/** Sleeps until `deadline_ns` (absolute, of bsp_now_ns()). */
void bsp_sleep_until_ns(uint64_t deadline_ns);

/** Closes the board. */
void bsp_close(void);

#endif

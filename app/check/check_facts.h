/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the checks of check.h judge, beside the files of the kernel. */
#ifndef BORESIGHT_CHECK_FACTS_H
#define BORESIGHT_CHECK_FACTS_H

#include <stdbool.h>
#include <stdint.h>

#define CHECK_TEXT_SIZE 256U
#define CHECK_INTERRUPTS 1024U /**< Interrupts with a number below this are looked at. */
#define CHECK_CARDS 10U        /**< Cards of the cycle whose budget is computed. */

/** The cost of a cycle, as the board's file gives it; all 0 without one. */
typedef struct {
    uint32_t wire_hz;             /**< Clock of the wires to the cards. */
    uint32_t wires;               /**< Cards that are served at once. */
    uint32_t word_ns;             /**< To bring one word of a frame to a wire and one back. */
    uint32_t instructions_per_us; /**< Speed of the controller's code. */
    uint32_t publish_us;
    uint32_t dialect; /**< card_dialect_t: how large the frames are. */
} check_board_t;

/** The facts that the checks judge and that no file of the kernel holds. */
typedef struct {
    const char *root; /**< Where /proc and /sys are; "" on this computer. */
    uint32_t core;    /**< Number of the control loop's core. */
    uint32_t cores;   /**< Number of cores of the computer. */
    uint32_t rights;  /**< EXCHANGE_RIGHT_ bits that were granted. */
    bool is_awake;    /**< The kernel lets control keep the cores from deep sleep. */
    bool is_simulated;
    check_board_t board;
    uint64_t clock_ns; /**< Resolution of the monotonic clock. */
    /* Measured. */
    uint32_t cycles;
    uint32_t wake_p99_us;
    uint32_t wake_worst_us;
    uint64_t minor_faults;
    uint64_t major_faults;
    uint64_t interrupts[CHECK_INTERRUPTS]; /**< Counts of the loop's core, before. */
} check_facts_t;

#endif

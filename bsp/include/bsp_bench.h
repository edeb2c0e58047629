/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Orders to a box that is simulated: what a person could do at a real one, and faults. A board that
 * offers them has an implementation of its own (BOARD_BENCH of its board.mk); every other one is
 * linked with bsp/no_bench.c, which has nothing to give orders to.
 */
#ifndef BORESIGHT_BSP_BENCH_H
#define BORESIGHT_BSP_BENCH_H

#include "card/card.h"

#include <stdbool.h>
#include <stdint.h>

/** State of a slot. Faults are numbered as the words of the order that causes them; 0: none. */
typedef struct {
    uint8_t card_type; /**< card_type_t; CARD_TYPE_NONE: the slot is empty. */
    uint8_t has_axis;  /**< 1: an axis is connected to the card; 0: none, and no fault of it. */
    uint8_t card_fault;
    uint8_t encoder_fault;
    uint8_t motor_fault;
    uint8_t switch_fault;
} bsp_bench_slot_t;

/** A place on the line of a needle that is not bent, um: across it, and its depth. */
typedef struct {
    int32_t x_um;
    int32_t y_um;
    int32_t depth_um;
} bsp_bench_point_t;

#define BSP_BENCH_WAY 33U

/** Where the needle truly is, which no controller knows. */
typedef struct {
    uint32_t is_seen; /**< 1: it is in front of tissue; 0: all that follows is 0. */
    int32_t surface_um;
    int32_t turn_mdeg;        /**< Of its base, over all turns, */
    int32_t lag_mdeg;         /**< and by so much the base is ahead of the tip. */
    int32_t curvature_per_km; /**< With which it is bent while it does not turn. */
    int32_t torsion_deg;      /**< Per 100 mm. */
    uint32_t has_target;
    bsp_bench_point_t target;
    uint32_t images_period_ms; /**< 0: none is taken. */
    uint32_t images_delay_ms;
    int32_t images_noise_um;
    uint32_t image; /**< Number of the newest image of the tip; 0: there is none. */
    uint32_t image_age_ms;
    bsp_bench_point_t image_place;
    bsp_bench_point_t way[BSP_BENCH_WAY]; /**< Its shaft; the last is the tip. */
} bsp_bench_needle_t;

/** Visible state of the box. */
typedef struct {
    uint32_t pedal_holder;  /**< Holder of the pedal from afar; 0: none. */
    uint32_t button_holder; /**< The same of the button. */
    uint32_t hand_holder;   /**< The same of the handle. */
    int32_t grip_mn;        /**< Force with which a hand presses the handle, below 0 outwards. */
    uint32_t layers;        /**< Layers of tissue in front of the needle. */
    uint32_t force_hand;    /**< Fault of the load cell of the hand, */
    uint32_t force_needle;  /**< and of the needle's. */
    uint32_t gate;          /**< 0: says nothing, 1: dose reached, 2: stop. */
    uint32_t is_probe_free; /**< 1: it is not coupled to the needle's axis. */
    bool is_pedal_pressed;  /**< Both channels are closed. */
    bool is_estop_pulled;
    bool is_scanner_active;
    bool is_button_pressed;
    bool is_hand_pressed; /**< A hand is at the handle. */
    bool is_lamp_alive;   /**< Lit, as those that follow. */
    bool is_lamp_may_move;
    bool is_lamp_moving;
    bool is_lamp_fault;
    bsp_bench_slot_t slots[CARD_SLOT_COUNT];
    bsp_bench_needle_t needle;
} bsp_bench_t;

typedef enum {
    BSP_BENCH_DONE = 0,
    BSP_BENCH_REFUSED = 1, /**< The box has not obeyed; nothing has changed. */
    BSP_BENCH_SILENT = 2   /**< It is not there, or does not answer. */
} bsp_bench_result_t;

/**
 * This board takes orders.
 *
 * @satisfies SWR-BOX-021
 */
bool bsp_bench_is_offered(void);

/** Looks at the box `name`. False: it is not there. */
bool bsp_bench_look(const char *name, bsp_bench_t *seen);

/** Gives the box `name` one order, as boresight-simctl does, and waits up to a second for its
 * answer. Any thread; one order at a time is under way, and the others wait for it. */
bsp_bench_result_t bsp_bench_order(const char *name, const char *order);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The controller and its simulated control box in one memory: a cycle as control and boresight-box
 * make it of each other, without processes, exchange or clock. Nothing passes but by
 * closed_loop_step(): the same robot, seed, orders and commands give the same bytes.
 */
#ifndef BORESIGHT_CLOSED_LOOP_H
#define BORESIGHT_CLOSED_LOOP_H

#include "control/board_inputs.h"
#include "controller/controller.h"
#include "sim/box.h"
#include "sim/box_grip.h"

#include <stdbool.h>
#include <stdint.h>

/** Owned by the caller; inputs and outputs are those of the last cycle. */
typedef struct {
    const robot_t *robot;
    box_t box;
    box_grip_t grip; /**< Counted in the time of the box: there is no other. */
    controller_t controller;
    controller_inputs_t inputs;
    controller_outputs_t outputs;
    board_inputs_t board_inputs;
    uint64_t time_us; /**< Time of the box. */
    uint32_t command_count;
    command_t commands[CONTROLLER_COMMANDS]; /**< Commands of the next cycle. */
} closed_loop_t;

/** A box that was just switched on, and a controller that knows nothing of before. `robot` must
 * outlive it. */
void closed_loop_init(closed_loop_t *self, const robot_t *robot, uint32_t seed);

/** The place of one more command of the next cycle, all zero; NULL: there are CONTROLLER_COMMANDS.
 */
command_t *closed_loop_command(closed_loop_t *self);

/**
 * A pedal or button that is not held on opens. The box exchanges the frames of the cycle before and
 * goes on by LIMIT_CYCLE_US; then its inputs are sampled and the controller makes its step.
 *
 * @satisfies SWR-SITE-003
 * @satisfies SWR-SITE-034
 */
void closed_loop_step(closed_loop_t *self);

#endif

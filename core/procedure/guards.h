/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Facts that decide about a command before its mode is asked, as one word. The controller finds
 * them, answers by them and shows them, so that the verdict shown beforehand is the one that the
 * command gets, whatever the state.
 */
#ifndef BORESIGHT_GUARDS_H
#define BORESIGHT_GUARDS_H

#include "charts/workphase_chart.h"
#include "interface/mode_list.h"
#include "interface/status.h"
#include "interface/workphase_list.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** Bit n: axis n of the robot is not enabled. */
#define GUARD_DISABLED_AXES (((uint32_t)1U << ROBOT_AXIS_MAX) - 1U)
/** Every card sends valid frames without a fault, the e-stop is closed, the pedal's channels agree.
 */
#define GUARD_HARDWARE_READY 0x00010000U
/** An axis without a switch has lost its position. */
#define GUARD_CONFIRMATION_DUE 0x00020000U
/** Nothing that START_UP clears stands against motion, but for cards and axes. */
#define GUARD_CLEAR 0x00040000U
#define GUARD_HOMED 0x00080000U /**< Every axis. */
#define GUARD_REGISTERED 0x00100000U
#define GUARD_TARGET 0x00200000U
#define GUARD_BLIND 0x00400000U /**< The robot's table was damaged. */
#define GUARD_UNFIT 0x00800000U /**< The computer lacks something that a real robot needs. */
#define GUARD_PEDAL_RELEASED 0x01000000U
#define GUARD_LINKED 0x02000000U /**< Every card of an axis may be given a drive. */
#define GUARD_SPENT 0x04000000U  /**< Vain START_UPs have moved an axis too far. */
#define GUARD_NO_BOX 0x08000000U /**< Nothing is recorded, and that is not accepted. */

/**
 * Status that bars a command of `kind`, whatever else it says; `asked`: the workphase that
 * COMMAND_WORKPHASE asks for.
 *
 * @return STATUS_OK; STATUS_MEMORY_DAMAGED while the robot's table is, unless the command changes
 * the workphase alone or is of authority; STATUS_COMPUTER_UNFIT for commands that enable axes;
 * STATUS_NO_BLACK_BOX for START_UP alone while GUARD_NO_BOX stands; STATUS_MOVED_IN_VAIN for those
 * that home them while GUARD_SPENT stands
 *
 * @satisfies SWR-LOOP-006
 * @satisfies SWR-MEMORY-004
 * @satisfies SWR-NEXT-024
 * @satisfies SWR-NEXT-027
 */
status_t guards_bar(uint32_t facts, uint32_t kind, uint32_t asked);

/** `fact` is among them; of several any. */
static inline bool guards_have(uint32_t facts, uint32_t fact)
{
    return (facts & fact) != 0U;
}

/** Inputs of the workphase chart for an order of mode `kind` in `workphase` that needs `axes` (bit
 * n: axis n). */
workphase_inputs_t guards_inputs(uint32_t facts, mode_kind_t kind, uint32_t axes,
                                 workphase_t workphase);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file A step of a treatment program, and the checksums by which it and a list of them are known.
 */
#ifndef BORESIGHT_PROGRAM_STEP_H
#define BORESIGHT_PROGRAM_STEP_H

#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** One step. No padding. */
typedef struct {
    int32_t depth_ticks; /**< Position of the axis along the needle. */
    int32_t angle_ticks; /**< Position of the one about it; of no meaning without one. */
    uint32_t dwell_ms;   /**< 0..LIMIT_PROGRAM_DWELL_MS; with a gate the longest. */
    uint32_t is_gated;   /**< The dose ends it: 0 or 1. */
    uint32_t crc;        /**< program_step_crc() of all before it. */
} program_step_t;

/** The axis that turns the needle about its line; the count of the axes without one. */
uint32_t program_step_turning_axis(const robot_t *robot);

/** CRC-32C of a step: depth, angle, dwell, gate, as they lie in memory. */
uint32_t program_step_crc(const program_step_t *step);

/** The step is as it was taken. */
bool program_step_is_whole(const program_step_t *step);

/** Checksum of a list that was `crc` (0 of none) with one step more: CRC-32C of that and of the
 * step's. */
uint32_t program_list_crc(uint32_t crc, const program_step_t *step);

/** Depth and angle of `step` from positions of all axes; 0 is the angle of a robot that turns no
 * needle. */
void program_step_place(const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX],
                        program_step_t *step);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Items of lists, rows of a trajectory and steps of a treatment program: steps in the units of the
 * operator, and both as the commands by which they go to control one by one.
 */
#ifndef BORESIGHT_LIST_TERMS_H
#define BORESIGHT_LIST_TERMS_H

#include "interface/command.h"
#include "interface/status.h"
#include "mode/lists/program_step.h"
#include "mode/lists/trajectory_row.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** A step of a treatment program; each number is finite. */
typedef struct {
    double depth_mm; /**< Position of the axis along the needle. */
    bool has_angle;
    double angle_deg; /**< Angle of the axis about it; without meaning where none exists. */
    double dwell_s;
    bool is_gated;
} reported_step_t;

/**
 * `step` as the robot has it, without its checksum; unspecified when refused.
 *
 * @return STATUS_OK; STATUS_OUT_OF_RANGE for a number that no axis can take, a dwell that no
 * command can hold, or an angle where no axis turns the needle, or none where one does;
 * STATUS_PROGRAM_DWELL for a gate without a dwell, which no command can hold either
 */
status_t list_terms_step(const robot_t *robot, const reported_step_t *reported,
                         program_step_t *step);

/** The command that hands in step `index`. */
command_t list_terms_step_command(const robot_t *robot, uint32_t index, const program_step_t *step);

/** The command that hands in row `index`. */
command_t list_terms_row_command(uint32_t index, const trajectory_row_t *row);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The curve that a sweep has measured, as a table of text with all that says whose it is, and a
 * CRC-32C behind it. It is kept in the recorder's folder, one for each robot, and shown; no motion
 * reads it.
 */
#ifndef BORESIGHT_SWEEP_CURVE_H
#define BORESIGHT_SWEEP_CURVE_H

#include "limits/requirement_limits.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define SWEEP_TEXT_SIZE 4096U /**< Size of the longest text, and its end. */
#define SWEEP_PATH_SIZE 512U

/** The ways of one run each, at one frequency. */
typedef struct {
    int32_t hertz;
    int32_t up_ticks;
    int32_t down_ticks;
} sweep_point_t;

typedef struct {
    char robot[12];
    uint32_t robot_crc;
    char axis[12];
    uint32_t card_firmware; /**< As robot_t. */
    uint64_t ended_us;      /**< UTC since 1970. */
    uint32_t end;           /**< sweep_end_t. */
    uint32_t count;         /**< 0..LIMIT_SWEEP_POINTS. */
    sweep_point_t points[LIMIT_SWEEP_POINTS];
} sweep_curve_t;

/** Verdict on a kept curve. */
typedef enum {
    SWEEP_KEPT_NONE = 0,
    SWEEP_KEPT_GOOD = 1,
    SWEEP_KEPT_DAMAGED = 2,    /**< Its CRC or its form is wrong, or it cannot be read. */
    SWEEP_KEPT_OTHER_ROBOT = 3 /**< Its robot's file was another one. */
} sweep_kept_t;

/** Speed in turns a minute of the way of a run; `axis` is one that turns. */
double sweep_curve_turns_per_min(const axis_config_t *axis, int32_t way_ticks);

/** The axis of the curve; NULL: `robot` has none of this name. */
const axis_config_t *sweep_curve_axis(const sweep_curve_t *self, const robot_t *robot);

/**
 * Writes the curve of an axis of `robot` as text.
 *
 * @return its length; 0 for an axis that the robot does not have
 *
 * @satisfies SWR-SWEEP-010
 */
size_t sweep_curve_write(const sweep_curve_t *self, const robot_t *robot,
                         char text[SWEEP_TEXT_SIZE]);

/**
 * Reads `text`.
 *
 * @return SWEEP_KEPT_GOOD, SWEEP_KEPT_DAMAGED, or SWEEP_KEPT_OTHER_ROBOT if it is not of `robot`,
 * as its file is now
 *
 * @satisfies SWR-SWEEP-011
 */
sweep_kept_t sweep_curve_read(sweep_curve_t *self, const robot_t *robot, const char *text);

/** Keeps the curve in `directory` instead of the one before. False with errno set. */
bool sweep_curve_keep(const sweep_curve_t *self, const robot_t *robot, const char *directory);

/** Finds the kept curve of `robot` in `directory`, and its text, which is empty but with
 * SWEEP_KEPT_GOOD. */
sweep_kept_t sweep_curve_find(sweep_curve_t *self, const robot_t *robot, const char *directory,
                              char text[SWEEP_TEXT_SIZE]);

#endif

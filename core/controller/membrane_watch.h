/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Membranes that are expected on the way to the target, and the detector that looks for them while
 * a hand inserts the needle. It is written by controller_membranes.c alone. Depths are below the
 * entry point.
 */
#ifndef BORESIGHT_MEMBRANE_WATCH_H
#define BORESIGHT_MEMBRANE_WATCH_H

#include "base/rigid.h"
#include "sensor/membrane_detector.h"
#include "sensor/membrane_list.h"

#include <stdint.h>

/** Data of the plan; those of another target or entry point are forgotten. No padding. */
typedef struct {
    membrane_list_t list;
    point_t entry; /**< For which they were sent, scanner coordinates; of no meaning without any. */
    point_t target; /**< As `entry`. */
} membrane_plan_t;

/** An insertion by hand. No padding. */
typedef struct {
    membrane_detector_t detector;
    int32_t target_um;   /**< Depth of the target. */
    uint32_t is_running; /**< 0 or 1; 0: the rest is of no meaning. */
} membrane_run_t;

/** What became of the last vibration. */
typedef enum {
    MEMBRANE_ANSWER_NONE = 0,
    MEMBRANE_ANSWER_RUNS = 1, /**< The needle comes to rest for it, or vibrates. */
    MEMBRANE_ANSWER_WHOLE = 2 /**< The hand has not let go since. */
} membrane_answer_t;

/** All zero: nothing is expected or looked for. */
typedef struct {
    membrane_plan_t plan;
    membrane_run_t run;
    uint32_t list_seal; /**< Of `plan`, looked at in each cycle of a run, and in turn otherwise. */
    uint32_t run_seal;  /**< Of `run`, as that of `plan`. */
    uint32_t sight;     /**< membrane_sight_t; shown only, as the next two. */
    int32_t depth_um;
    uint32_t least_fall_mn;
    uint32_t vibration; /**< membrane_answer_t; for the log only. */
} membrane_watch_t;

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file The sources of series in a snapshot: the state, each axis, each card that the robot
 * names. */
#ifndef BORESIGHT_SOURCE_H
#define BORESIGHT_SOURCE_H

#include "interface/snapshot.h"
#include "replay/data/series.h"

#define SOURCES (1U + ROBOT_AXIS_MAX + CARD_SLOT_COUNT) /**< Most of them. */
#define SOURCE_NAME_SIZE 32U

typedef struct {
    const char *says;
    const field_t *fields;
    size_t offset;                 /**< Offset in the snapshot. */
    const axis_config_t *axis;     /**< NULL: it is none. */
    char topic[SOURCE_NAME_SIZE];  /**< "/axes/yaw". */
    char prefix[SOURCE_NAME_SIZE]; /**< "yaw_". */
} source_t;

/** Writes those of `robot`, which must outlive them. Returns their number. */
uint32_t source_find(const robot_t *robot, source_t sources[SOURCES]);

/** Gives `sink` its series in `snapshot`, for an axis also its output in percent. */
void source_report(const source_t *self, const snapshot_t *snapshot, series_sink_t *sink, void *to);

#endif

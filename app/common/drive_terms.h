/* SPDX-License-Identifier: Apache-2.0 */
/** @file Drive words in the terms of people. */
#ifndef BORESIGHT_DRIVE_TERMS_H
#define BORESIGHT_DRIVE_TERMS_H

#include "interface/snapshot.h"
#include "robot/robot.h"

/** The drive word of `axis` in percent of its largest, with the sign of the way; 0 while it is not
 * driven. */
double drive_terms_percent(const axis_config_t *config, const snapshot_axis_t *axis);

#endif

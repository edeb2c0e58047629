/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The probe or needle that the robot carries: lengths that may change while the programs run,
 * unlike the rest of its table. plan_t holds the present one.
 */
#ifndef BORESIGHT_PROBE_H
#define BORESIGHT_PROBE_H

#include "interface/status.h"
#include "robot/robot.h"

#include <stdint.h>

/**
 * May the robot carry it?
 *
 * @return STATUS_OK; STATUS_PROBE_LENGTH when a length is outside of what the robot file allows, or
 * the robot has no such length; STATUS_PROBE_ORDER when one exceeds another that it may not
 *
 * @satisfies SWR-PROBE-002
 */
status_t probe_judge(const robot_t *robot, const probe_t *probe);

/** Value of a length of the robot that clients are sent, nm; `probe_nm`: those of the present
 * probe. */
static inline int32_t probe_reported_nm(const reported_length_t *reported,
                                        const int32_t probe_nm[ROBOT_PROBE_LENGTHS])
{
    return (reported->probe != 0U) ? probe_nm[reported->probe - 1U] : reported->length_nm;
}

/** Its CRC-32C. */
uint32_t probe_checksum(const probe_t *probe);

#endif

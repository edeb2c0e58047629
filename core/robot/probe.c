/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/probe.h"

#include "base/crc.h"

status_t probe_judge(const robot_t *robot, const probe_t *probe)
{
    status_t status = STATUS_OK;
    for (uint32_t i = 0U; i < ROBOT_PROBE_LENGTHS; i++) {
        const int32_t length_nm = probe->length_nm[i];
        const uint32_t within = robot->probe_within[i];
        /* Both ends are 0 where the robot has no length. */
        if ((length_nm < robot->probe_minimum.length_nm[i]) ||
            (length_nm > robot->probe_maximum.length_nm[i])) {
            return STATUS_PROBE_LENGTH;
        }
        if ((within != 0U) && (length_nm > probe->length_nm[within - 1U])) {
            status = STATUS_PROBE_ORDER;
        }
    }
    return status;
}

uint32_t probe_checksum(const probe_t *probe)
{
    return crc32c((const uint8_t *)probe, sizeof *probe);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "control/lamps.h"

#include "bsp.h"
#include "interface/permit_reason.h"

#define BIT(reason) (1U << (uint32_t)(reason))
#define FAULTS                                                                                     \
    (BIT(PERMIT_REASON_INPUTS_UNREAD) | BIT(PERMIT_REASON_ESTOP_PULLED) |                          \
     BIT(PERMIT_REASON_ESTOP_LATCHED) | BIT(PERMIT_REASON_LOOP_STOPPED) |                          \
     BIT(PERMIT_REASON_LINK_LOST) | BIT(PERMIT_REASON_PEDAL_FAULT) |                               \
     BIT(PERMIT_REASON_AXIS_FAULT) | BIT(PERMIT_REASON_MEMORY) |                                   \
     BIT(PERMIT_REASON_FORCE_DOUBTFUL))

static uint32_t lamps_of_axis(const snapshot_axis_t *axis)
{
    /* Those that the operator's foot and hand themselves take away. */
    const uint32_t others =
        axis->permit_reasons & ~(BIT(PERMIT_REASON_PEDAL_RELEASED) | BIT(PERMIT_REASON_HAND_OFF) |
                                 BIT(PERMIT_REASON_HAND_UNPROVEN));

    return ((others == 0U) ? BSP_LAMP_MAY_MOVE : 0U) |
           ((axis->drive_mode != (uint32_t)CARD_DRIVE_OFF) ? BSP_LAMP_MOVING : 0U) |
           (((others & FAULTS) != 0U) ? BSP_LAMP_FAULT : 0U);
}

uint32_t lamps_of(const snapshot_t *snapshot)
{
    uint32_t lamps = BSP_LAMP_ALIVE;
    for (uint32_t i = 0U; i < snapshot->axis_count; i++) {
        lamps |= lamps_of_axis(&snapshot->axes[i]);
    }
    return lamps;
}

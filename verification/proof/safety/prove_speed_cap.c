/* SPDX-License-Identifier: Apache-2.0 */
/* Cap of speed and hold of reasons, one cycle from any state that a cycle may leave: what holds
 * after each holds always. The table of the axis is any that the robot compiler accepts. */
#include "prove.h"

#include "limits/requirement_limits.h"
#include "safety/permit.h"
#include "safety/reason_hold.h"
#include "safety/speed_cap.h"

#define WIDEST                                                                                     \
    ((int64_t)LIMIT_AXIS_SPEED_MOST_TICKS_PER_S * (100 + LIMIT_SPEED_CAP_TOLERANCE_PERCENT) *      \
     LIMIT_SPEED_CAP_US)

static axis_config_t config;

static void begin(const speed_cap_t *self)
{
    axis_config_t any;
    config = any;
    assume((config.speed_ticks_per_s >= 1) &&
           (config.speed_ticks_per_s <= (int32_t)LIMIT_AXIS_SPEED_MOST_TICKS_PER_S));
    assume((self->left >= 0) && (self->left <= WIDEST));
}

void prove_SWR_PERMIT_005_the_account_of_any_axis_stays_within_its_ends(void)
{
    speed_cap_t self;
    uint32_t percent;
    uint32_t elapsed_us;
    int32_t position_ticks;
    begin(&self);
    assume((percent >= 1U) && (percent <= 100U));
    const int32_t before_ticks = self.position_ticks;

    const bool is_too_fast = speed_cap_step(&self, &config, percent, position_ticks, elapsed_us);

    PROVE((self.left >= 0) && (self.left <= WIDEST),
          "SWR-PERMIT-005: the next cycle may rely on it");
    PROVE(self.position_ticks == position_ticks, "SWR-PERMIT-005: the next way begins here");
    PROVE(IMPLIES(is_too_fast, (self.left == 0) && (position_ticks != before_ticks)),
          "SWR-PERMIT-005: who is too fast has moved, and has nothing left");
    POSSIBLE(is_too_fast, "too fast");
}

void prove_SWR_PERMIT_006_a_reason_that_stands_is_shown(void)
{
    reason_hold_t self;
    uint32_t reasons;
    uint32_t elapsed_us;
    const uint32_t of_place = ((uint32_t)1U << PERMIT_REASON_END_OF_PLACE) -
                              ((uint32_t)1U << PERMIT_REASON_FIRST_OF_PLACE);
    assume((self.flickering & ~of_place) == 0U);

    reason_hold_step(&self, reasons, elapsed_us);

    PROVE((reasons & ~self.shown) == 0U, "SWR-PERMIT-006: each reason that stands is shown");
    PROVE((self.shown & ~reasons & ~of_place) == 0U,
          "SWR-PERMIT-006: nothing else is shown but what comes and goes with the place");
    PROVE((self.flickering & ~of_place) == 0U, "SWR-PERMIT-006: the next cycle may rely on it");
    POSSIBLE((self.shown & ~reasons) != 0U, "shown for longer");
}

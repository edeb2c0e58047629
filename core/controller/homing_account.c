/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/homing_account.h"

#include "base/fixed.h"
#include "base/seal.h"
#include "limits/requirement_limits.h"
#include "robot/joints.h"

#include <stddef.h>
#include <string.h>

static uint32_t seal_it(const homing_account_t *self)
{
    return seal_of(SEAL_START, (const uint8_t *)self,
                   WHOLE_WORDS(offsetof(homing_account_t, seal)));
}

/* A damaged account stays so until it begins anew. */
static void reseal(homing_account_t *self, bool was_intact)
{
    self->seal = seal_it(self) ^ (was_intact ? 0U : 1U);
}

void homing_account_init(homing_account_t *self)
{
    (void)memset(self, 0, sizeof *self);
    self->seal = seal_it(self);
}

bool homing_account_is_intact(const homing_account_t *self)
{
    return self->seal == seal_it(self);
}

void homing_account_begin(homing_account_t *self, const robot_t *robot,
                          const axis_t axes[ROBOT_AXIS_MAX])
{
    const bool was_intact = homing_account_is_intact(self);
    self->homed = 0U;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        self->from_readings[i] = axes[i].sealed.encoder.reading;
        self->homed |= axis_is_homed(&axes[i]) ? ((uint32_t)1U << i) : 0U;
    }
    reseal(self, was_intact);
}

static int64_t find_way(const homing_account_t *self, const axis_config_t *config,
                        const encoder_t *encoder, uint32_t index)
{
    return fixed_magnitude(
        (int64_t)encoder_way(config, self->from_readings[index], encoder->reading));
}

void homing_account_charge(homing_account_t *self, const robot_t *robot,
                           const axis_t axes[ROBOT_AXIS_MAX], uint32_t failed)
{
    const bool was_intact = homing_account_is_intact(self);
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const axis_config_t *const config = &robot->axes[i];
        const bool was_homed = ((self->homed >> i) & 1U) != 0U;
        const int64_t unseen = (i == failed) ? (int64_t)config->following_error_ticks : 0;
        const int64_t way = find_way(self, config, &axes[i].sealed.encoder, i);
        if (axis_is_homed(&axes[i]) && !was_homed) {
            self->ways_ticks[i] = 0;
        } else {
            self->ways_ticks[i] =
                fixed_saturate((int64_t)self->ways_ticks[i] + ((way > unseen) ? way : unseen));
        }
    }
    reseal(self, was_intact);
}

bool homing_account_is_beyond(const homing_account_t *self, const robot_t *robot)
{
    bool is_beyond = !homing_account_is_intact(self);
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const int64_t way = (int64_t)self->ways_ticks[i];
        is_beyond = is_beyond ||
                    joints_is_beyond(&robot->axes[i], way, LIMIT_VAIN_WAY_NM, LIMIT_VAIN_WAY_BAM);
    }
    return is_beyond;
}

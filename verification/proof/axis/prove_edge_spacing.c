/* SPDX-License-Identifier: Apache-2.0 */
/* Spacing of counts and audit of drift, one cycle from any state. */
#include "prove.h"

#include "axis/drift_audit.h"
#include "axis/edge_spacing.h"
#include "limits/requirement_limits.h"

/* What each cycle leaves: below what is reported, a row of even ways may follow. */
#define MOST_UNEVEN (LIMIT_UNEVEN_MOST + LIMIT_UNEVEN_WEIGHT)

void prove_SWR_AXIS_027_uneven_counts_are_reported_when_their_sum_is_reached(void)
{
    edge_spacing_t self;
    edge_spacing_view_t view;
    assume(self.uneven < LIMIT_UNEVEN_MOST);
    const edge_spacing_t before = self;

    const bool is_uneven = edge_spacing_step(&self, &view);

    PROVE(SAME(is_uneven, self.uneven >= LIMIT_UNEVEN_MOST),
          "SWR-AXIS-027: reported when it is reached");
    PROVE(self.uneven <= (before.uneven + LIMIT_UNEVEN_WEIGHT),
          "SWR-AXIS-027: a way adds its weight at most");
    PROVE((self.uneven + 1U) >= before.uneven, "SWR-AXIS-027: an even way gives back one at most");
    PROVE(IMPLIES((view.ticks == 0U) || (before.since_q16 == UINT32_MAX) || (before.ticks == 0U),
                  self.uneven == before.uneven),
          "SWR-AXIS-027: without two ways nothing is compared");
    POSSIBLE(is_uneven, "uneven");
    POSSIBLE(self.uneven < before.uneven, "even");
}

void prove_SWR_AXIS_022_only_counts_of_an_axis_that_is_off_add_up(void)
{
    drift_audit_t self;
    int64_t way;
    bool is_off;
    uint32_t elapsed_us;
    assume((way >= -INT64_C(4294967296)) && (way <= INT64_C(4294967296)));
    assume((self.off_us < MOTOR_REST_US) ? (elapsed_us <= (UINT32_MAX - MOTOR_REST_US)) : true);
    const drift_audit_t before = self;

    drift_audit_step(&self, way, is_off, elapsed_us);

    PROVE(IMPLIES(!is_off || (before.off_us < MOTOR_REST_US), self.idle_ticks == before.idle_ticks),
          "SWR-AXIS-022: a motor that is driven, or was just now, adds nothing");
    PROVE(IMPLIES(is_off && (before.off_us >= MOTOR_REST_US),
                  self.idle_ticks == fixed_saturate((int64_t)before.idle_ticks + way)),
          "SWR-AXIS-022: each count of one that is off adds up");
    PROVE(self.confirmed_ticks == before.confirmed_ticks,
          "SWR-AXIS-022: nothing is confirmed by it");
    POSSIBLE(self.idle_ticks != before.idle_ticks, "a count of doubt");
}

void prove_SWR_AXIS_045_a_drift_is_judged_by_all_of_it(void)
{
    drift_audit_t self;
    axis_config_t config;

    const bool is_far = drift_audit_is_far(&self, &config);
    const int64_t way = (self.idle_ticks < 0) ? -(int64_t)self.idle_ticks : self.idle_ticks;
    const int32_t idle_ticks = self.idle_ticks;
    drift_audit_confirm(&self, &config);

    PROVE(SAME(is_far, way > (int64_t)config.drift_ticks),
          "SWR-AXIS-045: beyond the bound of its row");
    PROVE(self.confirmed_ticks == (is_far ? 0 : idle_ticks),
          "SWR-AXIS-022: what is confirmed is all that was counted");
    PROVE(self.idle_ticks == (is_far ? 0 : idle_ticks), "SWR-AXIS-045: a far one begins anew");
    POSSIBLE(is_far, "far");
    POSSIBLE(!is_far && (idle_ticks != 0), "near");
}

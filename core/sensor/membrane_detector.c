/* SPDX-License-Identifier: Apache-2.0 */
#include "sensor/membrane_detector.h"

#include "base/fixed.h"

#include <string.h>

#define MOST_NOISE_UN 10000000U
#define UN_PER_MN 1000U
#define UM_PER_MM 1000
#define MS_PER_S 1000
#define NM_PER_UM 1000
#define MOST_WAY_UM INT64_C(50000)
#define SPEED_PARTS (LIMIT_MEMBRANE_SPEED_MS / MEMBRANE_PART_MS)
#define RECENT_PARTS (LIMIT_MEMBRANE_RECENT_MS / MEMBRANE_PART_MS)
#define FORGET_PARTS (LIMIT_MEMBRANE_FORGET_MS / MEMBRANE_PART_MS)

static int32_t as_mn_q12(uint64_t un)
{
    const uint64_t mn_q12 = (un * (uint64_t)MEMBRANE_MN_Q12) / UN_PER_MN;
    return (int32_t)mn_q12;
}

void membrane_detector_init(membrane_detector_t *self, uint32_t noise_un)
{
    const uint32_t most_un = (noise_un < MOST_NOISE_UN) ? noise_un : MOST_NOISE_UN;
    const int32_t floor = as_mn_q12((uint64_t)most_un * LIMIT_MEMBRANE_FLOOR_SIGMAS);
    const int32_t least = (int32_t)LIMIT_MEMBRANE_LEAST_MN * MEMBRANE_MN_Q12;
    (void)memset(self, 0, sizeof *self);
    self->floor_mn_q12 = (floor > least) ? floor : least;
}

uint32_t membrane_detector_floor_un(const membrane_detector_t *self)
{
    return (uint32_t)(((uint64_t)self->floor_mn_q12 * UN_PER_MN) / (uint64_t)MEMBRANE_MN_Q12);
}

/* The part that began `parts` parts before the newest. */
static const membrane_part_t *earlier(const membrane_detector_t *self, uint32_t parts)
{
    return &self->parts[((self->at + MEMBRANE_PARTS) - parts) % MEMBRANE_PARTS];
}

/* A way that no needle makes in a window counts as MOST_WAY_UM. */
static int64_t way_since(const membrane_detector_t *self, uint32_t parts)
{
    const int64_t way_um =
        (int64_t)self->parts[self->at].depth_um - (int64_t)earlier(self, parts)->depth_um;
    return fixed_within(way_um, -MOST_WAY_UM, MOST_WAY_UM);
}

/* The fastest mean speed of the window; where its parts have none yet, 0. */
static int64_t fastest_nm_per_s(const membrane_detector_t *self)
{
    int64_t fastest_nm_per_s = 0;
    for (uint32_t i = 0U; i < MEMBRANE_PARTS; i++) {
        fastest_nm_per_s = fixed_larger(fastest_nm_per_s, self->parts[i].speed_nm_per_s);
    }
    return fastest_nm_per_s;
}

/* Speeds are known once all parts have a beginning. */
static void measure_speeds(membrane_detector_t *self)
{
    if (self->begun < MEMBRANE_PARTS) {
        return;
    }
    self->speed_nm_per_s = fixed_divide_by(way_since(self, SPEED_PARTS) * NM_PER_UM * MS_PER_S,
                                           LIMIT_MEMBRANE_SPEED_MS);
    self->recent_nm_per_s = fixed_divide_by(way_since(self, RECENT_PARTS) * NM_PER_UM * MS_PER_S,
                                            LIMIT_MEMBRANE_RECENT_MS);
    self->parts[self->at].speed_nm_per_s = self->speed_nm_per_s;
    const uint32_t forget_parts = FORGET_PARTS;
    const int64_t left_nm_per_s =
        self->before_nm_per_s - (self->before_nm_per_s / (int64_t)forget_parts);
    self->before_nm_per_s = fixed_larger(fastest_nm_per_s(self), left_nm_per_s);
}

static void begin_part(membrane_detector_t *self, int32_t depth_um)
{
    if (self->in_part == 0U) {
        self->at = (self->at + 1U) % MEMBRANE_PARTS;
        self->parts[self->at].depth_um = depth_um;
        self->parts[self->at].peak_mn_q12 = INT32_MIN;
        self->begun += (self->begun < MEMBRANE_PARTS) ? 1U : 0U;
        self->looked += ((self->looked > 0U) && (self->looked < MEMBRANE_PARTS)) ? 1U : 0U;
        measure_speeds(self);
    }
    self->in_part = (self->in_part + 1U) % MEMBRANE_PART_MS;
}

static bool is_near_last(const membrane_detector_t *self, int32_t depth_um)
{
    const int64_t away_um = fixed_magnitude((int64_t)depth_um - (int64_t)self->last_um);
    return (self->has_last != 0U) && (away_um < (int64_t)LIMIT_MEMBRANE_REFRACTORY_UM);
}

/* Whether the force of this millisecond may be part of a puncture. */
static bool is_looking(membrane_detector_t *self, const membrane_view_t *view)
{
    const bool is_slow =
        self->speed_nm_per_s < ((int64_t)LIMIT_MEMBRANE_SLOWEST_UM_PER_S * NM_PER_UM);
    if (view->is_blind || !view->is_inserting || is_slow) {
        self->from_um = fixed_saturate((int64_t)view->depth_um + (int64_t)LIMIT_MEMBRANE_BEGIN_UM);
        if (view->is_blind) {
            self->is_blind = 1U;
        }
        return false;
    }
    if (view->depth_um < self->from_um) {
        return false;
    }
    self->is_blind = 0U;
    return !is_near_last(self, view->depth_um);
}

static void keep_peak(membrane_detector_t *self, int32_t force_mn_q12, int32_t depth_um)
{
    membrane_part_t *const part = &self->parts[self->at];
    if ((self->looked == 0U) || (force_mn_q12 >= part->peak_mn_q12)) {
        part->peak_mn_q12 = force_mn_q12;
        part->peak_depth_um = depth_um;
    }
    self->looked += (self->looked == 0U) ? 1U : 0U;
}

static const membrane_part_t *find_peak(const membrane_detector_t *self)
{
    const membrane_part_t *peak = earlier(self, 0U);
    for (uint32_t i = 1U; i < self->looked; i++) {
        const membrane_part_t *const part = earlier(self, i);
        peak = (part->peak_mn_q12 > peak->peak_mn_q12) ? part : peak;
    }
    return peak;
}

static bool is_by_slowing(const membrane_detector_t *self, int64_t peak_mn_q12, int64_t fall_mn_q12)
{
    const int64_t lost_nm_per_s = self->before_nm_per_s - self->recent_nm_per_s;
    return (fall_mn_q12 * self->before_nm_per_s) < (peak_mn_q12 * lost_nm_per_s);
}

/* The fall of a puncture, mN with 12 fraction bits; 0: there is none. */
static int64_t find_fall(const membrane_detector_t *self, int32_t force_mn_q12, int32_t depth_um)
{
    const membrane_part_t *const peak = find_peak(self);
    const int64_t fall_mn_q12 = (int64_t)peak->peak_mn_q12 - (int64_t)force_mn_q12;
    const int64_t way_um = (int64_t)depth_um - (int64_t)peak->peak_depth_um;
    /* Times UM_PER_MM, for want of a division. */
    const int64_t steep_mn_q12 = (int64_t)LIMIT_MEMBRANE_SLOPE_MN_PER_MM * MEMBRANE_MN_Q12 * way_um;
    const bool is_fall = (fall_mn_q12 >= (int64_t)self->floor_mn_q12) && (way_um > 0) &&
                         ((fall_mn_q12 * UM_PER_MM) >= steep_mn_q12) &&
                         !is_by_slowing(self, (int64_t)peak->peak_mn_q12, fall_mn_q12);
    return is_fall ? fall_mn_q12 : 0;
}

static membrane_event_t puncture(membrane_detector_t *self, membrane_list_t *list, int32_t depth_um,
                                 int64_t fall_mn_q12)
{
    membrane_event_t event = {.kind = (uint32_t)MEMBRANE_EVENT_EXPECTED, .depth_um = depth_um};
    event.fall_mn = (int32_t)(fall_mn_q12 / MEMBRANE_MN_Q12);
    event.place = membrane_list_take(list, depth_um);
    if (event.place == MEMBRANE_NONE) {
        event.kind = (uint32_t)MEMBRANE_EVENT_UNEXPECTED;
    }
    self->last_um = depth_um;
    self->has_last = 1U;
    self->looked = 0U;
    return event;
}

static membrane_event_t passed(membrane_list_t *list, int32_t depth_um)
{
    membrane_event_t event = {.kind = (uint32_t)MEMBRANE_EVENT_NONE, .place = MEMBRANE_NONE};
    event.place = membrane_list_pass(list, depth_um);
    if (event.place != MEMBRANE_NONE) {
        event.kind = (uint32_t)MEMBRANE_EVENT_MISSED;
        event.depth_um = list->membranes[event.place].depth_um;
    }
    return event;
}

membrane_event_t membrane_detector_step(membrane_detector_t *self, membrane_list_t *list,
                                        const membrane_view_t *view)
{
    const int32_t force_mn_q12 = membrane_filter_step(&self->filter, view->force_mn);
    begin_part(self, view->depth_um);
    if (is_looking(self, view)) {
        keep_peak(self, force_mn_q12, view->depth_um);
        const int64_t fall_mn_q12 = find_fall(self, force_mn_q12, view->depth_um);
        if (fall_mn_q12 > 0) {
            return puncture(self, list, view->depth_um, fall_mn_q12);
        }
    } else {
        self->looked = 0U;
    }
    return passed(list, view->depth_um);
}

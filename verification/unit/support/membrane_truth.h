/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The equations of core/sensor/membrane_detector.h in double precision, on all samples of an
 * insertion that never rests. It keeps all of them instead of a ring.
 */
#ifndef BORESIGHT_MEMBRANE_TRUTH_H
#define BORESIGHT_MEMBRANE_TRUTH_H

#include "limits/requirement_limits.h"
#include "sensor/membrane_detector.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#define MEMBRANE_TRUTH_MS 80000U

static struct {
    double filtered_n[MEMBRANE_TRUTH_MS];
    double depth_mm[MEMBRANE_TRUTH_MS];
    double in_n[2];
    uint32_t count;
    uint32_t from; /* No peak is older. */
    double before_mm_per_s;
    double last_mm;
} membrane_truth;

static void membrane_truth_init(void)
{
    membrane_truth.count = 0U;
    membrane_truth.from = 0U;
    membrane_truth.before_mm_per_s = 0.0;
    membrane_truth.last_mm = -1e9;
}

static double membrane_truth_filter(double force_n)
{
    const uint32_t i = membrane_truth.count;
    const double k = tan(3.14159265358979323846 * LIMIT_MEMBRANE_FILTER_HZ / 1000.0);
    const double n = 1.0 + (sqrt(2.0) * k) + (k * k);
    const double a1 = 2.0 * ((k * k) - 1.0) / n;
    const double a2 = (1.0 - (sqrt(2.0) * k) + (k * k)) / n;
    const double in1 = (i == 0U) ? force_n : membrane_truth.in_n[0];
    const double in2 = (i == 0U) ? force_n : membrane_truth.in_n[1];
    const double out1 = (i < 1U) ? force_n : membrane_truth.filtered_n[i - 1U];
    const double out2 = (i < 2U) ? out1 : membrane_truth.filtered_n[i - 2U];
    membrane_truth.in_n[1] = in1;
    membrane_truth.in_n[0] = force_n;
    return (k * k / n * (force_n + (2.0 * in1) + in2)) - (a1 * out1) - (a2 * out2);
}

/* Mean speed of `ms` up to `at`. */
static double membrane_truth_speed(uint32_t at, uint32_t ms)
{
    return 1000.0 * (membrane_truth.depth_mm[at] - membrane_truth.depth_mm[at - ms]) / ms;
}

static bool membrane_truth_is_puncture(uint32_t at, double noise_n)
{
    /* Speeds and windows begin at whole parts. */
    const uint32_t part = at - (at % MEMBRANE_PART_MS);
    const uint32_t window = part - LIMIT_MEMBRANE_WINDOW_MS + MEMBRANE_PART_MS;
    uint32_t peak = (window > membrane_truth.from) ? window : membrane_truth.from;
    for (uint32_t i = peak; i <= at; i++) {
        peak = (membrane_truth.filtered_n[i] >= membrane_truth.filtered_n[peak]) ? i : peak;
    }
    const double peak_n = membrane_truth.filtered_n[peak];
    const double fall_n = peak_n - membrane_truth.filtered_n[at];
    const double way_mm = membrane_truth.depth_mm[at] - membrane_truth.depth_mm[peak];
    const double v = membrane_truth_speed(part, LIMIT_MEMBRANE_RECENT_MS);
    const double before = membrane_truth.before_mm_per_s;
    return (fall_n >=
            fmax(LIMIT_MEMBRANE_FLOOR_SIGMAS * noise_n, LIMIT_MEMBRANE_LEAST_MN / 1000.0)) &&
           (way_mm > 0.0) && (fall_n >= LIMIT_MEMBRANE_SLOPE_MN_PER_MM / 1000.0 * way_mm) &&
           (fall_n >= peak_n * (before - v) / before);
}

/* One millisecond; true: a puncture. */
static bool membrane_truth_step(double force_n, double depth_mm, double noise_n)
{
    const uint32_t at = membrane_truth.count;
    membrane_truth.filtered_n[at] = membrane_truth_filter(force_n);
    membrane_truth.depth_mm[at] = depth_mm;
    membrane_truth.count++;
    if (at < LIMIT_MEMBRANE_SPEED_MS) {
        membrane_truth.from = at + 1U;
        return false;
    }
    if ((at % MEMBRANE_PART_MS) == 0U) {
        const double parts = (double)LIMIT_MEMBRANE_FORGET_MS / (double)MEMBRANE_PART_MS;
        membrane_truth.before_mm_per_s *= 1.0 - (1.0 / parts);
        for (uint32_t ago = 0U;
             (ago < LIMIT_MEMBRANE_WINDOW_MS) && (at >= (ago + LIMIT_MEMBRANE_SPEED_MS));
             ago += MEMBRANE_PART_MS) {
            membrane_truth.before_mm_per_s =
                fmax(membrane_truth.before_mm_per_s,
                     membrane_truth_speed(at - ago, LIMIT_MEMBRANE_SPEED_MS));
        }
    }
    const double begin_mm =
        membrane_truth.depth_mm[LIMIT_MEMBRANE_SPEED_MS - 1U] + (LIMIT_MEMBRANE_BEGIN_UM / 1000.0);
    if ((depth_mm < begin_mm) ||
        (fabs(depth_mm - membrane_truth.last_mm) < LIMIT_MEMBRANE_REFRACTORY_UM / 1000.0)) {
        membrane_truth.from = at + 1U;
        return false;
    }
    if (!membrane_truth_is_puncture(at, noise_n)) {
        return false;
    }
    membrane_truth.last_mm = depth_mm;
    return true;
}

#endif

/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/model/sim_space.h"

#include <stdint.h>

#define UNIT_STEPS 6U /* Newton's, from 0.5 or 1.5 to the last bit. */
#define QUARTER_RAD 1.5707963267948966
#define QUARTER_REST_RAD 6.123233995736766e-17 /* What the double above lacks. */
#define TERMS 9U                               /* Taylor's, for up to an eighth of a turn. */

sim_vector_t sim_space_unit(sim_vector_t vector)
{
    sim_vector_t unit = vector;

    for (uint32_t i = 0U; i < UNIT_STEPS; i++) {
        const double by = 0.5 * (3.0 - sim_space_dot(unit, unit)) - 1.0;
        unit = sim_space_add(unit, by, unit);
    }
    return unit;
}

/* 1 - s / (n (n + 1)) + ..., where n is `first` and s the square of the angle: the cosine from 1
 * on, and from 2 on the sine's share of the angle. */
static double series(double square, double first)
{
    double sum = 1.0;

    for (uint32_t i = TERMS; i > 0U; i--) {
        const double n = first + 2.0 * (double)(i - 1U);
        sum = 1.0 - square / (n * (n + 1.0)) * sum;
    }
    return sum;
}

/* The sine of `rad` and `quarters` more quarters of a turn. */
static double sine_after(double rad, int64_t quarters)
{
    const double turned = rad / QUARTER_RAD;
    const int64_t whole = (int64_t)((turned < 0.0) ? (turned - 0.5) : (turned + 0.5));
    const double rest = (rad - (double)whole * QUARTER_RAD) - (double)whole * QUARTER_REST_RAD;
    const uint64_t quarter = (uint64_t)(whole + quarters) % 4U;
    const double value =
        ((quarter % 2U) == 0U) ? (rest * series(rest * rest, 2.0)) : series(rest * rest, 1.0);

    return (quarter < 2U) ? value : -value;
}

double sim_space_sine(double rad)
{
    return sine_after(rad, 0);
}

double sim_space_cosine(double rad)
{
    return sine_after(rad, 1);
}

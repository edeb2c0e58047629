/* SPDX-License-Identifier: Apache-2.0 */
/** @file Vectors, and the sine of any angle, for the simulated world. Sums and products only: the
 * bits are the same on every machine. Stateless. */
#ifndef BORESIGHT_SIM_SPACE_H
#define BORESIGHT_SIM_SPACE_H

#define SIM_RAD_PER_DEG 0.017453292519943295

typedef struct {
    double x;
    double y;
    double z;
} sim_vector_t;

/** `a` + `by` `b`. */
static inline sim_vector_t sim_space_add(sim_vector_t a, double by, sim_vector_t b)
{
    return (sim_vector_t){a.x + by * b.x, a.y + by * b.y, a.z + by * b.z};
}

static inline double sim_space_dot(sim_vector_t a, sim_vector_t b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline sim_vector_t sim_space_cross(sim_vector_t a, sim_vector_t b)
{
    return (sim_vector_t){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** A vector of a length from 0.5 to 1.5 as one of the length 1. */
sim_vector_t sim_space_unit(sim_vector_t vector);

/** Within 1e-12 for angles of up to 1000 turns. */
double sim_space_sine(double rad);
double sim_space_cosine(double rad);

#endif

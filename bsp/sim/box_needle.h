/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Where the needle of the simulated box truly is: in the z-frame, and on its line, the needle that
 * is not bent, at whose depth 0 the insertion is 0. x and y across it are those of the tip at the
 * rotation 0. No controller sees it, but by images. The needle is the one of the robot's file.
 */
#ifndef BORESIGHT_BOX_NEEDLE_H
#define BORESIGHT_BOX_NEEDLE_H

#include "base/rigid.h"
#include "sim/box.h"

/** The needle's line in the z-frame. */
void box_needle_line(const box_t *self, rigid_t *zframe_line);

/** The true tip on its line: of a probe that is free, too. */
sim_tip_t box_needle_tip(const box_t *self);

/** The target of the phantom as it has moved, on the needle's line. */
sim_vector_t box_needle_target(const box_t *self);

/** A place on the line as one of the z-frame. */
sim_vector_t box_needle_place(const rigid_t *zframe_line, sim_vector_t place_mm);

/** A direction, the same. */
sim_vector_t box_needle_direction(const rigid_t *zframe_line, sim_vector_t direction);

/**
 * Writes what there is to see of the needle on its line; nothing without tissue.
 *
 * @satisfies SWR-BOX-777
 */
void box_needle_show(const box_t *self, bsp_bench_needle_t *seen);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A hand at the handle of an axis. It presses with a force, whatever the handle does, or it holds
 * on like a spring to a place that it wishes the handle at, which may move. The motor holds the
 * handle by friction: only a controller that measures the force lets it go. The design is ours;
 * stiffness of 0.2 to 5 N/mm is that of hands.
 */
#ifndef BORESIGHT_SIM_HAND_H
#define BORESIGHT_SIM_HAND_H

#define SIM_HAND_MOST_N 30.0            /**< No hand is stronger. */
#define SIM_HAND_STIFFNESS_N_PER_MM 1.0 /**< Until it is set. */

typedef enum {
    SIM_HAND_OFF = 0,   /**< It does not touch the handle. */
    SIM_HAND_PRESS = 1, /**< Constant force. */
    SIM_HAND_SPRING = 2 /**< Spring to a place. */
} sim_hand_act_t;

/** State of the hand; all forces are positive in the direction of the insertion. */
typedef struct {
    sim_hand_act_t act;
    double press_n;            /**< Force of SIM_HAND_PRESS. */
    double stiffness_n_per_mm; /**< Of SIM_HAND_SPRING, above 0. */
    double wish_mm;            /**< The place, as a position of the handle, */
    double wish_mm_per_s;      /**< and its speed. */
    double force_n;            /**< Force on the handle. */
} sim_hand_t;

/** A hand that does not touch the handle. */
void sim_hand_init(sim_hand_t *self);

/** Lets go. */
void sim_hand_release(sim_hand_t *self);

/** Presses with `force_n`, below 0 outwards. */
void sim_hand_press(sim_hand_t *self, double force_n);

/** Wishes the handle, which is at `handle_mm`, `by_mm` farther in, and moves that wish by
 * `mm_per_s`. A hand that was a spring already moves on from its wish if `by_mm` is 0. */
void sim_hand_wish(sim_hand_t *self, double handle_mm, double by_mm, double mm_per_s);

/**
 * Advances by `step_s`; the handle is at `handle_mm` then.
 *
 * @satisfies SWR-BOX-525
 */
void sim_hand_step(sim_hand_t *self, double step_s, double handle_mm);

#endif

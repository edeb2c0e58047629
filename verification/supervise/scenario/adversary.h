/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Adversarial fault injector of the simulated box; it also works the pedal. In a scene it has one
 * plan: the broken part, the rhythm, and how the pedal is tapped. One part of one
 * axis at a time: two faults that hide each other are no plan. The scenario owns one.
 */
#ifndef BORESIGHT_ADVERSARY_H
#define BORESIGHT_ADVERSARY_H

#include "integration/support/rig.h"
#include "sim/model/sim_random.h"
#include "supervise/watch/coupled_limit_jogs.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Subject of a scene. */
typedef enum {
    FOE_TAPS = 0,     /**< The pedal is tapped; an encoder, or nothing, is broken for good. */
    FOE_FLICKER = 1,  /**< An encoder is broken for some ms of every few. */
    FOE_IMPOSTOR = 2, /**< A switch that is homed by acts as if it were elsewhere. */
    FOE_MOTOR = 3,    /**< A motor is weak, strong, stuck, running or loaded, on and off. */
    FOE_COUPLED = 4,  /**< Axes are far out in a coupled limit when one of them is lost. */
    FOE_REST = 5,     /**< Something is broken only while nothing is to move. */
    FOE_SHORT = 6     /**< An encoder is broken, and all moves are short. */
} adversary_plan_t;

#define FOE_PLANS 7U

/** Acts of the operator when all axes are homed and nothing is armed. */
typedef enum {
    FOE_ASKS_TARGETS = 0, /**< The step that the console asks for. */
    FOE_ASKS_NEAR = 1,    /**< The same, with each target near the one before. */
    FOE_ASKS_JOGS = 2,    /**< Jogs of its axis to anywhere. */
    FOE_ASKS_SHORT = 3,   /**< Jogs of its axis by a few ticks. */
    FOE_ASKS_APART = 4    /**< Jogs of the axes of a coupled limit, far out. */
} adversary_wish_t;

/** When the part is broken. */
typedef enum {
    FOE_ALWAYS = 0,
    FOE_HOMED = 1,  /**< Once all axes were homed. */
    FOE_MOVING = 2, /**< While an order moves. */
    FOE_IDLE = 3    /**< Homed, and nothing is armed. */
} adversary_when_t;

/** State of the enemy. */
typedef struct {
    const robot_t *robot;
    sim_random_t random;
    adversary_plan_t plan;
    adversary_wish_t wish;
    uint32_t start; /**< 0: power-on, 1: homed, 2: with a target. */
    uint32_t axis;
    coupled_limit_jogs_t apart; /**< Jogs of FOE_COUPLED. */
    uint32_t part; /**< Part of the axis, and its fault; indices into lists of adversary.c. */
    uint32_t fault;
    double load;
    adversary_when_t when;
    uint32_t from_cycle;
    uint32_t broken_ms; /**< Broken time of its rhythm; 0: nothing is ever broken. */
    uint32_t whole_ms;  /**< 0: it stays broken. */
    uint32_t on_ms;     /**< The pedal's rhythm; 0: the operator has it. */
    uint32_t off_ms;
    uint32_t lose_cycle; /**< A card falls silent: the reference is lost; UINT32_MAX: never. */
    uint32_t lost_axis;
    uint32_t free_ms;   /**< The impostor: free so long after backing off began. */
    int32_t past_ticks; /**< And pressed again so far beyond its place. */
    uint32_t approach_ms;
    bool has_mercy; /**< It is whole for a while after it was found out. */
    /* State of the play. */
    uint32_t cycle;
    bool was_homed;
    bool is_broken;
    uint32_t rhythm_cycles; /**< Left of this half of the rhythm. */
    uint32_t mercy_cycles;
    bool is_pressing;
    uint32_t pedal_cycles;
    bool is_outwards; /**< Short jogs go upwards. */
    uint32_t leg;     /**< axis_reference_t of the cycle before. */
    uint32_t leg_cycles;
    double edge_ticks;
} adversary_t;

/** Makes a plan for the scene `seed` of `robot` and starts the rig that it needs. */
void adversary_begin(adversary_t *self, rig_t *rig, const robot_t *robot, uint32_t seed);

/** Acts of the enemy before the next cycle, after the operator. @return something is broken */
bool adversary_play(adversary_t *self, rig_t *rig);

/** The jog that the operator wishes for now. */
command_t adversary_jog(adversary_t *self, const rig_t *rig);

/** The plan in words. */
void adversary_describe(const adversary_t *self, char *text, size_t size);

#endif

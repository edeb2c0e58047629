/* SPDX-License-Identifier: Apache-2.0 */
/** @file What is played, and which robot can give it. */
#ifndef BORESIGHT_PLAY_H
#define BORESIGHT_PLAY_H

#include "interface/command.h"
#include "robot/robot.h"

#include <stdbool.h>

/** Kind of play. */
typedef enum {
    PLAY_RANDOM = 0,      /**< Anything, with at most one fault at a time. */
    PLAY_CORNERS = 1,     /**< Moves to targets at the ends of the axes' ways; no fault. */
    PLAY_INTERRUPTED = 2, /**< Moves under a pedal that is released again and again; no fault. */
    PLAY_SPREAD = 3,      /**< Moves of motors up to a fifth faster or slower than their table. */
    PLAY_JOGS = 4,        /**< Anything, most of it jogs, before homing and after it; no fault. */
    PLAY_TAPS = 5,        /**< An enemy at the pedal and the fault keyboard: one plan a scene. */
    PLAY_MAGNITUDE = 6,   /**< As PLAY_SPREAD; cards without pwm take magnitudes. */
    PLAY_RIVALS = 7,      /**< Pages and connections that all want to command; no fault. */
    PLAY_MODES = 8,       /**< One order of any mode after the other; no fault. */
    PLAY_PROGRAMS = 9,    /**< As PLAY_MODES, mostly treatment programs, with their gate; faults in
                             every other scene. */
    PLAY_SWEEPS = 10,     /**< As PLAY_MODES, mostly sweeps; faults in every other scene. */
    PLAY_FLIPS = 11,      /**< Bits of the memory change; the scenes are of PLAY_RANDOM. */
    PLAY_OPERATOR = 12,   /**< An operator comes into a scene of any of these and follows the next
                             step alone. */
    PLAY_LATE = 13,       /**< As PLAY_MODES, from power-on in every third scene: time and wires are
                             the enemy; in every other scene something of an axis breaks as well. */
    PLAY_HANDS = 14       /**< Insertions by any hand; in every other scene load cells break. */
} play_t;

/** Names of all plays, between bars. */
#define PLAY_NAMES                                                                                 \
    "random|corners|interrupted|spread|jogs|taps|magnitude|rivals|modes|programs|sweeps|flips|"    \
    "operator|late|hands"

/** The play `name` of PLAY_NAMES, or -1. */
int play_find(const char *name);

/** Why `robot` cannot give `play`, as a sentence; NULL: it can. */
const char *play_refusal(const robot_t *robot, play_t play);

/** Kind of most of its orders, COMMAND_NONE: any. */
command_kind_t play_theme(play_t play);

/** One order after the other is given. */
bool play_is_of_orders(play_t play);

/** So many scenes are asked for, and not so many moves. */
bool play_is_of_scenes(play_t play);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * An oracle that sees what the controller cannot: where the simulated axes truly stand. Holds a
 * list of sentences against every cycle, and remembers which were broken, where first and by how
 * much.
 */
#ifndef BORESIGHT_MOTION_ORACLE_H
#define BORESIGHT_MOTION_ORACLE_H

#include "integration/support/rig.h"
#include "limits/requirement_limits.h"
#include "supervise/watch/hand_watch.h"
#include "supervise/watch/order_watch.h"
#include "supervise/watch/program_watch.h"
#include "supervise/watch/authority_oracle.h"
#include "supervise/watch/sweep_watch.h"

#include <stdbool.h>
#include <stdint.h>

#define MOTION_ORACLE_SECOND 1000U /**< Cycles. */
#define MOTION_ORACLE_MEAN                                                                         \
    (LIMIT_MEAN_SPEED_TIME_US / LIMIT_CYCLE_US) /**< Cycles of a mean speed. */
#define MOTION_ORACLE_LATE 10000U               /**< Cycles after a profile's end, counted apart. */

/** Sentences that must hold in every cycle. */
typedef enum {
    SENTENCE_PERMIT = 0,   /**< A drive leaves only with pedal, e-stop, scanner, cards, order. */
    SENTENCE_BELIEVED = 1, /**< A homed axis without a fault stands where it is believed to. */
    SENTENCE_OFF = 2,      /**< An axis that moves while off does not stay homed. */
    SENTENCE_ENDS = 3,     /**< A move under the pedal ends. */
    SENTENCE_NEEDLE = 4,   /**< Homing drives the needle forwards by little only. */
    SENTENCE_REACHED = 5,  /**< "Nothing; the target is reached": it is. */
    SENTENCE_COUPLED = 6,  /**< Axes keep their coupled limits, or come back to them. */
    SENTENCE_CALM = 7,     /**< As long as nothing is broken, no fault is found and no move lost. */
    SENTENCE_BEYOND =
        8, /**< No axis goes beyond the end of its profile by more than its deadband. */
    SENTENCE_SPEED = 9,    /**< In a short mean no axis is faster than its speed. */
    SENTENCE_ACROSS = 10,  /**< No jog drives anything across a needle that is in. */
    SENTENCE_INWARDS = 11, /**< A needle that is not homed is not jogged inwards. */
    SENTENCE_HOMING = 12,  /**< Homing drives only the axis that homes, and its followers. */
    SENTENCE_TARGET = 13,  /**< A proposal changes no target that was accepted. */
    SENTENCE_OUT = 14,     /**< A retraction drives the needle outwards only. */
    SENTENCE_PROBE = 15,   /**< Lengths of the probe are those sent last, or none. */
    SENTENCE_ACCUSED = 16, /**< An axis of which nothing is broken is not called faulty. */
    SENTENCE_ORDER = 17,   /**< From here on: those of order_rule_t. */
    /** From here on: those of sweep_rule_t. */
    SENTENCE_SWEEP = SENTENCE_ORDER + (int)ORDER_RULES,
    /** From here on: those of program_rule_t. */
    SENTENCE_PROGRAM = SENTENCE_SWEEP + (int)SWEEP_RULES,
    /** From here on: those of hand_rule_t. */
    SENTENCE_HAND = SENTENCE_PROGRAM + (int)PROGRAM_RULES,
    /** From here on: those of authority_oracle_rule_t. */
    SENTENCE_AUTHORITY = SENTENCE_HAND + (int)HAND_RULES
} sentence_t;

#define SENTENCE_COUNT ((uint32_t)SENTENCE_AUTHORITY + AUTHORITY_RULES)

/** A sentence's record. */
typedef struct {
    uint32_t episodes; /**< In which it was broken. */
    uint32_t seed;     /**< Scene of the first of them. */
    uint32_t cycle;
    uint32_t axis; /**< In SENTENCE_COUPLED: the limit. */
    double worst;  /**< In its own unit: mm or degrees, seconds. */
} verdict_t;

/** Motion that ends after a profile. */
typedef enum {
    ENDING_MOVE = 0,   /**< A move. */
    ENDING_NON_PWM = 1 /**< A leg of a move in which an axis without pwm has a way. */
} ending_t;

#define ENDING_COUNT 2U

/** How many ended so many cycles after their profile, in all episodes. */
typedef struct {
    uint32_t count;
    uint32_t late[MOTION_ORACLE_LATE];
} endings_t;

/** State of the oracle; one episode at a time. */
typedef struct {
    uint32_t seed;
    bool is_sound; /**< Nothing of an axis was broken, whatever the time and the wires do. */
    uint32_t found[EVENT_ID_COUNT]; /**< Events in all episodes. */
    endings_t endings[ENDING_COUNT];
    verdict_t verdicts[SENTENCE_COUNT];
    bool is_broken[SENTENCE_COUNT];                    /**< In this episode. */
    double rest[ROBOT_AXIS_MAX][MOTION_ORACLE_SECOND]; /**< True positions of the last second. */
    uint32_t off_cycles[ROBOT_AXIS_MAX];
    uint32_t half_cycles[ROBOT_AXIS_MAX]; /**< Left of a second after half counts. */
    uint32_t astray_cycles[ROBOT_AXIS_MAX];
    double swept_off[ROBOT_AXIS_MAX]; /**< Ticks that its encoder has missed in a sweep. */
    uint32_t untrue_cycles;           /**< An arrival is shown that is none. */
    double places[ROBOT_AXIS_MAX][MOTION_ORACLE_MEAN]; /**< True positions of the last cycles. */
    uint32_t looks;
    uint32_t moving_cycles;
    uint32_t lost_carriages;              /**< When that motion began. */
    uint32_t over_cycles;                 /**< Since the profile of the last leg has ended. */
    bool is_non_pwm_over;                 /**< An axis without pwm had a way in it. */
    double needle_from;                   /**< Where homing began. */
    int32_t target_ticks[ROBOT_AXIS_MAX]; /**< As accepted. */
    bool has_looked;
    bool was_homing;
    plan_t plan;   /**< Plan of the cycle before. */
    probe_t probe; /**< The probe that was sent last. */
    order_watch_t order_watch;
    sweep_watch_t sweep_watch;
    program_watch_t program_watch;
    hand_watch_t hand_watch;
    authority_oracle_t authority_oracle;
    uint32_t armed[COMMAND_KIND_COUNT]; /**< Orders in all episodes before this one. */
    uint32_t done[COMMAND_KIND_COUNT];  /**< How many of them ended as asked. */
    uint32_t losses_in_motion;
    uint32_t losses[AUTHORITY_LOSSES];    /**< In all episodes, by authority_loss_t. */
    bool is_retracting;                   /**< A retraction was accepted and has not ended. */
    uint32_t idle_cycles[ROBOT_AXIS_MAX]; /**< Driven in homing without a part in it. */
    double coupled_beyond[ROBOT_COUPLED_LIMITS]; /**< How far beyond each may be, mm or degrees. */
} motion_oracle_t;

/** Begins an episode; the verdicts stay. */
void motion_oracle_begin(motion_oracle_t *self, uint32_t seed);

/** Forgets what this episode has broken so far. */
void motion_oracle_forgive(motion_oracle_t *self);

/** Looks at the cycle that `rig` has just run; `truth`: the positions when its frames were made;
 * `is_disturbed`: something in the scene is or was broken. */
void motion_oracle_look(motion_oracle_t *self, const rig_t *rig, const double truth[ROBOT_AXIS_MAX],
                        bool is_disturbed);

/** Notes that a sentence is broken by `axis`, or by a limit, and by how much; for the parts of the
 * oracle. */
void motion_oracle_complain(motion_oracle_t *self, const rig_t *rig, sentence_t sentence,
                            uint32_t axis, double figure);

/** So many cycles after the end of its profile an `ending` came, in `percent` of all. */
uint32_t motion_oracle_late(const motion_oracle_t *self, ending_t ending, uint32_t percent);

/** The sentence in words, and the unit of `worst`. */
const char *motion_oracle_sentence(sentence_t sentence);

#endif

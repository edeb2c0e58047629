/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Independent oracle of command authority: derives the holder from inputs and frames, not from the
 * chart, and checks five rules in every cycle.
 */
#ifndef BORESIGHT_AUTHORITY_ORACLE_H
#define BORESIGHT_AUTHORITY_ORACLE_H

#include "integration/support/rig.h"

#include <stdbool.h>
#include <stdint.h>

/** Each a bit of authority_oracle_look(). */
typedef enum {
    AUTHORITY_ONE = 0,  /**< Only the holder commands; between two it is lost, and the axes rest. */
    AUTHORITY_LOST = 1, /**< Lost by its holder, by silence, or by button and released pedal. */
    AUTHORITY_RENEWED = 2, /**< A page that has it has given a sign of life. */
    AUTHORITY_AFTER = 3,   /**< After a loss nothing is driven before another order and press. */
    AUTHORITY_ARMED = 4    /**< Only the holder arms, and nothing stays armed without one. */
} authority_oracle_rule_t;

#define AUTHORITY_RULES 5U
#define AUTHORITY_LOSSES 4U /**< Values of authority_loss_t. */

/** At first all zero. */
typedef struct {
    bool has_looked;
    authority_party_t holder; /**< As shown in the cycle before; peer 0: none. */
    authority_party_t asked;  /**< The party that asked for it last. */
    bool is_ending;           /**< It was lost and no party has had it since. */
    uint32_t lost_us;         /**< So long ago. */
    bool has_rested;          /**< All axes at once, in a cycle since the loss. */
    uint32_t silent_us;       /**< Since its holder's last accepted command. */
    bool has_heard;           /**< False for a holder from before the first look. */
    uint32_t pressed_us;      /**< The button, with the pedal released. */
    bool is_barred;           /**< Since a loss no party has armed and then pressed. */
    bool is_armed_anew;
    bool was_moving;                   /**< In the cycle before. */
    uint32_t losses[AUTHORITY_LOSSES]; /**< How many there were, by authority_loss_t. */
    uint32_t losses_in_motion;         /**< How many of them. */
} authority_oracle_t;

/** Looks at the cycle that `rig` has just run. @return the rules that it broke */
uint32_t authority_oracle_look(authority_oracle_t *self, const rig_t *rig);

#endif

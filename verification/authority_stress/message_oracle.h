/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * An oracle of every cycle of a contest for authority: it keeps a book of its own of the holder, by
 * what was said and answered, and holds it against what the controller shows and drives.
 */
#ifndef BORESIGHT_MESSAGE_ORACLE_H
#define BORESIGHT_MESSAGE_ORACLE_H

#include "controller/controller.h"

#include <stdbool.h>
#include <stdint.h>

/** Sentences that must hold in every cycle. */
typedef enum {
    SENTENCE_ONE = 0,     /**< One holds at a time, and it is who is shown. */
    SENTENCE_REST = 1,    /**< Between two holders the axes rest, or their time has passed. */
    SENTENCE_WAY = 2,     /**< It is taken by a command, or by the button pressed for it. */
    SENTENCE_OBEYED = 3,  /**< Only the holder is obeyed. */
    SENTENCE_ARMED = 4,   /**< An order is of the holder, and does not outlive its authority. */
    SENTENCE_OFF = 5,     /**< Without the owner of its order no axis is driven. */
    SENTENCE_STOP = 6,    /**< No stop is refused for want of authority. */
    SENTENCE_ANSWERED = 7 /**< Each command is answered, and each refusal has a name. */
} sentence_t;

#define SENTENCE_COUNT 8U
#define LOSSES ((uint32_t)AUTHORITY_LOSS_TAKEN + 1U)

/** A page or a connection; peer 0 is none. */
typedef struct {
    uint32_t source;
    uint32_t peer;
} party_t;

/** All zero at first. */
typedef struct {
    uint32_t cycles;
    uint32_t broken[SENTENCE_COUNT];       /**< Cycles. */
    uint32_t first_cycle[SENTENCE_COUNT];  /**< The first of them. */
    uint32_t takes[COMMAND_SOURCE_COUNT];  /**< By source. */
    uint32_t losses[LOSSES];               /**< By authority_loss_t. */
    uint32_t orders[COMMAND_SOURCE_COUNT]; /**< Armed, by source. */
    uint32_t driven;                       /**< Cycles in which an axis was. */
    uint32_t cut;                          /**< Losses while an axis was driven. */
    uint32_t refused;                      /**< For want of authority. */
    uint32_t stops;                        /**< Sent without authority. */
    party_t holder;
    party_t owner; /**< Owner of the armed order. */
    party_t asker; /**< Party whose request to take it stands. */
    uint64_t time_us;
    uint64_t asked_us;
    uint64_t lost_us;
    bool is_ending;    /**< It was lost, and the axes did not rest yet. */
    bool was_released; /**< The button, since it was asked for. */
    bool is_pressed;   /**< Then, with the pedal released. */
    bool is_over;      /**< Since it was lost no order was armed. */
    bool was_driven;
} message_oracle_t;

/** Looks at a cycle. */
void message_oracle_look(message_oracle_t *self, uint32_t cycle, const controller_inputs_t *inputs,
                         const controller_outputs_t *outputs);

/** The sentence in words. */
const char *message_oracle_sentence(sentence_t sentence);

#endif

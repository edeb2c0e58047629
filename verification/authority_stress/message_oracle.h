/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * An oracle of every cycle of a contest for authority: it keeps a book of its own of who has it, by
 * what was said and answered, and holds it against what the controller shows and drives.
 */
#ifndef BORESIGHT_MESSAGE_ORACLE_H
#define BORESIGHT_MESSAGE_ORACLE_H

#include "controller/controller.h"

#include <stdbool.h>
#include <stdint.h>

/** What must hold in every cycle. */
typedef enum {
    SENTENCE_ONE = 0,     /**< One holds at a time, and it is who is shown. */
    SENTENCE_REST = 1,    /**< Between two holders the axes rest, or their time has passed. */
    SENTENCE_WAY = 2,     /**< Who takes it has commanded it, or pressed the button for it. */
    SENTENCE_OBEYED = 3,  /**< Nobody is obeyed who does not have it. */
    SENTENCE_ARMED = 4,   /**< An order is of who has it, and does not outlive that. */
    SENTENCE_OFF = 5,     /**< Without who armed its order no axis is driven. */
    SENTENCE_STOP = 6,    /**< A stop is refused to nobody for want of authority. */
    SENTENCE_ANSWERED = 7 /**< Each command is answered, and each refusal has a name. */
} sentence_t;

#define SENTENCE_COUNT 8U
#define LOSSES ((uint32_t)AUTHORITY_LOSS_TAKEN + 1U)

/** A page or a connection; peer 0 is nobody. */
typedef struct {
    uint32_t source;
    uint32_t peer;
} party_t;

/** All zero at first. */
typedef struct {
    uint32_t cycles;
    uint32_t broken[SENTENCE_COUNT];       /**< Cycles. */
    uint32_t first_cycle[SENTENCE_COUNT];  /**< Of them. */
    uint32_t takes[COMMAND_SOURCE_COUNT];  /**< By source. */
    uint32_t losses[LOSSES];               /**< By authority_loss_t. */
    uint32_t orders[COMMAND_SOURCE_COUNT]; /**< Armed, by source. */
    uint32_t driven;                       /**< Cycles in which an axis was. */
    uint32_t cut;                          /**< Losses while an axis was driven. */
    uint32_t refused;                      /**< For want of authority. */
    uint32_t stops;                        /**< Of who did not have it. */
    party_t holder;
    party_t owner; /**< Of the armed order. */
    party_t asker; /**< Whose request to take it stands. */
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

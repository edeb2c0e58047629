/* SPDX-License-Identifier: Apache-2.0 */
/** @file The records of cycles and checkpoints that control hands to the recorder. */
#ifndef BORESIGHT_EXCHANGE_RECORD_H
#define BORESIGHT_EXCHANGE_RECORD_H

#include "controller/controller.h"

#include <stdint.h>

typedef enum {
    CYCLE_RECORD_CHECKPOINT = 1, /**< State of the controller before the next cycle, but rows. */
    CYCLE_RECORD_CYCLE = 2       /**< One cycle. */
} cycle_record_kind_t;

/** The board's report in a cycle, for the record only. Fixed layout, no padding. Times are in us of
 * the board's time, which wrap. */
typedef struct {
    uint32_t sampled_us;              /**< When the inputs were sampled. */
    uint32_t levels;                  /**< As bsp_inputs_t: BSP_IN_ bits as they were, */
    uint32_t dropped;                 /**< that were low since the sample before, */
    uint32_t valid;                   /**< and that were read. */
    uint32_t started_us;              /**< Start of the ended exchange; 0: there was none. */
    uint32_t finished_us;             /**< The same. */
    int32_t error;                    /**< As bsp_exchange_t. */
    uint8_t results[CARD_SLOT_COUNT]; /**< bsp_slot_result_t. */
    uint8_t reserved[2];              /**< 0. */
} cycle_board_t;

/** One cycle. */
typedef struct {
    controller_inputs_t inputs;
    controller_outputs_t outputs;
    cycle_board_t board;
} recorded_cycle_t;

/* A checkpoint also shows all bytes of a cycle. */
#define CYCLE_RECORD_BYTES                                                                         \
    ((CONTROLLER_CHECKPOINT_BYTES > sizeof(recorded_cycle_t)) ? CONTROLLER_CHECKPOINT_BYTES        \
                                                              : sizeof(recorded_cycle_t))

/** One record, as exchange_cycles.h hands it over. */
typedef struct {
    uint32_t kind;  /**< cycle_record_kind_t. */
    uint32_t cycle; /**< Controller cycle. */
    uint32_t rows;  /**< Rows of the trajectory, at a checkpoint: they are in the exchange. */
    uint32_t list;  /**< Which trajectory that is. */
    union {
        recorded_cycle_t cycle;
        uint8_t checkpoint[CYCLE_RECORD_BYTES];
    } body;
} cycle_record_t;

/** One entry of the lane: a cycle or a part of a checkpoint. */
typedef struct {
    uint32_t kind;  /**< As cycle_record_t; 0: a later part of a checkpoint. */
    uint32_t cycle; /**< The same. */
    uint32_t rows;  /**< The same. */
    uint32_t list;  /**< The same. */
    union {
        recorded_cycle_t cycle;
        uint8_t part[sizeof(recorded_cycle_t)];
    } body;
} cycle_entry_t;

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The supervisor's description of the board that control is linked with: the programs that come
 * with it and their options. The one table is made of the board's file by tools/compile/boards.rb.
 * A pattern is a text with {names}, of which each stands for an option or for one of the names in
 * board_text.h.
 */
#ifndef BORESIGHT_BOARD_H
#define BORESIGHT_BOARD_H

#include "check/check.h"

#include <stdbool.h>
#include <stdint.h>

#define BOARD_OPTIONS 8U    /**< Options of one board at most. */
#define BOARD_COMPANIONS 4U /**< Programs that come with it. */
#define BOARD_ARGUMENTS 12U /**< Arguments of one of them. */
#define BOARD_SAYINGS 4U    /**< Lines for the operator. */
/** Size of an option's value, with its end: a whole wiring fits. */
#define BOARD_VALUE_SIZE 4096U

/** The kind of value behind an option. */
typedef enum {
    BOARD_TAKES_NOTHING = 0, /**< Its text is the option itself, or nothing. */
    BOARD_TAKES_NAME = 1,    /**< Letters, digits, - and _. */
    BOARD_TAKES_NUMBER = 2,
    BOARD_TAKES_TEXT = 3
} board_takes_t;

/** An option of boresight that only this board has. */
typedef struct {
    const char *name; /**< Without its hyphens; NULL: there is none of this place. */
    board_takes_t takes;
    const char *says;      /**< Its purpose, with its default. */
    const char *otherwise; /**< Pattern of its value when it is not given; NULL: nothing. */
    uint32_t least;        /**< Least number. */
    uint32_t most;
    const char *useless_with; /**< Another one that it is refused with; NULL: none. */
} board_option_t;

/** A program that is started before control and stopped after the recorder. */
typedef struct {
    const char *program;                    /**< Without "boresight-"; NULL: none. */
    const char *arguments[BOARD_ARGUMENTS]; /**< Patterns; an empty one is left out. */
    const char *ready;  /**< Line it prints when control may start; NULL: nothing is awaited. */
    const char *unless; /**< Option that names one that runs already; NULL: none does. */
} board_companion_t;

/** A line for the operator. */
typedef struct {
    const char *title; /**< NULL: none. */
    const char *text;  /**< Pattern. */
} board_saying_t;

typedef struct {
    board_option_t options[BOARD_OPTIONS];
    board_companion_t companions[BOARD_COMPANIONS];
    const char *box;        /**< Pattern of the box that control opens. */
    const char *name;       /**< Pattern of the box's name; positions are kept for each. */
    const char *slowness;   /**< Pattern of how many times slower its time passes. */
    bool is_simulated;      /**< No robot is connected. */
    check_board_t cycle;    /**< Cost of a cycle. */
    uint32_t cycle_lane_mb; /**< Memory for the cycles that wait for the recorder. */
    board_saying_t says[BOARD_SAYINGS];
} board_t;

extern const board_t board;

#endif

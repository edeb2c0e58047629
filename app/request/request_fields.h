/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The messages that a client may send, their fields and their bounds, as tables that are generated
 * from core/interface. A field that stands in no table is refused.
 */
#ifndef BORESIGHT_REQUEST_FIELDS_H
#define BORESIGHT_REQUEST_FIELDS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define REQUEST_DEPTH 8U        /**< Objects in objects, the outermost one included. */
#define REQUEST_FIELDS_MOST 32U /**< Fields of a message. */

/** The kind of a value in JSON, and its type in C. */
typedef enum {
    REQUEST_FLAG = 0,   /**< true or false: bool. */
    REQUEST_UINT32 = 1, /**< Whole, without fraction and exponent: uint32_t. */
    REQUEST_INT32 = 2,  /**< The same: int32_t. */
    REQUEST_NUMBER = 3, /**< Finite: double. */
    REQUEST_TEXT = 4,   /**< char[size], ends with a zero byte and holds no other. */
    REQUEST_WORD = 5,   /**< One of some words: its value as uint32_t. */
    REQUEST_OBJECT = 6  /**< A message: its structure. */
} request_kind_t;

/** A word and what it becomes. */
typedef struct {
    const char *word;
    uint32_t value;
} request_word_t;

struct request_message;

/** One field. Offsets are those of the structure that is filled. */
typedef struct {
    const char *name;
    request_kind_t kind;
    size_t offset;       /**< Place of the value, or of a list's first one. */
    size_t size;         /**< Size of one value. */
    size_t given_offset; /**< Place of the number of a list's values (uint32_t), or of the flag
                             of an optional value (bool). Only for lists and optional values. */
    bool is_optional;
    uint32_t least;      /**< Values of a list. */
    uint32_t most;       /**< The same; 0: it is no list. */
    double minimum;      /**< Least number, inclusive. */
    double maximum;      /**< Greatest number, inclusive. */
    const char *unit;    /**< Unit of a number, for people; NULL: it has none, or is no number. */
    uint32_t word_count; /**< Number of the words that are allowed. */
    const request_word_t *words;
    const struct request_message *message; /**< The message of an object. */
} request_field_t;

/** An object, or the parameters of a query. */
typedef struct request_message {
    const request_field_t *fields;
    uint32_t count; /**< At most REQUEST_FIELDS_MOST. */
} request_message_t;

#endif

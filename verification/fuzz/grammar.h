/* SPDX-License-Identifier: Apache-2.0 */
/** @file Messages of peers as bytes, written with the words of words.yml; header version 1, or 2
 * with metadata. */
#ifndef BORESIGHT_FUZZ_GRAMMAR_H
#define BORESIGHT_FUZZ_GRAMMAR_H

#include <stdbool.h>
#include <stdint.h>

#define GRAMMAR_MESSAGE_MAX 2048U

/** A message on its way to the server. */
typedef struct {
    uint32_t length;
    uint8_t bytes[GRAMMAR_MESSAGE_MAX];
} grammar_message_t;

/** Parts of it that are wrong on purpose. */
typedef struct {
    bool is_wanted;
    uint32_t position; /**< Modulo the message's length. */
    uint8_t value;
    bool is_checksum_kept;
} grammar_fault_t;

/** Every number is taken modulo the length of its list. */
void grammar_string(grammar_message_t *self, uint32_t version, const uint8_t words[3]);
void grammar_transform(grammar_message_t *self, uint32_t version, const uint8_t words[3]);

/** A message of type words[0], named words[1] and words[2]; what is in it follows from these. */
void grammar_ask(grammar_message_t *self, uint32_t version, const uint8_t words[3]);

/** Damages it. The body's length follows the header's; the checksum is put right unless kept. */
void grammar_damage(grammar_message_t *self, const grammar_fault_t *fault);

/** The order to the box of this number. */
const char *grammar_order(uint8_t number);

#endif

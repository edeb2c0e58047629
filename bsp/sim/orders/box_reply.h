/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the simulated box answers to orders, and the words of both. Stateless. */
#ifndef BORESIGHT_BOX_REPLY_H
#define BORESIGHT_BOX_REPLY_H

#include "sim/box.h"

#include <stddef.h>

/** A text that grows in `size` bytes; what has no room is left out. */
typedef struct {
    char *text;
    size_t size;
    size_t length;
} box_reply_t;

/* Each ends with NULL and is in the order of its enumeration: these of faults, */
extern const char *const box_card_words[];
extern const char *const box_encoder_words[];
extern const char *const box_motor_words[];
extern const char *const box_switch_words[];
extern const char *const box_load_cell_words[];
/* box_gate_t, */
extern const char *const box_gate_words[];
/* and card_type_t. */
extern const char *const box_type_words[];

/** A card that no axis has is in this slot. */
static inline bool box_has_sensor(const box_t *self, uint32_t slot)
{
    return ((self->sensor_slots >> slot) & 1U) != 0U;
}

/** Adds to the text. */
void box_reply_say(box_reply_t *reply, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/** States all that there is to see at the box. */
void box_reply_show(box_reply_t *reply, const box_t *self);

/** States the phantom, as a text that sim_phantom_read() takes. */
void box_reply_tissue(box_reply_t *reply, const box_t *self);

/** States that no card is in the slot that `word` names, and where there are cards. */
void box_reply_no_slot(box_reply_t *reply, const box_t *self, const char *word);

#endif

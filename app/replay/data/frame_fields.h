/* SPDX-License-Identifier: Apache-2.0 */
/** @file The fields of a frame to a card, as those of core/interface are known. */
#ifndef BORESIGHT_FRAME_FIELDS_H
#define BORESIGHT_FRAME_FIELDS_H

#include "card/card_frame.h"
#include "interface/app/fields.h"

/** Fields of card_command_t. */
extern const field_t fields_card_command[];

/** Name of a card_drive_mode_t. Lives as long as the process. */
const char *frame_drive_word(int32_t value);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Questions about one message, for the sentences of dialect_oracle.c.
 */
#ifndef BORESIGHT_FUZZ_DIALECT_MESSAGE_H
#define BORESIGHT_FUZZ_DIALECT_MESSAGE_H

#include "base/rigid.h"
#include "igtl/wire/igtl_codec.h"

#include <stdbool.h>
#include <stdint.h>

/** Bytes of the prefix that a command and its acknowledgement have. */
#define MESSAGE_PREFIX 4U

/** The name begins with `prefix`. */
bool message_begins(const char *name, const char *prefix);

/** A command by STRING. */
bool message_is_command(const igtl_message_t *message);

/** Length of the prefix before the id of a pose, 0 for a message without one. */
uint32_t message_id_prefix(const igtl_message_t *message);

/** A pose of the seen needle. */
bool message_is_tip(const igtl_message_t *message);

/** The echo of the message that was just received, `said`; false if that is NULL. */
bool message_acknowledges(const igtl_message_t *message, const igtl_message_t *said);

/** The whole name. */
bool message_is_named(const igtl_message_t *message, const char *name);

/** The whole text. */
bool message_says(const igtl_message_t *message, const char *text);

/** Computes the pose that was received once more in floating point, and compares it with the one
 * that is passed on. */
void message_judge_pose(const igtl_message_t *said, const rigid_t *pose);

/** Each entry of the pose may be commanded. */
bool message_is_in_range(const rigid_t *pose);

#endif

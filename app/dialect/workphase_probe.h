/* SPDX-License-Identifier: Apache-2.0 */
/** @file The lengths of the probe, as a peer of the workphase protocol sends them. */
#ifndef BORESIGHT_WORKPHASE_PROBE_H
#define BORESIGHT_WORKPHASE_PROBE_H

#include "interface/command.h"
#include "interface/status.h"
#include "message/igtl_codec.h"

#include <stdbool.h>

/** A STRING of the name PROBE, whose text is the lengths, or a text that begins with that word. */
bool workphase_probe_is(const igtl_message_t *message);

/**
 * Reads what workphase_probe_is() into `command`: mm, by spaces, in the order of the robot file.
 *
 * @return STATUS_OK, or STATUS_OUT_OF_RANGE when something is no number of mm within +-2000, or
 * there are more than ROBOT_PROBE_LENGTHS
 *
 * @satisfies SWR-PROBE-006
 */
status_t workphase_probe_read(const igtl_message_t *message, command_t *command);

#endif

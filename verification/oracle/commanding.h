/* SPDX-License-Identifier: Apache-2.0 */
/** @file Commands of the holder of authority alone, by the list of commands and not by the
 * controller. */
#ifndef BORESIGHT_COMMANDING_H
#define BORESIGHT_COMMANDING_H

#include "interface/command.h"

#include <stdbool.h>

/** STOP or EMERGENCY: everyone's. */
bool commanding_is_stop(const command_t *command);

/** It takes authority, or needs it; so a command that is new needs it. */
bool commanding_needs_authority(const command_t *command);

#endif

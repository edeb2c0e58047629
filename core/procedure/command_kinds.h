/* SPDX-License-Identifier: Apache-2.0 */
/** @file What several ask of a command: which workphase it is for. */
#ifndef BORESIGHT_COMMAND_KINDS_H
#define BORESIGHT_COMMAND_KINDS_H

#include "interface/command.h"
#include "interface/workphase_list.h"

#include <stdbool.h>

/** The workphase that COMMAND_WORKPHASE asks for; WORKPHASE_UNDEFINED of an unknown one, and of
 * every other kind. */
workphase_t command_kinds_workphase(const command_t *command);

/** It asks for STOP or EMERGENCY, which everybody may at any time. */
bool command_kinds_is_stop(const command_t *command);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The command that a step names.
 */
#ifndef BORESIGHT_OPERATOR_COMMAND_H
#define BORESIGHT_OPERATOR_COMMAND_H

#include "integration/support/rig.h"

#include <stdbool.h>
#include <stdint.h>

/** Id of each command of the operator. */
#define OPERATOR_COMMAND_ID 3000000U

/** The party that commands; the page while none does. */
authority_party_t operator_commander(const rig_t *rig);

/** @return false: the step is no command that can be given without knowing more */
bool operator_command_of(const rig_t *rig, uint32_t step, command_t *command);

#endif

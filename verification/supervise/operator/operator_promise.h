/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The next step is a promise: the command that it names is accepted in that cycle. The controller
 * is a pure function, so that on a copy of the world the command costs nothing.
 */
#ifndef BORESIGHT_OPERATOR_PROMISE_H
#define BORESIGHT_OPERATOR_PROMISE_H

#include "integration/support/rig.h"

#include <stdbool.h>

/** Gives the command of the step that is shown, on a copy.
 * @param answer its status; STATUS_OK as well if the box or a card changed in that cycle
 * @return false: the step names no command, or a card is late now */
bool operator_promise_try(const rig_t *rig, status_t *answer);

#endif

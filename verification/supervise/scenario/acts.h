/* SPDX-License-Identifier: Apache-2.0 */
/** @file What an operator does with single axes in MANUAL, by chance. */
#ifndef BORESIGHT_ACTS_H
#define BORESIGHT_ACTS_H

#include "integration/support/rig.h"

#include <stdbool.h>
#include <stdint.h>

/** The robot is seen where it is shown: the axes that a confirmation would verify. */
bool acts_is_shown_true(const rig_t *rig);

/**
 * One of the acts for some axis. The act that sets a home where it stands is for one that truly
 * stands there, as the operator sees; a home that is set elsewhere now and then is for the button
 * to refuse.
 */
command_t acts_choose(const rig_t *rig, uint32_t *chance);

#endif

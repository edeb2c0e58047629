/* SPDX-License-Identifier: Apache-2.0 */
/** @file What was answered to the commands of a cycle: at once, in their order, among others. */
#ifndef BORESIGHT_REPLIES_H
#define BORESIGHT_REPLIES_H

#include "controller/controller.h"

#include <stdbool.h>
#include <stdint.h>

/** To command `number` of the cycle. @return NULL: nothing */
const answer_t *replies_to(const controller_outputs_t *outputs, uint32_t number);

/** The command `number` of the cycle was accepted. */
bool replies_accept(const controller_outputs_t *outputs, uint32_t number);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file A number for all outputs of the controller in a scene: equal for two builds whose outputs
 * are equal in each cycle, whatever the layouts of their answers. */
#ifndef BORESIGHT_DIGEST_H
#define BORESIGHT_DIGEST_H

#include "controller/controller.h"

#include <stdint.h>

typedef struct {
    uint64_t hash; /**< FNV-1a. */
} digest_t;

void digest_begin(digest_t *self);

/** Adds frames, answers and events of one cycle. Of an answer that counts which its command, kind
 * and status give a meaning to. */
void digest_add(digest_t *self, const controller_outputs_t *outputs);

#endif

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

/** Adds frames, answers and events of one cycle. Only those fields of an
 * answer count to which its command, kind and status give a meaning. */
void digest_add(digest_t *self, const controller_outputs_t *outputs);

#endif

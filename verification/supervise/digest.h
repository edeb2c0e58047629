/* SPDX-License-Identifier: Apache-2.0 */
/** @file A number for all that the controller has said in a scene: equal for two builds that say
 * the same in each cycle, whatever the layouts of their answers. */
#ifndef BORESIGHT_DIGEST_H
#define BORESIGHT_DIGEST_H

#include "controller/controller.h"

#include <stdint.h>

typedef struct {
    uint64_t hash;   /**< FNV-1a. */
    uint32_t cycles; /**< That it is of. */
} digest_t;

void digest_begin(digest_t *self);

/** Adds frames, answers and events of one cycle. */
void digest_add(digest_t *self, const controller_outputs_t *outputs);

#endif

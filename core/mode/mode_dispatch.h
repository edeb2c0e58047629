/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Functions of the modes' folders: the calls that their rows in core/interface/modes.yml name, as a
 * switch of the build (interface/mode_dispatch.c). For mode.h.
 */
#ifndef BORESIGHT_MODE_DISPATCH_H
#define BORESIGHT_MODE_DISPATCH_H

#include "interface/mode_list.h"
#include "mode/leg/mode_frame.h"
#include "mode/mode_state.h"

#include <stdbool.h>

/** NAME_mode_step(): one cycle. @return false: `kind` is no mode, and nothing was done */
bool mode_dispatch_step(mode_state_t *self, mode_kind_t kind, const mode_frame_t *frame,
                        mode_result_t *result);

/** NAME_mode_is_done(): it needs no motion any more; false of a mode that has no such function. */
bool mode_dispatch_is_done(const mode_state_t *self, mode_kind_t kind, const mode_frame_t *frame);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/* Contract of mode_in(): any mode may run. */
#include "prove.h"

#include "mode/mode.h"

mode_kind_t mode_in(const mode_state_t *self, workphase_t workphase)
{
    mode_kind_t kind;
    (void)self;
    (void)workphase;
    return kind;
}

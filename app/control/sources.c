/* SPDX-License-Identifier: Apache-2.0 */
#include "control/sources.h"

#include "limits/requirement_limits.h"

#include <stdbool.h>

static bool is_silent(sources_t *self, uint32_t source, uint32_t beats, uint32_t passed_us)
{
    if (beats != self->beats[source]) {
        self->beats[source] = beats;
        self->silent_us[source] = 0U;
    } else if (self->silent_us[source] < LIMIT_AUTHORITY_SILENT_US) {
        self->silent_us[source] += passed_us;
    } else {
        /* Still. */
    }
    return self->silent_us[source] >= LIMIT_AUTHORITY_SILENT_US;
}

uint32_t sources_listen(sources_t *self, const uint32_t beats[COMMAND_SOURCE_COUNT],
                        uint32_t elapsed_us)
{
    const uint32_t passed_us = (elapsed_us < LIMIT_OVERRUN_US) ? elapsed_us : LIMIT_OVERRUN_US;
    uint32_t silent = 0U;
    for (uint32_t i = 0U; i < COMMAND_SOURCE_COUNT; i++) {
        silent |= is_silent(self, i, beats[i], passed_us) ? ((uint32_t)1U << i) : 0U;
    }
    return silent;
}

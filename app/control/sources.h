/* SPDX-License-Identifier: Apache-2.0 */
/** @file Which of the processes that command give no sign of life. Control owns one. */
#ifndef BORESIGHT_SOURCES_H
#define BORESIGHT_SOURCES_H

#include "interface/command.h"

#include <stdint.h>

/** At first all zero: no source was heard yet. */
typedef struct {
    uint32_t beats[COMMAND_SOURCE_COUNT];
    uint32_t silent_us[COMMAND_SOURCE_COUNT]; /**< Counted up to the limit. */
} sources_t;

/**
 * One cycle. `beats`: of each process, any number that it changes while it lives. `elapsed_us` of
 * the board's time; of a late cycle LIMIT_OVERRUN_US count, for it says nothing of the others.
 *
 * @return bit n: that of command_source_t n has been silent for LIMIT_AUTHORITY_SILENT_US
 *
 * @satisfies SWR-AUTH-015
 */
uint32_t sources_listen(sources_t *self, const uint32_t beats[COMMAND_SOURCE_COUNT],
                        uint32_t elapsed_us);

#endif

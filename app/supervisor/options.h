/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the supervisor was asked for: command line first, then the file of --config, then
 * environment, then defaults. */
#ifndef BORESIGHT_OPTIONS_H
#define BORESIGHT_OPTIONS_H

#include "supervisor/options_values.h"

#include <stdbool.h>
#include <stdint.h>

/** Factor by which the board's time passes slower, at least 1. */
uint32_t options_slowness(const options_t *self);

/** Whether the option `name` of the board was given; NULL is none. */
bool options_has(const options_t *self, const char *name);

/**
 * Reads options, and the file of ports.
 *
 * @return as command_line_read()
 *
 * @satisfies SWR-SUP-007
 * @satisfies SWR-SUP-009
 */
int options_read(options_t *self, int count, char *const arguments[]);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file Says before anything starts whether its ports are free. */
#ifndef BORESIGHT_PORTS_H
#define BORESIGHT_PORTS_H

#include "supervisor/options.h"

/**
 * Binds each port for a moment.
 *
 * @return false, with a sentence in `error`, when a port is in use or may not be used
 *
 * @satisfies SWR-SUP-003
 */
bool ports_check(const options_t *options, char *error, uint32_t error_size);

#endif

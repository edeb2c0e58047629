/* SPDX-License-Identifier: Apache-2.0 */
/** @file Whether a running Boresight may be replaced by another release. */
#ifndef BORESIGHT_AT_REST_H
#define BORESIGHT_AT_REST_H

#include <stdbool.h>

/**
 * Prints a sentence: that no Boresight of this name runs, or that no drive of it is on, nothing is
 * armed and START_UP has not been left; or which of these does not hold. `is_stopped`: it is also
 * stopped, by control in the cycle in which all of that holds; nothing begins between.
 *
 * @return exit code: 0 it may be replaced, or has stopped; 1 it may not, or goes on
 *
 * @satisfies SWR-PACK-002
 * @satisfies SWR-PACK-014
 */
int at_rest_report(const char *instance, bool is_stopped);

#endif

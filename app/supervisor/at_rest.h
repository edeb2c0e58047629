/* SPDX-License-Identifier: Apache-2.0 */
/** @file Whether a running Boresight may be replaced by another release. */
#ifndef BORESIGHT_AT_REST_H
#define BORESIGHT_AT_REST_H

/**
 * Prints a sentence: that no Boresight of this name runs, or that no drive of it is on, nothing is
 * armed and nobody has left START_UP; or which of these does not hold.
 *
 * @return exit code: 0 it may be replaced, 1 it may not
 *
 * @satisfies SWR-PACK-002
 */
int at_rest_tell(const char *instance);

#endif

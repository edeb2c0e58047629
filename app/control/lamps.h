/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the lamps of the box show. */
#ifndef BORESIGHT_LAMPS_H
#define BORESIGHT_LAMPS_H

#include "interface/snapshot.h"

#include <stdint.h>

/**
 * The BSP_LAMP_ bits of a cycle that ended as `snapshot` shows.
 *
 * @satisfies SWR-BSP-002
 */
uint32_t lamps_of(const snapshot_t *snapshot);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file The FPGA and its bitfile, and the person who accepts the lacks of its cards. */
#ifndef BORESIGHT_ADDRESS_H
#define BORESIGHT_ADDRESS_H

#include "bsp.h"

#include <stdbool.h>
#include <stdint.h>

#define ADDRESS_RESOURCE_SIZE 64U
#define ADDRESS_PATH_SIZE 128U

typedef struct {
    char resource[ADDRESS_RESOURCE_SIZE]; /**< As NI names it: RIO0. */
    char bitfile[ADDRESS_PATH_SIZE];
    char accepted[BSP_ACCEPTED_SIZE]; /**< "": not accepted. */
} address_t;

/**
 * Reads `nifpga:RIO0,/path/x.lvbitx`, after which `,accepted=` and a name with a date (2026-11-23)
 * may follow; "-" is none, and anything else is refused.
 *
 * @return false: `error` says in one sentence what is wrong
 *
 * @satisfies SWR-NI-008
 */
bool address_read(address_t *self, const char *text, char *error, uint32_t error_size);

#endif

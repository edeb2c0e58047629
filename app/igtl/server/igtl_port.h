/* SPDX-License-Identifier: Apache-2.0 */
/** @file One port, as igtl_ports.h reads it. */
#ifndef BORESIGHT_IGTL_PORT_H
#define BORESIGHT_IGTL_PORT_H

#include "igtl/dialect/igtl_dialect.h"

#include <stdbool.h>
#include <stdint.h>

#define IGTL_PORT_NAME_SIZE 16U /**< 15 characters and a NUL. */
#define IGTL_PREFIX_SIZE 9U     /**< 8 characters and a NUL. */
#define IGTL_ALLOWED 8U         /**< Networks that a port allows. */

/** IPv4 addresses, in the byte order of the host. */
typedef struct {
    uint32_t address;
    uint32_t mask;
} igtl_network_t;

typedef struct {
    char name[IGTL_PORT_NAME_SIZE];
    igtl_language_t language;
    bool is_calling; /**< It connects to its address; otherwise it listens there. */
    uint32_t address;
    uint16_t number; /**< 1 to 65535. */
    char entry_prefix[IGTL_PREFIX_SIZE];
    igtl_network_t allowed[IGTL_ALLOWED];
    uint32_t allowed_count; /**< 0: everyone. */
} igtl_port_t;

#endif

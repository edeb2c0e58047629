/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Which ports there are: read from a file that the operator wrote, a section for each port, or the
 * two that there are without one.
 *
 *     [slicer]
 *     dialect = brp-2021
 *     listen = 192.168.1.2:18944
 *     allow = 192.168.1.10, 192.168.7.0/24
 *
 * Keys: `dialect` (brp-2013, brp-2021 or crtk); `listen` or `connect`, an IPv4 address and a port;
 * `allow`, who may connect, needed where not only this machine can; `entry-prefix`, how the names
 * of entry points begin. A line that begins with # is a comment.
 */
#ifndef BORESIGHT_IGTL_PORTS_H
#define BORESIGHT_IGTL_PORTS_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/server/igtl_port.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define IGTL_PORTS_FILE 8192U /**< Longest file, in bytes. */

typedef struct {
    uint32_t count;
    igtl_port_t ports[IGTL_PORTS];
} igtl_ports_t;

/** The ports without a file: workphases and transforms, open to everyone who reaches `address`.
 * False when that is no IPv4 address. */
bool igtl_ports_set(igtl_ports_t *self, const char *address, uint16_t brp_port, uint16_t igtl_port);

/**
 * Reads `length` bytes of `text`; `file` is what errors call it.
 *
 * @return false with "FILE, line N: sentence" in `error`
 *
 * @satisfies SWR-IGTL-023
 */
bool igtl_ports_parse(igtl_ports_t *self, const char *file, const char *text, size_t length,
                      char *error, size_t error_size);

/** Reads the file. False with a sentence in `error`. */
bool igtl_ports_read(igtl_ports_t *self, const char *file, char *error, size_t error_size);

/**
 * Whether `address` may connect.
 *
 * @satisfies SWR-IGTL-024
 */
bool igtl_port_allows(const igtl_port_t *self, uint32_t address);

/** Writes "192.168.1.10:18944"; room for IGTL_PLACE_SIZE. */
#define IGTL_PLACE_SIZE 22U
void igtl_port_place(uint32_t address, uint16_t number, char text[IGTL_PLACE_SIZE]);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file The listening socket of a port. */
#ifndef BORESIGHT_IGTL_LISTENER_H
#define BORESIGHT_IGTL_LISTENER_H

#include <stddef.h>
#include <stdint.h>

/** Listens on an IPv4 address in the byte order of the host; -1 with one sentence in `error` and
 * the cause in errno. */
int igtl_listener_open(uint32_t address, uint16_t number, char *error, size_t error_size);

/** The next connection and from where it comes; -1 when none exists. */
int igtl_listener_accept(int listener, uint32_t *address, uint16_t *number);

#endif

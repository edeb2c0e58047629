/* SPDX-License-Identifier: Apache-2.0 */
/** @file The values in the file of ports. Nothing is read that is not meant: no names of machines,
 * no rest behind a number. */
#ifndef BORESIGHT_IGTL_PORTS_VALUES_H
#define BORESIGHT_IGTL_PORTS_VALUES_H

#include "igtl/server/igtl_port.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Cuts blanks off both ends, in place. */
char *igtl_ports_trim(char *text);

/** 1 to `most` letters, digits, - or _. */
bool igtl_ports_is_word(const char *text, size_t most);

/** Each reads the whole of `text`, or returns false. */
bool igtl_ports_read_address(const char *text, uint32_t *address);
bool igtl_ports_read_place(const char *text, uint32_t *address, uint16_t *number);
bool igtl_ports_read_dialect(const char *text, igtl_language_t *language);
bool igtl_ports_read_prefix(const char *text, char prefix[IGTL_PREFIX_SIZE]);

/** "a.b.c.d" and "a.b.c.d/n" between commas; of a network the bits behind the n first are 0. */
bool igtl_ports_read_allowed(const char *text, igtl_port_t *port);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the program was asked for. */
#ifndef BORESIGHT_IGTL_OPTIONS_H
#define BORESIGHT_IGTL_OPTIONS_H

#include "igtl/igtl_ports.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct {
    const char *exchange;
    const char *file; /**< Of ports, NULL: none. */
    igtl_ports_t ports;
} igtl_options_t;

/** One line. */
extern const char igtl_options_usage[];

/** Reads the command line, and the file of ports. False with a sentence in `error`. */
bool igtl_options_read(igtl_options_t *self, int count, char **arguments, char *error,
                       size_t error_size);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the program was asked for. */
#ifndef BORESIGHT_IGTL_OPTIONS_H
#define BORESIGHT_IGTL_OPTIONS_H

#include "igtl/server/igtl_ports.h"

typedef struct {
    const char *instance;
    const char *file; /**< File of ports, NULL: none. */
    igtl_ports_t ports;
} igtl_options_t;

/**
 * Reads the command line, and the file of ports.
 *
 * @return as command_line_read()
 */
int igtl_options_read(igtl_options_t *self, int count, char *const arguments[]);

#endif

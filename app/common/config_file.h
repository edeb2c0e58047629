/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Options in a file: the words of the command line, one option in each line, its name without
 * hyphens and its value behind blanks. A line that is empty or begins with # has no meaning.
 *
 *     http-port 8080
 *     recordings /var/lib/boresight
 */
#ifndef BORESIGHT_CONFIG_FILE_H
#define BORESIGHT_CONFIG_FILE_H

#include "common/command_line.h"

#include <stdint.h>

#define CONFIG_FILE_OPTIONS 32U    /**< That a program may have. */
#define CONFIG_FILE_LINE_SIZE 640U /**< Size of a line, with its end. */

/** The options of a file; the texts of its values live here. */
typedef struct {
    char words[CONFIG_FILE_OPTIONS][CONFIG_FILE_LINE_SIZE];
    const char *values[CONFIG_FILE_OPTIONS]; /**< By option, NULL where it says nothing. */
} config_file_t;

/**
 * Reads the file `path`, with the options of `command_line`, into `values` of command_line_read():
 * what the command line said stays. No option may stand there twice, and none that is `by_hand`.
 *
 * @return COMMAND_LINE_GO_ON, or COMMAND_LINE_WRONG after a sentence on the standard error with the
 *         file and the number of its line
 *
 * @satisfies SWR-PACK-001
 */
int config_file_read(config_file_t *self, const char *path, const command_line_t *command_line,
                     const char *values[]);

#endif

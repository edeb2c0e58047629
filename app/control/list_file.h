/* SPDX-License-Identifier: Apache-2.0 */
/** @file A trajectory of a file that was named where the box was started. */
#ifndef BORESIGHT_LIST_FILE_H
#define BORESIGHT_LIST_FILE_H

#include "controller/controller.h"

#include <stdbool.h>
#include <stdint.h>

/**
 * Reads the table `path`, in which every axis has a column, and has the controller hold it, before
 * its first cycle. It is judged as one that comes over HTTP.
 *
 * @return false with a sentence in `error`, which names the line, when it cannot be read or is
 * refused
 *
 * @satisfies SWR-TRAJ-020
 */
bool list_file_take(controller_t *controller, const robot_t *robot, const char *path, char *error,
                    uint32_t error_size);

#endif

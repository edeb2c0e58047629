/* SPDX-License-Identifier: Apache-2.0 */
/** @file The name of the field that holds a byte of a structure. */
#ifndef BORESIGHT_FIELD_NAME_H
#define BORESIGHT_FIELD_NAME_H

#include "interface/app/fields.h"

#include <stddef.h>

/** Writes the name of the field of `fields` at `offset`, such as "axes[3].drive_duty", or
 * "scanner_target, word 9". */
void field_name(const field_t *fields, size_t offset, char *text, size_t size);

#endif

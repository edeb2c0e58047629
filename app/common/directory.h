/* SPDX-License-Identifier: Apache-2.0 */
/** @file Directories. */
#ifndef BORESIGHT_DIRECTORY_H
#define BORESIGHT_DIRECTORY_H

#include <stdbool.h>

/** Creates `directory` and those above it, where they are missing. Returns false with errno set. */
bool directory_make(const char *directory);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file Numbers that the seed of a module decides: they keep no client out, as no other one is in
 * the page. */
#ifndef BORESIGHT_SITE_RANDOM_H
#define BORESIGHT_SITE_RANDOM_H

#include <sys/types.h>

ssize_t getrandom(void *bytes, size_t size, unsigned flags);

#endif

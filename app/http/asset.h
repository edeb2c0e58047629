/* SPDX-License-Identifier: Apache-2.0 */
/** @file The console's files, compiled into the program by tools/embed.rb. */
#ifndef BORESIGHT_ASSET_H
#define BORESIGHT_ASSET_H

#include <stddef.h>
#include <stdint.h>

/** One file. Everything it points to lives for ever. */
typedef struct {
    const char *path;  /**< As requested, with its slash in front. */
    const char *type;  /**< Content type. */
    const char *cache; /**< Cache-Control: only files named after their content may be kept. */
    const unsigned char *bytes;
    size_t size;
} asset_t;

extern const asset_t assets[];
extern const size_t asset_count;

/** Writes `port` into the page, where it says 00000: at it the page asks for a stop. To be called
 * once, before anything is served. */
void asset_tell_stop_port(uint32_t port);

/** The asset requested by `path`, "/" being the page itself; NULL when there is none. */
const asset_t *asset_find(const char *path);

#endif

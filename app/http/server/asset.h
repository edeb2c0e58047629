/* SPDX-License-Identifier: Apache-2.0 */
/** @file The console's files and the document for clients, compiled into the program by
 * tools/compile/embed.rb. */
#ifndef BORESIGHT_ASSET_H
#define BORESIGHT_ASSET_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** One file. Everything it points to lives as long as the process. */
typedef struct {
    const char *path;  /**< As requested, with its slash in front. */
    const char *type;  /**< Content type. */
    const char *cache; /**< Cache-Control: only files named after their content may be kept. */
    const char *tag;   /**< Another one for other bytes. */
    const unsigned char *bytes;
    size_t size;
    const unsigned char *packed; /**< The same by gzip; NULL where that is no shorter. */
    size_t packed_size;          /**< 0 without. */
} asset_t;

#define ASSET_ETAG_SIZE 48U /**< Room for an ETag. */

extern const asset_t assets[];
extern const size_t asset_count;

/** Writes two ports into the page, where it says 00000: at them the page asks for a stop, in the
 * clear or by TLS. To be called once, before anything is served. */
void asset_report_stop_ports(uint32_t port, uint32_t tls_port);

/** The asset requested by `path`, "/" being the page itself; NULL when none exists. */
const asset_t *asset_find(const char *path);

/** Writes the ETag of an asset, or of its packed bytes, with its quotes. */
void asset_write_etag(const asset_t *asset, bool is_packed, char etag[ASSET_ETAG_SIZE]);

#endif

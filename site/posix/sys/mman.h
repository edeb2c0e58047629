/* SPDX-License-Identifier: Apache-2.0 */
/** @file A file that is in memory anyway. */
#ifndef BORESIGHT_SITE_MMAN_H
#define BORESIGHT_SITE_MMAN_H

#include <sys/types.h>

#define PROT_READ 1
#define MAP_PRIVATE 2
#define MAP_FAILED ((void *)-1)

void *mmap(void *address, size_t size, int protection, int flags, int file, off_t offset);
int munmap(void *address, size_t size);

#endif

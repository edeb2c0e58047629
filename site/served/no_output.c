/* SPDX-License-Identifier: Apache-2.0 */
/** @file Output has no reader here: see no_system.c. */
#include <stdint.h>
#include <wasi/api.h>

int32_t __imported_wasi_snapshot_preview1_fd_write(int32_t fd, int32_t parts, int32_t count,
                                                   int32_t size);
int32_t __imported_wasi_snapshot_preview1_fd_write(int32_t fd, int32_t parts, int32_t count,
                                                   int32_t size)
{
    (void)fd;
    (void)parts;
    (void)count;
    (void)size;
    return __WASI_ERRNO_BADF;
}

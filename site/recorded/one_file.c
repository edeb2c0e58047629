/* SPDX-License-Identifier: Apache-2.0 */
#include "site/recorded/one_file.h"

#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <wasi/api.h>

#define NUMBER 3 /* The first behind those of input, output and error. */
#define PRINTED_SIZE 4096U

static uint8_t *bytes;
static uint32_t bytes_size;
static char printed[PRINTED_SIZE];
static size_t printed_size;

uint8_t *one_file_make(uint32_t size)
{
    bytes = malloc((size > 0U) ? size : 1U);
    bytes_size = size;
    return bytes;
}

const char *one_file_printed(void)
{
    return printed;
}

int open(const char *path, int flags, ...)
{
    (void)path;
    (void)flags;
    return NUMBER;
}

int close(int file)
{
    (void)file;
    return 0;
}

int fstat(int file, struct stat *status)
{
    (void)file;
    (void)memset(status, 0, sizeof *status);
    status->st_mode = S_IFREG;
    status->st_size = (off_t)bytes_size;
    return 0;
}

void *mmap(void *address, size_t size, int protection, int flags, int file, off_t offset)
{
    (void)address;
    (void)size;
    (void)protection;
    (void)flags;
    (void)file;
    (void)offset;
    return bytes;
}

int munmap(void *address, size_t size)
{
    (void)address;
    (void)size;
    return 0;
}

static void print(const __wasi_ciovec_t *part)
{
    const size_t room = PRINTED_SIZE - 1U - printed_size;
    const size_t size = (part->buf_len < room) ? part->buf_len : room;

    (void)memcpy(&printed[printed_size], part->buf, size);
    printed_size += size;
}

/* The import of the C library: see no_system.c. */
int32_t __imported_wasi_snapshot_preview1_fd_write(int32_t fd, int32_t parts, int32_t count,
                                                   int32_t size);
int32_t __imported_wasi_snapshot_preview1_fd_write(int32_t fd, int32_t parts, int32_t count,
                                                   int32_t size)
{
    const __wasi_ciovec_t *const all = (const __wasi_ciovec_t *)parts;
    __wasi_size_t *const written = (__wasi_size_t *)size;

    *written = 0U;
    for (int32_t i = 0; i < count; i++) {
        if (fd == STDERR_FILENO) {
            print(&all[i]);
        }
        *written += all[i].buf_len;
    }
    return __WASI_ERRNO_SUCCESS;
}

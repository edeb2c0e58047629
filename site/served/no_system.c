/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * There is no system below the C library of a page, and so no file that could be opened: what the
 * library would import is here, and refuses.
 */
#include <stdint.h>
#include <wasi/api.h>

#define IMPORT(name) __imported_wasi_snapshot_preview1_##name

#define REFUSE(name, ...)                                                                          \
    int32_t IMPORT(name)(__VA_ARGS__);                                                             \
    int32_t IMPORT(name)(__VA_ARGS__)                                                              \
    {                                                                                              \
        return __WASI_ERRNO_BADF;                                                                  \
    }

#pragma clang diagnostic ignored "-Wunused-parameter"

REFUSE(fd_close, int32_t fd)
REFUSE(fd_fdstat_get, int32_t fd, int32_t status)
REFUSE(fd_filestat_get, int32_t fd, int32_t status)
REFUSE(fd_prestat_get, int32_t fd, int32_t status)
REFUSE(fd_prestat_dir_name, int32_t fd, int32_t path, int32_t size)
REFUSE(fd_read, int32_t fd, int32_t parts, int32_t count, int32_t size)
REFUSE(fd_seek, int32_t fd, int64_t offset, int32_t whence, int32_t at)
REFUSE(path_open, int32_t fd, int32_t lookup, int32_t path, int32_t size, int32_t flags,
       int64_t rights, int64_t inherited, int32_t fd_flags, int32_t opened)

_Noreturn void IMPORT(proc_exit)(int32_t code);
_Noreturn void IMPORT(proc_exit)(int32_t code)
{
    __builtin_trap();
}

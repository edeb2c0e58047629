/* SPDX-License-Identifier: Apache-2.0 */
#include "nifpga/fpga.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

#define RUN_AT_ONCE 0U
#define RESET_IF_LAST 0U

typedef struct {
    const char *name;
    size_t place; /* In fpga_calls_t. */
} entry_t;

static const entry_t entries[] = {
    {"NiFpgaDll_Open", offsetof(fpga_calls_t, open)},
    {"NiFpgaDll_Close", offsetof(fpga_calls_t, close)},
    {"NiFpgaDll_ReadBool", offsetof(fpga_calls_t, read_bool)},
    {"NiFpgaDll_WriteBool", offsetof(fpga_calls_t, write_bool)},
    {"NiFpgaDll_ReadU16", offsetof(fpga_calls_t, read_u16)},
    {"NiFpgaDll_ReadArrayU32", offsetof(fpga_calls_t, read_words)},
    {"NiFpgaDll_WriteArrayU32", offsetof(fpga_calls_t, write_words)},
};

/* POSIX has it that a function fits a pointer to an object; ISO C has no cast for that. */
static bool resolve(fpga_t *self, char *error, uint32_t error_size)
{
    for (size_t i = 0U; i < (sizeof entries / sizeof entries[0]); i++) {
        void *const symbol = dlsym(self->library, entries[i].name);
        if (symbol == NULL) {
            (void)snprintf(error, error_size,
                           FPGA_LIBRARY " has no %s; install the library that NI delivers for this "
                                        "box.",
                           entries[i].name);
            return false;
        }
        (void)memcpy((char *)&self->calls + entries[i].place, &symbol, sizeof symbol);
    }
    return true;
}

static bool run(fpga_t *self, const char *resource, const char *path, const char *signature,
                char *error, uint32_t error_size)
{
    const int32_t status = self->calls.open(path, signature, resource, RUN_AT_ONCE, &self->session);

    if (status < 0) {
        (void)snprintf(
            error, error_size,
            "The FPGA %s does not take the bitfile \"%s\" (NI's status %d); check its name "
            "and that the bitfile was made for it.",
            resource, path, (int)status);
    }
    return status >= 0;
}

bool fpga_open(fpga_t *self, const char *resource, const char *path, const bitfile_t *bitfile,
               char *error, uint32_t error_size)
{
    *self = (fpga_t){.library = dlopen(FPGA_LIBRARY, RTLD_NOW)};
    if (self->library == NULL) {
        (void)snprintf(error, error_size,
                       FPGA_LIBRARY
                       " is not on this computer; this board runs on NI Linux RT only.");
        return false;
    }
    if (!resolve(self, error, error_size) ||
        !run(self, resource, path, bitfile->signature, error, error_size)) {
        (void)dlclose(self->library);
        *self = (fpga_t){.library = NULL};
        return false;
    }
    return true;
}

void fpga_close(fpga_t *self)
{
    if (self->library != NULL) {
        (void)self->calls.close(self->session, RESET_IF_LAST);
        (void)dlclose(self->library);
        *self = (fpga_t){.library = NULL};
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A session with an FPGA through the entry points of NI's library, which is loaded when it is
 * opened: libNiFpga.so is on the box and nowhere else. Statuses are NI's: below 0 an error, 0 good.
 */
#ifndef BORESIGHT_FPGA_H
#define BORESIGHT_FPGA_H

#include "nifpga/bitfile.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define FPGA_LIBRARY "libNiFpga.so"

/** As NI declares them; a boolean is a byte. */
typedef struct {
    int32_t (*open)(const char *bitfile, const char *signature, const char *resource,
                    uint32_t attribute, uint32_t *session);
    int32_t (*close)(uint32_t session, uint32_t attribute);
    int32_t (*read_bool)(uint32_t session, uint32_t address, uint8_t *value);
    int32_t (*write_bool)(uint32_t session, uint32_t address, uint8_t value);
    int32_t (*read_u16)(uint32_t session, uint32_t address, uint16_t *value);
    int32_t (*read_words)(uint32_t session, uint32_t address, uint32_t *words, size_t count);
    int32_t (*write_words)(uint32_t session, uint32_t address, const uint32_t *words, size_t count);
} fpga_calls_t;

typedef struct {
    void *library;
    uint32_t session;
    fpga_calls_t calls;
} fpga_t;

/**
 * Loads the library, and `bitfile` into the FPGA `resource`, and runs it.
 *
 * @return false: `error` says in one sentence what is wrong, and nothing is open
 *
 * @satisfies SWR-NI-010
 */
bool fpga_open(fpga_t *self, const char *resource, const char *path, const bitfile_t *bitfile,
               char *error, uint32_t error_size);

/** Resets the FPGA, which puts every register where it was after loading. */
void fpga_close(fpga_t *self);

#endif

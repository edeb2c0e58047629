/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Registers by a bitfile of LabVIEW FPGA (.lvbitx, XML). Read tolerantly: only the elements asked
 * for must be there, in any order and with any others between them.
 */
#ifndef BORESIGHT_BITFILE_H
#define BORESIGHT_BITFILE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define BITFILE_SIGNATURE_SIZE 40U
/** Bit of an address: the register is in another clock domain. */
#define BITFILE_MAY_TIME_OUT 0x80000000U

/** Types of registers that a box has. */
typedef enum {
    BITFILE_BOOLEAN = 0,
    BITFILE_PACKET = 1, /**< An array of 32 words of 32 bits without a sign. */
    BITFILE_STATE = 2   /**< An enumeration of 16 bits. */
} bitfile_type_t;

/** Register that is asked for. */
typedef struct {
    const char *name;
    bitfile_type_t type;
    bool is_indicator; /**< Written by the FPGA. */
} bitfile_query_t;

typedef enum {
    BITFILE_FOUND = 0,
    BITFILE_MISSING = 1,
    BITFILE_OTHERWISE = 2,
    BITFILE_TWICE = 3
} bitfile_answer_t;

/** An open file; its text is the owner's until bitfile_close(). */
typedef struct {
    char *text;
    char signature[BITFILE_SIGNATURE_SIZE];
    uint32_t base; /**< Address of the registers. */
} bitfile_t;

/**
 * Reads a file whole; what is no regular file is not waited for.
 *
 * @return false: `error` says in one sentence what is wrong, and nothing is open
 *
 * @satisfies SWR-NI-009
 * @satisfies SWR-NI-018
 */
bool bitfile_open(bitfile_t *self, const char *path, char *error, uint32_t error_size);

void bitfile_close(bitfile_t *self);

/**
 * Looks a register up by its name. `address` is as NI's library takes it.
 *
 * @return BITFILE_OTHERWISE if there is one of another type or direction, BITFILE_TWICE if there
 * are two; `address` is changed by BITFILE_FOUND only
 *
 * @satisfies SWR-NI-009
 * @satisfies SWR-NI-017
 */
bitfile_answer_t bitfile_find(const bitfile_t *self, const bitfile_query_t *query,
                              uint32_t *address);

/**
 * Number of the value `label` of the enumeration `name`.
 *
 * @return false if it has no such value
 */
bool bitfile_number(const bitfile_t *self, const char *name, const char *label, uint16_t *number);

#endif

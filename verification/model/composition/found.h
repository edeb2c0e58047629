/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The configurations that were found. Two that are each other's when the axes change places are two
 * sides of one row: as it stands (0), and exchanged (1). One that is its own exchange has side 0
 * alone.
 */
#ifndef BORESIGHT_FOUND_H
#define BORESIGHT_FOUND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** The number of each member's own configuration, OWN_BITS each. */
typedef uint64_t config_t;
#define OWN_BITS 5U
#define OWN_MASK 31U

#define NOBODY UINT32_MAX
#define BOTH_SIDES 3U

/** How a side was found first: from which side of which row (row * 2 + side, NOBODY for the start),
 * and by what. */
typedef struct {
    uint32_t before;
    uint16_t stimulus;
    uint16_t inputs;
} way_t;

typedef struct {
    config_t config;
    uint64_t objections[2]; /**< Objections of the properties, one bit each, to each side. */
    uint32_t sides;         /**< Bit n: side n was found. */
    uint32_t last_before;   /**< The row whose successor it became last. */
    way_t ways[2];
    uint32_t turn; /**< The last one that it got. */
    uint32_t first_successor;
    uint32_t successors;
    bool is_explored; /**< One of its turns is over. */
} found_t;

/** Sides of a row that wait to be explored. */
typedef struct {
    uint32_t row;
    uint32_t sides;
} turn_t;

extern found_t *found;
extern uint32_t found_count;

/** `exchanged` gives the configuration with the axes in each other's place. Starts with a
 * configuration that is its own exchange. */
void found_begin(config_t start, config_t (*exchanged)(config_t), uint64_t (*object)(config_t));

bool found_is(config_t config);

/** It will soon be looked up, and then (approach) very soon: fetches it from memory meanwhile. */
void found_expect(config_t config);
void found_approach(config_t config);

/** A step of `sides` of a row, which side 0 takes by ways[0] to `config`, and side 1 by ways[1] to
 * its exchange. Gives the row of `config` * 2 + its side. */
uint32_t found_add(config_t config, uint32_t sides, const way_t ways[2]);

/** The next to be explored, nearest to the start first; false: there is none. */
bool found_next(turn_t *turn);

/** Notes once that a row leads to another; what its first turn comes to is enough. */
void found_succeed(uint32_t row, uint32_t next);

/** Backwards over all successors, for so many steps: a row from which none is reached whose
 * objections[0] have this bit; NOBODY if there is none. */
uint32_t found_lost(uint32_t bit, uint32_t steps);

/** realloc() that does not fail. */
void *grown(void *memory, size_t size);

static inline uint64_t mixed(uint64_t value)
{
    value = (value ^ (value >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    value = (value ^ (value >> 27)) * UINT64_C(0x94D049BB133111EB);
    return value ^ (value >> 31);
}

#endif

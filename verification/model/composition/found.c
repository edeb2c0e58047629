/* SPDX-License-Identifier: Apache-2.0 */
#include "found.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The configuration stands here too: what is looked up is then seldom fetched twice. */
typedef struct {
    config_t config;
    uint32_t row;
} slot_t;

found_t *found;
uint32_t found_count;

static uint32_t *successors;
static uint32_t found_room;
static slot_t *slots;
static uint32_t slot_count;
static uint32_t successor_count;
static uint32_t successor_room;
static turn_t *turns;
static uint32_t turn_count;
static uint32_t turn_room;
static uint32_t next_turn;
static uint32_t next_level; /* The first turn that is a step farther from the start. */
static config_t (*exchange)(config_t config);
static uint64_t (*object)(config_t config);

void *grown(void *memory, size_t size)
{
    void *const larger = realloc(memory, size);
    if (larger == NULL) {
        puts("out of memory");
        exit(2);
    }
    return larger;
}

static uint32_t first_place(config_t config)
{
    return (uint32_t)mixed(config) & (slot_count - 1U);
}

static slot_t *slot_of(config_t config)
{
    uint32_t place = first_place(config);
    while ((slots[place].row != NOBODY) && (slots[place].config != config)) {
        place = (place + 1U) & (slot_count - 1U);
    }
    return &slots[place];
}

static void enlarge(void)
{
    slot_count = (slot_count == 0U) ? 1024U : (slot_count * 2U);
    found_room = slot_count / 2U;
    slots = grown(slots, slot_count * sizeof *slots);
    found = grown(found, found_room * sizeof *found);
    (void)memset(slots, 0xFF, slot_count * sizeof *slots);
    for (uint32_t i = 0U; i < found_count; i++) {
        *slot_of(found[i].config) = (slot_t){found[i].config, i};
    }
}

static uint32_t row_of(config_t config, config_t twin)
{
    slot_t *const slot = slot_of(config);
    if (slot->row != NOBODY) {
        return slot->row;
    }
    const uint32_t row = found_count;
    *slot = (slot_t){config, row};
    found[row] = (found_t){.config = config,
                           .objections = {object(config), object(twin)},
                           .turn = NOBODY,
                           .last_before = NOBODY};
    found_count++;
    if (found_count == found_room) {
        enlarge();
    }
    return row;
}

/* Sides found in the same level wait for one turn. */
static void wait_for_turn(uint32_t row, uint32_t sides)
{
    if ((found[row].turn != NOBODY) && (found[row].turn >= next_level)) {
        turns[found[row].turn].sides |= sides;
        return;
    }
    if (turn_count == turn_room) {
        turn_room = (turn_room == 0U) ? 1024U : (turn_room * 2U);
        turns = grown(turns, turn_room * sizeof *turns);
    }
    found[row].turn = turn_count;
    turns[turn_count] = (turn_t){row, sides};
    turn_count++;
}

void found_begin(config_t start, config_t (*exchanged)(config_t), uint64_t (*objects)(config_t))
{
    exchange = exchanged;
    object = objects;
    enlarge();
    const way_t none = {.before = NOBODY};
    (void)found_add(start, 1U, (const way_t[]){none, none});
}

bool found_is(config_t config)
{
    const config_t twin = exchange(config);
    const uint32_t row = slot_of((config < twin) ? config : twin)->row;
    return (row != NOBODY) && (((found[row].sides >> ((config > twin) ? 1U : 0U)) & 1U) != 0U);
}

void found_expect(config_t config)
{
    const config_t twin = exchange(config);
    __builtin_prefetch(&slots[first_place((config < twin) ? config : twin)]);
}

void found_approach(config_t config)
{
    const config_t twin = exchange(config);
    const slot_t *const slot = &slots[first_place((config < twin) ? config : twin)];
    if (slot->row != NOBODY) {
        __builtin_prefetch(&found[slot->row]);
    }
}

uint32_t found_add(config_t config, uint32_t sides, const way_t ways[2])
{
    const config_t twin = exchange(config);
    const uint32_t side = (config > twin) ? 1U : 0U;
    const uint32_t row = (side == 0U) ? row_of(config, twin) : row_of(twin, config);
    for (uint32_t i = 0U; i < 2U; i++) {
        const uint32_t other = (config == twin) ? 0U : (i ^ side);
        if ((((sides >> i) & 1U) != 0U) && (((found[row].sides >> other) & 1U) == 0U)) {
            found[row].sides |= 1U << other;
            found[row].ways[other] = ways[i];
            wait_for_turn(row, 1U << other);
        }
    }
    return (row * 2U) + side;
}

bool found_next(turn_t *turn)
{
    if (next_turn == turn_count) {
        return false;
    }
    if (next_turn == next_level) {
        next_level = turn_count;
    }
    *turn = turns[next_turn];
    next_turn++;
    return true;
}

void found_succeed(uint32_t row, uint32_t next)
{
    if (found[row].is_explored || (found[next].last_before == row)) {
        return;
    }
    found[next].last_before = row;
    if (found[row].successors == 0U) {
        found[row].first_successor = successor_count;
    }
    found[row].successors++;
    if (successor_count == successor_room) {
        successor_room = (successor_room == 0U) ? 1024U : (successor_room * 2U);
        successors = grown(successors, successor_room * sizeof *successors);
    }
    successors[successor_count] = next;
    successor_count++;
}

static bool is_before(uint32_t row, const bool *is_reached)
{
    const uint32_t *const next = &successors[found[row].first_successor];
    for (uint32_t i = 0U; i < found[row].successors; i++) {
        if (is_reached[next[i]]) {
            return true;
        }
    }
    return false;
}

/* One step backwards; false: nothing new. */
static bool sweep(bool *is_reached, bool *is_next)
{
    bool is_changed = false;
    (void)memcpy(is_next, is_reached, found_count);
    for (uint32_t i = 0U; i < found_count; i++) {
        if (!is_next[i] && is_before(i, is_reached)) {
            is_next[i] = true;
            is_changed = true;
        }
    }
    return is_changed;
}

uint32_t found_lost(uint32_t bit, uint32_t steps)
{
    bool *is_reached = grown(NULL, found_count);
    bool *is_next = grown(NULL, found_count);
    for (uint32_t i = 0U; i < found_count; i++) {
        is_reached[i] = ((found[i].objections[0] >> bit) & 1U) != 0U;
    }
    for (uint32_t i = 0U; (i < steps) && sweep(is_reached, is_next); i++) {
        bool *const swap = is_reached;
        is_reached = is_next;
        is_next = swap;
    }
    const bool *const lost = memchr(is_reached, 0, found_count);
    const uint32_t row = (lost == NULL) ? NOBODY : (uint32_t)(lost - is_reached);
    free(is_reached);
    free(is_next);
    return row;
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Every reachable configuration of composed charts, breadth first, with every stimulus and every
 * value of the free inputs. Each pair is stepped twice: by the compiled charts, and by tables of
 * what the interpreter does. composition.h, which is generated, has the charts and how they act on
 * each other.
 *
 *     explorer [SEEN]
 *
 * Prints the numbers, a digest of all pairs, each first difference or violated property with the
 * stimuli that lead there, and what of SEEN differs: configurations that are never
 * reached, and permits.
 */
#include "composition.h"

#include <inttypes.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define QUEUE 64U
#define NOBODY UINT32_MAX

/* One configuration as it was found. */
typedef struct {
    config_t config;
    uint32_t before;
    uint16_t stimulus;
    uint16_t inputs;
} found_t;

static found_t *found;
static uint32_t found_count;
static uint32_t found_room;
static uint32_t *slots;
static uint32_t slot_count;
static uint32_t *successors;
static uint32_t *successors_begin;
static uint32_t successor_count;
static uint32_t successor_room;
static uint64_t pairs;
static uint64_t digest;
static uint32_t longest_queue;
static uint32_t errors;
static bool is_violated[PROPERTIES];
static bool is_permit_wrong;

void contract_broken(const char *module, uint32_t id)
{
    printf("contract %s %u is broken\n", module, (unsigned)id);
    exit(2);
}

static void *grown(void *memory, size_t size)
{
    void *const larger = realloc(memory, size);
    if (larger == NULL) {
        puts("out of memory");
        exit(2);
    }
    return larger;
}

static uint64_t mixed(uint64_t value)
{
    value = (value ^ (value >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    value = (value ^ (value >> 27)) * UINT64_C(0x94D049BB133111EB);
    return value ^ (value >> 31);
}

static uint64_t key_of(const config_t *config)
{
    uint64_t key = 0U;
    for (uint32_t i = 0U; i < MEMBERS; i++) {
        key = (key << 4) | config->of[i];
    }
    return key;
}

static uint32_t *slot_of(const config_t *config)
{
    uint32_t place = (uint32_t)mixed(key_of(config)) & (slot_count - 1U);
    while ((slots[place] != NOBODY) &&
           (memcmp(&found[slots[place]].config, config, sizeof *config) != 0)) {
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
    successors_begin = grown(successors_begin, (found_room + 1U) * sizeof *successors_begin);
    (void)memset(slots, 0xFF, slot_count * sizeof *slots);
    for (uint32_t i = 0U; i < found_count; i++) {
        *slot_of(&found[i].config) = i;
    }
}

/* Its number; a new one is noted with what led there. */
static uint32_t number_of(const config_t *config, uint32_t before, uint32_t stimulus,
                          uint32_t inputs)
{
    uint32_t *const slot = slot_of(config);
    if (*slot != NOBODY) {
        return *slot;
    }
    *slot = found_count;
    found[found_count] = (found_t){.config = *config,
                                   .before = before,
                                   .stimulus = (uint16_t)stimulus,
                                   .inputs = (uint16_t)inputs};
    found_count++;
    if (found_count == found_room) {
        enlarge();
    }
    return found_count - 1U;
}

static void tell_step(uint32_t stimulus, uint32_t inputs)
{
    printf("%s", stimuli[stimulus].name);
    for (uint32_t i = 0U; i < FREE_INPUTS; i++) {
        if (((inputs >> i) & 1U) != 0U) {
            printf(" with %s", free_inputs[i]);
        }
    }
}

static void tell_path(uint32_t number)
{
    const uint32_t before = found[number].before;
    if (before != NOBODY) {
        tell_path(before);
        printf("%s", (found[before].before != NOBODY) ? ", " : "");
        tell_step(found[number].stimulus, found[number].inputs);
    }
}

/* stimulus: STIMULI when it is about the configuration itself. */
static void complain(const char *what, uint32_t number, uint32_t stimulus, uint32_t inputs)
{
    errors++;
    printf("%s: ", what);
    tell_path(number);
    if (stimulus < STIMULI) {
        printf("%s", (found[number].before != NOBODY) ? ", " : "");
        tell_step(stimulus, inputs);
    }
    puts("");
}

static bool is_triggered(const reaction_t *reaction, uint32_t event, uint64_t before,
                         uint64_t after, uint32_t actions)
{
    switch (reaction->trigger) {
    case TRIGGER_ENTERS:
        return (((after & ~before) >> reaction->what) & 1U) != 0U;
    case TRIGGER_DOES:
        return ((actions >> reaction->what) & 1U) != 0U;
    case TRIGGER_HEARS:
    default:
        return event == reaction->what;
    }
}

/* One stimulus with all that it makes the charts tell each other; false: it cannot happen. */
static bool step(config_t *config, step_t *const steps[MEMBERS], uint32_t stimulus, uint32_t free,
                 uint64_t *actions)
{
    uint32_t queue[QUEUE];
    uint32_t told = 0U;
    uint32_t member = stimuli[stimulus].member;
    uint32_t event = stimuli[stimulus].event;
    for (uint32_t next = 0U;; next++) {
        const uint32_t before = config->of[member];
        uint32_t done = 0U;
        const uint32_t after = steps[member](before, event, inputs_of(config, member, free), &done);
        if (after == NEVER) {
            return false;
        }
        config->of[member] = (uint8_t)after;
        *actions = mixed(*actions ^ (((uint64_t)member << 40) | ((uint64_t)event << 32) | done));
        for (uint32_t i = 0U; i < REACTIONS; i++) {
            if ((reactions[i].member == member) &&
                is_triggered(&reactions[i], event, active[member][before], active[member][after],
                             done)) {
                if (told == QUEUE) {
                    puts("the charts tell each other more than the queue holds");
                    exit(2);
                }
                queue[told] = i;
                told++;
            }
        }
        while ((next < told) && !does_react(config, queue[next])) {
            next++;
        }
        longest_queue = (told > longest_queue) ? told : longest_queue;
        if (next >= told) {
            return true;
        }
        member = reactions[queue[next]].told_member;
        event = reactions[queue[next]].told_event;
    }
}

static void check_step(uint32_t number, uint32_t stimulus, uint32_t inputs, const config_t *after)
{
    const uint32_t property = violated_by_step(&found[number].config, stimulus, after);
    if ((property < PROPERTIES) && !is_violated[property]) {
        is_violated[property] = true;
        complain(properties[property].id, number, stimulus, inputs);
    }
}

static void take_pair(uint32_t number, uint32_t stimulus, uint32_t free)
{
    config_t compiled = found[number].config;
    config_t expected = found[number].config;
    uint64_t compiled_actions = 0U;
    uint64_t expected_actions = 0U;
    if (!step(&expected, table_steps, stimulus, free, &expected_actions)) {
        return;
    }
    pairs++;
    const bool is_done = step(&compiled, compiled_steps, stimulus, free, &compiled_actions);
    if (!is_done || (memcmp(&compiled, &expected, sizeof compiled) != 0) ||
        (compiled_actions != expected_actions)) {
        if (errors < 10U) {
            complain("difference", number, stimulus, free);
        }
        return;
    }
    digest += mixed(mixed(key_of(&found[number].config)) ^ mixed(key_of(&compiled) + 1U) ^
                    compiled_actions ^ (((uint64_t)stimulus << 16) | free));
    check_step(number, stimulus, free, &compiled);
    const uint32_t next = number_of(&compiled, number, stimulus, free);
    if (next != number) {
        if (successor_count == successor_room) {
            successor_room = (successor_room == 0U) ? 1024U : (successor_room * 2U);
            successors = grown(successors, successor_room * sizeof *successors);
        }
        successors[successor_count] = next;
        successor_count++;
    }
}

/* Every subset of the free inputs that the stimulus may read. */
static void take_stimulus(uint32_t number, uint32_t stimulus)
{
    const uint32_t mask = stimuli[stimulus].free;
    uint32_t free = 0U;
    do {
        take_pair(number, stimulus, free);
        free = (free - mask) & mask;
    } while (free != 0U);
}

static void explore(void)
{
    for (uint32_t number = 0U; number < found_count; number++) {
        const config_t config = found[number].config;
        successors_begin[number] = successor_count;
        for (uint32_t stimulus = 0U; stimulus < STIMULI; stimulus++) {
            if (may_happen(&config, stimulus)) {
                take_stimulus(number, stimulus);
            }
        }
        const uint32_t property = violated_by(&config);
        if ((property < PROPERTIES) && !is_violated[property]) {
            is_violated[property] = true;
            complain(properties[property].id, number, STIMULI, 0U);
        }
        if (!does_permit_agree(&config) && !is_permit_wrong) {
            is_permit_wrong = true;
            complain("permit_decide() is not the permit", number, STIMULI, 0U);
        }
    }
    successors_begin[found_count] = successor_count;
}

static bool is_before_reached(uint32_t number, const bool *is_reached)
{
    for (uint32_t i = successors_begin[number]; i < successors_begin[number + 1U]; i++) {
        if (is_reached[successors[i]]) {
            return true;
        }
    }
    return false;
}

/* Backwards over all pairs, until nothing changes or for so many steps. */
static void check_reachable(uint32_t property)
{
    bool *is_reached = grown(NULL, found_count);
    bool *is_next = grown(NULL, found_count);
    for (uint32_t i = 0U; i < found_count; i++) {
        is_reached[i] = is_wanted(&found[i].config, property);
    }
    bool is_changed = true;
    for (uint32_t sweep = 0U; is_changed && (sweep < properties[property].steps); sweep++) {
        is_changed = false;
        (void)memcpy(is_next, is_reached, found_count);
        for (uint32_t i = found_count; i-- > 0U;) {
            if (!is_next[i] && is_before_reached(i, is_reached)) {
                is_next[i] = true;
                is_changed = true;
            }
        }
        bool *const swapped = is_reached;
        is_reached = is_next;
        is_next = swapped;
    }
    for (uint32_t i = 0U; i < found_count; i++) {
        if (!is_reached[i]) {
            complain(properties[property].id, i, STIMULI, 0U);
            break;
        }
    }
    free(is_reached);
    free(is_next);
}

static void complain_of_seen(const char *what, const uint32_t numbers[MEMBERS + AXES])
{
    errors++;
    printf("%s:", what);
    for (uint32_t i = 0U; i < (MEMBERS + AXES); i++) {
        printf(" %u", (unsigned)numbers[i]);
    }
    puts("");
}

/* A line of what was seen elsewhere: the members' numbers, then whether each axis was permitted to
 * move; 2: something outside forbade it. */
static void look_up(const uint32_t numbers[MEMBERS + AXES])
{
    config_t config = {{0}};
    for (uint32_t i = 0U; i < MEMBERS; i++) {
        config.of[i] = (uint8_t)numbers[i];
    }
    if (*slot_of(&config) == NOBODY) {
        complain_of_seen("not reached", numbers);
    }
    for (uint32_t axis = 0U; axis < AXES; axis++) {
        const uint32_t seen = numbers[MEMBERS + axis];
        if ((seen < 2U) && (seen != (is_permitted(&config, axis) ? 1U : 0U))) {
            complain_of_seen("another permit", numbers);
        }
    }
}

static void look_up_all(const char *path)
{
    FILE *const file = fopen(path, "r");
    uint32_t numbers[MEMBERS + AXES];
    uint32_t filled = 0U;
    while ((file != NULL) && (fscanf(file, "%" SCNu32, &numbers[filled]) == 1)) {
        filled++;
        if (filled == (MEMBERS + AXES)) {
            filled = 0U;
            look_up(numbers);
        }
    }
    if (file != NULL) {
        (void)fclose(file);
    }
}

int main(int count, char **arguments)
{
    config_t start = {{0}};
    begin(&start);
    enlarge();
    (void)number_of(&start, NOBODY, 0U, 0U);
    explore();
    for (uint32_t i = 0U; i < PROPERTIES; i++) {
        if (properties[i].steps > 0U) {
            check_reachable(i);
        }
    }
    if (count == 2) {
        look_up_all(arguments[1]);
    }
    printf("configurations %u\npairs %llu\ntold %u\ndigest %016llx\n", (unsigned)found_count,
           (unsigned long long)pairs, (unsigned)longest_queue, (unsigned long long)digest);
    return (errors == 0U) ? 0 : 1;
}

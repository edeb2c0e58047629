/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Every reachable configuration of composed charts, breadth first, with every stimulus and every
 * value of the free inputs. composition.h, which is generated, has the charts, as compiled and as
 * tables of what the interpreter does, and how they act on each other.
 *
 *     explorer [SEEN]
 *
 * A chart's step is a function of its configuration, the event and its inputs alone. So each is
 * taken once by the compiled chart and by the table, and every pair of the composition is made of
 * such steps. One of two configurations that are each other's when the axes change places is
 * explored for both. Still each of its pairs is taken by both, and must come out alike, unless a
 * reaction of one axis alone has a part in it; and in the end both are reached by ways of their
 * own.
 *
 * Prints the first differences and violated properties with the stimuli that lead there, what of
 * SEEN differs (configurations that are never reached, and reasons), the numbers, and a digest of
 * all pairs.
 */
#include "composition.h"

#include <inttypes.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#define QUEUE 64U
#define MOST_DIFFERENCES 10U
#define SOON 8U

/* One member's step. */
typedef struct {
    uint64_t reactions; /* Those that it triggers, one bit each. */
    uint16_t after;
    uint16_t actions;
    bool is_same; /* Compiled as interpreted. */
} cell_t;

/* Result of a stimulus, with all events that it made the charts send each other. */
typedef struct {
    config_t after;
    uint64_t actions;
    bool can_happen;
    bool is_same;
    bool is_of_one_axis;
} result_t;

/* A pair of a turn that is not over. */
typedef struct {
    turn_t turn;
    way_t ways[2];
    result_t result;
} pair_t;

static cell_t *cells[MEMBERS];
static pair_t *kept;
static uint32_t kept_count;
static uint32_t kept_room;
static uint64_t spoken_from; /* By which properties, where it is the turn. */
static uint64_t pairs;
static uint64_t explored_pairs;
static uint64_t digest;
static uint32_t longest_queue;
static uint32_t errors;
static bool is_violated[PROPERTIES];
static bool is_permit_wrong;
static bool are_reasons_wrong;

void contract_broken(const char *module, uint32_t id)
{
    printf("contract %s %u is broken\n", module, (unsigned)id);
    exit(2);
}

static void report_step(uint32_t stimulus, uint32_t inputs)
{
    printf("%s", stimuli[stimulus].name);
    for (uint32_t i = 0U; i < FREE_INPUTS; i++) {
        if (((inputs >> i) & 1U) != 0U) {
            printf(" with %s", free_inputs[i]);
        }
    }
}

static const way_t *way_to(uint32_t place)
{
    return &found[place / 2U].ways[place % 2U];
}

static void report_path(uint32_t place)
{
    const way_t *const way = way_to(place);
    if (way->before != NOBODY) {
        report_path(way->before);
        printf("%s", (way_to(way->before)->before != NOBODY) ? ", " : "");
        report_step(way->stimulus, way->inputs);
    }
}

/* About a configuration, or about what comes of it by `way`. */
static void complain(const char *what, uint32_t place, const way_t *way)
{
    errors++;
    printf("%s: ", what);
    report_path(place);
    if (way != NULL) {
        printf("%s", (way_to(place)->before != NOBODY) ? ", " : "");
        report_step(way->stimulus, way->inputs);
    }
    puts("");
}

static void complain_of_pair(const char *what, const way_t *way)
{
    if (errors < MOST_DIFFERENCES) {
        complain(what, way->before, way);
    }
}

static bool is_triggered(const reaction_t *reaction, uint32_t event, uint32_t before,
                         const cell_t *cell)
{
    switch (reaction->trigger) {
    case TRIGGER_ENTERS:
        return (((reaction->what >> cell->after) & ~(reaction->what >> before)) & 1U) != 0U;
    case TRIGGER_DOES:
        return (((uint32_t)cell->actions >> reaction->what) & 1U) != 0U;
    case TRIGGER_HEARS:
    default:
        return event == reaction->what;
    }
}

static cell_t cell_of(uint32_t member, uint32_t before, uint32_t event, uint32_t inputs)
{
    uint32_t compiled_actions = 0U;
    uint32_t actions = 0U;
    const uint32_t compiled = members[member].compiled(before, event, inputs, &compiled_actions);
    const uint32_t after = members[member].interpreted(before, event, inputs, &actions);
    cell_t cell = {.after = (uint16_t)after,
                   .actions = (uint16_t)actions,
                   .is_same = (compiled == after) && (compiled_actions == actions)};
    for (uint32_t i = 0U; (i < REACTIONS) && (after != NEVER); i++) {
        if ((reactions[i].member == member) && is_triggered(&reactions[i], event, before, &cell)) {
            cell.reactions |= UINT64_C(1) << i;
        }
    }
    return cell;
}

static cell_t *cell_at(uint32_t member, uint32_t before, uint32_t event, uint32_t inputs)
{
    const member_t *const self = &members[member];
    return &cells[member][(((before * self->events) + event) * self->valuations) + inputs];
}

static void fill_cells(uint32_t member)
{
    const member_t *const self = &members[member];
    const uint32_t count = self->configurations * self->events * self->valuations;
    cells[member] = grown(NULL, count * sizeof *cells[member]);
    for (uint32_t i = 0U; i < self->configurations; i++) {
        for (uint32_t event = 0U; event < self->events; event++) {
            for (uint32_t inputs = 0U; inputs < self->valuations; inputs++) {
                *cell_at(member, i, event, inputs) = cell_of(member, i, event, inputs);
            }
        }
    }
}

static uint32_t queued(uint8_t queue[QUEUE], uint32_t reported, uint64_t triggered)
{
    for (; triggered != 0U; triggered &= triggered - 1U) {
        if (reported == QUEUE) {
            puts("the charts send each other more than the queue holds");
            exit(2);
        }
        queue[reported] = (uint8_t)__builtin_ctzll(triggered);
        reported++;
    }
    longest_queue = (reported > longest_queue) ? reported : longest_queue;
    return reported;
}

static result_t step(config_t before, uint32_t stimulus, uint32_t free)
{
    result_t result = {.after = before, .can_happen = true, .is_same = true};
    uint8_t queue[QUEUE];
    uint32_t reported = 0U;
    uint32_t member = stimuli[stimulus].member;
    uint32_t event = stimuli[stimulus].event;
    for (uint32_t next = 0U;; next++) {
        const uint32_t inputs = inputs_of(result.after, member, free);
        const cell_t *const cell = cell_at(member, own(result.after, member), event, inputs);
        if (cell->after == NEVER) {
            result.can_happen = false;
            return result;
        }
        result.after = with_own(result.after, member, cell->after);
        result.actions = mixed(
            result.actions ^ (((uint64_t)member << 40) | ((uint64_t)event << 32) | cell->actions));
        result.is_same = result.is_same && cell->is_same;
        reported = queued(queue, reported, cell->reactions);
        while ((next < reported) && !does_react(result.after, queue[next])) {
            next++;
        }
        if (next >= reported) {
            return result;
        }
        const reaction_t *const reaction = &reactions[queue[next]];
        result.is_of_one_axis = result.is_of_one_axis || reaction->is_of_one_axis;
        member = reaction->reported_member;
        event = reaction->reported_event;
    }
}

/* violated: one bit for each property, as side 0 sees them. */
static void complain_of_properties(uint64_t violated, uint32_t place, const way_t *way)
{
    for (uint32_t i = 0U; violated != 0U; i++, violated >>= 1) {
        const uint32_t property = ((place % 2U) == 0U) ? i : properties[i].twin;
        if (((violated & 1U) != 0U) && !is_violated[property]) {
            is_violated[property] = true;
            complain(properties[property].id, place, way);
        }
    }
}

static uint32_t first_side(uint32_t sides)
{
    return ((sides & 1U) != 0U) ? 0U : 1U;
}

/* One pair of each of these sides; the result is that of side 0. */
static void note_pair(turn_t turn, const way_t ways[2], const result_t *result)
{
    const way_t *const way = &ways[first_side(turn.sides)];
    if (!result->is_same) {
        complain_of_pair("difference", way);
        return;
    }
    pairs += (turn.sides == BOTH_SIDES) ? 2U : 1U;
    explored_pairs++;
    digest +=
        mixed(mixed(found[turn.row].config) ^ mixed(result->after + 1U) ^ result->actions ^
              (((uint64_t)turn.sides << 32) | ((uint64_t)ways[0].stimulus << 16) | ways[0].inputs));
    const bool is_elsewhere = result->after != found[turn.row].config;
    const uint32_t place =
        is_elsewhere ? found_add(result->after, turn.sides, ways) : (turn.row * 2U);
    const uint64_t objections = found[place / 2U].objections[place % 2U];
    complain_of_properties(spoken_from & spoken_of[ways[0].stimulus] & objections, way->before,
                           way);
    if (is_elsewhere && !result->is_of_one_axis) {
        found_succeed(turn.row, place / 2U);
    }
}

/* Waits for the others of its turn: memory is slow, and asked for all of them at once. */
static void keep_pair(turn_t turn, const way_t ways[2], const result_t *result)
{
    if (kept_count == kept_room) {
        kept_room = (kept_room == 0U) ? 256U : (kept_room * 2U);
        kept = grown(kept, kept_room * sizeof *kept);
    }
    kept[kept_count] = (pair_t){turn, {ways[0], ways[1]}, *result};
    kept_count++;
    if (result->after != found[turn.row].config) {
        found_expect(result->after);
    }
}

static void note_kept(void)
{
    for (uint32_t i = 0U; i < kept_count; i++) {
        const uint32_t soon = i + SOON;
        if ((soon < kept_count) && (kept[soon].result.after != found[kept[soon].turn.row].config)) {
            found_approach(kept[soon].result.after);
        }
        note_pair(kept[i].turn, kept[i].ways, &kept[i].result);
    }
    kept_count = 0U;
}

static void take_pair(turn_t turn, uint32_t stimulus, uint32_t free)
{
    const config_t config = found[turn.row].config;
    const uint32_t twin = stimuli[stimulus].twin;
    const way_t ways[2] = {
        {turn.row * 2U, (uint16_t)stimulus, (uint16_t)free},
        {(turn.row * 2U) + 1U, (uint16_t)twin, (uint16_t)exchanged_inputs(free)}};
    const result_t here = step(config, stimulus, free);
    result_t there = here;
    if (AXES > 1U) {
        there = step(exchanged(config), twin, ways[1].inputs);
        there.after = exchanged(there.after);
    }
    if (here.is_of_one_axis && there.is_of_one_axis) {
        const result_t *const results[2] = {&here, &there};
        for (uint32_t side = 0U; side < 2U; side++) {
            if (((turn.sides >> side) & 1U) != 0U) {
                keep_pair((turn_t){turn.row, 1U << side}, ways, results[side]);
            }
        }
    } else if ((here.can_happen != there.can_happen) || (here.after != there.after)) {
        complain_of_pair("the axes are not alike", &ways[first_side(turn.sides)]);
    } else if (here.can_happen) {
        keep_pair(turn, ways, &here);
    }
}

/* Every subset of the free inputs that the stimulus may read. */
static void take_stimulus(turn_t turn, uint32_t stimulus)
{
    const uint32_t mask = stimuli[stimulus].free;
    uint32_t free = 0U;
    do {
        take_pair(turn, stimulus, free);
        free = (free - mask) & mask;
    } while (free != 0U);
}

static void complain_once(bool *is_reported, const char *what, uint32_t place)
{
    if (!*is_reported) {
        *is_reported = true;
        complain(what, place, NULL);
    }
}

static void check_permit(config_t config, uint32_t axis, uint32_t place)
{
    const permit_t permit = decided(config, axis);
    if (permit.is_allowed != is_permitted(config, axis)) {
        complain_once(&is_permit_wrong, "permit_decide() is not the permit", place);
    }
    if (permit.reasons != reasons_of(config, axis)) {
        complain_once(&are_reasons_wrong, "permit_decide() gives other reasons", place);
    }
}

static void take_turn(turn_t turn)
{
    const config_t config = found[turn.row].config;
    const uint32_t place = (turn.row * 2U) + first_side(turn.sides);
    spoken_from = speaks_from(config);
    for (uint32_t stimulus = 0U; stimulus < STIMULI; stimulus++) {
        const bool may = may_happen(config, stimulus);
        if (may != may_happen(exchanged(config), stimuli[stimulus].twin)) {
            complain("the axes are not alike", place, NULL);
        } else if (may) {
            take_stimulus(turn, stimulus);
        }
    }
    note_kept();
    found[turn.row].is_explored = true;
    complain_of_properties(found[turn.row].objections[0] & ALWAYS, place, NULL);
    for (uint32_t axis = 0U; axis < AXES; axis++) {
        check_permit(config, axis, place);
    }
}

static config_t config_at(uint32_t place)
{
    const config_t config = found[place / 2U].config;
    return ((place % 2U) == 0U) ? config : exchanged(config);
}

/* Every side that was found is reached as recorded, without an exchange. */
static void check_ways(void)
{
    for (uint32_t place = 2U; place < (found_count * 2U); place++) {
        const way_t *const way = way_to(place);
        if (((found[place / 2U].sides >> (place % 2U)) & 1U) != 0U) {
            const result_t result = step(config_at(way->before), way->stimulus, way->inputs);
            if (!result.can_happen || (result.after != config_at(place))) {
                complain_of_pair("this leads elsewhere", way);
            }
        }
    }
}

static void check_reachable(uint32_t property)
{
    const uint32_t row = found_lost(property, properties[property].steps);
    if (row != NOBODY) {
        complain(properties[property].id, (row * 2U) + first_side(found[row].sides), NULL);
    }
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

/* Another card may be lost too. */
static bool are_reasons_of(config_t config, uint32_t axis, uint32_t seen)
{
    const uint32_t unknown =
        ((seen & ANOTHER_CARD_LOST) != 0U) ? (1U << PERMIT_REASON_LINK_LOST) : 0U;
    return ((seen ^ reasons_of(config, axis)) & ~unknown & ~ANOTHER_CARD_LOST) == 0U;
}

/* A line of what was seen elsewhere: the members' numbers, then the reasons against motion of each
 * axis. */
static void look_up(const uint32_t numbers[MEMBERS + AXES])
{
    config_t config = 0U;
    bool is_known = true;
    for (uint32_t i = 0U; i < MEMBERS; i++) {
        is_known = is_known && (numbers[i] < members[i].configurations);
        config = with_own(config, i, numbers[i] & OWN_MASK);
    }
    if (!is_known || !found_is(config)) {
        complain_of_seen("not reached", numbers);
    }
    for (uint32_t axis = 0U; axis < AXES; axis++) {
        if (!are_reasons_of(config, axis, numbers[MEMBERS + axis])) {
            complain_of_seen("other reasons", numbers);
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

static uint32_t configurations(void)
{
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < found_count; i++) {
        count += (found[i].sides == BOTH_SIDES) ? 2U : 1U;
    }
    return count;
}

int main(int count, char **arguments)
{
    turn_t turn;
    (void)setvbuf(stdout, NULL, _IOLBF, BUFSIZ); /* A finding is read before all is explored. */
    for (uint32_t i = 0U; i < MEMBERS; i++) {
        fill_cells(i);
    }
    found_begin(start(), exchanged, objects_to);
    while (found_next(&turn)) {
        take_turn(turn);
    }
    check_ways();
    for (uint32_t i = 0U; i < PROPERTIES; i++) {
        if (properties[i].steps > 0U) {
            check_reachable(i);
        }
    }
    if (count == 2) {
        look_up_all(arguments[1]);
    }
    printf("configurations %u\nof them explored %u\npairs %llu\nof them explored %llu\ntold %u\n"
           "digest %016llx\n",
           (unsigned)configurations(), (unsigned)found_count, (unsigned long long)pairs,
           (unsigned long long)explored_pairs, (unsigned)longest_queue, (unsigned long long)digest);
    return (errors == 0U) ? 0 : 1;
}

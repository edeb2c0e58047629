/* SPDX-License-Identifier: Apache-2.0 */
#include "exchange/exchange.h"

#include "exchange/exchange_lock.h"
#include "exchange/exchange_segment.h"
#include "procedure/command_kinds.h"

#include <string.h>

/* Control waits for the recorder's sign of life, so that no other process may give it. */
static uint32_t *beats_of(const exchange_t *self, exchange_process_t process)
{
    return (process == EXCHANGE_RECORDER) ? &self->segment->recorder.beats
                                          : &self->segment->others.beats[process].count;
}

void exchange_beat(exchange_t *self, exchange_process_t process)
{
    uint32_t *count = beats_of(self, process);
    __atomic_store_n(count, *count + 1U, __ATOMIC_RELEASE);
}

uint32_t exchange_beats(const exchange_t *self, exchange_process_t process)
{
    return __atomic_load_n(beats_of(self, process), __ATOMIC_ACQUIRE);
}

void exchange_publish_snapshot(exchange_t *self, const snapshot_t *snapshot)
{
    segment_control_t *control = &self->segment->control;
    const uint32_t published = __atomic_load_n(&control->published, __ATOMIC_RELAXED);
    segment_snapshot_t *slot = &control->snapshots[published % SEGMENT_SNAPSHOTS];

    exchange_write_locked(&slot->sequence, &slot->snapshot, snapshot, sizeof *snapshot);
    __atomic_store_n(&control->published, published + 1U, __ATOMIC_RELEASE);
}

bool exchange_read_snapshot(const exchange_t *self, snapshot_t *snapshot)
{
    const segment_control_t *control = &self->segment->control;

    for (uint32_t tries = 0U; tries < EXCHANGE_READ_TRIES; tries++) {
        const uint32_t published = __atomic_load_n(&control->published, __ATOMIC_ACQUIRE);
        const segment_snapshot_t *slot = &control->snapshots[(published - 1U) % SEGMENT_SNAPSHOTS];
        if (exchange_read_locked(&slot->sequence, snapshot, &slot->snapshot, sizeof *snapshot)) {
            return true;
        }
    }
    return false;
}

void exchange_publish_robot(exchange_t *self, const robot_t *robot)
{
    robot_t *published = &self->segment->control.robot;
    robot_t copy = *robot;

    copy.axis_count = 0U;
    *published = copy;
    __atomic_store_n(&published->axis_count, robot->axis_count, __ATOMIC_RELEASE);
}

void exchange_publish_cards(exchange_t *self, const exchange_cards_t *cards)
{
    self->segment->control.cards = *cards;
}

const exchange_cards_t *exchange_cards(const exchange_t *self)
{
    return &self->segment->control.cards;
}

const robot_t *exchange_robot(const exchange_t *self)
{
    return &self->segment->control.robot;
}

void exchange_publish_loop(exchange_t *self, const loop_figures_t *figures)
{
    segment_control_t *control = &self->segment->control;

    exchange_write_locked(&control->loop_sequence, &control->loop, figures, sizeof *figures);
}

bool exchange_read_loop(const exchange_t *self, loop_figures_t *figures)
{
    const segment_control_t *control = &self->segment->control;

    for (uint32_t tries = 0U; tries < EXCHANGE_READ_TRIES; tries++) {
        if (exchange_read_locked(&control->loop_sequence, figures, &control->loop,
                                 sizeof *figures)) {
            return true;
        }
    }
    return false;
}

/* STOP and EMERGENCY of the console have a latch instead. */
static bool has_lane(const command_t *command)
{
    const bool is_latched =
        (command->source == (uint32_t)COMMAND_SOURCE_HTTP) && command_kinds_is_stop(command);

    return (command->source < COMMAND_SOURCE_COUNT) && !is_latched;
}

status_t exchange_send_command(exchange_t *self, const command_t *command)
{
    if (!has_lane(command)) {
        return STATUS_NOT_ALLOWED;
    }
    segment_commands_t *lane = &self->segment->others.lanes[command->source];
    const uint32_t put = __atomic_load_n(&lane->head, __ATOMIC_RELAXED);
    const uint32_t taken =
        __atomic_load_n(&self->segment->control.taken[command->source].tail, __ATOMIC_ACQUIRE);
    const uint32_t places = command_kinds_is_stop(command) ? SEGMENT_COMMANDS : EXCHANGE_COMMANDS;

    if ((put - taken) >= places) {
        return STATUS_BUSY;
    }
    segment_command_t *place = &lane->commands[put % SEGMENT_COMMANDS];
    place->command = *command;
    place->check = exchange_check(put, command, sizeof *command);
    __atomic_store_n(&lane->head, put + 1U, __ATOMIC_RELEASE);
    return STATUS_OK;
}

/* The number of requests so far. */
static uint32_t number_of(uint64_t requests)
{
    return (uint32_t)(requests / SEGMENT_STOP);
}

uint32_t exchange_request_stop(exchange_t *self, workphase_t workphase)
{
    const uint64_t request =
        SEGMENT_STOP + ((workphase == WORKPHASE_EMERGENCY) ? UINT64_C(1) : UINT64_C(0));

    return number_of(
        __atomic_add_fetch(&self->segment->others.stops_requested, request, __ATOMIC_RELEASE));
}

bool exchange_read_stop_answer(const exchange_t *self, uint32_t number, answer_t *answer)
{
    const segment_control_t *control = &self->segment->control;

    return exchange_read_locked(&control->stop_sequence, answer, &control->stop_answer,
                                sizeof *answer) &&
           ((answer->id - number) <= (uint32_t)INT32_MAX);
}

/* One command stands for all requests so far: EMERGENCY, if one of them asked for it. */
static bool take_stop(exchange_t *self, command_t *command)
{
    const uint64_t requested =
        __atomic_load_n(&self->segment->others.stops_requested, __ATOMIC_ACQUIRE);
    uint64_t *taken = &self->segment->control.stops_taken;
    const uint64_t before = __atomic_load_n(taken, __ATOMIC_RELAXED);

    if (requested == before) {
        return false;
    }
    (void)memset(command, 0, sizeof *command);
    command->id = number_of(requested);
    command->source = (uint32_t)COMMAND_SOURCE_HTTP;
    command->kind = (uint32_t)COMMAND_WORKPHASE;
    command->as.workphase.workphase = ((uint32_t)requested != (uint32_t)before)
                                          ? (uint32_t)WORKPHASE_EMERGENCY
                                          : (uint32_t)WORKPHASE_STOP;
    __atomic_store_n(taken, requested, __ATOMIC_RELEASE);
    return true;
}

static void count_one(uint32_t *counter)
{
    __atomic_store_n(counter, __atomic_load_n(counter, __ATOMIC_RELAXED) + 1U, __ATOMIC_RELEASE);
}

/* False when it was not put there as this one. */
static bool read_command(const exchange_t *self, uint32_t source, uint32_t number,
                         command_t *command)
{
    const segment_command_t *place =
        &self->segment->others.lanes[source].commands[number % SEGMENT_COMMANDS];

    *command = place->command;
    return place->check == exchange_check(number, command, sizeof *command);
}

/* False: the command was damaged, and is dropped. */
static bool take_command(exchange_t *self, uint32_t source, command_t *command)
{
    uint32_t *tail = &self->segment->control.taken[source].tail;
    const uint32_t taken = __atomic_load_n(tail, __ATOMIC_RELAXED);
    const bool is_good = read_command(self, source, taken, command);

    command->source = source; /* No source speaks for another. */
    command_clear_unused(command);
    __atomic_store_n(tail, taken + 1U, __ATOMIC_RELEASE);
    if (!is_good) {
        count_one(&self->segment->control.taken[source].damaged);
    }
    return is_good;
}

static bool is_costly(const command_t *command)
{
    const bool is_move = command_kinds_workphase(command) == WORKPHASE_MOVE_TO_TARGET;
    return is_move || ((command->kind < COMMAND_KIND_COUNT) &&
                       (((COMMAND_KINDS_COSTLY >> command->kind) & 1U) != 0U));
}

/* Commands of a lane that wait, from its `*taken` on. More than it has places were never put in:
 * its head was damaged, and nothing waits. */
static uint32_t count_waiting(exchange_t *self, uint32_t source, uint32_t *taken)
{
    const uint32_t put =
        __atomic_load_n(&self->segment->others.lanes[source].head, __ATOMIC_ACQUIRE);
    uint32_t *tail = &self->segment->control.taken[source].tail;

    *taken = __atomic_load_n(tail, __ATOMIC_RELAXED);
    if ((put - *taken) > SEGMENT_COMMANDS) {
        *taken = put;
        __atomic_store_n(tail, put, __ATOMIC_RELEASE);
        count_one(&self->segment->control.taken[source].damaged);
    }
    return put - *taken;
}

/* A stop refuses all commands before it but the stops among them, in this cycle and, where those
 * fill it, in later ones. True, with the stop, when there is a new one. */
static bool find_stop(exchange_t *self, uint32_t source, uint32_t *stop_for)
{
    exchange_refused_t *refused = &self->refused[source];
    uint32_t taken;
    const uint32_t waiting = count_waiting(self, source, &taken);
    bool is_found = false;

    if ((refused->until - taken) > waiting) {
        refused->until = taken; /* All of them have been refused. */
    }
    for (uint32_t i = refused->until - taken; i < waiting; i++) {
        command_t command;
        if (read_command(self, source, taken + i, &command) && command_kinds_is_stop(&command)) {
            refused->until = taken + i + 1U;
            refused->stop_for = (uint32_t)command_kinds_workphase(&command);
            *stop_for = refused->stop_for;
            is_found = true;
        }
    }
    return is_found;
}

/* All that waits in a lane waits behind a stop that came elsewhere. */
static void refuse_waiting(exchange_t *self, uint32_t source, uint32_t stop_for)
{
    uint32_t taken;
    const uint32_t waiting = count_waiting(self, source, &taken);

    self->refused[source].until = taken + waiting;
    self->refused[source].stop_for = stop_for;
}

/* `requested`: the stop that was, NULL: none. */
static void find_refused(exchange_t *self, const command_t *requested)
{
    uint32_t stop_for = (uint32_t)WORKPHASE_STOP;

    for (uint32_t i = 0U; i < COMMAND_SOURCE_COUNT; i++) {
        if (find_stop(self, i, &stop_for)) {
            for (uint32_t j = 0U; j < COMMAND_SOURCE_COUNT; j++) {
                if (j != i) {
                    refuse_waiting(self, j, stop_for);
                }
            }
        }
    }
    for (uint32_t i = 0U; (i < COMMAND_SOURCE_COUNT) && (requested != NULL); i++) {
        refuse_waiting(self, i, (uint32_t)command_kinds_workphase(requested));
    }
}

static void refuse(exchange_t *self, const command_t *command, uint32_t workphase)
{
    const answer_t refusal = {.id = command->id,
                              .source = command->source,
                              .command = command->kind,
                              .asked = (uint32_t)command_kinds_workphase(command),
                              .kind = (uint32_t)ANSWER_REFUSED,
                              .status = (uint32_t)STATUS_DISCARDED,
                              .is_final = 1U,
                              .workphase = workphase};

    (void)exchange_push_answer(self, &refusal);
}

/* Up to `most` of a lane. True when the last of them computes kinematics. */
static bool take_lane(exchange_t *self, uint32_t source, command_t *commands, uint32_t most,
                      uint32_t *count)
{
    const exchange_refused_t *refused = &self->refused[source];
    uint32_t taken;
    const uint32_t waiting = count_waiting(self, source, &taken);
    const uint32_t left = refused->until - taken;
    bool is_enough = false;

    for (uint32_t i = 0U; (i < waiting) && (*count < most) && !is_enough; i++) {
        command_t *command = &commands[*count];
        const bool is_good = take_command(self, source, command);
        if (is_good && (i < left) && !command_kinds_is_stop(command)) {
            refuse(self, command, refused->stop_for);
        } else if (is_good) {
            is_enough = is_costly(command);
            (*count)++;
        } else {
            /* It was damaged. */
        }
    }
    return is_enough;
}

uint32_t exchange_take_commands(exchange_t *self, command_t *commands, uint32_t most)
{
    command_t stop;
    const bool is_stop_requested = take_stop(self, &stop);
    const uint32_t others = is_stop_requested ? (most - 1U) : most;
    uint32_t count = 0U;
    bool is_enough = false;

    find_refused(self, is_stop_requested ? &stop : NULL);
    for (uint32_t i = 0U; (i < COMMAND_SOURCE_COUNT) && !is_enough; i++) {
        const uint32_t source = (self->first_lane + i) % COMMAND_SOURCE_COUNT;
        is_enough = take_lane(self, source, commands, others, &count);
    }
    self->first_lane++; /* None waits for another. */
    if (is_stop_requested) {
        commands[count] = stop; /* The last one: nothing of the same cycle undoes it. */
        count++;
    }
    return count;
}

uint32_t exchange_lane_damages(const exchange_t *self, command_source_t source)
{
    return __atomic_load_n(&self->segment->control.taken[source].damaged, __ATOMIC_ACQUIRE);
}

static bool push_into_lane(exchange_t *self, const answer_t *answer)
{
    segment_answers_t *lane = &self->segment->control.answers[answer->source];
    const uint32_t put = __atomic_load_n(&lane->head, __ATOMIC_RELAXED);
    const uint32_t taken =
        __atomic_load_n(&self->segment->others.answered[answer->source].tail, __ATOMIC_ACQUIRE);

    if ((put - taken) >= EXCHANGE_ANSWERS) {
        return false;
    }
    lane->answers[put % EXCHANGE_ANSWERS] = *answer;
    __atomic_store_n(&lane->head, put + 1U, __ATOMIC_RELEASE);
    return true;
}

/* To a stop that was requested: none of HTTP's stops comes by its lane. */
static bool is_of_latch(const answer_t *answer)
{
    return (answer->source == (uint32_t)COMMAND_SOURCE_HTTP) &&
           ((answer->asked == (uint32_t)WORKPHASE_STOP) ||
            (answer->asked == (uint32_t)WORKPHASE_EMERGENCY));
}

bool exchange_push_answer(exchange_t *self, const answer_t *answer)
{
    segment_control_t *control = &self->segment->control;
    bool is_kept = false;

    if (is_of_latch(answer)) {
        exchange_write_locked(&control->stop_sequence, &control->stop_answer, answer,
                              sizeof *answer);
        is_kept = true;
    } else if (answer->source < COMMAND_SOURCE_COUNT) {
        is_kept = push_into_lane(self, answer);
    } else {
        /* No source asked. */
    }
    if (!is_kept) {
        count_one(&control->answers_lost);
    }
    return is_kept;
}

bool exchange_take_answer(exchange_t *self, command_source_t source, answer_t *answer)
{
    const segment_answers_t *lane = &self->segment->control.answers[source];
    const uint32_t put = __atomic_load_n(&lane->head, __ATOMIC_ACQUIRE);
    uint32_t *taken = &self->answered[source];
    bool is_one;

    if ((put - *taken) > EXCHANGE_ANSWERS) {
        *taken = put; /* A damaged tail has shown control more room than there was. */
    }
    is_one = put != *taken;
    if (is_one) {
        *answer = lane->answers[*taken % EXCHANGE_ANSWERS];
        (*taken)++;
    }
    __atomic_store_n(&self->segment->others.answered[source].tail, *taken, __ATOMIC_RELEASE);
    return is_one;
}

void exchange_note_replaced(exchange_t *self, exchange_process_t process)
{
    uint64_t *noted = &self->segment->others.replaced[process];
    uint64_t before = __atomic_load_n(noted, __ATOMIC_ACQUIRE);

    while (!__atomic_compare_exchange_n(noted, &before,
                                        exchange_sealed(exchange_unsealed(before) + 1U), false,
                                        __ATOMIC_ACQ_REL, __ATOMIC_ACQUIRE)) {
    }
}

uint32_t exchange_take_replaced(exchange_t *self, exchange_process_t process)
{
    return exchange_unsealed(__atomic_exchange_n(&self->segment->others.replaced[process],
                                                 UINT64_C(0), __ATOMIC_ACQ_REL));
}

void exchange_note_stop_port(exchange_t *self, uint32_t port)
{
    exchange_store_number(&self->segment->others.stop_port, port);
}

uint32_t exchange_stop_port(const exchange_t *self)
{
    return exchange_load_number(&self->segment->others.stop_port);
}

uint32_t exchange_answers_lost(const exchange_t *self)
{
    return __atomic_load_n(&self->segment->control.answers_lost, __ATOMIC_ACQUIRE);
}

void exchange_push_event(exchange_t *self, const event_t *event, uint64_t utc_us)
{
    const exchange_event_t dated = {.event = *event, .utc_us = utc_us};
    segment_control_t *control = &self->segment->control;
    segment_event_t *slot = &control->events[event->number % EXCHANGE_EVENTS];

    exchange_write_locked(&slot->sequence, &slot->event, &dated, sizeof dated);
    __atomic_store_n(&control->events_head, event->number + 1U, __ATOMIC_RELEASE);
}

uint32_t exchange_read_events(const exchange_t *self, uint32_t *next, exchange_event_t *events,
                              uint32_t most, uint32_t *lost)
{
    const segment_control_t *control = &self->segment->control;
    const uint32_t head = __atomic_load_n(&control->events_head, __ATOMIC_ACQUIRE);
    uint32_t count = 0U;

    if ((head - *next) > (uint32_t)INT32_MAX) {
        return 0U; /* The reader is ahead: nothing new. */
    }
    if ((head - *next) > EXCHANGE_EVENTS) {
        *lost += head - *next - EXCHANGE_EVENTS;
        *next = head - EXCHANGE_EVENTS;
    }
    while ((*next != head) && (count < most)) {
        const segment_event_t *slot = &control->events[*next % EXCHANGE_EVENTS];
        const bool is_whole =
            exchange_read_locked(&slot->sequence, &events[count], &slot->event, sizeof slot->event);
        if (is_whole && (events[count].event.number == *next)) {
            count++;
        } else {
            (*lost)++;
        }
        (*next)++;
    }
    return count;
}

uint32_t exchange_oldest_event(const exchange_t *self)
{
    const uint32_t head = __atomic_load_n(&self->segment->control.events_head, __ATOMIC_ACQUIRE);

    return (head > EXCHANGE_EVENTS) ? (head - EXCHANGE_EVENTS) : 0U;
}

void exchange_note_logged(exchange_t *self, uint32_t next)
{
    exchange_store_number(&self->segment->others.events_logged, next);
}

uint32_t exchange_logged(const exchange_t *self)
{
    return exchange_load_number(&self->segment->others.events_logged);
}

void exchange_request_checkpoint(exchange_t *self)
{
    count_one(&self->segment->recorder.checkpoint_requests);
}

/* Any change of the number counts: a checkpoint too many does no harm. */
bool exchange_take_checkpoint_request(exchange_t *self)
{
    uint32_t *taken = &self->segment->control.checkpoints_taken;
    const uint32_t requested =
        __atomic_load_n(&self->segment->recorder.checkpoint_requests, __ATOMIC_ACQUIRE);
    const bool is_new = (requested != __atomic_load_n(taken, __ATOMIC_RELAXED));

    __atomic_store_n(taken, requested, __ATOMIC_RELEASE);
    return is_new;
}

static uint32_t next_end(const exchange_t *self)
{
    return __atomic_load_n(&self->segment->control.ends_taken, __ATOMIC_ACQUIRE) + 1U;
}

void exchange_request_end(exchange_t *self)
{
    exchange_store_number(&self->segment->others.end_requested, next_end(self));
}

/* Damage ends nothing. */
bool exchange_take_end_request(exchange_t *self)
{
    const bool is_requested =
        exchange_load_number(&self->segment->others.end_requested) == next_end(self);

    if (is_requested) {
        count_one(&self->segment->control.ends_taken);
    }
    return is_requested;
}

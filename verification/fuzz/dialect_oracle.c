/* SPDX-License-Identifier: Apache-2.0 */
#include "fuzz/dialect_oracle.h"

#include "igtl/dialect/igtl_units.h"
#include "igtl/dialect/transform_proposals.h"
#include "fuzz/dialect_message.h"
#include "fuzz/dialect_requests.h"
#include "fuzz/sentence.h"
#include "limits/requirement_limits.h"
#include "igtl/wire/igtl_crc64.h"
#include "procedure/command_kinds.h"
#include "unit/support/commands.h"

#include <string.h>

#define NOWHERE UINT32_MAX
#define SEEN 64U
#define TRACKED_BYTES 70U   /* Size of an element of a TDATA, */
#define TRACKED_NUMBERS 22U /* and where its numbers begin. */
#define SECOND_US UINT64_C(1000000)
#define JITTER_US UINT64_C(5000)
/* Proposals of a planner in the second after a pause. */
#define PROPOSALS ((LIMIT_IGTL_PROPOSAL_BURST - 1U) + (SECOND_US / LIMIT_IGTL_PROPOSAL_INTERVAL_US))

/** Messages to one peer since a dialect was called, and its own before. */
typedef struct {
    uint32_t statuses;
    uint32_t answers; /**< All but acknowledgements. */
    bool is_acknowledged;
    bool has_asked;
    bool was_pose_known;           /**< In any call since it has read last. */
    bool was_homed;                /**< The same of the axes. */
    bool has_hung;                 /**< Since then. */
    uint64_t passed_us[PROPOSALS]; /**< Its latest proposals, a ring. */
    uint32_t passed_count;
    uint64_t seen[SEEN]; /**< Commands, a ring. */
    uint32_t seen_count;
} peer_t;

static struct {
    peer_t peers[WORLD_PEERS];
    igtl_requests_t before;
    uint32_t next_proposal;
    uint32_t commander;
    uint32_t speaker; /**< Or NOWHERE. */
    const igtl_message_t *said;
    bool is_stop_owed;
    bool is_emergency_owed;
} oracle;

void dialect_oracle_begin(world_t *world)
{
    (void)memset(&oracle, 0, sizeof oracle);
    oracle.commander = NOWHERE;
    oracle.speaker = NOWHERE;
    oracle.before = world->workphase.requests;
}

void dialect_oracle_connected(const world_t *world, uint32_t place)
{
    (void)world;
    oracle.peers[place] = (peer_t){.statuses = 0U};
}

static uint32_t commander_of(const world_t *world)
{
    uint32_t found = NOWHERE;

    for (uint32_t i = 0U; i < WORLD_PEERS; i++) {
        if (workphase_dialect_is_controlled_by(&world->workphase, i)) {
            SENTENCE(found == NOWHERE, "one commands at most");
            found = i;
        }
    }
    return found;
}

void dialect_oracle_leaves(const world_t *world, uint32_t place)
{
    if (world->peers[place].language == IGTL_LANGUAGE_CRTK) {
        return;
    }
    if (oracle.commander == place) {
        oracle.commander = NOWHERE;
    }
}

static bool is_pose_known(const world_t *world)
{
    return igtl_pose_status(&world->moment) == STATUS_OK;
}

static bool is_homed(const world_t *world)
{
    return (world->moment.snapshot != NULL) && (world->moment.snapshot->is_homed != 0U);
}

void dialect_oracle_before(const world_t *world)
{
    oracle.speaker = NOWHERE;
    oracle.said = NULL;
    oracle.before = world->workphase.requests;
    oracle.next_proposal = world->transform.requests.next_id;
    for (uint32_t i = 0U; i < WORLD_PEERS; i++) {
        peer_t *peer = &oracle.peers[i];

        peer->statuses = 0U;
        peer->answers = 0U;
        peer->is_acknowledged = false;
        peer->has_hung = peer->has_hung || world->peers[i].is_hung;
        peer->was_pose_known = peer->was_pose_known || is_pose_known(world);
        peer->was_homed = peer->was_homed || is_homed(world);
    }
}

void dialect_oracle_hears(const world_t *world, uint32_t place, const igtl_message_t *message)
{
    dialect_oracle_before(world);
    oracle.speaker = place;
    oracle.said = message;
    if ((message->kind != IGTL_KIND_STRING) && (message->kind != IGTL_KIND_TRANSFORM) &&
        (message->kind != IGTL_KIND_STATUS)) {
        oracle.peers[place].has_asked = true;
    }
}

/* Tracking is of the needle alone. */
static void judge_tracking(const world_t *world, uint32_t place, const igtl_message_t *message)
{
    uint32_t numbers[IGTL_TRANSFORM_NUMBERS];

    if ((message->content_bytes == 0U) || oracle.peers[place].has_hung) {
        return;
    }
    SENTENCE(message->content_bytes == TRACKED_BYTES, "one instrument is tracked");
    SENTENCE(is_pose_known(world), "no pose is tracked that is not known");
    igtl_units_write_pose(&world->moment.snapshot->scanner_treatment, numbers);
    for (uint32_t i = 0U; i < IGTL_TRANSFORM_BYTES; i++) {
        SENTENCE(message->content[TRACKED_NUMBERS + i] ==
                     (uint8_t)(numbers[i / 4U] >> (24U - (8U * (i % 4U)))),
                 "a tracked pose is the present one");
    }
}

/* The needle's pose, or what is computed with it. */
static void judge_transform(const world_t *world, uint32_t place, const igtl_message_t *message)
{
    const peer_t *peer = &oracle.peers[place];
    const bool is_measured =
        message_is_named(message, "CURRENT_POSITION") || message_is_named(message, "measured_cp");
    uint32_t numbers[IGTL_TRANSFORM_NUMBERS];

    if (message_begins(message->name, "ACK_")) {
        return; /* It echoes anything. */
    }
    for (uint32_t i = 0U; i < IGTL_TRANSFORM_NUMBERS; i++) {
        SENTENCE(((message->numbers[i] >> 23U) & 0xFFU) != 0xFFU, "what is reported is finite");
    }
    if (is_measured || message_is_named(message, "desired_cp")) {
        SENTENCE(peer->was_pose_known, "no pose is reported that is not known");
    }
    if (is_measured && !peer->has_hung) {
        igtl_units_write_pose(&world->moment.snapshot->scanner_treatment, numbers);
        SENTENCE(memcmp(numbers, message->numbers, sizeof numbers) == 0,
                 "a pose is the present one");
    }
}

static void judge_string(uint32_t place, const igtl_message_t *message)
{
    if (message_is_named(message, "measured_jp") || message_is_named(message, "measured_jv")) {
        SENTENCE(oracle.peers[place].was_homed, "no joint is reported that is not known");
    }
    if (message_is_named(message, "IS_IN_TARGETING_POS") ||
        message_is_named(message, "HAS_REACHED_TARGET")) {
        SENTENCE((message->text_bytes == 1U), "a question of yes or no is answered so");
        SENTENCE((message->text[0] == '0') || oracle.peers[place].was_pose_known,
                 "no needle stands anywhere that is not known");
    }
}

static void judge(const world_t *world, uint32_t place, const uint8_t *bytes, uint32_t length)
{
    peer_t *peer = &oracle.peers[place];
    igtl_header_t header;
    igtl_message_t message;

    SENTENCE(length >= IGTL_HEADER_BYTES, "a message has a header");
    SENTENCE(igtl_decode_header(bytes, &header) == IGTL_OK, "a message's header is well formed");
    SENTENCE((header.body_bytes + IGTL_HEADER_BYTES) == length, "a message is whole");
    SENTENCE(igtl_decode_body(&header, &bytes[IGTL_HEADER_BYTES], &message) == IGTL_OK,
             "a message is well formed");
    SENTENCE((header.version == 1U) || world->peers[place].has_spoken_2 ||
                 (strcmp(header.type, "RTS_COMMAND") == 0),
             "version 2 is for those who speak it");
    SENTENCE((message.kind == IGTL_KIND_TRANSFORM) || (message.kind == IGTL_KIND_STRING) ||
                 (message.kind == IGTL_KIND_STATUS) || (message.kind == IGTL_KIND_POINT) ||
                 peer->has_asked,
             "other types are for those who asked");
    if (message.kind == IGTL_KIND_TRANSFORM) {
        judge_transform(world, place, &message);
    } else if (message.kind == IGTL_KIND_STRING) {
        judge_string(place, &message);
    } else if (strcmp(header.type, "TDATA") == 0) {
        judge_tracking(world, place, &message);
    } else {
        peer->statuses += (message.kind == IGTL_KIND_STATUS) ? 1U : 0U;
    }
    if ((place == oracle.speaker) && message_acknowledges(&message, oracle.said)) {
        peer->is_acknowledged = true;
    } else {
        peer->answers++;
    }
}

static void take_messages(world_t *world, uint32_t place)
{
    igtl_outbox_t *outbox = &world->peers[place].outbox;
    uint32_t length;

    SENTENCE(!outbox->has_overflowed || oracle.peers[place].has_hung,
             "nobody who reads is dropped for it");
    for (const uint8_t *bytes = igtl_outbox_next(outbox, &length); bytes != NULL;
         bytes = igtl_outbox_next(outbox, &length)) {
        judge(world, place, bytes, length);
        igtl_outbox_advance(outbox, length);
    }
    oracle.peers[place].has_hung = false;
    oracle.peers[place].was_pose_known = false;
    oracle.peers[place].was_homed = false;
}

static bool reads(const world_t *world, uint32_t place)
{
    return (place < WORLD_PEERS) && world->peers[place].is_connected &&
           !world->peers[place].is_hung;
}

/* Said before on this connection, or forgotten whether. */
static bool is_repeated(peer_t *peer, const igtl_message_t *message)
{
    const uint64_t name =
        igtl_crc64(1U, (const uint8_t *)message->name, strlen(message->name) + 1U);
    const uint64_t sum = igtl_crc64(name, (const uint8_t *)message->text, message->text_bytes);

    for (uint32_t i = 0U; (i < SEEN) && (i < peer->seen_count); i++) {
        if (peer->seen[i] == sum) {
            return true;
        }
    }
    peer->seen[peer->seen_count % SEEN] = sum;
    peer->seen_count++;
    return peer->seen_count > SEEN;
}

/* Messages that are passed on at once. */
static void judge_stops(const world_t *world, const igtl_message_t *said)
{
    if (message_is_command(said) && message_says(said, "STOP")) {
        SENTENCE(request_is_queued(world, WORKPHASE_STOP), "STOP is passed on");
        oracle.is_stop_owed = true;
    }
    if (message_is_command(said) && message_says(said, "EMERGENCY")) {
        SENTENCE(request_is_queued(world, WORKPHASE_EMERGENCY), "EMERGENCY is passed on");
        oracle.is_emergency_owed = true;
    }
}

static void judge_speech(world_t *world)
{
    const uint32_t place = oracle.speaker;
    const igtl_message_t *said = oracle.said;
    peer_t *peer = &oracle.peers[place];

    if (world->peers[place].language == IGTL_LANGUAGE_CRTK) {
        return;
    }
    const bool is_old = message_is_command(said) && is_repeated(peer, said);

    judge_stops(world, said);
    if (!reads(world, place)) {
        return;
    }
    SENTENCE(peer->is_acknowledged ||
                 (!message_is_command(said) && (message_id_prefix(said) == 0U)),
             "what is said with an id is acknowledged");
    SENTENCE(is_old || (peer->answers > 0U) || (said->kind == IGTL_KIND_STATUS) ||
                 request_waits(world, place) ||
                 (message_is_tip(said) && world->workphase.peers[place].tip.is_waiting),
             "whatever is said is answered, or waits for control");
}

/* A waiting peer is informed when it need not wait any more; for the rows of an array once. */
static void judge_requests(const world_t *world)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *was = &oracle.before.requests[i];
        const bool waited = (was->id != 0U) && !was->is_accepted && !was->is_overdue;

        if (!waited || !reads(world, was->peer)) {
            continue;
        }
        const igtl_request_t *is = request_find(&world->workphase.requests, was->id);
        const bool waits = (is != NULL) && !is->is_accepted && !is->is_overdue;

        SENTENCE(waits || (oracle.peers[was->peer].statuses > 0U) ||
                     (was->command.kind == (uint32_t)COMMAND_NEEDLE) ||
                     workphase_array_has(&world->workphase.array, was) ||
                     (request_is_urgent(was) && request_has_newer(world, was)) ||
                     request_goes_on_draping(world, was),
                 "a client that waits for an answer is informed");
    }
}

static bool is_of_planner(const command_t *command)
{
    return (command->id % 2U) != 0U;
}

/* Place of the connected peer `number`, or NOWHERE. */
static uint32_t place_of(const world_t *world, uint32_t number)
{
    for (uint32_t i = 0U; i < WORLD_PEERS; i++) {
        if (world->peers[i].is_connected && (world->peers[i].number == number)) {
            return i;
        }
    }
    return NOWHERE;
}

/* While another connection commands, who does not stops at most. */
static bool may_pass(const world_t *world, uint32_t place, const command_t *command)
{
    const uint32_t commander = commander_of(world);

    return command_kinds_is_stop(command) || (commander == NOWHERE) || (commander == place);
}

/* A proposal that has waited goes on while its sender says something else. */
static bool is_said_now(const command_t *command)
{
    return !is_of_planner(command) ||
           (strcmp(transform_proposals_name(command), oracle.said->name) == 0);
}

static void judge_command(const world_t *world, const command_t *command)
{
    const uint32_t place = place_of(world, command->peer);

    if (command->kind == (uint32_t)COMMAND_RELEASE) {
        SENTENCE(place == NOWHERE, "nobody who is there loses what he has");
        return;
    }

    SENTENCE((place != NOWHERE) &&
                 ((place == oracle.speaker) || (command->kind == (uint32_t)COMMAND_NEEDLE) ||
                  request_is_of_array(world, place, command) ||
                  request_is_draping(world, request_find(&world->workphase.requests, command->id))),
             "a command is its speaker's");
    SENTENCE((command->kind < (uint32_t)COMMAND_HOME_AXIS) ||
                 (command->kind > (uint32_t)COMMAND_SET_HOME),
             "what is for a single axis does not come by the network of navigation");
    SENTENCE(is_of_planner(command) || may_pass(world, place, command),
             "while another one commands a stop passes at most");
    if ((place == oracle.speaker) && is_said_now(command)) {
        message_judge_pose(oracle.said, commands_pose(command));
    }
}

static void judge_queue(const world_t *world, const igtl_requests_t *requests, uint32_t first_id)
{
    for (uint32_t i = 0U; i < requests->queued; i++) {
        if ((int32_t)(requests->queue[i].id - first_id) >= 0) {
            judge_command(world, &requests->queue[i]);
        }
    }
}

static void judge_commander(const world_t *world)
{
    const uint32_t now = commander_of(world);

    if (now != oracle.commander) {
        SENTENCE((now == NOWHERE) || (oracle.commander == NOWHERE),
                 "command is not taken from who has it");
        oracle.commander = now;
    }
}

void dialect_oracle_after(world_t *world)
{
    for (uint32_t i = 0U; i < WORLD_PEERS; i++) {
        if (reads(world, i)) {
            take_messages(world, i);
        }
        SENTENCE(world->peers[i].is_connected || (world->peers[i].outbox.count == WORLD_NOTHING),
                 "nothing is said to who has gone");
    }
    judge_commander(world);
    judge_queue(world, &world->workphase.requests, oracle.before.next_id);
    if (oracle.speaker != NOWHERE) {
        judge_queue(world, &world->transform.requests, oracle.next_proposal);
    }
    judge_requests(world);
    if (oracle.speaker != NOWHERE) {
        judge_speech(world);
    }
    SENTENCE(!oracle.is_stop_owed || request_is_queued(world, WORKPHASE_STOP), "STOP is not lost");
    SENTENCE(!oracle.is_emergency_owed || request_is_queued(world, WORKPHASE_EMERGENCY),
             "EMERGENCY is not lost");
}

static bool is_proposal(uint32_t kind)
{
    return (kind < COMMAND_KIND_COUNT) && (((COMMAND_KINDS_PROPOSING >> kind) & 1U) != 0U);
}

/* A planner that floods costs the controller no more than this. */
static void judge_rate(const world_t *world, const command_t *command)
{
    for (uint32_t i = 0U; i < WORLD_PEERS; i++) {
        peer_t *peer = &oracle.peers[i];

        if (!world->peers[i].is_connected || (world->peers[i].number != command->peer)) {
            continue;
        }
        uint64_t *slot = &peer->passed_us[peer->passed_count % PROPOSALS];

        SENTENCE((peer->passed_count < PROPOSALS) ||
                     ((world->moment.now_us - *slot) >= (SECOND_US - JITTER_US)),
                 "a planner proposes no faster than it may");
        *slot = world->moment.now_us;
        peer->passed_count++;
    }
}

void dialect_oracle_passed(const world_t *world, const command_t *command)
{
    SENTENCE(message_is_in_range(commands_pose(command)),
             "a number out of its range is not passed on");
    SENTENCE(command->source == (uint32_t)COMMAND_SOURCE_IGTL, "a command says where it is from");
    if (is_of_planner(command)) {
        SENTENCE(is_proposal(command->kind) || ((command->kind == (uint32_t)COMMAND_WITHDRAW) &&
                                                is_proposal(command->as.withdrawal.of)),
                 "a planner proposes and does nothing else");
        judge_rate(world, command);
    }
    const workphase_t asked = command_kinds_workphase(command);
    oracle.is_stop_owed = oracle.is_stop_owed && (asked != WORKPHASE_STOP);
    oracle.is_emergency_owed = oracle.is_emergency_owed && (asked != WORKPHASE_EMERGENCY);
}

void dialect_oracle_stepped(world_t *world)
{
    SENTENCE(!authority_is_held_by_lost(world) || request_is_releasing(world),
             "what a connection had that was lost is released");
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &world->workphase.requests.requests[i];
        const uint64_t age_us = world->moment.answer_clock_us - request->sent_us;

        if ((request->id != 0U) && !request->is_accepted && !request->is_overdue) {
            SENTENCE(age_us < (IGTL_ANSWER_TIMEOUT_US + WORLD_TURN_US), "nobody waits for ever");
        }
    }
}

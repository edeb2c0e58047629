/* SPDX-License-Identifier: Apache-2.0 */
#include "fuzz/dialect_oracle.h"

#include "igtl/dialect/igtl_units.h"
#include "igtl/dialect/transform_proposals.h"
#include "igtl/workphase/workphase_commands.h"
#include "fuzz/sentence.h"
#include "limits/requirement_limits.h"
#include "igtl/wire/igtl_crc64.h"
#include "procedure/command_kinds.h"
#include "unit/support/commands.h"

#include <math.h>
#include <string.h>

#define NOWHERE UINT32_MAX
#define ONE_Q30 1073741824.0
#define NM_PER_MM 1e6
#define NM_MAX 2000000000.5
#define SEEN 64U
#define PREFIX 4U
#define TRACKED_BYTES 70U   /* Size of an element of a TDATA, */
#define TRACKED_NUMBERS 22U /* and where its numbers begin. */
#define SECOND_US UINT64_C(1000000)
#define JITTER_US UINT64_C(5000)
/* Proposals of a planner in the second after a pause. */
#define PROPOSALS ((LIMIT_IGTL_PROPOSAL_BURST - 1U) + (SECOND_US / LIMIT_IGTL_PROPOSAL_INTERVAL_US))
#define ENTRY_MAX_Q30 INT32_C(1074815565) /* 1 + 1e-3. */

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

static bool begins(const char *name, const char *prefix)
{
    return strncmp(name, prefix, strlen(prefix)) == 0;
}

static bool is_command(const igtl_message_t *message)
{
    return (message->kind == IGTL_KIND_STRING) && begins(message->name, "CMD_");
}

/* How long what stands before the id of a pose is, 0 for one without. */
static uint32_t prefix_of(const igtl_message_t *message)
{
    static const char *const prefixes[] = {"CLB_", "TGT_", "NPOS_", "ENTRY_"};

    for (uint32_t i = 0U; i < (sizeof prefixes / sizeof prefixes[0]); i++) {
        if ((message->kind == IGTL_KIND_TRANSFORM) && begins(message->name, prefixes[i])) {
            return (uint32_t)strlen(prefixes[i]);
        }
    }
    return 0U;
}

static bool is_tip(const igtl_message_t *message)
{
    return (message->kind == IGTL_KIND_TRANSFORM) && begins(message->name, "NPOS_");
}

/* The echo of what was just said. */
static bool acknowledges(const igtl_message_t *message, const igtl_message_t *said)
{
    if (!begins(message->name, "ACK_") || (said == NULL) || (message->kind != said->kind)) {
        return false;
    }
    const uint32_t prefix = is_command(said) ? PREFIX : prefix_of(said);

    if ((prefix == 0U) || (strcmp(&message->name[PREFIX], &said->name[prefix]) != 0)) {
        return false;
    }
    if (message->kind == IGTL_KIND_TRANSFORM) {
        return memcmp(message->numbers, said->numbers, sizeof message->numbers) == 0;
    }
    const uint32_t length = (said->text_bytes < IGTL_TEXT_MAX) ? said->text_bytes : IGTL_TEXT_MAX;

    return (message->text_bytes == length) && (memcmp(message->text, said->text, length) == 0);
}

static bool is_named(const igtl_message_t *message, const char *name)
{
    return strcmp(message->name, name) == 0;
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
        is_named(message, "CURRENT_POSITION") || is_named(message, "measured_cp");
    uint32_t numbers[IGTL_TRANSFORM_NUMBERS];

    if (begins(message->name, "ACK_")) {
        return; /* It echoes anything. */
    }
    for (uint32_t i = 0U; i < IGTL_TRANSFORM_NUMBERS; i++) {
        SENTENCE(((message->numbers[i] >> 23U) & 0xFFU) != 0xFFU, "what is reported is finite");
    }
    if (is_measured || is_named(message, "desired_cp")) {
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
    if (is_named(message, "measured_jp") || is_named(message, "measured_jv")) {
        SENTENCE(oracle.peers[place].was_homed, "no joint is reported that is not known");
    }
    if (is_named(message, "IS_IN_TARGETING_POS") || is_named(message, "HAS_REACHED_TARGET")) {
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
    if ((place == oracle.speaker) && acknowledges(&message, oracle.said)) {
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

static bool is_queued(const world_t *world, workphase_t phase)
{
    const igtl_requests_t *requests = &world->workphase.requests;

    for (uint32_t i = 0U; i < requests->queued; i++) {
        if (command_kinds_workphase(&requests->queue[i]) == phase) {
            return true;
        }
    }
    return false;
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

static bool has_request(const world_t *world, uint32_t place)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &world->workphase.requests.requests[i];

        if ((request->id != 0U) && (request->peer == place) && !request->is_accepted &&
            !request->is_overdue) {
            return true;
        }
    }
    return false;
}

static bool says(const igtl_message_t *message, const char *text)
{
    return (message->text_bytes == strlen(text)) &&
           (memcmp(message->text, text, message->text_bytes) == 0);
}

/* Messages that are passed on at once. */
static void judge_stops(const world_t *world, const igtl_message_t *said)
{
    if (is_command(said) && says(said, "STOP")) {
        SENTENCE(is_queued(world, WORKPHASE_STOP), "STOP is passed on");
        oracle.is_stop_owed = true;
    }
    if (is_command(said) && says(said, "EMERGENCY")) {
        SENTENCE(is_queued(world, WORKPHASE_EMERGENCY), "EMERGENCY is passed on");
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
    const bool is_old = is_command(said) && is_repeated(peer, said);

    judge_stops(world, said);
    if (!reads(world, place)) {
        return;
    }
    SENTENCE(peer->is_acknowledged || (!is_command(said) && (prefix_of(said) == 0U)),
             "what is said with an id is acknowledged");
    SENTENCE(is_old || (peer->answers > 0U) || (said->kind == IGTL_KIND_STATUS) ||
                 has_request(world, place) ||
                 (is_tip(said) && world->workphase.peers[place].tip.is_waiting),
             "whatever is said is answered, or waits for control");
}

static const igtl_request_t *request_of(const igtl_requests_t *requests, uint32_t id)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        if (requests->requests[i].id == id) {
            return &requests->requests[i];
        }
    }
    return NULL;
}

static bool is_urgent(const igtl_request_t *request)
{
    return command_kinds_is_stop(&request->command);
}

/* One answer serves several stops of one peer. */
static bool has_newer(const world_t *world, const igtl_request_t *request)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *other = &world->workphase.requests.requests[i];

        if ((other->id != 0U) && (other->id != request->id) && (other->peer == request->peer) &&
            (memcmp(&other->command.as, &request->command.as, sizeof other->command.as) == 0) &&
            (other->command.kind == request->command.kind)) {
            return true;
        }
    }
    return false;
}

/* By its word DRAPING. */
static bool is_draping(const world_t *world, const igtl_request_t *pose)
{
    const char *motion = (pose == NULL) ? NULL : world->workphase.peers[pose->peer].motion;

    return (motion != NULL) && (strcmp(motion, WORKPHASE_COMMAND_DRAPING) == 0) &&
           (pose->command.kind == (uint32_t)COMMAND_POSE) &&
           (pose->command.as.pose_name.pose == (uint32_t)POSE_DRAPING);
}

/* MANUAL was entered for DRAPING, of which only the answer to its pose is sent. */
static bool goes_on_draping(const world_t *world, const igtl_request_t *was)
{
    const workphase_peer_t *peer = &world->workphase.peers[was->peer];

    return (command_kinds_workphase(&was->command) == WORKPHASE_MANUAL) &&
           is_draping(world, request_of(&world->workphase.requests, peer->pending));
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
        const igtl_request_t *is = request_of(&world->workphase.requests, was->id);
        const bool waits = (is != NULL) && !is->is_accepted && !is->is_overdue;

        SENTENCE(waits || (oracle.peers[was->peer].statuses > 0U) ||
                     (was->command.kind == (uint32_t)COMMAND_NEEDLE) ||
                     workphase_array_has(&world->workphase.array, was) ||
                     (is_urgent(was) && has_newer(world, was)) || goes_on_draping(world, was),
                 "a client that waits for an answer is informed");
    }
}

static bool is_of_planner(const command_t *command)
{
    return (command->id % 2U) != 0U;
}

static double number_of(uint32_t bits)
{
    float number;

    (void)memcpy(&number, &bits, sizeof number);
    return (double)number;
}

static void judge_number(uint32_t bits, double unit, double most, int32_t taken)
{
    const double meant = number_of(bits) * unit;

    SENTENCE(isfinite(meant) && (fabs(meant) <= most), "a number out of its range is refused");
    SENTENCE(fabs(meant - (double)taken) <= 1.0, "a number is taken as it was meant");
}

/* Said once more in floating point. */
static void judge_pose(const igtl_message_t *said, const rigid_t *pose)
{
    if (said->kind != IGTL_KIND_TRANSFORM) {
        return;
    }
    for (uint32_t i = 0U; i < 9U; i++) {
        judge_number(said->numbers[i], ONE_Q30, ONE_Q30 * 1.0011,
                     pose->rotation_q30[i % 3U][i / 3U]);
    }
    judge_number(said->numbers[9], NM_PER_MM, NM_MAX, pose->translation.x_nm);
    judge_number(said->numbers[10], NM_PER_MM, NM_MAX, pose->translation.y_nm);
    judge_number(said->numbers[11], NM_PER_MM, NM_MAX, pose->translation.z_nm);
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

/* A row of an array goes on when the one before was taken. */
static bool is_of_array(const world_t *world, uint32_t place, const command_t *command)
{
    const igtl_request_t request = {.id = command->id, .peer = place, .command = *command};

    return workphase_array_has(&world->workphase.array, &request);
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
                  is_of_array(world, place, command) ||
                  is_draping(world, request_of(&world->workphase.requests, command->id))),
             "a command is its speaker's");
    SENTENCE((command->kind < (uint32_t)COMMAND_HOME_AXIS) ||
                 (command->kind > (uint32_t)COMMAND_SET_HOME),
             "what is for a single axis does not come by the network of navigation");
    SENTENCE(is_of_planner(command) || may_pass(world, place, command),
             "while another one commands a stop passes at most");
    if ((place == oracle.speaker) && is_said_now(command)) {
        judge_pose(oracle.said, commands_pose(command));
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
    SENTENCE(!oracle.is_stop_owed || is_queued(world, WORKPHASE_STOP), "STOP is not lost");
    SENTENCE(!oracle.is_emergency_owed || is_queued(world, WORKPHASE_EMERGENCY),
             "EMERGENCY is not lost");
}

static bool is_in_range(const rigid_t *pose)
{
    for (uint32_t i = 0U; i < 9U; i++) {
        const int32_t entry = pose->rotation_q30[i / 3U][i % 3U];

        if ((entry > ENTRY_MAX_Q30) || (entry < -ENTRY_MAX_Q30)) {
            return false;
        }
    }
    return (pose->translation.x_nm <= IGTL_UNITS_MAX_NM) &&
           (pose->translation.x_nm >= -IGTL_UNITS_MAX_NM) &&
           (pose->translation.y_nm <= IGTL_UNITS_MAX_NM) &&
           (pose->translation.y_nm >= -IGTL_UNITS_MAX_NM) &&
           (pose->translation.z_nm <= IGTL_UNITS_MAX_NM) &&
           (pose->translation.z_nm >= -IGTL_UNITS_MAX_NM);
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
    SENTENCE(is_in_range(commands_pose(command)), "a number out of its range is not passed on");
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

/* A connection has authority that is not there any more. */
static bool is_held_by_lost(const world_t *world)
{
    const snapshot_t *shown = world->moment.snapshot;
    bool is_there = (shown == NULL) || (shown->holder_peer == 0U) ||
                    (shown->holder != (uint32_t)COMMAND_SOURCE_IGTL);

    for (uint32_t i = 0U; i < WORLD_PEERS; i++) {
        is_there = is_there ||
                   (world->peers[i].is_connected && (world->peers[i].number == shown->holder_peer));
    }
    return !is_there;
}

static bool is_releasing(const world_t *world)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &world->workphase.requests.requests[i];

        if ((request->id != 0U) && (request->command.kind == (uint32_t)COMMAND_RELEASE)) {
            return true;
        }
    }
    return false;
}

void dialect_oracle_stepped(world_t *world)
{
    SENTENCE(!is_held_by_lost(world) || is_releasing(world),
             "what a connection had that was lost is released");
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &world->workphase.requests.requests[i];
        const uint64_t age_us = world->moment.answer_clock_us - request->sent_us;

        if ((request->id != 0U) && !request->is_accepted && !request->is_overdue) {
            SENTENCE(age_us < (IGTL_ANSWER_TIMEOUT_US + WORLD_TURN_US), "nobody waits for ever");
        }
    }
}

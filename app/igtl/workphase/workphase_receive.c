/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/workphase/workphase_receive.h"

#include "igtl/dialect/igtl_units.h"
#include "igtl/workphase/workphase_draping.h"
#include "igtl/lists/workphase_lists.h"
#include "igtl/workphase/workphase_needle.h"
#include "igtl/workphase/workphase_peer.h"
#include "igtl/workphase/workphase_queries.h"
#include "igtl/workphase/workphase_commands.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"

#include <stddef.h>
#include <string.h>

/* A command by a pose; `result` is the name of what it is answered by. */
typedef struct {
    const char *prefix;
    const char *result;
    command_kind_t kind;
} pose_command_t;

static const pose_command_t pose_commands[] = {
    {"CLB_", "CALIBRATION", COMMAND_REGISTRATION},
    {"TGT_", "TARGET", COMMAND_TARGET},
    {"NPOS_", NULL, COMMAND_NEEDLE},
};

static const char *subject_of(const workphase_peer_t *peer, const pose_command_t *what)
{
    return (what->kind == COMMAND_NEEDLE) ? workphase_peer_tip_subject(peer) : what->result;
}

static bool is_others(const workphase_dialect_t *self, uint32_t peer)
{
    return (self->controller != IGTL_NOBODY) && (self->controller != peer);
}

/* The workphase named by a text, WORKPHASE_UNDEFINED for none that can be commanded. */
static workphase_t phase_of(const igtl_message_t *message)
{
    for (uint32_t i = (uint32_t)WORKPHASE_START_UP; i < WORKPHASE_COUNT; i++) {
        if (igtl_is_text(message, workphase_name((int32_t)i))) {
            return (workphase_t)i;
        }
    }
    return WORKPHASE_UNDEFINED;
}

/* Lists of forbidden workphases name it; how it is entered and answered is published nowhere. */
static const struct {
    const char *name;
    igtl_status_t refusal;
} ablation = {"ABLATION",
              {IGTL_STATUS_UNKNOWN_INSTRUCTION, "UNKNOWN_COMMAND",
               "UNKNOWN_COMMAND: No published list of workphases has ABLATION; send a treatment "
               "program and PROGRAM RUN."}};

static void refuse_text(workphase_peer_t *peer, const igtl_message_t *message,
                        const igtl_moment_t *moment)
{
    char name[IGTL_NAME_SIZE] = "";
    const uint32_t length =
        (message->text_bytes < (IGTL_NAME_SIZE - 1U)) ? message->text_bytes : (IGTL_NAME_SIZE - 1U);

    (void)memcpy(name, message->text, length);
    if (strcmp(name, ablation.name) == 0) {
        igtl_send_refused(peer->outbox, name, &ablation.refusal, moment);
        return;
    }
    igtl_send_refusal(peer->outbox, (length > 0U) ? name : message->name, STATUS_UNKNOWN_COMMAND,
                      moment);
}

/* Passes on what may end an order. 0 when too many are on their way. */
static uint32_t request(workphase_dialect_t *self, uint32_t index, command_t *command,
                        const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[index];
    const igtl_request_t *entry =
        igtl_requests_add(&self->requests, index, command, moment->answer_clock_us);

    peer->tip.is_waiting = false;
    if (entry == NULL) {
        return 0U;
    }
    peer->pending = entry->id;
    return entry->id;
}

/* Announces a workphase that is not entered, as if the controller had refused it. */
static void announce(workphase_peer_t *peer, workphase_t phase, const igtl_moment_t *moment)
{
    workphase_peer_send_phase(peer, IGTL_STATUS_OK, (uint32_t)phase, "", moment);
}

/* `id` is what was remembered of it, NULL for nothing. */
static void request_phase(workphase_dialect_t *self, uint32_t index, workphase_t phase,
                          workphase_id_t *id, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[index];
    command_t command = {.peer = peer->number,
                         .kind = (uint32_t)COMMAND_WORKPHASE,
                         .as.workphase = {.workphase = (uint32_t)phase}};
    const uint32_t number = request(self, index, &command, moment);

    if (id != NULL) {
        id->request = number;
        id->name[0] = (number == 0U) ? '\0' : id->name[0];
    }
    if (number == 0U) {
        announce(peer, phase, moment);
        igtl_send_refusal(peer->outbox, workphase_name((int32_t)phase), STATUS_BUSY, moment);
    }
}

static void receive_phase(workphase_dialect_t *self, uint32_t index, workphase_t phase,
                          workphase_id_t *id, const igtl_moment_t *moment)
{
    const bool is_everyones = id == NULL;

    if (is_everyones || !is_others(self, index)) {
        request_phase(self, index, phase, id, moment);
    } else {
        announce(&self->peers[index], phase, moment);
        igtl_send_refusal(self->peers[index].outbox, workphase_name((int32_t)phase),
                          STATUS_NO_AUTHORITY, moment);
    }
}

/* A motion, which may end an order, is awaited. */
static bool pass_word(workphase_dialect_t *self, uint32_t index, const char *word,
                      command_t *command, const igtl_moment_t *moment)
{
    if (workphase_peer_is_motion(command->kind)) {
        self->peers[index].motion = word;
        return request(self, index, command, moment) != 0U;
    }
    return igtl_requests_add(&self->requests, index, command, moment->answer_clock_us) != NULL;
}

/* A text that is no list of lengths by name may be the earlier list without names. */
static void refuse_word(const workphase_dialect_t *self, workphase_peer_t *peer,
                        const workphase_command_t *word, status_t status,
                        const igtl_moment_t *moment)
{
    char text[IGTL_REASON_SIZE];
    const bool is_form = (word->kind == COMMAND_PROBE) &&
                         ((status == STATUS_PROBE_LENGTH) || (status == STATUS_OUT_OF_RANGE));

    if (is_form) {
        workphase_commands_send_form(self->robot, status, text);
        const igtl_status_t refusal = {igtl_reason_code(status), status_name((int32_t)status),
                                       text};
        igtl_send_refused(peer->outbox, word->word, &refusal, moment);
    } else if ((status == STATUS_WRONG_UNIT) && (word->form != NULL)) {
        workphase_peer_send_unit(peer, word->word, word->form, moment);
    } else {
        igtl_send_refusal(peer->outbox, word->word, status, moment);
    }
}

static void receive_word(workphase_dialect_t *self, uint32_t index, const workphase_command_t *word,
                         const igtl_message_t *message, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[index];
    command_t command = {.peer = peer->number};
    status_t status = is_others(self, index)
                          ? STATUS_NO_AUTHORITY
                          : workphase_commands_read(word, self->robot, message, &command);

    if ((status == STATUS_OK) && workphase_draping_is_ahead(word, moment)) {
        status = workphase_draping_begin(self, index, moment);
    } else if ((status == STATUS_OK) && !pass_word(self, index, word->word, &command, moment)) {
        status = STATUS_BUSY;
    } else {
        /* It is on its way, or refused. */
    }
    if (status != STATUS_OK) {
        refuse_word(self, peer, word, status, moment);
    }
}

/* A row is longer than a word's text, and what was sent of a list is remembered. */
static void receive_list(workphase_dialect_t *self, uint32_t index, const workphase_list_t *list,
                         const igtl_message_t *message, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[index];
    uint32_t sum = peer->sums[list->number];
    command_t command = {.peer = peer->number};
    status_t status = is_others(self, index)
                          ? STATUS_NO_AUTHORITY
                          : workphase_lists_read(list, self->robot, message, &sum, &command);

    if (status != STATUS_OK) {
        /* It is none, or another's. */
    } else if (self->array.is_busy && (self->array.peer == index)) {
        status = STATUS_BUSY; /* Items of two lists would be mixed. */
    } else if (pass_word(self, index, list->word, &command, moment)) {
        peer->sums[list->number] = sum;
        peer->steps_reported = (command.kind == (uint32_t)list->run) ? 0U : peer->steps_reported;
    } else {
        status = STATUS_BUSY;
    }
    if (status == STATUS_WRONG_UNIT) {
        workphase_peer_send_unit(peer, list->word, list->form(self->robot), moment);
    } else if (status != STATUS_OK) {
        igtl_send_refusal(peer->outbox, list->word, status, moment);
    } else {
        /* It is on its way. */
    }
}

/* Its begin goes on at once, or the array is refused. */
static status_t begin_array(workphase_dialect_t *self, uint32_t index, const workphase_list_t *list,
                            const igtl_message_t *message, const igtl_moment_t *moment)
{
    workphase_array_t *array = &self->array;
    const status_t status = workphase_array_is_awaited(&self->requests, index)
                                ? STATUS_BUSY
                                : workphase_array_take(array, list, self->robot, index, message);

    if (status != STATUS_OK) {
        return status;
    }
    workphase_array_step(array, &self->requests, self->peers[index].number,
                         moment->answer_clock_us);
    if (array->next == 0U) {
        workphase_array_end(array, index);
        return STATUS_BUSY;
    }
    return STATUS_OK;
}

void workphase_receive_array(workphase_dialect_t *self, uint32_t index,
                             const igtl_message_t *message, const igtl_moment_t *moment)
{
    const workphase_list_t *list = workphase_lists_named(message->name);
    status_t status = STATUS_UNKNOWN_COMMAND;

    if (list != NULL) {
        status = is_others(self, index) ? STATUS_NO_AUTHORITY
                                        : begin_array(self, index, list, message, moment);
    }
    if (status != STATUS_OK) {
        igtl_send_refusal(self->peers[index].outbox, message->name, status, moment);
    }
}

/* A message that is no workphase: false when it has no meaning. */
static bool receive_other(workphase_dialect_t *self, uint32_t index, const igtl_message_t *message,
                          const igtl_moment_t *moment)
{
    const workphase_command_t *word = workphase_commands_find(message);
    const workphase_list_t *list = workphase_lists_find(message);

    if (word != NULL) {
        receive_word(self, index, word, message, moment);
        return true;
    }
    if (list != NULL) {
        receive_list(self, index, list, message, moment);
        return true;
    }
    return workphase_queries_string(&self->peers[index], message, moment);
}

static bool is_command(const igtl_message_t *message)
{
    return (message->kind == IGTL_KIND_STRING) && (strncmp(message->name, "CMD_", 4U) == 0);
}

static bool is_urgent_phase(workphase_t phase)
{
    return (phase == WORKPHASE_STOP) || (phase == WORKPHASE_EMERGENCY);
}

bool workphase_receive_is_stop(const igtl_message_t *message)
{
    return is_command(message) && is_urgent_phase(phase_of(message));
}

static void receive_command(workphase_dialect_t *self, uint32_t index,
                            const igtl_message_t *message, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[index];
    const workphase_t phase = phase_of(message);
    const bool is_urgent = is_urgent_phase(phase);
    workphase_id_t *id = NULL;

    workphase_peer_acknowledge_string(peer, message, moment);
    if (!is_urgent) {
        if (workphase_peer_is_repeated(peer, message)) {
            return;
        }
        id = workphase_peer_remember(peer, message);
    }
    if (phase != WORKPHASE_UNDEFINED) {
        workphase_peer_cancel_deferred(peer);
        receive_phase(self, index, phase, id, moment);
    } else if (!receive_other(self, index, message, moment)) {
        workphase_peer_cancel_deferred(peer);
        refuse_text(peer, message, moment);
    } else {
        /* It was a question, or one of the words. */
    }
}

void workphase_receive_string(workphase_dialect_t *self, uint32_t index,
                              const igtl_message_t *message, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[index];

    if (is_command(message)) {
        receive_command(self, index, message, moment);
        return;
    }
    workphase_peer_send_deferred(peer, moment->now_us, true);
    if (strcmp(message->name, "NEEDLE_LENGTH") == 0) {
        workphase_needle_send_length(peer, self->robot, message, moment);
    } else if (!receive_other(self, index, message, moment)) {
        igtl_send_refusal(peer->outbox, message->name, STATUS_UNKNOWN_COMMAND, moment);
    } else {
        /* It is answered, or will be. */
    }
}

/* The newest waits for its turn. */
static void receive_tip(workphase_peer_t *peer, const rigid_t *pose)
{
    peer->tip.is_waiting = true;
    peer->tip.pose = *pose;
}

static status_t pass_pose(workphase_dialect_t *self, uint32_t index, const pose_command_t *what,
                          const igtl_message_t *message, const igtl_moment_t *moment)
{
    command_t command = {.peer = self->peers[index].number, .kind = (uint32_t)what->kind};
    rigid_t pose;
    status_t status = igtl_units_read_pose(message->numbers, &pose);

    if (status == STATUS_OK) {
        if (what->kind == COMMAND_REGISTRATION) {
            command.as.registration.pose = pose;
        } else {
            command.as.pose.pose = pose;
        }
        if (what->kind == COMMAND_NEEDLE) {
            receive_tip(&self->peers[index], &pose);
        } else if (igtl_requests_add(&self->requests, index, &command, moment->answer_clock_us) ==
                   NULL) {
            status = STATUS_BUSY;
        } else {
            /* It is on its way. */
        }
    }
    return status;
}

static void receive_pose(workphase_dialect_t *self, uint32_t index, const pose_command_t *what,
                         const igtl_message_t *message, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[index];
    status_t status;

    workphase_peer_cancel_deferred(peer);
    workphase_peer_acknowledge_transform(peer, message, (uint32_t)strlen(what->prefix), moment);
    if (is_others(self, index)) {
        igtl_send_refusal(peer->outbox, subject_of(peer, what), STATUS_NO_AUTHORITY, moment);
        return;
    }
    status = pass_pose(self, index, what, message, moment);
    if (status != STATUS_OK) {
        igtl_send_refusal(peer->outbox, subject_of(peer, what), status, moment);
    }
}

void workphase_receive_transform(workphase_dialect_t *self, uint32_t index,
                                 const igtl_message_t *message, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[index];
    const pose_command_t entry = {peer->entry_prefix, "ENTRY", COMMAND_ENTRY};

    for (size_t i = 0U; i < (sizeof pose_commands / sizeof pose_commands[0]); i++) {
        if (strncmp(message->name, pose_commands[i].prefix, strlen(pose_commands[i].prefix)) == 0) {
            receive_pose(self, index, &pose_commands[i], message, moment);
            return;
        }
    }
    if ((entry.prefix[0] != '\0') &&
        (strncmp(message->name, entry.prefix, strlen(entry.prefix)) == 0)) {
        receive_pose(self, index, &entry, message, moment);
    } else {
        igtl_send_refusal(peer->outbox, message->name, STATUS_UNKNOWN_COMMAND, moment);
    }
}

void workphase_receive_go_on(workphase_dialect_t *self, const igtl_moment_t *moment)
{
    workphase_array_t *array = &self->array;
    workphase_peer_t *peer = &self->peers[array->peer];

    if (array->is_busy && is_others(self, array->peer) && workphase_array_fail(array)) {
        igtl_send_refusal(peer->outbox, array->list->word, STATUS_NO_AUTHORITY, moment);
    }
    workphase_array_step(array, &self->requests, peer->number, moment->answer_clock_us);
    if (array->is_owed && !array->is_busy && (peer->outbox != NULL)) {
        igtl_outbox_add(peer->outbox, &array->refusal);
    }
    array->is_owed = array->is_owed && array->is_busy;
}

/* The tips of all peers; while none commands each may send them. */
static bool are_tips_enough(const workphase_dialect_t *self)
{
    uint32_t count = 0U;

    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &self->requests.requests[i];

        count +=
            ((request->id != 0U) && (request->command.kind == (uint32_t)COMMAND_NEEDLE)) ? 1U : 0U;
    }
    return count >= LIMIT_IGTL_TIPS_AT_A_TIME;
}

static void pass_tip(workphase_dialect_t *self, uint32_t index, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[index];
    const bool is_noted = moment->now_us >= peer->tip.next_note_us;
    command_t command = {
        .peer = peer->number,
        .kind = (uint32_t)COMMAND_NEEDLE,
        .as.seen_pose = {.pose = peer->tip.pose, .is_one_of_many = is_noted ? 0U : 1U}};

    if (igtl_requests_add(&self->requests, index, &command, moment->answer_clock_us) == NULL) {
        return;
    }
    peer->tip.is_waiting = false;
    peer->tip.next_us = moment->now_us + LIMIT_IGTL_TIP_INTERVAL_US;
    if (is_noted) {
        peer->tip.next_note_us = moment->now_us + LIMIT_IGTL_TIP_NOTE_US;
    }
}

void workphase_receive_step(workphase_dialect_t *self, uint32_t index, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[index];

    if (!peer->tip.is_waiting || (moment->now_us < peer->tip.next_us)) {
        return;
    }
    if (is_others(self, index)) { /* Since it came. */
        peer->tip.is_waiting = false;
        igtl_send_refusal(peer->outbox, workphase_peer_tip_subject(peer), STATUS_NO_AUTHORITY,
                          moment);
        return;
    }
    if (!are_tips_enough(self)) {
        pass_tip(self, index, moment);
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "command_desk.h"

#include "telemetry.h"

#include <string.h>
#include <sys/random.h>
#include <time.h>

#define LOOK_MS 2U

static void pause_briefly(void)
{
    struct timespec look = {.tv_sec = 0, .tv_nsec = (long)LOOK_MS * 1000000L};
    (void)nanosleep(&look, NULL);
}

/* A pause of the machine, in which control could not answer, is one look; a slow board answers
 * slowly. */
static uint32_t looks_in(const command_desk_t *self, uint32_t timeout_ms)
{
    loop_figures_t loop;
    bool is_known = exchange_read_loop(self->exchange, &loop);
    return (timeout_ms / LOOK_MS) * (is_known ? loop.slowness : 1U);
}

void command_desk_init(command_desk_t *self, exchange_t *exchange)
{
    memset(self, 0, sizeof(*self));
    self->exchange = exchange;
    (void)pthread_mutex_init(&self->lock, NULL);
    /* Not the numbers of an earlier run: its late answers must not be taken for ours. */
    if (getrandom(&self->next_id, sizeof(self->next_id), 0U) != (ssize_t)sizeof(self->next_id)) {
        self->next_id = (uint32_t)telemetry_now_ms();
    }
}

static command_question_t *find(command_desk_t *self, uint32_t id)
{
    for (uint32_t i = 0U; i < COMMAND_DESK_QUESTIONS; i++) {
        if (self->questions[i].id == id) {
            return &self->questions[i];
        }
    }
    return NULL;
}

static command_question_t *open_question(command_desk_t *self)
{
    (void)pthread_mutex_lock(&self->lock);
    command_question_t *question = find(self, 0U);
    if (question != NULL) {
        self->next_id++;
        self->next_id += (self->next_id == 0U) ? 1U : 0U;
        question->id = self->next_id;
        question->is_answered = false;
    }
    (void)pthread_mutex_unlock(&self->lock);
    return question;
}

static void close_question(command_desk_t *self, command_question_t *question)
{
    (void)pthread_mutex_lock(&self->lock);
    question->id = 0U;
    (void)pthread_mutex_unlock(&self->lock);
}

static bool send_command(command_desk_t *self, const command_t *command)
{
    (void)pthread_mutex_lock(&self->lock);
    bool is_sent = exchange_send_command(self->exchange, command) == STATUS_OK;
    (void)pthread_mutex_unlock(&self->lock);
    return is_sent;
}

static bool collect(command_desk_t *self, const command_question_t *question, answer_t *answer)
{
    (void)pthread_mutex_lock(&self->lock);
    answer_t taken;
    while (exchange_take_answer(self->exchange, COMMAND_SOURCE_HTTP, &taken)) {
        command_question_t *asked = (taken.id != 0U) ? find(self, taken.id) : NULL;
        if ((asked != NULL) && !asked->is_answered) {
            asked->answer = taken;
            asked->is_answered = true;
        }
    }
    bool is_answered = question->is_answered;
    *answer = question->answer;
    (void)pthread_mutex_unlock(&self->lock);
    return is_answered;
}

static status_t converse(command_desk_t *self, const command_t *command, uint32_t timeout_ms,
                         const command_question_t *question, answer_t *answer)
{
    bool is_sent = send_command(self, command);
    for (uint32_t looks = looks_in(self, timeout_ms); looks > 0U; looks--) {
        is_sent = is_sent || send_command(self, command);
        if (collect(self, question, answer)) {
            return STATUS_OK;
        }
        pause_briefly();
    }
    return is_sent ? STATUS_NO_ANSWER : STATUS_BUSY;
}

status_t command_desk_ask(command_desk_t *self, const command_t *command, uint32_t timeout_ms,
                          answer_t *answer)
{
    command_question_t *question = open_question(self);
    if (question == NULL) {
        return STATUS_BUSY;
    }
    command_t sent = *command;
    sent.id = question->id;
    sent.source = (uint32_t)COMMAND_SOURCE_HTTP;
    status_t status = converse(self, &sent, timeout_ms, question, answer);
    close_question(self, question);
    return status;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "http/pages/command_client.h"

#include "common/clock.h"
#include "exchange/exchange_peers.h"
#include "http/gate/answer_timeout.h"

#include <stdio.h>
#include <string.h>
#include <sys/random.h>

/* With the lock. */
static void note_end(command_client_t *self, const page_t *page, const page_act_t *act)
{
    act_result_t *news = &self->news[self->news_next % COMMAND_CLIENT_RESULT_COUNT];
    news->page = page->number;
    news->id = act->id;
    news->answer = act->answer;
    self->news_next++;
}

/* With the lock. */
static void take_batch_answer(command_client_t *self, const answer_t *answer)
{
    for (uint32_t i = 0U; i < self->batch_count; i++) {
        if (self->batch[i].id == answer->id) {
            self->batch[i].is_answered = true;
            self->batch[i].answer = *answer;
        }
    }
}

/* With the lock. */
static void take_answers(command_client_t *self)
{
    answer_t answer;
    while (exchange_take_answer(self->exchange, COMMAND_SOURCE_HTTP, &answer)) {
        const page_t *page = NULL;
        page_act_t *act = page_table_find_sent(&self->table, answer.id, &page);
        take_batch_answer(self, &answer);
        if (act != NULL) {
            const bool is_end = act->is_answered;
            act->answer = answer;
            act->is_answered = true;
            if (is_end) {
                note_end(self, page, act);
            }
        }
    }
}

/* With the lock. The lane of answers does not fill up: they are taken before more is asked for. */
static bool send_as(command_client_t *self, uint32_t page, const command_t *command,
                    command_t *sent)
{
    take_answers(self);
    *sent = *command;
    sent->source = (uint32_t)COMMAND_SOURCE_HTTP;
    sent->peer = page;
    sent->id = self->commands + 1U;
    command_clear_unused(sent);
    if (exchange_send_command(self->exchange, sent) != STATUS_OK) {
        return false;
    }
    self->commands++;
    return true;
}

/* With the lock. */
static bool release(command_client_t *self, uint32_t page)
{
    const command_t release = {.kind = (uint32_t)COMMAND_RELEASE};
    command_t sent;
    return send_as(self, page, &release, &sent);
}

/* With the lock. */
static void publish(command_client_t *self)
{
    exchange_peers_t peers;
    (void)memset(&peers, 0, sizeof peers);
    for (uint32_t i = 0U; (i < PAGE_TABLE_PAGES) && (peers.count < EXCHANGE_PEERS); i++) {
        const page_t *page = &self->table.pages[i];
        if (page->number != 0U) {
            exchange_peer_t *row = &peers.peers[peers.count];
            row->number = page->number;
            row->since_us = page->since_us;
            (void)snprintf(row->name, sizeof row->name, "%s", page->name);
            peers.count++;
        }
    }
    exchange_publish_peers(self->exchange, COMMAND_SOURCE_HTTP, &peers);
}

/* With the lock. A page of an earlier server keeps no authority. */
static void begin(command_client_t *self)
{
    self->has_to_begin = self->has_to_begin && !release(self, 0U);
}

void command_client_init(command_client_t *self, exchange_t *exchange)
{
    answer_t stale;
    (void)memset(self, 0, sizeof *self);
    (void)pthread_mutex_init(&self->lock, NULL);
    self->exchange = exchange;
    self->has_to_begin = true;
    (void)!getrandom(&self->commands, sizeof self->commands, 0U);
    while (exchange_take_answer(exchange, COMMAND_SOURCE_HTTP, &stale)) {
    }
    begin(self);
    publish(self);
}

/* With the lock. The evicted page loses its authority first: another session may reuse its number.
 */
static bool make_room(command_client_t *self, uint32_t number, const session_t *session,
                      uint32_t kept)
{
    const page_t *place = (page_table_find(&self->table, number) == NULL)
                              ? page_table_place(&self->table, session, kept)
                              : NULL;
    return (place == NULL) || (place->number == 0U) ||
           (!self->has_to_begin && release(self, place->number));
}

page_verdict_t command_client_register_page(command_client_t *self, uint32_t number,
                                            const session_t *session, uint32_t holder)
{
    page_verdict_t verdict = PAGE_GREETED;
    (void)pthread_mutex_lock(&self->lock);
    page_t *page = make_room(self, number, session, holder)
                       ? page_table_greet(&self->table, number, session, holder)
                       : NULL;
    if (page == NULL) {
        verdict = (page_table_find(&self->table, number) != NULL) ? PAGE_ANOTHERS : PAGE_LATER;
    } else if (page->since_us == 0U) {
        page->since_us = clock_monotonic_us();
        publish(self);
    } else {
        /* It is known. */
    }
    (void)pthread_mutex_unlock(&self->lock);
    return verdict;
}

/* `sent` has no byte that its kind does not use. */
static bool is_same(const command_t *sent, const command_t *asked)
{
    command_t other = *asked;
    command_clear_unused(&other);
    return (sent->kind == other.kind) && (memcmp(&sent->as, &other.as, sizeof other.as) == 0);
}

/* With the lock. Sends a new act. */
static act_verdict_t begin_act(command_client_t *self, page_t *page, uint32_t id,
                               const command_t *command)
{
    command_t sent;
    if (id <= page->newest) {
        return ACT_ID_USED;
    }
    if (self->has_to_begin || !send_as(self, page->number, command, &sent)) {
        return ACT_LATER;
    }
    page_act_t *act = page_table_add(page);
    act->id = id;
    act->command = sent;
    page->newest = id;
    return ACT_NO_ANSWER;
}

/* With the lock. State of an act that is kept. */
static act_verdict_t report(const page_act_t *act, const command_t *command, answer_t *answer)
{
    if (!is_same(&act->command, command)) {
        return ACT_ID_USED;
    }
    *answer = act->answer;
    return act->is_answered ? ACT_ANSWERED : ACT_NO_ANSWER;
}

act_verdict_t command_client_ask(command_client_t *self, uint32_t number, uint32_t id,
                                 const command_t *command, answer_t *answer)
{
    act_verdict_t verdict = ACT_LATER;
    (void)pthread_mutex_lock(&self->lock);
    page_t *page = page_table_find(&self->table, number);
    if (page != NULL) {
        take_answers(self);
        const page_act_t *act = page_table_act(page, id);
        verdict = (act != NULL) ? report(act, command, answer) : begin_act(self, page, id, command);
    }
    (void)pthread_mutex_unlock(&self->lock);
    return verdict;
}

act_verdict_t command_client_look(command_client_t *self, uint32_t number, uint32_t id,
                                  const command_t *command, answer_t *answer)
{
    (void)pthread_mutex_lock(&self->lock);
    take_answers(self);
    page_t *page = page_table_find(&self->table, number);
    const page_act_t *act = (page != NULL) ? page_table_act(page, id) : NULL;
    const act_verdict_t verdict = (act != NULL) ? report(act, command, answer) : ACT_NO_ANSWER;
    (void)pthread_mutex_unlock(&self->lock);
    return verdict;
}

act_verdict_t command_client_send_and_wait(command_client_t *self, uint32_t page, uint32_t id,
                                           const command_t *command, answer_t *answer)
{
    const uint32_t looks = answer_timeout_looks(self->exchange);
    act_verdict_t verdict = command_client_ask(self, page, id, command, answer);
    for (uint32_t i = 0U; (i < looks) && (verdict == ACT_NO_ANSWER); i++) {
        answer_timeout_wait();
        verdict = command_client_look(self, page, id, command, answer);
    }
    return verdict;
}

static bool begin_batch(command_client_t *self, uint32_t page, const command_t *commands,
                        uint32_t count)
{
    (void)pthread_mutex_lock(&self->lock);
    const bool is_free = (self->batch_count == 0U) && !self->has_to_begin;
    bool is_sent = is_free;
    for (uint32_t i = 0U; (i < count) && is_sent; i++) {
        command_t sent;
        is_sent = send_as(self, page, &commands[i], &sent);
        if (is_sent) {
            self->batch[i] = (batch_command_t){.id = sent.id};
            self->batch_count++;
        }
    }
    if (is_free && !is_sent) {
        self->batch_count = 0U; /* No caller waits for those that were sent. */
    }
    (void)pthread_mutex_unlock(&self->lock);
    return is_sent;
}

static bool look_for_batch(command_client_t *self, bool is_last, answer_t *answers)
{
    bool is_answered = true;
    (void)pthread_mutex_lock(&self->lock);
    take_answers(self);
    for (uint32_t i = 0U; i < self->batch_count; i++) {
        is_answered = is_answered && self->batch[i].is_answered;
        answers[i] = self->batch[i].answer;
    }
    if (is_answered || is_last) {
        self->batch_count = 0U;
    }
    (void)pthread_mutex_unlock(&self->lock);
    return is_answered;
}

act_verdict_t command_client_do_all(command_client_t *self, uint32_t page,
                                    const command_t *commands, uint32_t count, answer_t *answers)
{
    const uint32_t looks = answer_timeout_looks(self->exchange);
    if (!begin_batch(self, page, commands, count)) {
        return ACT_LATER;
    }
    for (uint32_t i = 0U; i <= looks; i++) {
        if (look_for_batch(self, i == looks, answers)) {
            return ACT_ANSWERED;
        }
        answer_timeout_wait();
    }
    return ACT_NO_ANSWER;
}

act_verdict_t command_client_do(command_client_t *self, uint32_t page, const command_t *command,
                                answer_t *answer)
{
    return command_client_do_all(self, page, command, 1U, answer);
}

bool command_client_recall(command_client_t *self, uint32_t page, uint32_t id, command_t *command)
{
    (void)pthread_mutex_lock(&self->lock);
    page_t *found = page_table_find(&self->table, page);
    const page_act_t *act = (found != NULL) ? page_table_act(found, id) : NULL;
    if (act != NULL) {
        *command = act->command;
    }
    (void)pthread_mutex_unlock(&self->lock);
    return act != NULL;
}

bool command_client_send(command_client_t *self, uint32_t page, const command_t *command)
{
    command_t sent;
    (void)pthread_mutex_lock(&self->lock);
    const bool is_sent = !self->has_to_begin && send_as(self, page, command, &sent);
    (void)pthread_mutex_unlock(&self->lock);
    return is_sent;
}

/* With the lock. */
static void dismiss_ended(command_client_t *self, session_store_t *sessions, uint64_t now_ms)
{
    for (uint32_t i = 0U; i < PAGE_TABLE_PAGES; i++) {
        page_t *page = &self->table.pages[i];
        session_t session;
        if ((page->number != 0U) &&
            !session_store_find(sessions, page->session, now_ms, &session) &&
            release(self, page->number)) {
            (void)memset(page, 0, sizeof *page);
        }
    }
}

void command_client_tick(command_client_t *self, session_store_t *sessions, uint64_t now_ms)
{
    (void)pthread_mutex_lock(&self->lock);
    begin(self);
    take_answers(self);
    dismiss_ended(self, sessions, now_ms);
    publish(self); /* Again: a neighbour may have damaged it. */
    (void)pthread_mutex_unlock(&self->lock);
}

uint32_t command_client_result_count(command_client_t *self)
{
    (void)pthread_mutex_lock(&self->lock);
    const uint32_t next = self->news_next;
    (void)pthread_mutex_unlock(&self->lock);
    return next;
}

bool command_client_read_results(command_client_t *self, uint32_t *next, act_result_t *news)
{
    (void)pthread_mutex_lock(&self->lock);
    const uint32_t behind = self->news_next - *next;
    if (behind > COMMAND_CLIENT_RESULT_COUNT) {
        *next = self->news_next - COMMAND_CLIENT_RESULT_COUNT;
    }
    const bool is_one = behind > 0U;
    if (is_one) {
        *news = self->news[*next % COMMAND_CLIENT_RESULT_COUNT];
        (*next)++;
    }
    (void)pthread_mutex_unlock(&self->lock);
    return is_one;
}

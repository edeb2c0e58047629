/* SPDX-License-Identifier: Apache-2.0 */
#include "http/pages/http_peers_log.h"

#include "limits/requirement_limits.h"
#include "http/login/passed.h"

#include <stdio.h>
#include <string.h>

#define LEFT_OUT_SIZE 48U

void http_peers_log_init(http_peers_log_t *self, http_notes_t *notes)
{
    (void)memset(self, 0, sizeof *self);
    self->notes = notes;
}

static const http_peers_log_row_t *row_of(const http_peers_log_t *self, const exchange_peer_t *peer)
{
    for (uint32_t i = 0U; i < EXCHANGE_PEERS; i++) {
        if ((self->rows[i].number == peer->number) && (self->rows[i].since_us == peer->since_us)) {
            return &self->rows[i];
        }
    }
    return NULL;
}

static void take_rows(http_peers_log_t *self, const exchange_peers_t *peers)
{
    http_peers_log_row_t rows[EXCHANGE_PEERS];
    (void)memset(rows, 0, sizeof rows);
    for (uint32_t i = 0U; i < peers->count; i++) {
        const exchange_peer_t *peer = &peers->peers[i];
        const http_peers_log_row_t *known = row_of(self, peer);
        rows[i] = (http_peers_log_row_t){.since_us = peer->since_us, .number = peer->number};
        if (known != NULL) {
            rows[i] = *known;
        }
    }
    (void)memcpy(self->rows, rows, sizeof rows);
}

static bool is_time(const http_peers_log_t *self, uint64_t now_ms)
{
    return ((self->logged_ms == 0U) ||
            (passed_ms(self->logged_ms, now_ms) >= LIMIT_STATUS_LOG_PAUSE_MS)) &&
           !http_notes_are_behind(self->notes);
}

static void report(http_peers_log_t *self, const exchange_peer_t *peer, http_peers_log_row_t *row,
                   http_peers_log_kind_t kind)
{
    const bool is_status = kind == HTTP_PEERS_LOG_STATUS;
    const uint32_t changes = is_status ? peer->statuses : peer->refusals;
    const uint32_t left_out = changes - row->logged[kind] - 1U;
    char before[LEFT_OUT_SIZE] = "";
    char text[EXCHANGE_PEER_STATUS_SIZE + LEFT_OUT_SIZE + sizeof "REFUSED "];
    if (left_out > 0U) {
        (void)snprintf(before, sizeof before, "(%u before it are not logged) ", (unsigned)left_out);
    }
    (void)snprintf(text, sizeof text, "%s%s %s", before, is_status ? "STATUS" : "REFUSED",
                   is_status ? peer->status : peer->refusal);
    http_notes_write(self->notes, is_status ? NOTE_STATUS : NOTE_REFUSAL, peer->name, text);
    row->logged[kind] = changes;
}

void http_peers_log_tick(http_peers_log_t *self, uint64_t now_ms)
{
    exchange_peers_t peers;
    if (!exchange_read_peers(self->notes->exchange, COMMAND_SOURCE_IGTL, &peers)) {
        return;
    }
    take_rows(self, &peers);
    for (uint32_t i = 0U; (i < (peers.count * HTTP_PEERS_LOG_KINDS)) && is_time(self, now_ms);
         i++) {
        const uint32_t turn = (self->next + i) % (peers.count * HTTP_PEERS_LOG_KINDS);
        const uint32_t at = turn / HTTP_PEERS_LOG_KINDS;
        const http_peers_log_kind_t kind = (http_peers_log_kind_t)(turn % HTTP_PEERS_LOG_KINDS);
        const exchange_peer_t *peer = &peers.peers[at];
        const uint32_t changes = (kind == HTTP_PEERS_LOG_STATUS) ? peer->statuses : peer->refusals;
        if (changes != self->rows[at].logged[kind]) {
            report(self, peer, &self->rows[at], kind);
            self->logged_ms = now_ms;
            self->next = turn + 1U;
        }
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "http/http_statuses.h"

#include "limits/requirement_limits.h"
#include "session/passed.h"

#include <stdio.h>
#include <string.h>

#define LEFT_OUT_SIZE 48U

void http_statuses_init(http_statuses_t *self, http_notes_t *notes)
{
    (void)memset(self, 0, sizeof *self);
    self->notes = notes;
}

static uint32_t logged_of(const http_statuses_t *self, const exchange_peer_t *peer)
{
    for (uint32_t i = 0U; i < EXCHANGE_PEERS; i++) {
        if ((self->rows[i].number == peer->number) && (self->rows[i].since_us == peer->since_us)) {
            return self->rows[i].logged;
        }
    }
    return 0U;
}

static void take_rows(http_statuses_t *self, const exchange_peers_t *peers)
{
    http_statuses_row_t rows[EXCHANGE_PEERS];
    (void)memset(rows, 0, sizeof rows);
    for (uint32_t i = 0U; i < peers->count; i++) {
        const exchange_peer_t *peer = &peers->peers[i];
        rows[i] = (http_statuses_row_t){
            .since_us = peer->since_us, .number = peer->number, .logged = logged_of(self, peer)};
    }
    (void)memcpy(self->rows, rows, sizeof rows);
}

static void tell(const http_statuses_t *self, const exchange_peer_t *peer, uint32_t left_out)
{
    char before[LEFT_OUT_SIZE] = "";
    char text[EXCHANGE_PEER_STATUS_SIZE + LEFT_OUT_SIZE + sizeof "STATUS "];
    if (left_out > 0U) {
        (void)snprintf(before, sizeof before, "(%u before it are not logged) ", (unsigned)left_out);
    }
    (void)snprintf(text, sizeof text, "%sSTATUS %s", before, peer->status);
    http_notes_write(self->notes, NOTE_STATUS, peer->name, text);
}

static bool is_time(const http_statuses_t *self, uint64_t now_ms)
{
    return ((self->logged_ms == 0U) ||
            (passed_ms(self->logged_ms, now_ms) >= LIMIT_STATUS_LOG_PAUSE_MS)) &&
           !http_notes_are_behind(self->notes);
}

void http_statuses_tick(http_statuses_t *self, uint64_t now_ms)
{
    exchange_peers_t peers;
    if (!exchange_read_peers(self->notes->exchange, COMMAND_SOURCE_IGTL, &peers)) {
        return;
    }
    take_rows(self, &peers);
    for (uint32_t i = 0U; (i < peers.count) && is_time(self, now_ms); i++) {
        const uint32_t at = (self->next + i) % peers.count;
        const exchange_peer_t *peer = &peers.peers[at];
        if (peer->statuses != self->rows[at].logged) {
            tell(self, peer, peer->statuses - self->rows[at].logged - 1U);
            self->rows[at].logged = peer->statuses;
            self->logged_ms = now_ms;
            self->next = at + 1U;
        }
    }
}

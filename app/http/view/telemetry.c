/* SPDX-License-Identifier: Apache-2.0 */
#include "http/view/telemetry.h"

#include "common/clock.h"

#include <string.h>

/* A process that has not beaten for so long is shown as not running. */
#define SILENCE_MS 3000U
#define EVENTS_AT_ONCE 16U

uint64_t telemetry_now_ms(void)
{
    return clock_monotonic_us() / 1000U;
}

void telemetry_init(telemetry_t *self, exchange_t *exchange)
{
    (void)memset(self, 0, sizeof *self);
    self->exchange = exchange;
    self->moved_ms = telemetry_now_ms();
    self->view.robot = exchange_robot(exchange);
    self->view.cards = exchange_cards(exchange);
    (void)pthread_mutex_init(&self->lock, NULL);
    for (uint32_t i = 0U; i < EXCHANGE_PROCESS_COUNT; i++) {
        self->beats[i] = exchange_beats(exchange, (exchange_process_t)i);
    }
}

static void look_at_snapshot(telemetry_t *self, uint64_t now_ms)
{
    telemetry_view_t *view = &self->view;
    snapshot_t snapshot;
    if (exchange_read_snapshot(self->exchange, &snapshot)) {
        if (!view->has_snapshot || (snapshot.cycle != view->snapshot.cycle)) {
            self->moved_ms = now_ms;
        }
        view->snapshot = snapshot;
        view->has_snapshot = true;
    }
    (void)exchange_read_loop(self->exchange, &view->loop);
    view->age_ms = now_ms - self->moved_ms;
}

static void look_at_beats(telemetry_t *self, uint64_t now_ms)
{
    for (uint32_t i = 0U; i < EXCHANGE_PROCESS_COUNT; i++) {
        uint32_t beats = exchange_beats(self->exchange, (exchange_process_t)i);
        if (beats != self->beats[i]) {
            self->beats[i] = beats;
            self->beaten_ms[i] = now_ms;
        }
        self->view.is_running[i] =
            (self->beaten_ms[i] != 0U) && ((now_ms - self->beaten_ms[i]) < SILENCE_MS);
    }
}

static void look_at_ports(telemetry_t *self)
{
    telemetry_view_t *view = &self->view;

    if (!view->is_running[EXCHANGE_IGTL] || !exchange_read_ports(self->exchange, &view->ports)) {
        view->ports.count = 0U;
    }
}

static void look_up(const telemetry_t *self, uint32_t source, uint32_t peer,
                    char title[EXCHANGE_TITLE_SIZE])
{
    title[0] = '\0';
    if (peer != 0U) {
        exchange_title(self->exchange, (command_source_t)source, peer, title);
    }
}

static void look_who_commands(telemetry_t *self)
{
    telemetry_view_t *view = &self->view;

    look_up(self, view->snapshot.holder, view->snapshot.holder_peer, view->holder);
    look_up(self, view->snapshot.requester, view->snapshot.requester_peer, view->requester);
}

/* After the snapshot: no event that it knows of is missing then. */
static void look_at_events(telemetry_t *self)
{
    exchange_event_t events[EVENTS_AT_ONCE];
    uint32_t lost = 0U;
    uint32_t count;
    do {
        count =
            exchange_read_events(self->exchange, &self->next_event, events, EVENTS_AT_ONCE, &lost);
        for (uint32_t i = 0U; i < count; i++) {
            origins_take(&self->view.origins, self->exchange, &events[i].event);
            alarms_take(&self->view.alarms, &events[i]);
        }
    } while (count == EVENTS_AT_ONCE);
    alarms_see(&self->view.alarms, &self->view.snapshot);
}

void telemetry_look(telemetry_t *self, telemetry_view_t *view)
{
    (void)pthread_mutex_lock(&self->lock);
    uint64_t now_ms = telemetry_now_ms();
    look_at_snapshot(self, now_ms);
    look_at_beats(self, now_ms);
    look_at_ports(self);
    look_who_commands(self);
    look_at_events(self);
    origins_take_shown(&self->view.origins, self->exchange, &self->view.snapshot);
    *view = self->view;
    (void)pthread_mutex_unlock(&self->lock);
}

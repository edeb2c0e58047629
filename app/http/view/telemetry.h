/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The server's knowledge of control: the newest snapshot and its age. Shared by all threads of the
 * server. The age grows as soon as the cycle counter stands still, so a frozen control is seen
 * even though its last snapshot can still be read.
 */
#ifndef BORESIGHT_TELEMETRY_H
#define BORESIGHT_TELEMETRY_H

#include "exchange/exchange.h"
#include "exchange/exchange_peers.h"
#include "http/view/alarms.h"
#include "http/view/origins.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

/** One consistent view. */
typedef struct {
    bool has_snapshot;             /**< Control has published at least once. */
    uint64_t age_ms;               /**< Since the cycle counter was last seen to move. */
    const robot_t *robot;          /**< As control published it; of no axes before that. */
    const exchange_cards_t *cards; /**< The same. */
    snapshot_t snapshot;
    loop_figures_t loop;
    origins_t origins;
    alarms_t alarms;
    char holder[EXCHANGE_TITLE_SIZE];        /**< Title of the client with authority; "": none. */
    char requester[EXCHANGE_TITLE_SIZE];     /**< Title of the one that asks for it; "": none. */
    exchange_ports_t ports;                  /**< None while igtl does not run. */
    bool is_running[EXCHANGE_PROCESS_COUNT]; /**< Its alive counter moved lately. */
} telemetry_view_t;

typedef struct {
    exchange_t *exchange;
    pthread_mutex_t lock;
    telemetry_view_t view;
    uint32_t next_event;
    uint64_t moved_ms; /**< Monotonic time at which the cycle counter last moved. */
    uint32_t beats[EXCHANGE_PROCESS_COUNT];
    uint64_t beaten_ms[EXCHANGE_PROCESS_COUNT];
} telemetry_t;

/** Monotonic time. */
uint64_t telemetry_now_ms(void);

/** Starts with nothing known. `exchange` outlives `self`. */
void telemetry_init(telemetry_t *self, exchange_t *exchange);

/** Looks into the exchange and copies what is known now. Any thread; called at least every 100 ms
 * by one. */
void telemetry_look(telemetry_t *self, telemetry_view_t *view);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A client that came by a gate, until it is answered or the library has it. At the console's gate
 * its request is looked at without being taken: what is no good stop is the library's, as it came.
 */
#ifndef BORESIGHT_STOP_CLIENT_H
#define BORESIGHT_STOP_CLIENT_H

#include "exchange/exchange.h"
#include "http/stop/gate.h"
#include "http/stop/stop_command.h"
#include "http/stop/stop_request.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef enum {
    STOP_CLIENT_READS = 0,
    STOP_CLIENT_WAITS = 1, /**< For control's answer. */
    STOP_CLIENT_LEAVES =
        2 /**< It was answered; what else it sends is thrown away until it closes. */
} stop_client_state_t;

typedef struct {
    int socket; /**< -1: none exists. */
    const gate_t *gate;
    stop_client_state_t state;
    uint64_t number; /**< In the order of coming. */
    uint64_t since_us;
    bool is_reported; /**< To go on with its body. */
    size_t size;
    char bytes[STOP_REQUEST_SIZE + 1U];
    stop_request_t request;
    stop_question_t question;
} stop_client_t;

/** Begins with `socket`, which came by `gate`, and reads what is there. */
void stop_client_enter(stop_client_t *self, exchange_t *exchange, const gate_t *gate, int socket);

/** Something has come. */
void stop_client_hear(stop_client_t *self, exchange_t *exchange);

/** Looks for control's answer. */
void stop_client_look(stop_client_t *self, exchange_t *exchange);

/** Ends its wait for a client that does not finish, or does not go. */
void stop_client_judge_timeout(stop_client_t *self);

/** Another one needs its place. */
void stop_client_give_way(stop_client_t *self);

#endif

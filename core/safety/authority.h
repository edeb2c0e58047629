/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The party that may command: one page of the console or one connection of OpenIGTLink, or none. It
 * also keeps the request to the button at the box. The controller owns one. Behaviour:
 * statecharts/authority.scxml.
 */
#ifndef BORESIGHT_AUTHORITY_H
#define BORESIGHT_AUTHORITY_H

#include "charts/authority_chart.h"
#include "interface/authority_list.h"
#include "interface/command.h"

#include <stdbool.h>
#include <stdint.h>

/** A page or a connection. */
typedef struct {
    uint32_t source; /**< command_source_t. */
    uint32_t peer;   /**< As command_t; 0: none. */
} authority_party_t;

/** Under seal. */
typedef struct {
    authority_party_t holder; /**< Peer 0 while it is not held. */
    uint32_t since_cycle;     /**< It was taken. */
    uint32_t since_us;        /**< Renewed last, or lost. */
    uint32_t request;         /**< authority_request_t. */
    uint32_t request_axis;    /**< Axis, with AUTHORITY_REQUEST_CONFIRM_AXIS. */
    authority_party_t requester;
    uint32_t requested_us;
} authority_sealed_t;

typedef struct {
    authority_sealed_t sealed;
    authority_chart_t chart;
} authority_t;

/** When something happens. */
typedef struct {
    uint32_t cycle;
    uint32_t time_us; /**< Wraps. */
} authority_time_t;

/** Starts without a holder and without a request; so does one that was damaged. */
void authority_init(authority_t *self);

/** Before each step: with a damaged one no party has authority. True when it was damaged. */
bool authority_check(authority_t *self);

static inline bool authority_is_free(const authority_t *self)
{
    return self->chart.state == AUTHORITY_STATE_NOBODY;
}

static inline bool authority_is_held(const authority_t *self)
{
    return self->chart.state == AUTHORITY_STATE_HELD;
}

static inline bool authority_is_ending(const authority_t *self)
{
    return self->chart.state == AUTHORITY_STATE_ENDING;
}

/** `party` has it. */
bool authority_is_of(const authority_t *self, const authority_party_t *party);

/**
 * Gives what is free to `party`; a party without a name gets nothing.
 *
 * @return true when it has authority now and had not before
 *
 * @satisfies SWR-AUTH-001
 */
bool authority_take(authority_t *self, const authority_party_t *party, authority_time_t now);

/** The holder has given a sign of life. */
static inline void authority_renew(authority_t *self, uint32_t time_us)
{
    self->sealed.since_us = time_us;
}

/** The holder, if there is one, has lost it. @return AUTHORITY_ACTION_ bits */
uint32_t authority_lose(authority_t *self, uint32_t time_us);

/** The page that has it did not renew it for LIMIT_AUTHORITY_RENEW_US.
 *
 * @satisfies SWR-AUTH-007
 */
bool authority_is_unrenewed(const authority_t *self, uint32_t time_us);

/**
 * Once a cycle; `is_at_rest`: every axis. @return true when the party that asked for authority has
 * it now
 *
 * @satisfies SWR-AUTH-006
 */
bool authority_step(authority_t *self, bool is_at_rest, uint32_t elapsed_us, authority_time_t now);

/** That request waits for the button, and for `party`. */
bool authority_is_asked(const authority_t *self, authority_request_t request, uint32_t axis,
                        const authority_party_t *party);

/**
 * The next press of the button means `request`, for `party`; with AUTHORITY_REQUEST_CONFIRM_AXIS of
 * `axis`. @return false: another one's request stands
 *
 * @satisfies SWR-AUTH-012
 */
bool authority_ask(authority_t *self, authority_request_t request, uint32_t axis,
                   const authority_party_t *party, uint32_t time_us);

/** Until the request lapses, in us; 0 without one, and once it was granted. */
uint32_t authority_request_left_us(const authority_t *self, uint32_t time_us);

/** The button has its own meaning again. */
void authority_forget_request(authority_t *self);

#endif

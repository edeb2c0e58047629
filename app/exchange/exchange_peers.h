/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The connected clients: the ports of OpenIGTLink, and a row for each of its connections and for
 * each page of the console. Each process writes its own; everyone reads. The rows of a process that
 * has ended stay readable: a reader looks at its beats.
 */
#ifndef BORESIGHT_EXCHANGE_PEERS_H
#define BORESIGHT_EXCHANGE_PEERS_H

#include "exchange/exchange.h"

#include <stdbool.h>
#include <stdint.h>

/** For igtl: how its ports are. */
void exchange_publish_ports(exchange_t *self, const exchange_ports_t *ports);

/** Copies the newest; every number in it is in its range and every text has its end. False before
 * the first, or when the writer kept interfering. */
bool exchange_read_ports(const exchange_t *self, exchange_ports_t *ports);

/**
 * For igtl and http: their connected clients. One thread of each.
 *
 * @satisfies SWR-EXCH-016
 */
void exchange_publish_peers(exchange_t *self, command_source_t source,
                            const exchange_peers_t *peers);

/**
 * Copies the newest; every number in it is in its range and every text has its end. False before
 * the first, or when the writer kept interfering.
 *
 * @satisfies SWR-EXCH-016
 */
bool exchange_read_peers(const exchange_t *self, command_source_t source, exchange_peers_t *peers);

/**
 * For http: asks it of igtl. One at a time: a newer one takes the place of one that was not taken
 * yet. @return its id
 *
 * @satisfies SWR-EXCH-018
 */
uint32_t exchange_give_order(exchange_t *self, const exchange_order_t *order);

/** igtl's answer to the order `id`; false while none exists. */
bool exchange_read_order_answer(const exchange_t *self, uint32_t id, status_t *status);

/** For igtl: the newest order, if it is not answered. False as well when a number in it is out of
 * its range. */
bool exchange_take_order(exchange_t *self, exchange_order_t *order);

/** For igtl: answers it. */
void exchange_answer_order(exchange_t *self, const exchange_order_t *order, status_t status);

/**
 * Writes how people call a peer: "brp 127.0.0.1:53212", "page of anna"; by its number when the
 * table does not have it, "connection 21".
 *
 * @satisfies SWR-EXCH-017
 */
#define EXCHANGE_TITLE_SIZE 56U
void exchange_title(const exchange_t *self, command_source_t source, uint32_t number,
                    char title[EXCHANGE_TITLE_SIZE]);

#endif

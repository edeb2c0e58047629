/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Who is connected: the ports of OpenIGTLink, and a row for each of its connections and for each
 * page of the console. Each process writes its own; everyone reads. What a process that has gone
 * left behind stays readable: a reader looks at its beats.
 */
#ifndef BORESIGHT_EXCHANGE_PEERS_H
#define BORESIGHT_EXCHANGE_PEERS_H

#include "exchange/exchange.h"

#include <stdbool.h>
#include <stdint.h>

#define EXCHANGE_PORTS 4U
#define EXCHANGE_PORT_NAME_SIZE 16U
#define EXCHANGE_PORT_TROUBLE_SIZE 96U

/** What the dialects are called: "brp-2013" ... */
typedef enum {
    EXCHANGE_DIALECT_BRP_2013 = 0,
    EXCHANGE_DIALECT_BRP_2021 = 1,
    EXCHANGE_DIALECT_CRTK = 2
} exchange_dialect_t;

#define EXCHANGE_DIALECTS 3U

typedef enum {
    EXCHANGE_PORT_LISTENING = 0, /**< Peers come to it. */
    EXCHANGE_PORT_CALLING = 1,   /**< It calls its peer. */
    EXCHANGE_PORT_WAITING = 2,   /**< It calls again in a while. */
    EXCHANGE_PORT_CONNECTED = 3  /**< Its peer has answered. */
} exchange_port_state_t;

#define EXCHANGE_PORT_STATES 4U

/** A port of OpenIGTLink. */
typedef struct {
    char name[EXCHANGE_PORT_NAME_SIZE];
    uint32_t dialect; /**< exchange_dialect_t. */
    uint32_t address; /**< IPv4, where it listens or whom it calls; 127.0.0.1 is 0x7F000001. */
    uint32_t number;
    uint32_t state;    /**< exchange_port_state_t. */
    uint32_t again_ms; /**< WAITING: until it calls. */
    uint32_t peers;
    uint32_t waiting;                         /**< Connections without a place. */
    uint32_t troubles;                        /**< Counted since igtl started. */
    char trouble[EXCHANGE_PORT_TROUBLE_SIZE]; /**< The last one in words. */
} exchange_port_t;

typedef struct {
    uint32_t count;
    exchange_port_t ports[EXCHANGE_PORTS];
} exchange_ports_t;

#define EXCHANGE_PEERS 48U          /**< Rows of a source. */
#define EXCHANGE_PEER_NAME_SIZE 32U /**< Room for an address with its port, and for an account. */
#define EXCHANGE_PEER_MESSAGE_SIZE 24U /**< Room for the name of a message. */
#define EXCHANGE_PEER_STATUS_SIZE 128U /**< Longer texts are cut. */

/** A connection of OpenIGTLink, or a page of the console; of a page what is not known is 0. Times
 * are monotonic, of the machine. */
typedef struct {
    uint64_t since_us; /**< When it came. */
    uint64_t heard_us; /**< When it sent `message`; 0: nothing yet. */
    uint64_t messages_in;
    uint64_t messages_out;
    uint64_t bytes_in;
    uint64_t bytes_out;
    uint32_t number;                    /**< As command_t.peer; not 0. */
    uint32_t errors;                    /**< Messages that were refused. */
    uint32_t dialect;                   /**< exchange_dialect_t. */
    uint32_t is_waiting;                /**< 1: it has no place yet. */
    uint32_t is_kept_alive;             /**< 1: its machine is asked whether it is still there. */
    char port[EXCHANGE_PORT_NAME_SIZE]; /**< Name of its port. */
    char name[EXCHANGE_PEER_NAME_SIZE]; /**< Its address with its port; the account of a page. */
    char message[EXCHANGE_PEER_MESSAGE_SIZE]; /**< Name of its last one. */
    char status[EXCHANGE_PEER_STATUS_SIZE];   /**< Its last STATUS in words; "": none. */
    char refusal[EXCHANGE_PEER_STATUS_SIZE];  /**< Its last message that igtl refused; "": none. */
    uint32_t statuses;                        /**< Number of changes of `status`. */
    uint32_t refusals;                        /**< Number of changes of `refusal`. */
    uint32_t spare;                           /**< 0: no padding. */
} exchange_peer_t;

typedef struct {
    exchange_peer_t peers[EXCHANGE_PEERS];
    uint32_t count;
    uint32_t spare; /**< 0: no padding. */
} exchange_peers_t;

typedef enum { EXCHANGE_ORDER_DISCONNECT = 0, EXCHANGE_ORDER_KEEP_ALIVE = 1 } exchange_order_kind_t;

/** What is asked of a connection of OpenIGTLink. */
typedef struct {
    uint32_t id;     /**< Given by exchange_give_order(). */
    uint32_t kind;   /**< exchange_order_kind_t. */
    uint32_t number; /**< Of the connection. */
    uint32_t is_on;  /**< KEEP_ALIVE: 1 or 0. */
} exchange_order_t;

/** For igtl: how its ports are. */
void exchange_publish_ports(exchange_t *self, const exchange_ports_t *ports);

/** Copies the newest; every number in it is in its range and every text has its end. False before
 * the first, or when the writer kept interfering. */
bool exchange_read_ports(const exchange_t *self, exchange_ports_t *ports);

/**
 * For igtl and http: who has come to it. One thread of each.
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

/** igtl's answer to the order `id`; false while there is none. */
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

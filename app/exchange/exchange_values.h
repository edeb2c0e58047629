/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The values that the processes hand to each other, as they lie in the segment, and how many of
 * them it holds. Each is described beside the functions that write and read it: exchange.h,
 * exchange_files.h, exchange_notes.h, exchange_peers.h.
 */
#ifndef BORESIGHT_EXCHANGE_VALUES_H
#define BORESIGHT_EXCHANGE_VALUES_H

#include "interface/event.h"
#include "limits/requirement_limits.h"

#include <stdint.h>

#define EXCHANGE_COMMANDS 16U /**< Capacity of a command lane. */
#define EXCHANGE_STOPS 16U    /**< Its places for STOP and EMERGENCY alone. */
#define EXCHANGE_ANSWERS 64U  /**< Capacity of an answer lane. */
#define EXCHANGE_EVENTS 1024U /**< Events kept for slow readers. */

/** The processes of the segment; each beats its own counter. */
typedef enum {
    EXCHANGE_CONTROL = 0,
    EXCHANGE_IGTL = 1,
    EXCHANGE_HTTP = 2,
    EXCHANGE_RECORDER = 3,
    EXCHANGE_SUPERVISOR = 4
} exchange_process_t;

#define EXCHANGE_PROCESS_COUNT 5U

#define EXCHANGE_ACCEPTED_SIZE 64U

/** How the cards speak, as the board says it. */
typedef struct {
    uint32_t dialect; /**< card_dialect_t. */
    /** Name of the person who accepts the lacks of cards of another dialect, and when; "": none. */
    char accepted[EXCHANGE_ACCEPTED_SIZE];
} exchange_cards_t;

/** An event, and when control published it: UTC since 1970. */
typedef struct {
    event_t event;
    uint64_t utc_us;
} exchange_event_t;

typedef enum {
    EXCHANGE_FILE_RECORDING = 0,
    EXCHANGE_FILE_LOG = 1,
    EXCHANGE_FILE_LOG_BEFORE = 2 /**< The log before it, of the same run. */
} exchange_file_t;

#define EXCHANGE_FILES 3U

#define EXCHANGE_SETTER_SIZE 32U /**< Room for the name of an account. */

/** Which events the recorder writes to the log's file. All zero: all of them. */
typedef struct {
    uint32_t severity;             /**< event_severity_t: these and those above it. */
    char by[EXCHANGE_SETTER_SIZE]; /**< Name of the user that has set it. */
} exchange_log_level_t;

#define EXCHANGE_NOTES LIMIT_NOTES_KEPT
#define EXCHANGE_NOTE_WHO_SIZE 32U   /**< 31 bytes and a NUL. */
#define EXCHANGE_NOTE_TEXT_SIZE 768U /**< 767 bytes and a NUL: a request and its answer. */

typedef struct {
    uint32_t number;
    uint32_t kind;                      /**< note_kind_t. */
    char who[EXCHANGE_NOTE_WHO_SIZE];   /**< The name of an account; "?": a stranger. */
    char text[EXCHANGE_NOTE_TEXT_SIZE]; /**< UTF-8, goes on after the name. */
} exchange_note_t;

#define EXCHANGE_PORTS 4U
#define EXCHANGE_PORT_NAME_SIZE 16U
#define EXCHANGE_PORT_TROUBLE_SIZE 96U

/** The dialects: "brp-2013" ... */
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

/** An order for a connection of OpenIGTLink. */
typedef struct {
    uint32_t id;     /**< Given by exchange_give_order(). */
    uint32_t kind;   /**< exchange_order_kind_t. */
    uint32_t number; /**< Number of the connection. */
    uint32_t is_on;  /**< KEEP_ALIVE: 1 or 0. */
} exchange_order_t;

#endif

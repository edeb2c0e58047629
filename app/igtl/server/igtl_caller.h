/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Calls one address until it answers, never waiting for it. Each vain call, and each connection
 * that ended without one message of the peer and lasted no longer than the pause before it, doubles
 * the pause; after any other connection it is the first one.
 */
#ifndef BORESIGHT_IGTL_CALLER_H
#define BORESIGHT_IGTL_CALLER_H

#include <stdbool.h>
#include <stdint.h>

#define IGTL_CALL_TIMEOUT_US UINT64_C(5000000) /**< Then a call is over. */

typedef struct {
    uint32_t address; /**< IPv4, in the byte order of the host. */
    uint16_t number;
    int descriptor;    /**< Descriptor of the call, -1: none. */
    int error;         /**< errno of the last call, 0: it was answered. */
    uint64_t pause_us; /**< Before the next call. */
    uint64_t since_us; /**< When the call or the connection began. */
    uint64_t next_us;  /**< When it calls again. */
    bool is_connected;
} igtl_caller_t;

/** Calls at the first igtl_caller_step(). */
void igtl_caller_init(igtl_caller_t *self, uint32_t address, uint16_t number);

/** Ends a call. */
void igtl_caller_close(igtl_caller_t *self);

/** The result of the last step. */
typedef enum {
    IGTL_CALL_NOTHING = 0,  /**< No news. */
    IGTL_CALL_ANSWERED = 1, /**< `*descriptor` is connected and the caller's of this function. */
    IGTL_CALL_FAILED = 2    /**< `error` says why. */
} igtl_call_t;

/**
 * Calls when it is time, and looks whether a call was answered. Nothing while connected.
 *
 * @satisfies SWR-IGTL-025
 */
igtl_call_t igtl_caller_step(igtl_caller_t *self, uint64_t now_us, int *descriptor);

/**
 * The connection has ended; `was_heard`: the peer sent a message.
 *
 * @satisfies SWR-IGTL-025
 */
void igtl_caller_lost(igtl_caller_t *self, bool was_heard, uint64_t now_us);

#endif

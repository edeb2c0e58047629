/* SPDX-License-Identifier: Apache-2.0 */
/** @file An exchange of each test's own, with two views of it. */
#ifndef BORESIGHT_EXCHANGE_WORLD_H
#define BORESIGHT_EXCHANGE_WORLD_H

#include "exchange/exchange.h"

#include <stdio.h>
#include <unistd.h>

#define ROUNDS 20000U
#define LANE 100U /**< Entries of the lane of cycles. */

static exchange_t *control; /* The creator's view. */
static exchange_t *reader;
static char exchange_name[32];
static char error[256];

static inline void exchange_world_init(void)
{
    (void)snprintf(exchange_name, sizeof(exchange_name), "test-exchange-%d", (int)getpid());
    control = exchange_create(exchange_name, LANE, error, sizeof(error));
    TEST_ASSERT_NOT_NULL_MESSAGE(control, error);
    reader = exchange_open(exchange_name, error, sizeof(error));
    TEST_ASSERT_NOT_NULL_MESSAGE(reader, error);
    error[0] = '\0';
}

static inline void exchange_world_end(void)
{
    exchange_close(reader);
    exchange_close(control);
}

#endif

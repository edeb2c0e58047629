/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The control end of the simulated wire; the test itself holds the end of the box.
 */
#ifndef BORESIGHT_WIRE_WORLD_H
#define BORESIGHT_WIRE_WORLD_H

#include "unity.h"
#include "bsp.h"
#include "card/card_frame.h"
#include "sim/box.h"
#include "sim/model/sim_card.h"
#include "sim/wire.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#define TIMEOUT_US 2000U
#define LONG_TIMEOUT_US 5000000U

static char name[40];
static char error[200];
static wire_port_t served;
static bool is_serving;
static const box_time_t real_time = {.is_elastic = false, .slowness = 1U, .speedup = 1U};
static bsp_identity_t identity;
static bsp_exchange_t result; /* Result of the last exchange. */
static uint8_t sent[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
static uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES];

static void begin_wire(void)
{
    (void)snprintf(name, sizeof name, "boresight-test-%d", (int)getpid());
    error[0] = '\0';
    is_serving = wire_serve(&served, name, real_time, error, sizeof error);
    TEST_ASSERT_TRUE_MESSAGE(is_serving, error);
}

static void end_wire(void)
{
    if (is_serving) {
        wire_close(&served, WIRE_END_BOX);
    }
}

static void stop_serving(void)
{
    wire_close(&served, WIRE_END_BOX);
    is_serving = false;
}

static void serve_in(box_time_t time)
{
    stop_serving();
    is_serving = wire_serve(&served, name, time, error, sizeof error);
    TEST_ASSERT_TRUE_MESSAGE(is_serving, error);
}

static void serve_anew(bool is_elastic, uint32_t slowness)
{
    serve_in((box_time_t){is_elastic, slowness, 1U});
}

static void start(uint32_t send)
{
    bsp_start(send, (const uint8_t(*)[CARD_FRAME_BYTES])sent);
}

static uint32_t finish(uint32_t timeout_us)
{
    bsp_finish(bsp_now_ns() + (UINT64_C(1000) * timeout_us), received, &result);
    return result.received;
}

static uint32_t exchange(uint32_t send, uint32_t timeout_us)
{
    start(send);
    return finish(timeout_us);
}

/* Act of the kernel on the box's end when its process is killed: the name stays, the lock
 * goes. */
static void kill_box(void)
{
    (void)munmap(served.wire, sizeof(wire_t));
    (void)close(served.file);
}

#endif

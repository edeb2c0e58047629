/* SPDX-License-Identifier: Apache-2.0 */
/** @file The board support of a board without a card, whose inputs read as safe. */
#include "bsp.h"

#include <stdio.h>
#include <time.h>

#define NS_PER_S UINT64_C(1000000000)

bool bsp_open(const char *address, bsp_identity_t *identity, char *error, uint32_t error_size)
{
    (void)fprintf(stderr, "control: opened %s\n", address);
    (void)snprintf(error, error_size, "The lamp is always there.");
    *identity = (bsp_identity_t){
        .board = "lamp", .power_on = 1U, .was_used = true, .slowness = 1U, .speedup = 1U};
    return true;
}

bool bsp_self_test(char *error, uint32_t error_size)
{
    (void)snprintf(error, error_size, "The lamp has no wires.");
    return true;
}

void bsp_start(uint32_t send, const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES])
{
    (void)send;
    (void)frames;
}

void bsp_finish(uint64_t deadline_ns, uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                bsp_exchange_t *result)
{
    (void)deadline_ns;
    (void)received;
    *result = (bsp_exchange_t){0};
}

void bsp_sample_inputs(bsp_inputs_t *inputs)
{
    *inputs = (bsp_inputs_t){.sampled_ns = bsp_now_ns()};
}

void bsp_set_lamps(uint32_t lamps)
{
    (void)lamps;
}

void bsp_drives_off(void)
{
}

void bsp_kick(void)
{
}

uint64_t bsp_now_ns(void)
{
    struct timespec now;

    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return ((uint64_t)now.tv_sec * NS_PER_S) + (uint64_t)now.tv_nsec;
}

uint64_t bsp_reached_ns(void)
{
    return bsp_now_ns();
}

void bsp_sleep_until_ns(uint64_t deadline_ns)
{
    const struct timespec deadline = {.tv_sec = (time_t)(deadline_ns / NS_PER_S),
                                      .tv_nsec = (long)(deadline_ns % NS_PER_S)};

    (void)clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, NULL);
}

void bsp_stand_still_ns(uint64_t world_ns)
{
    (void)world_ns; /* It does not wait. */
}

void bsp_close(void)
{
}

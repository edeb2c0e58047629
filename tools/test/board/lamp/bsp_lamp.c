/* SPDX-License-Identifier: Apache-2.0 */
/** @file The board support of a board without a card, whose inputs read as safe. */
#include "bsp.h"

#include <stdio.h>
#include <time.h>

#define NS_PER_S UINT64_C(1000000000)

bool bsp_open(const char *name, char *error, uint32_t error_size)
{
    (void)fprintf(stderr, "control: opened %s\n", name);
    (void)snprintf(error, error_size, "The lamp is always there.");
    return true;
}

uint32_t bsp_exchange(uint32_t send, const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                      uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES], uint32_t timeout_us)
{
    (void)send;
    (void)frames;
    (void)received;
    (void)timeout_us;
    return 0U;
}

bsp_inputs_t bsp_sample_inputs(void)
{
    return (bsp_inputs_t){.estop_open = true, .scanner_active = true};
}

bsp_power_on_t bsp_power_on(void)
{
    return (bsp_power_on_t){.id = 1U, .was_used = true};
}

uint32_t bsp_robot_crc(void)
{
    return 0U;
}

bsp_time_t bsp_time(void)
{
    return (bsp_time_t){.is_elastic = false, .slowness = 1U};
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

void bsp_close(void)
{
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "http/gate/answer_timeout.h"

#include <time.h>

#define ANSWER_TIMEOUT_MS 500U

uint32_t answer_timeout_looks(const exchange_t *exchange)
{
    loop_figures_t loop;
    const uint32_t slowness = exchange_read_loop(exchange, &loop) ? loop.slowness : 1U;
    return (ANSWER_TIMEOUT_MS / ANSWER_POLL_MS) * slowness;
}

void answer_timeout_wait(void)
{
    const struct timespec look = {.tv_sec = 0, .tv_nsec = (long)ANSWER_POLL_MS * 1000000L};
    (void)nanosleep(&look, NULL);
}

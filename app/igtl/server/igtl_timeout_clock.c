/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/server/igtl_timeout_clock.h"

#include "limits/requirement_limits.h"

#define NS_PER_US UINT64_C(1000)
#define CYCLE_NS (NS_PER_US * LIMIT_CYCLE_US)
#define TURN_NS (NS_PER_US * LIMIT_IGTL_TURN_US)

static uint64_t least(uint64_t one, uint64_t other)
{
    return (one < other) ? one : other;
}

void igtl_timeout_clock_step(igtl_timeout_clock_t *self, uint64_t elapsed_us, uint32_t slowness,
                             uint32_t beats, bool is_silent)
{
    const uint64_t turn_ns = (least(elapsed_us, LIMIT_IGTL_TURN_US) * NS_PER_US) / slowness;
    const uint64_t passed_ns = (uint64_t)(beats - self->beats) * CYCLE_NS;

    self->beats = beats;
    self->listened_ns += turn_ns;
    self->cycles_ns = least(self->cycles_ns + passed_ns, TURN_NS);
    const uint64_t advance_ns = is_silent ? turn_ns : least(turn_ns, self->cycles_ns);
    self->cycles_ns -= least(advance_ns, self->cycles_ns);
    self->timeout_ns += advance_ns;
}

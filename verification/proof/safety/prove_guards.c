/* SPDX-License-Identifier: Apache-2.0 */
/* E-stop latch, loop guard and confirm button, one cycle from any sound state: what holds after
 * each holds always. */
#include "prove.h"

#include "limits/requirement_limits.h"
#include "safety/confirm_button.h"
#include "safety/estop_latch.h"
#include "safety/loop_guard.h"

void prove_SWR_ESTOP_001_an_open_chain_is_pulled_in_its_cycle(void)
{
    estop_latch_chart_t self;
    bool is_open;
    uint32_t elapsed_us;
    assume(estop_latch_chart_is_sound(&self));
    const estop_latch_state_t before = self.state;

    estop_latch_step(&self, is_open, elapsed_us);

    PROVE(IMPLIES(is_open, self.state == ESTOP_LATCH_STATE_PULLED),
          "SWR-ESTOP-001: an open chain is pulled in its cycle");
    PROVE(IMPLIES(self.state == ESTOP_LATCH_STATE_CLEAR,
                  (before == ESTOP_LATCH_STATE_CLEAR) && !is_open),
          "SWR-ESTOP-002: no cycle clears what was not clear");
    PROVE(estop_latch_chart_is_sound(&self), "SWR-CORE-004: the chart stays sound");
    POSSIBLE(self.state == ESTOP_LATCH_STATE_CLEAR, "clear");
}

void prove_SWR_ESTOP_002_only_a_reset_with_a_closed_chain_clears_it(void)
{
    estop_latch_chart_t self;
    assume(estop_latch_chart_is_sound(&self));
    const estop_latch_state_t before = self.state;

    estop_latch_reset(&self);

    PROVE(IMPLIES(before == ESTOP_LATCH_STATE_PULLED, self.state == ESTOP_LATCH_STATE_PULLED),
          "SWR-ESTOP-002: an open chain is not cleared");
    PROVE(estop_latch_chart_is_sound(&self), "SWR-CORE-004: the chart stays sound");
    POSSIBLE((before == ESTOP_LATCH_STATE_LATCHED) && (self.state == ESTOP_LATCH_STATE_CLEAR),
             "cleared");
}

void prove_SWR_LOOP_002_late_cycles_stop_the_loop(void)
{
    loop_guard_t self;
    uint32_t elapsed_us;
    uint32_t stage;
    assume(loop_guard_chart_is_sound(&self.chart));
    const loop_guard_state_t before = self.chart.state;
    const bool is_late = elapsed_us > LIMIT_OVERRUN_US;
    const uint32_t overruns = self.sealed.overruns;

    loop_guard_step(&self, elapsed_us, stage);

    PROVE(IMPLIES(elapsed_us > LIMIT_LOOP_SILENT_US, self.chart.state == LOOP_GUARD_STATE_STOPPED),
          "SWR-LOOP-009: a cycle that is far too late stops it at once");
    PROVE(IMPLIES(is_late && (before == LOOP_GUARD_STATE_LATE_TWICE),
                  self.chart.state == LOOP_GUARD_STATE_STOPPED),
          "SWR-LOOP-002: the third late one stops it");
    PROVE(IMPLIES(before == LOOP_GUARD_STATE_STOPPED, self.chart.state == LOOP_GUARD_STATE_STOPPED),
          "SWR-LOOP-002: it stays stopped until it is reset");
    PROVE(IMPLIES(is_late, (uint32_t)self.chart.state >= (uint32_t)LOOP_GUARD_STATE_LATE_ONCE),
          "SWR-LOOP-004: a late one is counted");
    PROVE(self.sealed.overruns == (overruns + ((is_late && (overruns < UINT32_MAX)) ? 1U : 0U)),
          "SWR-LOOP-001: each late cycle is one overrun");
    PROVE(loop_guard_chart_is_sound(&self.chart), "SWR-CORE-004: the chart stays sound");
    POSSIBLE(self.chart.state == LOOP_GUARD_STATE_ON_TIME, "on time");
}

/* So long a press is at most before it counts: what every cycle leaves. */
static bool is_button_sound(const confirm_button_t *self)
{
    return ((uint64_t)self->sealed.held_cycles * LIMIT_CYCLE_US < LIMIT_CONFIRM_HOLD_US) &&
           (self->sealed.is_proven <= 1U) &&
           IMPLIES(self->sealed.is_proven == 0U, self->sealed.held_cycles == 0U);
}

void prove_SWR_REF_006_a_press_counts_once_and_only_after_a_release(void)
{
    confirm_button_t self;
    bool is_pressed;
    bool is_barred;
    assume(is_button_sound(&self));
    const confirm_button_t before = self;

    const bool counts = confirm_button_step(&self, is_pressed, is_barred);

    PROVE(IMPLIES(counts, is_pressed && !is_barred), "SWR-REF-006: it is pressed, and not barred");
    PROVE(IMPLIES(counts, before.sealed.is_proven != 0U), "SWR-REF-006: it was seen released");
    PROVE(
        IMPLIES(counts, (before.sealed.held_cycles + 1U) * LIMIT_CYCLE_US >= LIMIT_CONFIRM_HOLD_US),
        "SWR-REF-006: it was held for as long as it must");
    PROVE(IMPLIES(counts, (self.sealed.is_proven == 0U) && (self.sealed.held_cycles == 0U)),
          "SWR-REF-006: it counts once");
    PROVE(self.sealed.held_cycles <= (before.sealed.held_cycles + 1U),
          "SWR-REF-006: a cycle adds one");
    PROVE(is_button_sound(&self), "SWR-REF-006: the next cycle may rely on it");
    POSSIBLE(counts, "a press that counts");
}

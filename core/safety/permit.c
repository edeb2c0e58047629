/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/permit.h"

/* An unread input says nothing, and allows nothing: each bit that takes a reason away gives one.
 */
static uint32_t name_unread(uint32_t reasons, uint32_t unread)
{
    const uint32_t pedal = permit_reason(true, PERMIT_REASON_PEDAL_UNPROVEN) |
                           permit_reason(true, PERMIT_REASON_PEDAL_RELEASED);
    const bool is_pedal = (unread & permit_input(BOX_INPUT_PEDAL)) != 0U;
    const bool is_estop = (unread & permit_input(BOX_INPUT_ESTOP)) != 0U;
    const bool is_scanner = (unread & permit_input(BOX_INPUT_SCANNER)) != 0U;
    const uint32_t unsaid = (is_pedal ? pedal : 0U) |
                            permit_reason(is_estop, PERMIT_REASON_ESTOP_PULLED) |
                            permit_reason(is_scanner, PERMIT_REASON_SCANNER_ACTIVE);
    return (reasons & ~unsaid) |
           permit_reason(is_pedal || is_estop || is_scanner, PERMIT_REASON_INPUTS_UNREAD);
}

permit_common_t permit_decide_common(const permit_common_facts_t *facts, uint32_t unread)
{
    uint32_t reasons = 0U;
    reasons |= permit_reason(facts->is_estop_pulled, PERMIT_REASON_ESTOP_PULLED);
    reasons |= permit_reason(facts->is_estop_latched, PERMIT_REASON_ESTOP_LATCHED);
    reasons |= permit_reason(facts->is_loop_stopped, PERMIT_REASON_LOOP_STOPPED);
    reasons |= permit_reason(facts->is_link_lost, PERMIT_REASON_LINK_LOST);
    reasons |= permit_reason(facts->is_pedal_faulty, PERMIT_REASON_PEDAL_FAULT);
    reasons |= permit_reason(facts->is_scanner_active, PERMIT_REASON_SCANNER_ACTIVE);
    reasons |= permit_reason(!facts->is_armed, PERMIT_REASON_NOTHING_ARMED);
    reasons |= permit_reason(facts->is_pedal_unproven, PERMIT_REASON_PEDAL_UNPROVEN);
    reasons |= permit_reason(!facts->is_pedal_pressed, PERMIT_REASON_PEDAL_RELEASED);
    reasons |= permit_reason(facts->is_memory_damaged, PERMIT_REASON_MEMORY);
    reasons |= permit_reason(facts->are_cards_unprotected, PERMIT_REASON_CARDS_UNPROTECTED);
    reasons |= facts->hand_reasons;
    if (unread != 0U) {
        reasons = name_unread(reasons, unread);
    }
    const permit_common_t common = {
        .reasons = reasons,
        .unhomed_reasons = permit_reason(!facts->may_be_unhomed, PERMIT_REASON_NOT_HOMED),
        .speed_cap_percent = permit_cap_percent(facts->is_every_axis_homed)};
    return common;
}

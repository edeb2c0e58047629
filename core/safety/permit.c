/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/permit.h"

#include "limits/requirement_limits.h"

#define FULL_PERCENT 100U

static uint32_t reason(bool stands, permit_reason_t name)
{
    return stands ? ((uint32_t)1U << (uint32_t)name) : 0U;
}

uint32_t permit_cap_percent(bool is_every_axis_homed)
{
    return is_every_axis_homed ? FULL_PERCENT : LIMIT_UNHOMED_SPEED_PERCENT;
}

permit_common_t permit_decide_common(const permit_common_facts_t *facts)
{
    uint32_t reasons = 0U;
    reasons |= reason(facts->is_estop_pulled, PERMIT_REASON_ESTOP_PULLED);
    reasons |= reason(facts->is_estop_latched, PERMIT_REASON_ESTOP_LATCHED);
    reasons |= reason(facts->is_loop_stopped, PERMIT_REASON_LOOP_STOPPED);
    reasons |= reason(facts->is_link_lost, PERMIT_REASON_LINK_LOST);
    reasons |= reason(facts->is_pedal_faulty, PERMIT_REASON_PEDAL_FAULT);
    reasons |= reason(facts->is_scanner_active, PERMIT_REASON_SCANNER_ACTIVE);
    reasons |= reason(!facts->is_armed, PERMIT_REASON_NOTHING_ARMED);
    reasons |= reason(facts->is_pedal_unproven, PERMIT_REASON_PEDAL_UNPROVEN);
    reasons |= reason(!facts->is_pedal_pressed, PERMIT_REASON_PEDAL_RELEASED);
    reasons |= reason(facts->is_memory_damaged, PERMIT_REASON_MEMORY);
    reasons |= reason(facts->are_cards_unprotected, PERMIT_REASON_CARDS_UNPROTECTED);
    const permit_common_t common = {
        .reasons = reasons,
        .unhomed_reasons = reason(!facts->may_be_unhomed, PERMIT_REASON_NOT_HOMED),
        .speed_cap_percent = permit_cap_percent(facts->is_every_axis_homed)};
    return common;
}

permit_t permit_decide(const permit_common_t *common, const permit_facts_t *facts)
{
    uint32_t reasons = common->reasons;
    reasons |= facts->is_homed ? 0U : common->unhomed_reasons;
    reasons |= reason(facts->is_axis_faulty, PERMIT_REASON_AXIS_FAULT);
    reasons |= reason(!facts->is_axis_enabled, PERMIT_REASON_AXIS_DISABLED);
    reasons |= reason(facts->is_towards_switch, PERMIT_REASON_LIMIT_SWITCH);
    reasons |= reason(facts->is_beyond_soft_limit, PERMIT_REASON_SOFT_LIMIT);
    reasons |= reason(facts->is_coupled_limit, PERMIT_REASON_COUPLED_LIMIT);
    reasons |= reason(facts->is_needle_in, PERMIT_REASON_NEEDLE_IN);
    const bool is_allowed = reasons == 0U;
    const permit_t permit = {.is_allowed = is_allowed,
                             .reasons = reasons,
                             .speed_cap_percent = is_allowed ? common->speed_cap_percent : 0U};
    return permit;
}

card_drive_t permit_apply(const permit_t *permit, bool is_too_fast, const card_drive_t *requested)
{
    const card_drive_t off = {.mode = (uint32_t)CARD_DRIVE_OFF, .direction = 0U, .duty = 0U};
    return (permit->is_allowed && !is_too_fast) ? *requested : off;
}

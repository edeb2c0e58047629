/* SPDX-License-Identifier: Apache-2.0 */
/* The permit of one axis, for every fact, every input that was not read, and every request. */
#include "prove.h"

#include "safety/permit.h"

#define UNREAD                                                                                     \
    (permit_input(BOX_INPUT_PEDAL) | permit_input(BOX_INPUT_ESTOP) |                               \
     permit_input(BOX_INPUT_SCANNER))

/* All that hand_guard_reasons() makes. */
#define OF_A_HAND                                                                                  \
    (permit_reason(true, PERMIT_REASON_FORCE_DOUBTFUL) |                                           \
     permit_reason(true, PERMIT_REASON_HAND_UNPROVEN) |                                            \
     permit_reason(true, PERMIT_REASON_HAND_OFF) | permit_reason(true, PERMIT_REASON_AT_DEPTH))

/* A fact against every axis stands. */
static bool bars_all(const permit_common_facts_t *facts, uint32_t unread)
{
    return facts->is_estop_pulled || facts->is_estop_latched || facts->is_loop_stopped ||
           facts->is_link_lost || facts->is_pedal_faulty || facts->is_scanner_active ||
           !facts->is_armed || facts->is_pedal_unproven || !facts->is_pedal_pressed ||
           facts->is_memory_damaged || facts->are_cards_unprotected ||
           (facts->hand_reasons != 0U) || ((unread & UNREAD) != 0U);
}

static bool bars_axis(const permit_common_facts_t *common, const permit_facts_t *facts)
{
    return facts->is_axis_faulty || !facts->is_axis_enabled ||
           (!facts->is_homed && !common->may_be_unhomed) || facts->is_towards_switch ||
           facts->is_beyond_soft_limit || facts->is_coupled_limit || facts->is_needle_in ||
           facts->is_unsteered;
}

static bool has(const permit_t *permit, permit_reason_t name)
{
    return ((permit->reasons >> (uint32_t)name) & 1U) != 0U;
}

void prove_SWR_PERMIT_001_a_drive_is_allowed_exactly_when_nothing_stands_against_it(void)
{
    permit_common_facts_t common_facts;
    permit_facts_t facts;
    uint32_t unread;
    bool is_too_fast;
    card_drive_t requested;
    const permit_common_t common = permit_decide_common(&common_facts, unread);
    const permit_t permit = permit_decide(&common, &facts);
    const card_drive_t drive = permit_apply(&permit, is_too_fast, &requested);
    const bool is_barred = bars_all(&common_facts, unread) || bars_axis(&common_facts, &facts);
    const bool is_off = (drive.mode | drive.direction | drive.duty | drive.amplitude) == 0U;

    PROVE(SAME(permit.is_allowed, !is_barred),
          "SWR-PERMIT-001: allowed exactly when no fact stands");
    PROVE(SAME(permit.is_allowed, permit.reasons == 0U),
          "SWR-PERMIT-003: a reason stands exactly when it is not allowed");
    PROVE(IMPLIES(!permit.is_allowed || is_too_fast, is_off),
          "SWR-PERMIT-002: off unless it is allowed and not too fast");
    PROVE(IMPLIES(permit.is_allowed && !is_too_fast,
                  (drive.mode == requested.mode) && (drive.direction == requested.direction) &&
                      (drive.duty == requested.duty) && (drive.amplitude == requested.amplitude)),
          "SWR-PERMIT-002: otherwise as requested");
    PROVE(permit.speed_cap_percent ==
              (is_barred ? 0U : permit_cap_percent(common_facts.is_every_axis_homed)),
          "SWR-AXIS-006: the cap of an axis that is not allowed is 0");
    POSSIBLE(!is_off, "a drive");
}

void prove_SWR_PERMIT_003_each_reason_stands_exactly_for_its_fact(void)
{
    permit_common_facts_t common_facts;
    permit_facts_t facts;
    uint32_t unread;
    assume((common_facts.hand_reasons & ~OF_A_HAND) == 0U);
    const permit_common_t common = permit_decide_common(&common_facts, unread);
    const permit_t permit = permit_decide(&common, &facts);
    const bool is_pedal_read = (unread & permit_input(BOX_INPUT_PEDAL)) == 0U;
    const bool is_estop_read = (unread & permit_input(BOX_INPUT_ESTOP)) == 0U;
    const bool is_scanner_read = (unread & permit_input(BOX_INPUT_SCANNER)) == 0U;

    PROVE(SAME(has(&permit, PERMIT_REASON_ESTOP_PULLED),
               (common_facts.is_estop_pulled && is_estop_read)),
          "SWR-PERMIT-003: the e-stop");
    PROVE(SAME(has(&permit, PERMIT_REASON_ESTOP_LATCHED), common_facts.is_estop_latched),
          "SWR-PERMIT-003: its latch");
    PROVE(SAME(has(&permit, PERMIT_REASON_LOOP_STOPPED), common_facts.is_loop_stopped),
          "SWR-PERMIT-003: the loop");
    PROVE(SAME(has(&permit, PERMIT_REASON_LINK_LOST), common_facts.is_link_lost),
          "SWR-PERMIT-003: a link");
    PROVE(SAME(has(&permit, PERMIT_REASON_PEDAL_FAULT), common_facts.is_pedal_faulty),
          "SWR-PERMIT-003: a faulty pedal");
    PROVE(SAME(has(&permit, PERMIT_REASON_SCANNER_ACTIVE),
               (common_facts.is_scanner_active && is_scanner_read)),
          "SWR-PERMIT-004: the scanner");
    PROVE(SAME(has(&permit, PERMIT_REASON_NOTHING_ARMED), !common_facts.is_armed),
          "SWR-PERMIT-003: nothing armed");
    PROVE(SAME(has(&permit, PERMIT_REASON_PEDAL_UNPROVEN),
               (common_facts.is_pedal_unproven && is_pedal_read)),
          "SWR-PERMIT-003: a pedal that was not seen released");
    PROVE(SAME(has(&permit, PERMIT_REASON_PEDAL_RELEASED),
               (!common_facts.is_pedal_pressed && is_pedal_read)),
          "SWR-PERMIT-003: a pedal that is not pressed");
    PROVE(SAME(has(&permit, PERMIT_REASON_MEMORY), common_facts.is_memory_damaged),
          "SWR-PERMIT-003: a damaged table");
    PROVE(SAME(has(&permit, PERMIT_REASON_CARDS_UNPROTECTED), common_facts.are_cards_unprotected),
          "SWR-PERMIT-003: cards without protections");
    PROVE(SAME(has(&permit, PERMIT_REASON_INPUTS_UNREAD), ((unread & UNREAD) != 0U)),
          "SWR-PERMIT-040: an input that was not read");
    PROVE(SAME(has(&permit, PERMIT_REASON_NOT_HOMED),
               (!facts.is_homed && !common_facts.may_be_unhomed)),
          "SWR-PERMIT-003: an axis that is not homed");
    PROVE(SAME(has(&permit, PERMIT_REASON_AXIS_FAULT), facts.is_axis_faulty),
          "SWR-PERMIT-003: a faulty axis");
    PROVE(SAME(has(&permit, PERMIT_REASON_AXIS_DISABLED), !facts.is_axis_enabled),
          "SWR-PERMIT-003: a disabled axis");
    PROVE(SAME(has(&permit, PERMIT_REASON_LIMIT_SWITCH), facts.is_towards_switch),
          "SWR-PERMIT-003: a limit switch");
    PROVE(SAME(has(&permit, PERMIT_REASON_SOFT_LIMIT), facts.is_beyond_soft_limit),
          "SWR-PERMIT-003: a soft limit");
    PROVE(SAME(has(&permit, PERMIT_REASON_COUPLED_LIMIT), facts.is_coupled_limit),
          "SWR-PERMIT-003: a coupled limit");
    PROVE(SAME(has(&permit, PERMIT_REASON_NEEDLE_IN), facts.is_needle_in),
          "SWR-PERMIT-003: the needle");
    PROVE(SAME(has(&permit, PERMIT_REASON_ROTATION_LAGS), facts.is_unsteered),
          "SWR-PERMIT-003: a rotation that does not follow its law");
    PROVE((permit.reasons & OF_A_HAND) == common_facts.hand_reasons,
          "SWR-COOP-008: a hand that moves the needle");
    POSSIBLE(permit.is_allowed, "no reason");
}

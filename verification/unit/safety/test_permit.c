/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an axis may be driven only when no reason stands against it; each standing
 * reason is named; whatever is not allowed leaves as zero drive words.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "safety/permit.h"

#include <stddef.h>
#include <string.h>

#define FACTS 21U
#define COMBINATIONS (1UL << FACTS)

/* Those of every axis and those of one. */
typedef struct {
    permit_common_facts_t common;
    permit_facts_t axis;
} facts_t;

/* Eighteen facts forbid by themselves; two decide together about the nineteenth
 * reason; one decides about the speed cap. */
typedef struct {
    size_t fact;
    bool forbids_when;
    permit_reason_t reason;
} rule_t;

static const rule_t rules[] = {
    {offsetof(facts_t, common.is_estop_pulled), true, PERMIT_REASON_ESTOP_PULLED},
    {offsetof(facts_t, common.is_estop_latched), true, PERMIT_REASON_ESTOP_LATCHED},
    {offsetof(facts_t, common.is_loop_stopped), true, PERMIT_REASON_LOOP_STOPPED},
    {offsetof(facts_t, common.is_link_lost), true, PERMIT_REASON_LINK_LOST},
    {offsetof(facts_t, common.is_pedal_faulty), true, PERMIT_REASON_PEDAL_FAULT},
    {offsetof(facts_t, common.is_scanner_active), true, PERMIT_REASON_SCANNER_ACTIVE},
    {offsetof(facts_t, axis.is_axis_faulty), true, PERMIT_REASON_AXIS_FAULT},
    {offsetof(facts_t, axis.is_axis_enabled), false, PERMIT_REASON_AXIS_DISABLED},
    {offsetof(facts_t, common.is_armed), false, PERMIT_REASON_NOTHING_ARMED},
    {offsetof(facts_t, common.is_pedal_unproven), true, PERMIT_REASON_PEDAL_UNPROVEN},
    {offsetof(facts_t, common.is_pedal_pressed), false, PERMIT_REASON_PEDAL_RELEASED},
    {offsetof(facts_t, axis.is_towards_switch), true, PERMIT_REASON_LIMIT_SWITCH},
    {offsetof(facts_t, axis.is_beyond_soft_limit), true, PERMIT_REASON_SOFT_LIMIT},
    {offsetof(facts_t, axis.is_coupled_limit), true, PERMIT_REASON_COUPLED_LIMIT},
    {offsetof(facts_t, axis.is_needle_in), true, PERMIT_REASON_NEEDLE_IN},
    {offsetof(facts_t, axis.is_unsteered), true, PERMIT_REASON_ROTATION_LAGS},
    {offsetof(facts_t, common.is_memory_damaged), true, PERMIT_REASON_MEMORY},
    {offsetof(facts_t, common.are_cards_unprotected), true, PERMIT_REASON_CARDS_UNPROTECTED},
};

#define RULES (sizeof rules / sizeof rules[0])

static permit_t decide_unread(const facts_t *facts, uint32_t unread)
{
    const permit_common_t common = permit_decide_common(&facts->common, unread);
    return permit_decide(&common, &facts->axis);
}

static permit_t decide(const facts_t *facts)
{
    return decide_unread(facts, 0U);
}

static bool *fact(facts_t *facts, size_t offset)
{
    return (bool *)((unsigned char *)facts + offset);
}

static facts_t combination(uint32_t bits)
{
    facts_t facts = {.common = {.hand_reasons = 0U}};

    for (size_t i = 0U; i < RULES; i++) {
        *fact(&facts, rules[i].fact) = ((bits >> i) & 1U) != 0U;
    }
    facts.axis.is_homed = ((bits >> RULES) & 1U) != 0U;
    facts.common.may_be_unhomed = ((bits >> (RULES + 1U)) & 1U) != 0U;
    facts.common.is_every_axis_homed = ((bits >> (RULES + 2U)) & 1U) != 0U;
    return facts;
}

/* Nothing stands in the way: a homed axis, armed, with the pedal down. */
static facts_t free_facts(void)
{
    facts_t facts;

    (void)memset(&facts, 0, sizeof facts);
    facts.axis.is_axis_enabled = true;
    facts.common.is_armed = true;
    facts.common.is_pedal_pressed = true;
    facts.axis.is_homed = true;
    facts.common.is_every_axis_homed = true;
    return facts;
}

static uint32_t mask(permit_reason_t reason)
{
    return (uint32_t)1U << (uint32_t)reason;
}

void setUp(void)
{
}

void tearDown(void)
{
}

void test_SWR_PERMIT_001_every_combination_of_facts_is_decided_by_the_rule(void)
{
    uint32_t allowed = 0U;

    TEST_ASSERT_EQUAL_size_t(FACTS * sizeof(bool), offsetof(permit_common_facts_t, may_be_unhomed) +
                                                       sizeof(bool) + sizeof(permit_facts_t));
    for (uint32_t bits = 0U; bits < COMBINATIONS; bits++) {
        facts_t facts = combination(bits);
        const permit_t permit = decide(&facts);
        uint32_t expected = 0U;
        for (size_t i = 0U; i < RULES; i++) {
            if (*fact(&facts, rules[i].fact) == rules[i].forbids_when) {
                expected |= mask(rules[i].reason);
            }
        }
        if (!(facts.axis.is_homed || facts.common.may_be_unhomed)) {
            expected |= mask(PERMIT_REASON_NOT_HOMED);
        }
        TEST_ASSERT_EQUAL_HEX32(expected, permit.reasons);
        TEST_ASSERT_EQUAL(expected == 0U, permit.is_allowed);
        TEST_ASSERT_EQUAL(permit.is_allowed, permit.speed_cap_percent > 0U);
        allowed += permit.is_allowed ? 1U : 0U;
    }
    /* Homed in any order, or not homed in a homing or a jog; each at both speeds. */
    TEST_ASSERT_EQUAL_UINT32(6U, allowed);
}

void test_SWR_PERMIT_002_an_allowed_request_passes_unchanged(void)
{
    const facts_t facts = free_facts();
    const permit_t permit = decide(&facts);
    const card_drive_t request = {CARD_DRIVE_PWM, 1U, 0x1FFFFU, 0U};
    const card_drive_t drive = permit_apply(&permit, false, &request);

    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_PWM, drive.mode);
    TEST_ASSERT_EQUAL_UINT32(1U, drive.direction);
    TEST_ASSERT_EQUAL_UINT32(0x1FFFFU, drive.duty);
}

void test_SWR_PERMIT_002_any_single_reason_makes_every_drive_word_zero(void)
{
    const card_drive_t request = {CARD_DRIVE_NON_PWM, 1U, 0x1FFFFU, 0U};

    for (size_t i = 0U; i < RULES; i++) {
        facts_t facts = free_facts();
        *fact(&facts, rules[i].fact) = rules[i].forbids_when;
        const permit_t permit = decide(&facts);
        const card_drive_t drive = permit_apply(&permit, false, &request);
        TEST_ASSERT_EQUAL_UINT32(0U, drive.mode);
        TEST_ASSERT_EQUAL_UINT32(0U, drive.direction);
        TEST_ASSERT_EQUAL_UINT32(0U, drive.duty);
    }
}

void test_SWR_PERMIT_003_each_fact_alone_is_named_by_its_own_reason(void)
{
    for (size_t i = 0U; i < RULES; i++) {
        facts_t facts = free_facts();
        *fact(&facts, rules[i].fact) = rules[i].forbids_when;
        TEST_ASSERT_EQUAL_HEX32(mask(rules[i].reason), decide(&facts).reasons);
    }
    facts_t facts = free_facts();
    facts.axis.is_homed = false;
    TEST_ASSERT_EQUAL_HEX32(mask(PERMIT_REASON_NOT_HOMED), decide(&facts).reasons);
}

void test_SWR_PERMIT_003_reasons_that_stand_together_are_all_named(void)
{
    facts_t facts = free_facts();
    uint32_t all = mask(PERMIT_REASON_NOT_HOMED);

    for (size_t i = 0U; i < RULES; i++) {
        *fact(&facts, rules[i].fact) = rules[i].forbids_when;
        all |= mask(rules[i].reason);
    }
    facts.axis.is_homed = false;
    TEST_ASSERT_EQUAL_HEX32(all, decide(&facts).reasons);
}

void test_SWR_COOP_008_what_stands_against_a_hand_stands_against_every_drive(void)
{
    static const permit_reason_t of_a_hand[] = {PERMIT_REASON_FORCE_DOUBTFUL,
                                                PERMIT_REASON_HAND_UNPROVEN, PERMIT_REASON_HAND_OFF,
                                                PERMIT_REASON_AT_DEPTH};
    for (size_t i = 0U; i < (sizeof of_a_hand / sizeof of_a_hand[0]); i++) {
        facts_t facts = free_facts();
        facts.common.hand_reasons = mask(of_a_hand[i]);
        TEST_ASSERT_EQUAL_HEX32(mask(of_a_hand[i]), decide(&facts).reasons);
        TEST_ASSERT_FALSE(decide(&facts).is_allowed);
        facts.common.is_armed = false;
        TEST_ASSERT_EQUAL_HEX32(mask(of_a_hand[i]) | mask(PERMIT_REASON_NOTHING_ARMED),
                                decide(&facts).reasons);
    }
}

void test_SWR_PERMIT_004_no_axis_is_allowed_while_the_scanner_acquires(void)
{
    facts_t facts = free_facts();

    TEST_ASSERT_TRUE(decide(&facts).is_allowed);
    facts.common.is_scanner_active = true;
    TEST_ASSERT_FALSE(decide(&facts).is_allowed);
    facts.common.may_be_unhomed = true;
    TEST_ASSERT_FALSE(decide(&facts).is_allowed);
}

/* All that a box which is not heard is taken for. */
static facts_t unheard_facts(void)
{
    facts_t facts = free_facts();
    facts.common.is_estop_pulled = true;
    facts.common.is_scanner_active = true;
    facts.common.is_pedal_unproven = true;
    facts.common.is_pedal_pressed = false;
    return facts;
}

void test_SWR_PERMIT_040_what_is_not_read_is_the_reason_and_not_what_it_is_taken_for(void)
{
    const uint32_t unread = permit_input(BOX_INPUT_PEDAL) | permit_input(BOX_INPUT_ESTOP) |
                            permit_input(BOX_INPUT_SCANNER);
    const facts_t facts = unheard_facts();
    const permit_t permit = decide_unread(&facts, unread);
    TEST_ASSERT_EQUAL_HEX32(mask(PERMIT_REASON_INPUTS_UNREAD), permit.reasons);
    TEST_ASSERT_FALSE(permit.is_allowed);
}

void test_SWR_PERMIT_040_each_alone_forbids_and_takes_away_its_own_reasons_only(void)
{
    const uint32_t all = mask(PERMIT_REASON_INPUTS_UNREAD) | mask(PERMIT_REASON_ESTOP_PULLED) |
                         mask(PERMIT_REASON_SCANNER_ACTIVE) | mask(PERMIT_REASON_PEDAL_UNPROVEN) |
                         mask(PERMIT_REASON_PEDAL_RELEASED);
    const uint32_t own[] = {[BOX_INPUT_PEDAL] = mask(PERMIT_REASON_PEDAL_UNPROVEN) |
                                                mask(PERMIT_REASON_PEDAL_RELEASED),
                            [BOX_INPUT_ESTOP] = mask(PERMIT_REASON_ESTOP_PULLED),
                            [BOX_INPUT_SCANNER] = mask(PERMIT_REASON_SCANNER_ACTIVE)};
    for (uint32_t i = 0U; i <= (uint32_t)BOX_INPUT_SCANNER; i++) {
        const facts_t unheard = unheard_facts();
        const facts_t facts = free_facts();
        const uint32_t unread = permit_input((box_input_t)i);
        TEST_ASSERT_EQUAL_HEX32(all & ~own[i], decide_unread(&unheard, unread).reasons);
        TEST_ASSERT_EQUAL_HEX32(mask(PERMIT_REASON_INPUTS_UNREAD),
                                decide_unread(&facts, unread).reasons);
    }
}

void test_SWR_PERMIT_040_a_gate_that_is_not_read_forbids_nothing(void)
{
    const facts_t facts = free_facts();
    TEST_ASSERT_TRUE(decide_unread(&facts, permit_input(BOX_INPUT_GATE)).is_allowed);
}

void test_SWR_PERMIT_005_a_homed_axis_has_its_full_speed(void)
{
    facts_t facts = free_facts();

    TEST_ASSERT_EQUAL_UINT32(100U, decide(&facts).speed_cap_percent);
    facts.common.may_be_unhomed = true;
    TEST_ASSERT_EQUAL_UINT32(100U, decide(&facts).speed_cap_percent);
}

void test_SWR_PERMIT_005_an_axis_that_is_not_allowed_has_no_speed(void)
{
    facts_t facts = free_facts();

    facts.common.is_estop_pulled = true;
    TEST_ASSERT_EQUAL_UINT32(0U, decide(&facts).speed_cap_percent);
}

void test_SWR_AXIS_006_an_axis_not_homed_homes_and_jogs_at_reduced_speed(void)
{
    facts_t facts = free_facts();

    facts.axis.is_homed = false;
    facts.common.is_every_axis_homed = false;
    facts.common.may_be_unhomed = true;
    const permit_t permit = decide(&facts);
    TEST_ASSERT_TRUE(permit.is_allowed);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_UNHOMED_SPEED_PERCENT, permit.speed_cap_percent);
}

void test_SWR_AXIS_006_a_homed_axis_is_slow_too_while_another_is_not_homed(void)
{
    facts_t facts = free_facts();

    facts.common.is_every_axis_homed = false;
    TEST_ASSERT_EQUAL_UINT32(LIMIT_UNHOMED_SPEED_PERCENT, decide(&facts).speed_cap_percent);
}

void test_SWR_PERMIT_005_an_axis_that_is_too_fast_gets_no_drive(void)
{
    const card_drive_t request = {CARD_DRIVE_PWM, 1U, 0x1FFFFU, 0U};
    const facts_t facts = free_facts();
    const permit_t permit = decide(&facts);
    const card_drive_t drive = permit_apply(&permit, true, &request);

    TEST_ASSERT_EQUAL_UINT32(0U, drive.mode | drive.direction | drive.duty);
}

void test_SWR_AXIS_006_the_cap_is_lower_until_every_axis_is_homed(void)
{
    TEST_ASSERT_EQUAL_UINT32(LIMIT_UNHOMED_SPEED_PERCENT, permit_cap_percent(false));
    TEST_ASSERT_EQUAL_UINT32(100U, permit_cap_percent(true));
}

void test_SWR_AXIS_006_an_axis_not_homed_does_nothing_else(void)
{
    facts_t facts = free_facts();

    facts.axis.is_homed = false;
    TEST_ASSERT_FALSE(decide(&facts).is_allowed);
}

void test_SWR_PEDAL_001_without_the_pedal_every_drive_word_is_zero_whatever_else_holds(void)
{
    const card_drive_t request = {CARD_DRIVE_PWM, 1U, 0x1FFFFU, 0U};

    for (uint32_t bits = 0U; bits < COMBINATIONS; bits++) {
        facts_t facts = combination(bits);
        facts.common.is_pedal_pressed = false;
        const permit_t permit = decide(&facts);
        const card_drive_t drive = permit_apply(&permit, false, &request);
        TEST_ASSERT_EQUAL_UINT32(0U, drive.mode | drive.direction | drive.duty);
    }
}

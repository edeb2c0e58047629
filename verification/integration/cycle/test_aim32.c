/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: with cards of the dialect aim32 the controller goes on as with its own, but
 * drives nothing until a person has accepted the lacks of such cards.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "card/card_dialect.h"
#include "robot/robot_neuro.h"

#include <string.h>

static rig_t rig;

static uint32_t word(uint32_t slot, uint32_t index)
{
    const uint8_t *const at = &rig.outputs.frames[slot][index * 4U];
    return ((uint32_t)at[0] << 24U) | ((uint32_t)at[1] << 16U) | ((uint32_t)at[2] << 8U) | at[3];
}

static bool is_reason_standing(uint32_t axis)
{
    const uint32_t reasons = rig.outputs.snapshot.axes[axis].permit_reasons;
    return (reasons & (1UL << PERMIT_REASON_CARDS_UNPROTECTED)) != 0U;
}

void setUp(void)
{
    rig_start(&rig);
    rig.dialect = (uint32_t)CARD_DIALECT_AIM32;
    rig.outputs.frames_to_send = 0U; /* They are of the other dialect. */
    (void)memset(rig.outputs.frames, 0, sizeof rig.outputs.frames);
    rig_cycles(&rig, 3U);
}

void tearDown(void)
{
}

void test_SWR_NI_005_commands_go_out_and_reports_come_in_in_the_dialect(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const uint32_t slot = robot_neuro.axes[i].slot;
        TEST_ASSERT_EQUAL_HEX32(0xFEFEFE01U, word(slot, 0U));
        TEST_ASSERT_EQUAL_HEX32(0U, word(slot, 1U));
        TEST_ASSERT_EQUAL_HEX32(0xFFFFFFFFU - 0xFEFEFE01U, word(slot, 31U));
        TEST_ASSERT_EQUAL_HEX32(0U, word(slot, 63U));
        TEST_ASSERT_TRUE(link_is_healthy_now(&rig.controller.links[slot]));
    }
}

void test_SWR_NI_005_damaged_reports_are_refused_and_the_card_is_lost(void)
{
    rig_box(&rig, "card 3 corrupt");
    rig_cycles(&rig, LIMIT_LINK_AGE_CYCLES);
    TEST_ASSERT_FALSE(link_is_usable(&rig.controller.links[3]));
}

void test_SWR_NI_005_health_that_the_cards_do_not_tell_is_not_judged(void)
{
    rig_cycles(&rig, (LIMIT_CARD_SUPPLY_LOOKS + 2U) * CARD_SLOT_COUNT);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        TEST_ASSERT_EQUAL_HEX32(0U, rig.controller.health[slot].troubles);
    }
}

void test_SWR_NI_006_nothing_moves_and_every_axis_says_why(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    for (uint32_t cycle = 0U; cycle < 500U; cycle++) {
        rig_cycle(&rig);
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            const uint32_t slot = robot_neuro.axes[i].slot;
            TEST_ASSERT_TRUE(is_reason_standing(i));
            TEST_ASSERT_EQUAL_HEX32(0U, word(slot, 3U) | word(slot, 14U));
        }
    }
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_ACCEPT_CARDS, rig.outputs.snapshot.next_step);
}

void test_SWR_NI_006_accepted_in_writing_the_robot_is_homed_and_the_reason_never_stands(void)
{
    rig.is_dialect_accepted = 1U;
    rig_home(&rig);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_FALSE(is_reason_standing(i));
        TEST_ASSERT_TRUE(axis_is_homed(&rig.controller.axes[i]));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, rig.driven_without_pedal);
}

void test_SWR_NI_006_cards_that_protect_themselves_need_nobodys_word(void)
{
    rig_start(&rig);
    TEST_ASSERT_EQUAL_UINT32(CARD_DIALECT_OWN, rig.inputs.dialect);
    TEST_ASSERT_FALSE(is_reason_standing(0U));
}

/* Homed, in MANUAL, with a jog armed. */
static void start_jog(void)
{
    const command_t jog = {.kind = COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_LATERAL, .to_ticks = -2000}};
    setUp();
    rig.is_dialect_accepted = 1U;
    rig_home(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_cycles(&rig, 20U);
}

static uint32_t grade(void)
{
    return rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].reference;
}

/* No report shows whether it has begun to count anew. */
void test_SWR_REF_009_an_axis_whose_card_falls_silent_at_rest_is_unverified(void)
{
    start_jog();
    rig_box(&rig, "card lateral silent");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, grade());
    rig_box(&rig, "card lateral normal");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    rig_cycles(&rig, LIMIT_SPEED_TIMEOUT_US / LIMIT_CYCLE_US);
    rig_box(&rig, "button press");
    rig_cycles(&rig, (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US) + 1U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade());
    rig_box(&rig, "card lateral silent");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, grade());
}

/* The card falls silent once it has been driven for so long; the pedal opens so much later. */
static void expect_lost_after(uint32_t driven_cycles, uint32_t pedal_cycles)
{
    start_jog();
    rig_box(&rig, "pedal press");
    while (!rig_is_driving(&rig)) {
        rig_cycle(&rig);
    }
    rig_cycles(&rig, driven_cycles);
    rig_box(&rig, "card lateral silent");
    rig_cycles(&rig, pedal_cycles);
    rig_box(&rig, "pedal a open");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, grade());
}

void test_SWR_REF_009_an_axis_that_may_have_been_driven_unseen_is_lost(void)
{
    expect_lost_after(100U, 0U);
    expect_lost_after(0U, LIMIT_LINK_AGE_CYCLES);
    expect_lost_after(0U, LIMIT_LINK_AGE_CYCLES - 2U);
}

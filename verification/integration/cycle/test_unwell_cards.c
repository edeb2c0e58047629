/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: how each card is, whether or not it has an axis, is reported when it changes and
 * shown in its slot; a driver that is too hot is not driven, and everything else goes on. One that
 * is not heard any more is lost by what became of its frame.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "base/seal.h"
#include "controller/controller.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

#include <stddef.h>

#define SENSOR 8U
#define ROUND (CARD_SLOT_COUNT + 2U) /* Each slot has had its turn, with a report of its fault. */
#define BIT(trouble) card_health_bit(trouble)

static rig_t rig;
static robot_t robot; /* The NeuroRobot with a card that has no motor. */

void setUp(void)
{
    robot = robot_neuro;
    rig_put_near_switches(&robot);
    robot.sensor_slots = (uint32_t)1U << SENSOR;
    robot.seal = seal_of(SEAL_START, (const uint8_t *)&robot, offsetof(robot_t, seal));
    rig_start_robot(&rig, &robot);
    rig_cycles(&rig, ROUND);
    rig_forget(&rig);
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static const snapshot_card_t *shown(uint32_t slot)
{
    return &rig.outputs.snapshot.cards[slot];
}

static uint32_t reported(event_id_t id, uint32_t slot, card_trouble_t trouble)
{
    uint32_t count = 0U;

    for (uint32_t i = 0U; i < rig.event_count; i++) {
        const event_t *const event = &rig.events[i];
        count += ((event->id == (uint32_t)id) && (event->subject == slot) &&
                  (event->value == (int32_t)trouble))
                     ? 1U
                     : 0U;
    }
    return count;
}

void test_SWR_CARD_011_a_bad_supply_is_reported_and_shown_of_any_card(void)
{
    rig_box(&rig, "card 8 low");
    rig_cycles(&rig, ROUND + (LIMIT_CARD_SUPPLY_LOOKS * CARD_SLOT_COUNT));
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_CARD_UNWELL, SENSOR, CARD_TROUBLE_SUPPLY_LOW));
    TEST_ASSERT_EQUAL_HEX32(BIT(CARD_TROUBLE_SUPPLY_LOW), shown(SENSOR)->troubles);
    TEST_ASSERT_LESS_THAN_UINT32(LIMIT_CARD_SUPPLY_LEAST_MV, shown(SENSOR)->supply_mv);
    rig_box(&rig, "card 8 normal");
    rig_cycles(&rig, ROUND);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_CARD_WELL, SENSOR, CARD_TROUBLE_SUPPLY_LOW));
    TEST_ASSERT_EQUAL_HEX32(0U, shown(SENSOR)->troubles);
}

void test_SWR_CARD_011_a_pulled_estop_takes_the_supply_and_blames_no_card(void)
{
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 20U * CARD_SLOT_COUNT);
    TEST_ASSERT_EQUAL_UINT32(0U, shown(SENSOR)->supply_mv);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 20U * CARD_SLOT_COUNT);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_CARD_UNWELL));
}

static void begin_jog(void)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_LATERAL, .to_ticks = -2000}};

    rig_home(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    rig_cycles(&rig, 100U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_forget(&rig);
}

void test_SWR_CARD_012_a_warm_driver_is_reported_and_driven_on(void)
{
    begin_jog();
    rig_box(&rig, "card lateral warm");
    rig_cycles(&rig, ROUND);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_UNWELL));
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

void test_SWR_CARD_012_a_driver_that_is_too_hot_is_not_driven_and_keeps_its_position(void)
{
    const uint32_t slot = robot.axes[NEURO_AXIS_LATERAL].slot;

    begin_jog();
    rig_box(&rig, "card lateral hot");
    rig_cycles(&rig, ROUND);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_HOT));
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_CARD_UNWELL, slot, CARD_TROUBLE_DRIVER_HOT));
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_DISABLED,
                             rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].power);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED,
                             rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].reference);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_ENABLED, rig.outputs.snapshot.axes[NEURO_AXIS_YAW].power);
}

void test_SWR_CARD_012_a_card_without_an_axis_disables_none(void)
{
    begin_jog();
    rig_box(&rig, "card 8 hot");
    rig_cycles(&rig, ROUND);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_CARD_HOT));
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_CARD_UNWELL, SENSOR, CARD_TROUBLE_DRIVER_HOT));
}

void test_SWR_CARD_012_of_an_axis_that_is_disabled_there_is_nothing_to_disable(void)
{
    const uint32_t slot = robot.axes[NEURO_AXIS_LATERAL].slot;

    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_DISABLED,
                             rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].power);
    rig_box(&rig, "card lateral hot");
    rig_cycles(&rig, ROUND);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_CARD_UNWELL, slot, CARD_TROUBLE_DRIVER_HOT));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_CARD_HOT));
}

void test_SWR_CARD_013_a_noisy_wire_is_reported_while_motion_goes_on(void)
{
    begin_jog();
    rig_box(&rig, "card lateral noisy");
    rig_cycles(&rig, 200U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_UNWELL));
    TEST_ASSERT_GREATER_THAN_UINT32(1U, shown(robot.axes[NEURO_AXIS_LATERAL].slot)->rx_crc_errors);
}

/* A command of fifty does not reach its card, which goes on with the one before. */
void test_SWR_LINK_013_a_command_that_was_refused_makes_no_count_wrong(void)
{
    static const uint32_t axes[] = {NEURO_AXIS_HEAD, NEURO_AXIS_FEET, NEURO_AXIS_PITCH};
    static const char *const orders[] = {"card head noisy", "card feet noisy", "card pitch noisy"};
    static const int32_t ends[] = {-4000, 3000, -300};
    for (uint32_t i = 0U; i < (sizeof axes / sizeof axes[0]); i++) {
        rig_start_robot_homed(&rig, &robot_neuro);
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
        rig_box(&rig, orders[i]);
        const command_t jog = {.kind = COMMAND_JOG,
                               .as.jog = {.axis = axes[i], .to_ticks = ends[i]}};
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
        rig_press(&rig);
        TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 20000U).kind);
        TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_UNEVEN_COUNTS));
    }
}

void test_SWR_CARD_013_a_card_that_hears_nothing_trips_and_is_lost(void)
{
    rig_box(&rig, "card 8 deaf");
    rig_cycles(&rig, LIMIT_CARD_WATCHDOG_US / LIMIT_CYCLE_US + ROUND);
    TEST_ASSERT_EQUAL_UINT32(1U,
                             reported(EVENT_CARD_UNWELL, SENSOR, CARD_TROUBLE_WATCHDOG_TRIPPED));
    TEST_ASSERT_EQUAL_UINT32(1U, shown(SENSOR)->watchdog_trips);
    TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LOST, shown(SENSOR)->link);
}

/* The reported cause of the loss of the card in `slot`. */
static int32_t cause_of_loss(uint32_t slot)
{
    int32_t cause = -1;

    rig_cycles(&rig, LIMIT_LINK_AGE_CYCLES + 1U);
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        const event_t *const event = &rig.events[i];
        if ((event->id == (uint32_t)EVENT_CARD_LOST) && (event->subject == slot)) {
            TEST_ASSERT_EQUAL_INT32_MESSAGE(-1, cause, "reported twice");
            cause = event->value;
        }
    }
    return cause;
}

void test_SWR_CARD_015_a_card_that_does_not_answer_is_lost_by_age(void)
{
    rig_box(&rig, "card lateral silent");
    TEST_ASSERT_EQUAL_INT32(LINK_CAUSE_AGE, cause_of_loss(robot.axes[NEURO_AXIS_LATERAL].slot));
}

void test_SWR_CARD_015_a_card_whose_frames_are_refused_is_lost_by_that(void)
{
    rig_box(&rig, "card lateral corrupt");
    TEST_ASSERT_EQUAL_INT32(LINK_CAUSE_REFUSED, cause_of_loss(robot.axes[NEURO_AXIS_LATERAL].slot));
}

void test_SWR_CARD_015_a_card_without_an_axis_is_lost_by_late_frames(void)
{
    rig.frames_late = (uint32_t)1U << SENSOR;
    TEST_ASSERT_EQUAL_INT32(LINK_CAUSE_LATE, cause_of_loss(SENSOR));
}

void test_SWR_CARD_015_a_bus_that_fails_is_named(void)
{
    rig.frames_failed = (uint32_t)1U << robot.axes[NEURO_AXIS_LATERAL].slot;
    TEST_ASSERT_EQUAL_INT32(LINK_CAUSE_BUS_ERROR,
                            cause_of_loss(robot.axes[NEURO_AXIS_LATERAL].slot));
}

void test_SWR_CARD_015_another_cause_stays(void)
{
    rig_box(&rig, "card lateral foreign");
    TEST_ASSERT_EQUAL_INT32(LINK_CAUSE_WRONG_CARD,
                            cause_of_loss(robot.axes[NEURO_AXIS_LATERAL].slot));
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an axis is driven by the words of its own type of card and motor, and a motor
 * that is too hot is not driven.
 */
#include "integration/support/rig.h"

#include "limits/requirement_limits.h"
#include "robot/robot_bench2.h"
#include "robot/robot_prostate.h"
#include "unity.h"

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static answer_t jog(uint32_t axis, int32_t ticks)
{
    const command_t command = {.kind = (uint32_t)COMMAND_JOG,
                               .as.jog = {.axis = axis, .to_ticks = ticks}};
    return rig_command(&rig, command);
}

static answer_t jog_rotation(int32_t ticks)
{
    return jog(PROSTATE_AXIS_ROTATION, ticks);
}

/* `axis` of the homed `robot` goes to both places by drives of `mode` alone. */
static void expect_jogs_by(card_drive_mode_t mode, const robot_t *robot, uint32_t axis,
                           const int32_t places[2])
{
    uint32_t driven = 0U;
    rig_start_robot_homed(&rig, robot);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    for (uint32_t place = 0U; place < 2U; place++) {
        TEST_ASSERT_EQUAL_UINT32(ANSWER_ACCEPTED, jog(axis, places[place]).kind);
        rig_press(&rig);
        for (uint32_t i = 0U; i < 4000U; i++) {
            rig_cycle(&rig);
            const card_drive_t drive = rig_sent(&rig, axis).drive;
            if (drive.mode != (uint32_t)CARD_DRIVE_OFF) {
                TEST_ASSERT_EQUAL_UINT32(mode, drive.mode);
                driven++;
            }
        }
        rig_release(&rig);
        TEST_ASSERT_INT32_WITHIN(2, places[place], rig_position(&rig, axis));
    }
    TEST_ASSERT_GREATER_THAN_UINT32(500U, driven);
    TEST_ASSERT_TRUE(axis_is_homed(&rig.controller.axes[axis]));
}

void test_SWR_DRIVE_010_a_piezo_motor_on_an_analog_card_goes_there_and_back(void)
{
    TEST_ASSERT_EQUAL_UINT8(MOTOR_TYPE_PIEZO, robot_bench2.axes[BENCH2_AXIS_NEEDLE].motor_type);
    TEST_ASSERT_EQUAL_INT32(LIMIT_PIEZO_HOTTEST_DC,
                            robot_bench2.axes[BENCH2_AXIS_NEEDLE].hottest_dc);
    expect_jogs_by(CARD_DRIVE_ANALOG, &robot_bench2, BENCH2_AXIS_NEEDLE,
                   (const int32_t[]){20000, 500});
}

void test_SWR_DRIVE_010_a_high_frequency_axis_goes_there_and_back(void)
{
    expect_jogs_by(CARD_DRIVE_HIGH_FREQUENCY, rig_short_prostate(), PROSTATE_AXIS_ROTATION,
                   (const int32_t[]){900, -900});
}

void test_SWR_DRIVE_008_a_hot_motor_is_disabled_and_keeps_its_position(void)
{
    rig_start_robot_homed(&rig, rig_short_prostate());
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ACCEPTED, jog_rotation(900).kind);
    rig_press(&rig);
    rig_cycles(&rig, 50U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_forget(&rig);
    rig_box(&rig, "motor rotation hot");
    for (uint32_t i = 0U; axis_is_enabled(&rig.controller.axes[PROSTATE_AXIS_ROTATION]); i++) {
        TEST_ASSERT_LESS_THAN_UINT32(12U, i);
        TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_HOT));
        rig_cycle(&rig);
    }
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_HOT));
    TEST_ASSERT_TRUE(axis_is_homed(&rig.controller.axes[PROSTATE_AXIS_ROTATION]));
    TEST_ASSERT_EQUAL_UINT32(1U, rig.answer_count);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig.answers[0].kind);
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_HOT));
    rig_release(&rig);
}

void test_SWR_DRIVE_008_a_motor_as_warm_as_it_may_be_is_driven_on(void)
{
    rig_start_robot_homed(&rig, rig_short_prostate());
    TEST_ASSERT_EQUAL_INT32(LIMIT_SHINSEI_HOTTEST_DC,
                            robot_prostate.axes[PROSTATE_AXIS_ROTATION].hottest_dc);
    rig.box.axes[PROSTATE_AXIS_ROTATION].card.motor_temperature_c = 55.0;
    rig_cycles(&rig, 12U);
    TEST_ASSERT_TRUE(axis_is_enabled(&rig.controller.axes[PROSTATE_AXIS_ROTATION]));
    rig.box.axes[PROSTATE_AXIS_ROTATION].card.motor_temperature_c = 55.2;
    rig_cycles(&rig, 12U);
    TEST_ASSERT_FALSE(axis_is_enabled(&rig.controller.axes[PROSTATE_AXIS_ROTATION]));
}

/* The rotation goes to `ticks`. @return the smallest word of its drives */
static uint32_t smallest_word_to(int32_t ticks)
{
    uint32_t smallest = UINT32_MAX;
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ACCEPTED, jog_rotation(ticks).kind);
    rig_press(&rig);
    for (uint32_t i = 0U; i < 5000U; i++) {
        rig_cycle(&rig);
        const card_drive_t drive = rig_sent(&rig, PROSTATE_AXIS_ROTATION).drive;
        if ((drive.mode != (uint32_t)CARD_DRIVE_OFF) && (drive.duty < smallest)) {
            smallest = drive.duty;
        }
    }
    rig_release(&rig);
    TEST_ASSERT_INT32_WITHIN(1, ticks, rig_position(&rig, PROSTATE_AXIS_ROTATION));
    return smallest;
}

void test_SWR_DRIVE_015_words_of_a_warm_motor_follow_its_resonance(void)
{
    rig_start_robot_homed(&rig, rig_short_prostate());
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    const uint32_t cold = smallest_word_to(4000);
    TEST_ASSERT_GREATER_OR_EQUAL_UINT32(robot_prostate.axes[PROSTATE_AXIS_ROTATION].maximum_duty,
                                        cold);
    /* As after minutes of drive; it does not cool down much in a test. */
    rig.box.axes[PROSTATE_AXIS_ROTATION].card.motor_temperature_c = 52.0;
    rig_cycles(&rig, 20U);
    const uint32_t warm = smallest_word_to(0);
    TEST_ASSERT_LESS_THAN_UINT32(cold - 400U * 22009U, warm);
    TEST_ASSERT_GREATER_OR_EQUAL_UINT32(LIMIT_RESONANCE_WORD, warm);
    TEST_ASSERT_TRUE(axis_is_homed(&rig.controller.axes[PROSTATE_AXIS_ROTATION]));
}

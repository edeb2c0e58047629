/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: an axis without pwm whose table has magnitudes of its drive is moved by them,
 * and arrives as soon as any other; without them it runs or stops.
 */
#include "integration/support/rig.h"

#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "unit/support/scenes.h"
#include "unity.h"

#define MOVES SCENES(6U)

static rig_t rig;
static robot_t robot; /* The NeuroRobot; each of its cards without pwm takes magnitudes. */

static bool is_without_pwm(uint32_t axis)
{
    return robot_neuro.axes[axis].card_type == (uint8_t)CARD_TYPE_NON_PWM;
}

void setUp(void)
{
    rig_set_magnitude_robot(&robot, &robot_neuro);
    rig_put_near_switches(&robot);
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

/* A robot of `table`, homed and registered, with motors `share` as fast as it says. */
static void start(const robot_t *table, double share)
{
    rigid_t identity;
    rigid_set_identity(&identity);
    rig_start_robot(&rig, table);
    for (uint32_t i = 0U; i < table->axis_count; i++) {
        rig.box.axes[i].motor.full_speed_ticks_per_s *= share;
    }
    rig_home(&rig);
    rig_register(&rig, &identity);
}

/* Magnitudes that leave for axes without pwm in this cycle: 0 if there are none. */
static uint32_t largest_magnitude(void)
{
    uint32_t largest = 0U;
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        const card_drive_t drive = rig_sent(&rig, i).drive;
        if (is_without_pwm(i) && (drive.mode != (uint32_t)CARD_DRIVE_OFF)) {
            TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_NON_PWM, drive.mode);
            largest = (drive.duty > largest) ? drive.duty : largest;
        }
    }
    return largest;
}

/* Arms the move to a target and presses the pedal. */
static void begin_move(uint32_t number)
{
    const bool is_near = (number % 2U) == 0U;
    const rigid_t pose =
        is_near ? rig_pose(5000000, 190000000, 60000000) : rig_pose(-8000000, 185000000, 40000000);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &pose).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_forget(&rig);
    rig_press(&rig);
}

/* Ends the move. @return cycles since the end of its last profile; `largest` becomes the largest
 * magnitude */
static uint32_t end_move(uint32_t *largest)
{
    uint32_t late = 0U;
    for (uint32_t i = 0U; rig_count(&rig, EVENT_ORDER_DONE) == 0U; i++) {
        const uint32_t magnitude = largest_magnitude();
        TEST_ASSERT_LESS_THAN_UINT32(40000U, i);
        *largest = (magnitude > *largest) ? magnitude : *largest;
        rig_cycle(&rig);
        late = profile_is_finished(&rig.controller.mode.sealed.leg.profile) ? (late + 1U) : 0U;
    }
    rig_release(&rig);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    return late;
}

void test_SWR_MOTION_022_an_axis_without_magnitudes_runs_or_stops(void)
{
    uint32_t largest = 0U;
    start(&robot_neuro, 1.0);
    begin_move(1U);
    (void)end_move(&largest);
    TEST_ASSERT_EQUAL_UINT32(0U, largest);
}

void test_SWR_MOTION_022_an_axis_with_magnitudes_is_homed_and_moved_by_them(void)
{
    uint32_t largest = 0U;
    start(&robot, 1.0);
    begin_move(1U);
    (void)end_move(&largest);
    TEST_ASSERT_GREATER_THAN_UINT32(robot.axes[NEURO_AXIS_HEAD].minimum_duty, largest);
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(robot.axes[NEURO_AXIS_HEAD].maximum_duty, largest);
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_INT32_WITHIN(robot.axes[i].deadband_ticks, rig.controller.plan.target_ticks[i],
                                 rig_position(&rig, i));
    }
}

/* Motors as far from their table as any may be: too slow, as it says, too fast. */
void test_SWR_MOTION_006_moves_by_magnitudes_are_done_in_time(void)
{
    static const double faster[] = {-1.0, 0.0, 1.0};
    for (uint32_t k = 0U; k < SCENES(sizeof faster / sizeof faster[0]); k++) {
        const double share = 1.0 + ((faster[k] * (double)LIMIT_MOTOR_SPREAD_PERCENT) / 100.0);
        start(&robot, share);
        for (uint32_t i = 0U; i < MOVES; i++) {
            uint32_t largest = 0U;
            begin_move(i + 1U);
            TEST_ASSERT_LESS_OR_EQUAL_UINT32(LIMIT_DONE_TIME_US / LIMIT_CYCLE_US,
                                             end_move(&largest));
            TEST_ASSERT_GREATER_THAN_UINT32(0U, largest);
        }
    }
}

void test_SWR_MOTION_022_a_motor_that_ignores_its_magnitude_is_found(void)
{
    start(&robot, 1.0);
    rig.box.axes[NEURO_AXIS_HEAD].motor.minimum_duty = 0.0;
    rig.box.axes[NEURO_AXIS_HEAD].motor.maximum_duty = 0.0;
    begin_move(1U);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 20000U).kind);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_WRONG_SPEED));
}

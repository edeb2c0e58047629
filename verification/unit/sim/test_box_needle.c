/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the needle of the box bends by its true insertion and rotation, images show its
 * tip in the z-frame, and orders change and state what bends it. */
#include "unity.h"

#include "robot/joints.h"
#include "robot/kinematics.h"
#include "robot/robot_neuro.h"
#include "robot/robot_prostate.h"
#include "sim/box.h"
#include "sim/box_needle.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define SURFACE_MM 30.0
#define KAPPA 0.0041
#define PI 3.14159265358979323846

static box_t box;
static char reply[BOX_REPLY_SIZE];

void setUp(void)
{
    box_init(&box, &robot_prostate, 1U);
}

void tearDown(void)
{
}

static void order(const char *line)
{
    TEST_ASSERT_TRUE_MESSAGE(box_command(&box, line, reply, sizeof reply), reply);
}

static void refused(const char *line)
{
    static box_t before;

    (void)memcpy(&before, &box, sizeof box);
    TEST_ASSERT_FALSE_MESSAGE(box_command(&box, line, reply, sizeof reply), line);
    TEST_ASSERT_EQUAL_MEMORY(&before, &box, sizeof box);
}

/* By hand, at 5 mm/s. */
static void go_to(double mm)
{
    const double way_mm = mm - box_depth_mm(&box);

    box_push(&box, way_mm);
    box_advance(&box, (uint32_t)(fabs(way_mm) / 5.0 * 1e6) + 1000U);
    TEST_ASSERT_DOUBLE_WITHIN(0.001, mm, box_depth_mm(&box));
}

static void turn_to(double deg)
{
    sim_motor_t *const motor = &box.axes[PROSTATE_AXIS_ROTATION].motor;
    const double radians_per_tick =
        (double)box.axes[PROSTATE_AXIS_ROTATION].config->unit_per_tick_q16 / 65536.0 * 2.0 * PI /
        4294967296.0;

    sim_motor_push(motor, deg * PI / 180.0 / radians_per_tick - motor->position_ticks);
    box_advance(&box, 1000U);
    TEST_ASSERT_DOUBLE_WITHIN(1e-3, deg * PI / 180.0, box_turn_rad(&box));
}

static double side_mm(double in_mm)
{
    return (1.0 - cos(KAPPA * in_mm)) / KAPPA;
}

void test_SWR_BOX_770_the_true_insertion_bends_it_beyond_the_surface(void)
{
    order("encoder insertion stuck");
    order("encoder rotation stuck");
    go_to(29.9);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, box_needle_tip(&box).place_mm.y);
    go_to(100.0);
    TEST_ASSERT_DOUBLE_WITHIN(0.001, -side_mm(70.0), box_needle_tip(&box).place_mm.y);
    TEST_ASSERT_DOUBLE_WITHIN(0.001, 0.0, box_needle_tip(&box).place_mm.x);
    go_to(29.9);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, box_needle_tip(&box).place_mm.y);
}

void test_SWR_BOX_770_the_true_rotation_says_where_to(void)
{
    order("encoder rotation stuck");
    turn_to(450.0);
    go_to(100.0);
    TEST_ASSERT_DOUBLE_WITHIN(0.02, side_mm(70.0), box_needle_tip(&box).place_mm.x);
    TEST_ASSERT_DOUBLE_WITHIN(0.02, 0.0, box_needle_tip(&box).place_mm.y);
}

void test_SWR_BOX_770_a_free_probe_is_the_needle(void)
{
    order("probe free");
    go_to(100.0);
    TEST_ASSERT_DOUBLE_WITHIN(0.001, -side_mm(70.0), box_needle_tip(&box).place_mm.y);
}

void test_SWR_BOX_770_a_robot_without_tissue_has_a_straight_needle(void)
{
    box_init(&box, &robot_neuro, 1U);
    go_to(20.0);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, box_needle_tip(&box).place_mm.x);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, box_needle_tip(&box).place_mm.y);
}

void test_SWR_BOX_771_the_base_is_ahead_by_the_torsion_of_the_order(void)
{
    order("needle torsion 45");
    go_to(130.0);
    turn_to(200.0);
    TEST_ASSERT_DOUBLE_WITHIN(0.001, PI / 4.0, box.force.bevel.lag_rad);
    order("needle torsion 0");
    turn_to(201.0);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, box.force.bevel.lag_rad);
}

void test_SWR_BOX_773_the_way_does_not_depend_on_the_strides_of_time(void)
{
    static box_t other;

    box_init(&other, &robot_prostate, 1U);
    box_push(&box, 120.0);
    box_push(&other, 120.0);
    box_advance(&box, 25000000U);
    for (uint32_t i = 0U; i < 25000U; i++) {
        box_advance(&other, 1000U);
    }
    TEST_ASSERT_EQUAL_MEMORY(&other.force.bevel, &box.force.bevel, sizeof box.force.bevel);
    TEST_ASSERT_EQUAL_UINT32(other.imager.last.number, box.imager.last.number);
    TEST_ASSERT_EQUAL_DOUBLE(other.imager.last.place_mm.x, box.imager.last.place_mm.x);
}

/* By the kinematics, of the robot as it stands. */
static rigid_t pose_now(bool is_straight)
{
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    joints_t joints;
    rigid_t pose;

    for (uint32_t i = 0U; i < robot_prostate.axis_count; i++) {
        ticks[i] = (int32_t)lround(box.axes[i].motor.position_ticks);
    }
    ticks[PROSTATE_AXIS_ROTATION] = is_straight ? 0 : ticks[PROSTATE_AXIS_ROTATION];
    joints_from_ticks(&robot_prostate, ticks, &joints);
    kinematics_forward(&robot_prostate, &robot_prostate.probe, &joints, &pose);
    return pose;
}

void test_SWR_BOX_775_an_image_of_a_straight_needle_is_the_pose_of_the_robot(void)
{
    order("needle curvature 0");
    order("images noise 0");
    order("images tilt 0");
    sim_motor_push(&box.axes[PROSTATE_AXIS_FRONT_LEFT].motor, 20000.0);
    go_to(100.0);
    box_advance(&box, 5000000U);
    const sim_image_t *const image = &box.imager.last;
    const rigid_t pose = pose_now(true);
    TEST_ASSERT_DOUBLE_WITHIN(0.001, pose.translation.x_nm / 1e6, image->place_mm.x);
    TEST_ASSERT_DOUBLE_WITHIN(0.001, pose.translation.y_nm / 1e6, image->place_mm.y);
    TEST_ASSERT_DOUBLE_WITHIN(0.001, pose.translation.z_nm / 1e6, image->place_mm.z);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, pose.rotation_q30[0][2] / 1073741824.0, image->direction.x);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, pose.rotation_q30[1][2] / 1073741824.0, image->direction.y);
    TEST_ASSERT_DOUBLE_WITHIN(1e-6, pose.rotation_q30[2][2] / 1073741824.0, image->direction.z);
    TEST_ASSERT_TRUE(fabs(image->direction.x) > 0.01);
}

void test_SWR_BOX_775_an_image_of_a_bent_needle_is_off_that_pose_to_where_it_bends(void)
{
    order("images noise 0");
    order("images tilt 0");
    order("needle torsion 0");
    turn_to(90.0);
    go_to(100.0);
    box_advance(&box, 5000000U);
    const rigid_t pose = pose_now(false);
    const double sagged_mm = (70.0 - sin(KAPPA * 70.0) / KAPPA);
    const double down[3] = {-pose.rotation_q30[0][1] / 1073741824.0,
                            -pose.rotation_q30[1][1] / 1073741824.0,
                            -pose.rotation_q30[2][1] / 1073741824.0};
    const double along[3] = {pose.rotation_q30[0][2] / 1073741824.0,
                             pose.rotation_q30[1][2] / 1073741824.0,
                             pose.rotation_q30[2][2] / 1073741824.0};
    const sim_vector_t place_mm = box.imager.last.place_mm;
    TEST_ASSERT_DOUBLE_WITHIN(
        0.05, pose.translation.x_nm / 1e6 + side_mm(70.0) * down[0] - sagged_mm * along[0],
        place_mm.x);
    TEST_ASSERT_DOUBLE_WITHIN(
        0.05, pose.translation.y_nm / 1e6 + side_mm(70.0) * down[1] - sagged_mm * along[1],
        place_mm.y);
    TEST_ASSERT_DOUBLE_WITHIN(
        0.05, pose.translation.z_nm / 1e6 + side_mm(70.0) * down[2] - sagged_mm * along[2],
        place_mm.z);
}

void test_SWR_BOX_776_orders_change_what_bends_the_needle_and_its_images(void)
{
    const sim_phantom_file_t *const phantom = &box.force.phantom;

    order("needle curvature 2200");
    TEST_ASSERT_EQUAL_DOUBLE(0.0022, phantom->needle.curvature_per_mm);
    order("needle torsion 20");
    TEST_ASSERT_EQUAL_DOUBLE(20.0, phantom->needle.torsion_deg_per_100_mm);
    order("images period 700");
    TEST_ASSERT_EQUAL_DOUBLE(700.0, phantom->images.period_ms);
    order("images delay 300");
    TEST_ASSERT_EQUAL_DOUBLE(300.0, phantom->images.delay_ms);
    order("images noise 250");
    TEST_ASSERT_EQUAL_DOUBLE(0.25, phantom->images.noise_mm);
    order("images tilt 125");
    TEST_ASSERT_EQUAL_DOUBLE(0.125, phantom->images.noise_deg);
    order("target usual");
    TEST_ASSERT_EQUAL_DOUBLE(100.0, phantom->target.depth_mm);
    order("target none");
    TEST_ASSERT_EQUAL_DOUBLE(0.0, phantom->target.depth_mm);
}

void test_SWR_BOX_776_wrong_orders_are_refused_and_change_nothing(void)
{
    static const char *const lines[] = {"needle",
                                        "needle curvature",
                                        "needle curvature -1",
                                        "needle curvature 20001",
                                        "needle torsion 91",
                                        "needle period 5",
                                        "needle curvature x",
                                        "needle show now",
                                        "images torsion 5",
                                        "images delay",
                                        "images delay 60001",
                                        "images noise 10001",
                                        "target",
                                        "target moving",
                                        "target none none",
                                        "needle bend 4"};

    for (uint32_t i = 0U; i < sizeof lines / sizeof lines[0]; i++) {
        refused(lines[i]);
    }
    refused("needle curvature 20001");
    TEST_ASSERT_NOT_NULL(strstr(reply, "takes a number from 0 to 20000 per km"));
}

/* Numbers behind `word` of the reply. */
static void expect_numbers(const char *word, const char *format, double within,
                           const double expected[3])
{
    const char *const at = strstr(reply, word);
    double read[3] = {0.0, 0.0, 0.0};

    TEST_ASSERT_NOT_NULL_MESSAGE(at, reply);
    TEST_ASSERT_EQUAL_INT_MESSAGE(3, sscanf(at, format, &read[0], &read[1], &read[2]), reply);
    for (uint32_t i = 0U; i < 3U; i++) {
        TEST_ASSERT_DOUBLE_WITHIN(within, expected[i], read[i]);
    }
}

void test_SWR_BOX_776_the_true_tip_target_and_image_are_stated(void)
{
    order("needle show");
    TEST_ASSERT_NOT_NULL(strstr(reply, "target: none\nimage: none\n"));
    order("target usual");
    order("images noise 0");
    go_to(100.0);
    box_advance(&box, 4000000U);
    order("needle show");
    const double tip[3] = {0.0, -side_mm(70.0), SURFACE_MM + sin(KAPPA * 70.0) / KAPPA};
    const double target[3] = {3.2, -2.4, 103.0};
    expect_numbers("tip:", "tip: %lf %lf mm off the line at %lf", 0.001, tip);
    expect_numbers("target:", "target: %lf %lf mm off the line at %lf", 0.001, target);
    rigid_t line;
    box_needle_line(&box, &line);
    const sim_vector_t at = box_needle_place(&line, (sim_vector_t){tip[0], tip[1], tip[2]});
    const double zframe[3] = {at.x, at.y, at.z};
    expect_numbers(" old, z-frame", " old, z-frame %lf %lf %lf", 0.001, zframe);
}

static double um(double mm)
{
    return mm * 1000.0;
}

void test_SWR_BOX_777_the_box_shows_the_true_needle_to_a_page(void)
{
    bsp_bench_t seen;

    order("target usual");
    order("images noise 0");
    turn_to(90.0);
    go_to(100.0);
    box_advance(&box, 3000000U);
    box_show(&box, &seen);
    TEST_ASSERT_EQUAL_UINT32(1U, seen.needle.is_seen);
    TEST_ASSERT_EQUAL_INT32(30000, seen.needle.surface_um);
    TEST_ASSERT_INT32_WITHIN(300, 90000, seen.needle.turn_mdeg);
    TEST_ASSERT_EQUAL_INT32(0, seen.needle.way[0].depth_um);
    const bsp_bench_point_t *const tip = &seen.needle.way[BSP_BENCH_WAY - 1U];
    TEST_ASSERT_INT32_WITHIN(40, (int32_t)um(side_mm(70.0)), tip->x_um);
    TEST_ASSERT_INT32_WITHIN(40, (int32_t)um(30.0 + sin(KAPPA * 70.0) / KAPPA), tip->depth_um);
    TEST_ASSERT_EQUAL_UINT32(1U, seen.needle.has_target);
    TEST_ASSERT_EQUAL_INT32(3200, seen.needle.target.x_um);
    TEST_ASSERT_EQUAL_INT32(103000, seen.needle.target.depth_um);
    TEST_ASSERT_TRUE(seen.needle.image > 0U);
    TEST_ASSERT_TRUE((seen.needle.image_age_ms >= 500U) && (seen.needle.image_age_ms < 2500U));
    TEST_ASSERT_INT32_WITHIN(1, tip->x_um, seen.needle.image_place.x_um);
    TEST_ASSERT_INT32_WITHIN(1, tip->depth_um, seen.needle.image_place.depth_um);
}

void test_SWR_BOX_777_without_tissue_no_needle_is_shown(void)
{
    bsp_bench_t seen;
    static const bsp_bench_needle_t nothing;

    go_to(100.0);
    order("tissue none");
    box_show(&box, &seen);
    TEST_ASSERT_EQUAL_MEMORY(&nothing, &seen.needle, sizeof nothing);
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the length of a needle is only compared with that of the robot; lengths of a
 * probe, depths of membranes and the zeroing of the force sensor go to the controller, and the
 * result back.
 */
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/workphase/workphase_dialect.h"
#include "unit/support/workphase_world.h"
#include "unity.h"

#include <stdio.h>

void setUp(void)
{
    world_start(IGTL_LANGUAGE_BRP_2021);
    snapshot.workphase = (uint32_t)WORKPHASE_MOVE_TO_TARGET;
}

void tearDown(void)
{
}

/* The needle of the robot is 259.075 mm long. */
static void say_length(const char *text)
{
    robot.reported_lengths[1] = (reported_length_t){"needle_length", 1, 2U};
    snapshot.has_probe = 1U;
    snapshot.probe_nm[1] = 259075000;
    say(0U, "NEEDLE_LENGTH", text);
    EXPECT_BEGIN(0U, "STRING ACK_NEEDLE_LENGTH ");
}

void test_SWR_IGTL_036_the_length_of_the_robots_needle_is_confirmed(void)
{
    static const char *const right[] = {"259.075", "259.175", "258.975", "259.1"};

    for (uint32_t i = 0U; i < 4U; i++) {
        say_length(right[i]);
        EXPECT(0U, "STATUS NEEDLE_LENGTH 1 NEEDLE_LENGTH|The robot is set to a needle of 259.075 "
                   "mm.");
    }
}

void test_SWR_IGTL_036_another_length_is_refused_with_that_of_the_robot(void)
{
    static const char *const wrong[] = {"259.18", "258.97", "150",        "",         "nan",
                                        "inf",    "1e999",  "259.075 mm", "-259.075", "needle"};

    for (uint32_t i = 0U; i < 10U; i++) {
        say_length(wrong[i]);
        EXPECT(0U,
               "STATUS NEEDLE_LENGTH 10 CONFIG_ERROR|CONFIG_ERROR: The robot is set to a needle "
               "of 259.075 mm.");
    }
    TEST_ASSERT_EQUAL_INT32(259075000, snapshot.probe_nm[1]);
    TEST_ASSERT_FALSE(workphase_dialect_is_controlled_by(&dialect, 0U));
    expect_no_command();
}

void test_SWR_IGTL_036_a_needle_that_is_not_known_is_compared_with_none(void)
{
    robot.reported_lengths[1] = (reported_length_t){"needle_length", 259075000, 2U};
    snapshot.has_probe = 0U;
    say(0U, "NEEDLE_LENGTH", "259.075");
    EXPECT_BEGIN(0U, "STRING ACK_NEEDLE_LENGTH ");
    EXPECT_BEGIN(0U, "STATUS NEEDLE_LENGTH 13 NO_PROBE|");
    moment.snapshot = NULL;
    say(0U, "NEEDLE_LENGTH", "259.075");
    EXPECT_BEGIN(0U, "STRING ACK_NEEDLE_LENGTH ");
    EXPECT_BEGIN(0U, "STATUS NEEDLE_LENGTH 7 NO_ANSWER|");
}

void test_SWR_IGTL_036_a_robot_without_a_length_does_not_know_the_question(void)
{
    say(0U, "NEEDLE_LENGTH", "150");
    EXPECT(0U, "STRING ACK_NEEDLE_LENGTH 150");
    EXPECT_BEGIN(0U, "STATUS NEEDLE_LENGTH 12 UNKNOWN_COMMAND|");
}

#define LENGTHS "treatment_to_tip 10 robot_to_entry 5 cannula_to_treatment 5 robot_to_treatment 41"

static const int32_t file_nm[] = {10000000, 5000000, 5000000, 41000000};

static void carry_probe(void)
{
    static const char *const names[] = {"treatment_to_tip", "robot_to_entry",
                                        "cannula_to_treatment", "robot_to_treatment"};

    robot.probe_length_count = 4U;
    for (uint32_t i = 0U; i < 4U; i++) {
        (void)snprintf(robot.probe_names[i], sizeof robot.probe_names[i], "%s", names[i]);
        robot.probe.length_nm[i] = file_nm[i];
    }
}

/* A probe that is sent arrives as lengths in nm. */
static void expect_probe(uint32_t count, const int32_t *length_nm)
{
    pass_us(0U);
    expect_command(COMMAND_PROBE, count);
    for (uint32_t i = 0U; i < count; i++) {
        TEST_ASSERT_EQUAL_INT32(length_nm[i], command.as.probe.lengths_nm[i]);
    }
    TEST_ASSERT_EQUAL_UINT32(NUMBER, command.peer);
}

void test_SWR_PROBE_006_lengths_are_passed_on_and_the_result_is_reported(void)
{
    static const int32_t first_nm[] = {10000000, 5250000, -5, 41000000};

    carry_probe();
    say(0U, "PROBE",
        "robot_to_entry 5.25  treatment_to_tip 10 cannula_to_treatment -0.000005 "
        "robot_to_treatment 4.1e1 ");
    expect_probe(4U, first_nm);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "STATUS PROBE 1 MOVE_TO_TARGET|");
    say(0U, "CMD_1", "PROBE " LENGTHS);
    EXPECT(0U, "STRING ACK_1 PROBE " LENGTHS);
    expect_probe(1U + 3U, file_nm);
    answer_to(&command, ANSWER_REFUSED, STATUS_PROBE_ORDER, 1U);
    EXPECT_BEGIN(0U, "STATUS PROBE 10 MOVE_TO_TARGET|PROBE_ORDER: ");
}

void test_SWR_IGTL_073_lengths_without_names_are_refused_with_the_form_that_is_taken(void)
{
    static const char *const wrong[] = {
        "10 5 5 41",
        "10",
        "",
        "treatment_to_tip 10",
        LENGTHS " treatment_to_tip 10",
        "needle_tip 10 robot_to_entry 5 cannula_to_treatment 5 robot_to_treatment 41"};

    carry_probe();
    for (uint32_t i = 0U; i < (sizeof wrong / sizeof wrong[0]); i++) {
        say(0U, "PROBE", wrong[i]);
        EXPECT(0U,
               "STATUS PROBE 10 PROBE_LENGTH|PROBE_LENGTH: Send each length by its name, in mm: "
               "PROBE " LENGTHS);
        expect_no_command();
    }
}

void test_SWR_PROBE_006_what_is_no_length_is_refused_and_not_passed_on(void)
{
    static const char *const wrong[] = {"nan", "10,5", "2000.1", "-2000.1",
                                        "inf", "1e99", "ten",    ""};

    carry_probe();
    for (uint32_t i = 0U; i < 8U; i++) {
        char text[80];
        (void)snprintf(text, sizeof text, "treatment_to_tip %s", wrong[i]);
        say(0U, "PROBE", text);
        EXPECT_BEGIN(0U, "STATUS PROBE 10 OUT_OF_RANGE|");
        expect_no_command();
    }
    say(0U, "PROBES", "10 5 5 41");
    EXPECT_BEGIN(0U, "STATUS PROBES 12 UNKNOWN_COMMAND|");
    say(0U, "CMD_1", "PROBES 10");
    EXPECT_BEGIN(0U, "STRING ACK_1 ");
    EXPECT_BEGIN(0U, "STATUS PROBES 10 12 UNKNOWN_COMMAND|");
    expect_no_command();
}

void test_SWR_PROBE_006_of_too_many_at_a_time_the_last_is_refused(void)
{
    carry_probe();
    for (uint32_t i = 0U; i < IGTL_REQUESTS_PER_PEER; i++) {
        say(0U, "PROBE", LENGTHS);
    }
    EXPECT(0U, "");
    say(0U, "PROBE", LENGTHS);
    EXPECT_BEGIN(0U, "STATUS PROBE 6 BUSY|");
}

static void expect_membranes(uint32_t count, const int32_t *depths_um)
{
    pass_us(0U);
    expect_command(COMMAND_MEMBRANES, count);
    for (uint32_t i = 0U; i < count; i++) {
        TEST_ASSERT_EQUAL_INT32(depths_um[i], command.as.membranes.depths_um[i]);
    }
}

void test_SWR_PUNCT_619_depths_are_passed_on_and_the_result_is_reported(void)
{
    static const int32_t depths_um[] = {12500, 30000, 41001};

    say(0U, "MEMBRANES", "12.5  30 41.0006 ");
    expect_membranes(3U, depths_um);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "STATUS MEMBRANES 1 MOVE_TO_TARGET|");
    say(0U, "CMD_1", "MEMBRANES 12.5");
    EXPECT(0U, "STRING ACK_1 MEMBRANES 12.5");
    expect_membranes(1U, depths_um);
    answer_to(&command, ANSWER_REFUSED, STATUS_MEMBRANE_DEPTH, 1U);
    EXPECT_BEGIN(0U, "STATUS MEMBRANES 10 MOVE_TO_TARGET|MEMBRANE_DEPTH: ");
    say(0U, "MEMBRANES", "");
    expect_membranes(0U, depths_um);
}

void test_SWR_PUNCT_619_no_list_of_depths_is_refused_and_not_passed_on(void)
{
    static const char *const wrong[] = {"nan", "10,5", "10 mm", "2000.1", "1 2 3 4 5 6 7 8 9"};

    for (uint32_t i = 0U; i < 5U; i++) {
        say(0U, "MEMBRANES", wrong[i]);
        EXPECT_BEGIN(0U, "STATUS MEMBRANES 10 OUT_OF_RANGE|");
        expect_no_command();
    }
}

static void expect_steering(steering_method_t method, uint32_t per_km, int32_t direction_deg)
{
    pass_us(0U);
    expect_command(COMMAND_STEER, per_km);
    TEST_ASSERT_EQUAL_UINT32(method, command.as.steering.method);
    TEST_ASSERT_EQUAL_INT32(direction_deg, command.as.steering.direction_deg);
}

void test_SWR_STEER_010_steering_is_passed_on_and_the_result_is_reported(void)
{
    say(0U, "STEER", "BIDIRECTIONAL 1.2 /m -90 deg");
    expect_steering(STEERING_BIDIRECTIONAL, 1200U, -90);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "STATUS STEER 1 MOVE_TO_TARGET|");
    say(0U, "CMD_1", "STEER UNIDIRECTIONAL 0 /m 360 deg");
    EXPECT(0U, "STRING ACK_1 STEER UNIDIRECTIONAL 0 /m 360 deg");
    expect_steering(STEERING_UNIDIRECTIONAL, 0U, 360);
    answer_to(&command, ANSWER_REFUSED, STATUS_STEERING_CURVATURE, 1U);
    EXPECT_BEGIN(0U, "STATUS STEER 10 MOVE_TO_TARGET|STEERING_CURVATURE: ");
    say(0U, "STEER", "NONE");
    expect_steering(STEERING_NONE, 0U, 0);
}

void test_SWR_STEER_010_no_steering_is_refused_and_not_passed_on(void)
{
    static const char *const wrong[] = {"BIDIRECTIONAL 1.2 /m 90",
                                        "BIDIRECTIONAL 1.2 90 deg",
                                        "BIDIRECTIONAL -0.1 /m 90 deg",
                                        "BIDIRECTIONAL 21 /m 90 deg",
                                        "BIDIRECTIONAL 1.2 /m 361 deg",
                                        "BIDIRECTIONAL nan /m 90 deg",
                                        "BIDIRECTIONAL 1.2 /m 90 deg 1",
                                        "NONE 1.2 /m 90 deg",
                                        "BOTH 1.2 /m 90 deg",
                                        ""};

    for (uint32_t i = 0U; i < (sizeof wrong / sizeof wrong[0]); i++) {
        say(0U, "STEER", wrong[i]);
        EXPECT_BEGIN(0U, "STATUS STEER ");
        expect_no_command();
    }
}

void test_SWR_IGTL_756_the_force_sensor_is_zeroed_and_the_result_is_reported(void)
{
    say(0U, "ZERO_FORCE", "");
    pass_us(0U);
    expect_command(COMMAND_ZERO_FORCE, 0U);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
    EXPECT(0U, "STATUS ZERO_FORCE 1 MOVE_TO_TARGET|");
    say(0U, "CMD_1", "ZERO_FORCE");
    EXPECT(0U, "STRING ACK_1 ZERO_FORCE");
    pass_us(0U);
    expect_command(COMMAND_ZERO_FORCE, 0U);
    answer_to(&command, ANSWER_REFUSED, STATUS_NEEDLE_IN, 1U);
    EXPECT_BEGIN(0U, "STATUS ZERO_FORCE 13 MOVE_TO_TARGET|NEEDLE_IN: ");
}

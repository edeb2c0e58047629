/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the last known position of the needle outlives a fault, and a reason names the
 * part that is in trouble.
 */
#include "unity.h"

#include "http/view/alarm_json.h"
#include "http/view/telemetry_json.h"
#include "http/view/telemetry_units.h"
#include "integration/support/rig.h"
#include "robot/robot_neuro.h"

#include <cjson/cJSON.h>
#include <string.h>

#include "integration/support/alarms_world.inc"

void setUp(void)
{
    (void)memset(&view, 0, sizeof view);
}

void tearDown(void)
{
    forget();
}

static bool is_true(const char *key)
{
    return cJSON_IsTrue(cJSON_GetObjectItem(needle, key)) != 0;
}

void test_SWR_HTTP_065_the_needle_stands_where_its_axis_stands(void)
{
    insert();
    TEST_ASSERT_EQUAL_STRING("insertion",
                             cJSON_GetStringValue(cJSON_GetObjectItem(needle, "axis")));
    TEST_ASSERT_TRUE(is_true("is_known"));
    TEST_ASSERT_TRUE(is_true("may_be_in"));
    TEST_ASSERT_EQUAL_DOUBLE(0.0, number_of(needle, "age_s"));
    TEST_ASSERT_EQUAL_DOUBLE(telemetry_units_position(&rig.robot.axes[NEURO_AXIS_INSERTION],
                                                      rig_position(&rig, NEURO_AXIS_INSERTION)),
                             number_of(needle, "position"));
    rig_box(&rig, "estop pull");
    run(200U);
    TEST_ASSERT_TRUE(is_true("is_known"));
    TEST_ASSERT_TRUE(is_true("may_be_in"));
    rig_start_homed(&rig);
    look();
    TEST_ASSERT_FALSE(is_true("may_be_in"));
}

void test_SWR_HTTP_065_after_a_fault_the_last_known_position_stays_and_ages(void)
{
    insert();
    const double before = number_of(needle, "position");
    rig_box(&rig, "card insertion silent");
    run(LIMIT_SILENT_KEPT_CYCLES + 2000U);
    TEST_ASSERT_FALSE(is_true("is_known"));
    TEST_ASSERT_TRUE(is_true("may_be_in"));
    TEST_ASSERT_DOUBLE_WITHIN(0.5, before, number_of(needle, "position"));
    TEST_ASSERT_DOUBLE_WITHIN(0.1, 2.0, number_of(needle, "age_s"));
    rig_box(&rig, "estop pull");
    run(1000U);
    TEST_ASSERT_DOUBLE_WITHIN(0.1, 3.0, number_of(needle, "age_s"));
    TEST_ASSERT_TRUE(is_true("may_be_in"));
}

void test_SWR_HTTP_065_counts_of_an_axis_that_was_never_homed_are_no_position(void)
{
    rig_start(&rig);
    rig_cycles(&rig, 100U);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    rig_press(&rig);
    run(500U);
    rig_box(&rig, "card insertion silent");
    run(500U);
    TEST_ASSERT_TRUE(cJSON_IsNull(cJSON_GetObjectItem(needle, "position")) != 0);
    TEST_ASSERT_TRUE(cJSON_IsNull(cJSON_GetObjectItem(needle, "age_s")) != 0);
    TEST_ASSERT_FALSE(is_true("is_known"));
    TEST_ASSERT_TRUE(is_true("may_be_in"));
}

void test_SWR_HTTP_065_a_fault_that_says_no_position_keeps_the_one_seen_before(void)
{
    insert();
    const double before = number_of(needle, "position");
    rig_box(&rig, "encoder insertion stuck");
    run(2000U);
    TEST_ASSERT_EQUAL_INT(0, find("AXIS_NO_COUNTS"));
    TEST_ASSERT_FALSE(is_true("is_known"));
    TEST_ASSERT_DOUBLE_WITHIN(1.0, before, number_of(needle, "position"));
}

void test_SWR_HTTP_066_a_reason_against_an_axis_names_the_part_that_is_in_trouble(void)
{
    static const char *const expected =
        "Card 3 (insertion) is lost. No frame of it came for several cycles: check its cable and "
        "its supply.";
    insert();
    rig_box(&rig, "card insertion silent");
    run(200U);
    cJSON *const motors = telemetry_json_motors(&view);
    const cJSON *axis = NULL;
    cJSON_ArrayForEach(axis, cJSON_GetObjectItem(motors, "axes"))
    {
        const cJSON *const reason = cJSON_GetArrayItem(
            cJSON_GetObjectItem(cJSON_GetObjectItem(axis, "permit"), "reasons"), 0);
        TEST_ASSERT_EQUAL_STRING("LINK_LOST",
                                 cJSON_GetStringValue(cJSON_GetObjectItem(reason, "name")));
        TEST_ASSERT_EQUAL_STRING(expected,
                                 cJSON_GetStringValue(cJSON_GetObjectItem(reason, "text")));
    }
    cJSON_Delete(motors);
}

void test_SWR_HTTP_066_the_fault_of_an_axis_is_reported_at_that_axis_alone(void)
{
    insert();
    rig_box(&rig, "encoder insertion stuck");
    run(1000U);
    cJSON *const motors = telemetry_json_motors(&view);
    const cJSON *axis = NULL;
    cJSON_ArrayForEach(axis, cJSON_GetObjectItem(motors, "axes"))
    {
        char *const permit = cJSON_PrintUnformatted(cJSON_GetObjectItem(axis, "permit"));
        const bool is_insertion =
            strcmp("insertion", cJSON_GetStringValue(cJSON_GetObjectItem(axis, "name"))) == 0;
        TEST_ASSERT_EQUAL(is_insertion, strstr(permit, "Axis insertion should have") != NULL);
        cJSON_free(permit);
    }
    cJSON_Delete(motors);
}

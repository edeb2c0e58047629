/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: only a sweep that was done is kept, with whose and when it is; one that was
 * damaged, or is of another robot, is not believed.
 */
#include "unity.h"

#include "base/crc.h"
#include "recording/write/sweep_keeper.h"
#include "robot/robot_prostate.h"
#include "sweep/sweep_curve.h"
#include "sweep/sweep_expected.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define UTC_US UINT64_C(1700000000123000)

static char folder[40];
static char path[80];
static robot_t robot;
static sweep_curve_t curve;
static sweep_keeper_t keeper;
static char text[SWEEP_TEXT_SIZE];

/* The events that a test says; the exchange has no others. */
static exchange_event_t ring[8];
static uint32_t ring_count;

uint32_t exchange_read_events(const exchange_t *self, uint32_t *next, exchange_event_t *events,
                              uint32_t most, uint32_t *lost)
{
    const uint32_t count = ring_count - *next;
    (void)self;
    *lost = 0U;
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(most, count);
    (void)memcpy(events, &ring[*next], count * sizeof ring[0]);
    *next += count;
    return count;
}

void setUp(void)
{
    (void)strcpy(folder, "/tmp/test-sweep-XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    (void)snprintf(path, sizeof path, "%s/sweep-prostate.csv", folder);
    robot = robot_prostate;
    keeper = (sweep_keeper_t){.directory = folder, .robot = &robot};
    ring_count = 0U;
}

void tearDown(void)
{
    (void)unlink(path);
    (void)rmdir(folder);
}

static exchange_event_t event_of(event_id_t id, int32_t value)
{
    return (exchange_event_t){
        .event = {.id = (uint32_t)id, .subject = PROSTATE_AXIS_ROTATION, .value = value},
        .utc_us = UTC_US};
}

static void hear(event_id_t id, int32_t value)
{
    const exchange_event_t event = event_of(id, value);
    TEST_ASSERT_TRUE(sweep_keeper_hear(&keeper, &event, 0U));
}

static void hear_point(int32_t hertz, int32_t up_ticks, int32_t down_ticks)
{
    hear(EVENT_SWEEP_WORD, hertz);
    hear(EVENT_SWEEP_UPWARDS, up_ticks);
    hear(EVENT_SWEEP_WORD, hertz);
    hear(EVENT_SWEEP_DOWNWARDS, down_ticks);
}

static void hear_sweep(void)
{
    hear(EVENT_SWEEP_BEGUN, 0);
    hear(EVENT_SWEEP_WORD, 55000);
    hear_point(53923, 5, 6);
    hear(EVENT_PEDAL_RELEASED, 0);
    hear_point(51600, 3138, 3123);
}

static void expect_kept(sweep_kept_t kept)
{
    TEST_ASSERT_EQUAL(kept, sweep_curve_find(&curve, &robot, folder, text));
}

static void write_text(const char *mode, const char *bytes)
{
    FILE *file = fopen(path, mode);
    TEST_ASSERT_NOT_NULL(file);
    (void)fputs(bytes, file);
    (void)fclose(file);
}

void test_SWR_SWEEP_010_a_sweep_that_was_done_is_kept_with_whose_and_when_it_is(void)
{
    expect_kept(SWEEP_KEPT_NONE);
    hear_sweep();
    expect_kept(SWEEP_KEPT_NONE);
    hear(EVENT_SWEEP_ENDED, (int32_t)SWEEP_END_SPEED);
    expect_kept(SWEEP_KEPT_GOOD);
    TEST_ASSERT_EQUAL_STRING("prostate", curve.robot);
    TEST_ASSERT_EQUAL_STRING("rotation", curve.axis);
    TEST_ASSERT_EQUAL_HEX32(robot.crc, curve.robot_crc);
    TEST_ASSERT_EQUAL_UINT32(robot.card_firmware, curve.card_firmware);
    TEST_ASSERT_EQUAL_UINT64(UTC_US, curve.ended_us);
    TEST_ASSERT_EQUAL_UINT32(SWEEP_END_SPEED, curve.end);
    TEST_ASSERT_EQUAL_UINT32(2U, curve.count);
    TEST_ASSERT_EQUAL_INT32(53923, curve.points[0].hertz);
    TEST_ASSERT_EQUAL_INT32(6, curve.points[0].down_ticks);
    TEST_ASSERT_EQUAL_INT32(3138, curve.points[1].up_ticks);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, "\n51600,3138,3123,22.593,22.485\n"), text);
    TEST_ASSERT_NOT_NULL(strstr(text, " SPEED\n"));
}

void test_SWR_SWEEP_010_a_sweep_that_was_not_done_or_not_heard_is_not_kept(void)
{
    hear_point(53923, 5, 6);
    hear(EVENT_SWEEP_ENDED, 0);
    expect_kept(SWEEP_KEPT_NONE);
    hear_sweep();
    const exchange_event_t late = event_of(EVENT_SWEEP_ENDED, 0);
    TEST_ASSERT_TRUE(sweep_keeper_hear(&keeper, &late, 3U));
    expect_kept(SWEEP_KEPT_NONE);
    exchange_event_t strange = event_of(EVENT_SWEEP_BEGUN, 0);
    strange.event.subject = ROBOT_AXIS_MAX;
    TEST_ASSERT_TRUE(sweep_keeper_hear(&keeper, &strange, 0U));
    hear(EVENT_SWEEP_ENDED, 0);
    expect_kept(SWEEP_KEPT_NONE);
}

void test_SWR_SWEEP_010_points_of_a_sweep_that_was_given_up_are_forgotten(void)
{
    hear_sweep();
    hear_sweep();
    for (uint32_t i = 0U; i < LIMIT_SWEEP_POINTS; i++) {
        hear_point(50000, 1, 2);
    }
    hear(EVENT_SWEEP_ENDED, (int32_t)SWEEP_END_POINTS);
    expect_kept(SWEEP_KEPT_GOOD);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_SWEEP_POINTS, curve.count);
    TEST_ASSERT_EQUAL_INT32(53923, curve.points[0].hertz);
    TEST_ASSERT_EQUAL_INT32(50000, curve.points[2].hertz);
}

void test_SWR_SWEEP_010_what_the_exchange_has_is_heard_and_a_full_disk_is_reported(void)
{
    ring[0] = event_of(EVENT_SWEEP_BEGUN, 0);
    ring[1] = event_of(EVENT_SWEEP_ENDED, 0);
    ring_count = 2U;
    sweep_keeper_drain(&keeper, NULL);
    TEST_ASSERT_EQUAL_UINT32(2U, keeper.next);
    expect_kept(SWEEP_KEPT_GOOD);
    TEST_ASSERT_EQUAL_UINT32(0U, curve.count);
    keeper.directory = "/nowhere/at/all";
    keeper.next = 0U;
    sweep_keeper_drain(&keeper, NULL);
    keeper.is_gathering = true;
    TEST_ASSERT_FALSE(sweep_keeper_hear(&keeper, &ring[1], 0U));
}

void test_SWR_SWEEP_011_each_changed_byte_is_damage(void)
{
    hear_sweep();
    hear(EVENT_SWEEP_ENDED, 0);
    expect_kept(SWEEP_KEPT_GOOD);
    char whole[SWEEP_TEXT_SIZE];
    (void)strcpy(whole, text);
    for (size_t i = 0U; whole[i] != '\0'; i++) {
        char changed[SWEEP_TEXT_SIZE];
        (void)strcpy(changed, whole);
        changed[i] ^= 1;
        TEST_ASSERT_EQUAL(SWEEP_KEPT_DAMAGED, sweep_curve_read(&curve, &robot, changed));
        changed[i] = '\0';
        TEST_ASSERT_EQUAL(SWEEP_KEPT_DAMAGED, sweep_curve_read(&curve, &robot, changed));
    }
    write_text("a", "\n");
    expect_kept(SWEEP_KEPT_DAMAGED);
    TEST_ASSERT_EQUAL_STRING("", text);
}

void test_SWR_SWEEP_011_a_file_of_another_form_or_none_is_damage(void)
{
    char other[128] = "# robot prostate\n";
    const uint32_t crc = crc32c((const uint8_t *)other, strlen(other));
    (void)snprintf(&other[strlen(other)], 64U, "# crc32c %08x\n", (unsigned)crc);
    write_text("w", other);
    expect_kept(SWEEP_KEPT_DAMAGED);
    write_text("w", "");
    expect_kept(SWEEP_KEPT_DAMAGED);
    (void)unlink(path);
    TEST_ASSERT_EQUAL_INT(0, mkdir(path, 0700));
    expect_kept(SWEEP_KEPT_DAMAGED);
    (void)rmdir(path);
    TEST_ASSERT_EQUAL_INT(0, symlink("/dev/zero", path));
    expect_kept(SWEEP_KEPT_DAMAGED);
}

void test_SWR_SWEEP_011_a_curve_of_another_robot_or_file_is_reported_as_that(void)
{
    hear_sweep();
    hear(EVENT_SWEEP_ENDED, 0);
    robot.crc ^= 1U;
    expect_kept(SWEEP_KEPT_OTHER_ROBOT);
    TEST_ASSERT_EQUAL_STRING("", text);
    robot.crc ^= 1U;
    (void)strcpy(robot.axes[PROSTATE_AXIS_ROTATION].name, "turn");
    expect_kept(SWEEP_KEPT_OTHER_ROBOT);
    TEST_ASSERT_EQUAL_size_t(0U, sweep_curve_write(&curve, &robot, text));
}

void test_SWR_SWEEP_011_the_file_of_the_robot_says_what_is_expected_of_its_own_words(void)
{
    const axis_config_t *const axis = &robot.axes[PROSTATE_AXIS_ROTATION];
    double expected = -1.0;
    TEST_ASSERT_FALSE(sweep_expected(axis, 53000, &expected));
    TEST_ASSERT_TRUE(sweep_expected(axis, 51600, &expected));
    TEST_ASSERT_DOUBLE_WITHIN(0.05, 1928.0 * 0.325 * 60.0 / 1666.74, expected);
    TEST_ASSERT_DOUBLE_WITHIN(0.01, 12.0, sweep_curve_turns_per_min(axis, 1667));
}

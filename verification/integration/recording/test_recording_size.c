/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a recording grows no faster than its limits, whatever the robot, and what was
 * recorded is replayed from the file, every output equal.
 */
#include "integration/support/recorded.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "limits/requirement_limits.h"
#include "recording/format/cycle_code.h"
#include "recording/read/recording_reader.h"
#include "replay/verify/replay.h"
#include "robot/robot_neuro.h"

#include <stdio.h>
#include <unistd.h>

static char path[64];
static rig_t rig;
static recorded_t recorded;
static recording_reader_t reader;
static recording_finding_t finding;
static cycle_record_t record;
static cycle_known_t known;
static replay_t replay;

void setUp(void)
{
    (void)snprintf(path, sizeof path, "/tmp/test-recording-size-%d.bsr", (int)getpid());
}

void tearDown(void)
{
    recording_reader_close(&reader);
    (void)unlink(path);
}

static void replay_file(const robot_t *robot)
{
    TEST_ASSERT_TRUE(recorded_end(&recorded));
    TEST_ASSERT_EQUAL_MESSAGE(RECORDING_WHOLE, recording_reader_open(&reader, path, &finding),
                              finding.sentence);
    replay_init(&replay);
    while (recording_reader_next(&reader, &record, &known)) {
        TEST_ASSERT_TRUE(replay_take(&replay, robot, &record, &known));
    }
    TEST_ASSERT_EQUAL_UINT64(recorded.cycles, replay.replayed);
    TEST_ASSERT_EQUAL_UINT64(0U, replay.unreplayed);
    recording_reader_close(&reader);
}

static void expect_at_most(const robot_t *robot, const char *what, uint32_t limit_mb_per_h)
{
    const double grown = recorded_mb_per_h(&recorded);
    char text[128];

    (void)snprintf(text, sizeof text, "%s %s: %.1f MB an hour of %u", robot->name, what, grown,
                   (unsigned)limit_mb_per_h);
    TEST_ASSERT_TRUE_MESSAGE(grown <= (double)limit_mb_per_h, text);
}

static void record_rest(const robot_t *robot)
{
    recorded_rest(&recorded, &rig, robot, path);
    expect_at_most(robot, "at rest", LIMIT_RECORDING_REST_MB_PER_H);
    replay_file(robot);
}

static void record_homing(const robot_t *robot)
{
    recorded_homing(&recorded, &rig, robot, path);
    expect_at_most(robot, "while it homes", LIMIT_RECORDING_MOTION_MB_PER_H);
    replay_file(robot);
}

void test_SWR_REC_004_every_robot_leaves_little_at_rest(void)
{
    TEST_ASSERT_GREATER_THAN_UINT32(1U, recorded_each_robot(record_rest));
}

void test_SWR_REC_005_every_robot_leaves_little_while_it_homes(void)
{
    TEST_ASSERT_GREATER_THAN_UINT32(1U, recorded_each_robot(record_homing));
}

void test_SWR_REC_005_a_move_to_a_target_leaves_little(void)
{
    recorded_move(&recorded, &rig, path);
    expect_at_most(&robot_neuro, "in a move", LIMIT_RECORDING_MOTION_MB_PER_H);
    replay_file(&robot_neuro);
}

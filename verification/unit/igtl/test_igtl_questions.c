/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: every question has an answer that says what is true, nothing of it commands,
 * what was not asked for is not sent, and a force is a number only while it is believed.
 */
#include "base/rigid.h"
#include "charts/arming_chart.h"
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_questions.h"
#include "interface/force_doubt.h"
#include "interface/snapshot.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "robot/robot_prostate.h"
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_outbox.h"
#include "unit/support/igtl_peer.h"
#include "unity.h"

#include <string.h>

#define EXPECT(expected) TEST_ASSERT_EQUAL_STRING((expected), igtl_peer_next(&outbox))
#define EXPECT_BEGIN(expected)                                                                     \
    TEST_ASSERT_EQUAL_STRING_LEN((expected), igtl_peer_next(&outbox), strlen(expected))
#define ALL_DOUBTS ((UINT32_C(1) << (uint32_t)FORCE_DOUBT_COUNT) - 1U)

static igtl_tracking_t tracking;
static igtl_outbox_t outbox;
static igtl_asker_t asker;
static snapshot_t snapshot;
static igtl_moment_t moment;

void setUp(void)
{
    (void)memset(&snapshot, 0, sizeof snapshot);
    (void)memset(&tracking, 0, sizeof tracking);
    asker = (igtl_asker_t){&outbox, IGTL_LANGUAGE_CRTK, &robot_neuro};
    rigid_set_identity(&snapshot.scanner_treatment);
    moment = (igtl_moment_t){.now_us = 1000000U, .snapshot = &snapshot};
    igtl_outbox_init(&outbox);
}

void tearDown(void)
{
}

static void pass_us(uint64_t time_us)
{
    moment.now_us += time_us;
    igtl_questions_step(&tracking, &outbox, &moment);
}

static bool ask(igtl_kind_t kind, const char *type, const char *name)
{
    igtl_message_t question = igtl_peer_query(kind, name);

    (void)snprintf(question.type, sizeof question.type, "%s", type);
    return igtl_questions_receive(&tracking, &asker, &question, &moment);
}

static void track(int32_t resolution_ms)
{
    igtl_message_t start = igtl_peer_query(IGTL_KIND_STT_TDATA, "probe");

    (void)strcpy(start.type, "STT_TDATA");
    start.resolution_ms = resolution_ms;
    TEST_ASSERT_TRUE(igtl_questions_receive(&tracking, &asker, &start, &moment));
    EXPECT("RTS_TDATA probe 0");
}

static void command(uint32_t id, const char *name)
{
    igtl_message_t message = igtl_peer_query(IGTL_KIND_COMMAND, "peer");

    message.code = id;
    message.subject = name;
    message.subject_bytes = (uint32_t)strlen(name);
    TEST_ASSERT_TRUE(igtl_questions_receive(&tracking, &asker, &message, &moment));
}

void test_SWR_IGTL_041_the_types_that_are_understood_are_named(void)
{
    TEST_ASSERT_TRUE(ask(IGTL_KIND_GET_CAPABILITY, "GET_CAPABIL", "who"));
    EXPECT("CAPABILITY who TRANSFORM STRING STATUS GET_TRANS GET_STATUS GET_CAPABIL GET_SENSOR "
           "STT_TDATA "
           "STP_TDATA COMMAND GET_POINT TRAJ");
}

void test_SWR_IGTL_041_a_port_names_only_what_it_answers(void)
{
    static const igtl_language_t languages[] = {IGTL_LANGUAGE_BRP_2013, IGTL_LANGUAGE_BRP_2021};

    for (uint32_t i = 0U; i < 2U; i++) {
        asker.language = languages[i];
        TEST_ASSERT_TRUE(ask(IGTL_KIND_GET_CAPABILITY, "GET_CAPABIL", "who"));
        EXPECT("CAPABILITY who NDARRAY TRANSFORM STRING STATUS GET_TRANS GET_STATUS GET_CAPABIL "
               "GET_SENSOR STT_TDATA STP_TDATA COMMAND");
        command(1U, "Capabilities");
        EXPECT(
            "RTS_COMMAND peer 1 Capabilities <Capabilities Types=\"NDARRAY TRANSFORM STRING "
            "STATUS GET_TRANS GET_STATUS GET_CAPABIL GET_SENSOR STT_TDATA STP_TDATA COMMAND\"/>");
    }
}

void test_SWR_IGTL_041_what_there_is_not_is_answered_by_a_status(void)
{
    TEST_ASSERT_TRUE(ask(IGTL_KIND_GET_OTHER, "GET_IMAGE", "T1"));
    EXPECT("STATUS T1 4 NOT_FOUND|NOT_FOUND: There is nothing of this name.");
    TEST_ASSERT_TRUE(ask(IGTL_KIND_GET_POINT, "GET_POINT", ""));
    EXPECT("STATUS  4 NOT_FOUND|NOT_FOUND: There is nothing of this name.");
    EXPECT("");
}

void test_SWR_IGTL_041_other_streams_are_refused_by_their_own_name(void)
{
    TEST_ASSERT_TRUE(ask(IGTL_KIND_STT_OTHER, "STT_QTDATA", "probe"));
    EXPECT("RTS_QTDATA probe 1");
    TEST_ASSERT_TRUE(ask(IGTL_KIND_STP_OTHER, "STP_POLYDATA", "probe"));
    EXPECT("RTS_POLYDATA probe 1");
    pass_us(LIMIT_IGTL_TRACKING_MOST_US);
    EXPECT("");
}

void test_SWR_IGTL_041_other_messages_are_left_to_the_dialect(void)
{
    TEST_ASSERT_FALSE(ask(IGTL_KIND_STATUS, "STATUS", "hello"));
    TEST_ASSERT_FALSE(ask(IGTL_KIND_TRANSFORM, "TRANSFORM", "TGT_1"));
    TEST_ASSERT_FALSE(ask(IGTL_KIND_OTHER, "IMAGE", "T1"));
    EXPECT("");
}

void test_SWR_IGTL_042_nothing_is_tracked_before_it_is_asked_for(void)
{
    pass_us(LIMIT_IGTL_TRACKING_MOST_US);
    EXPECT("");
}

void test_SWR_IGTL_042_the_needle_comes_in_the_interval_that_was_asked_for(void)
{
    track(50);
    snapshot.scanner_treatment.translation.x_nm = 1000000;
    pass_us(0U);
    EXPECT("TDATA probe 1.000 0.000 0.000");
    pass_us(49999U);
    EXPECT("");
    snapshot.scanner_treatment.translation.x_nm = 2000000;
    pass_us(1U);
    EXPECT("TDATA probe 2.000 0.000 0.000");
}

void test_SWR_IGTL_042_an_interval_has_its_bounds(void)
{
    static const struct {
        int32_t asked_ms;
        uint32_t got_us;
    } cases[] = {{0, LIMIT_IGTL_TRACKING_LEAST_US},
                 {-1, LIMIT_IGTL_TRACKING_LEAST_US},
                 {INT32_MIN, LIMIT_IGTL_TRACKING_LEAST_US},
                 {19, LIMIT_IGTL_TRACKING_LEAST_US},
                 {21, 21000U},
                 {999, 999000U},
                 {1001, LIMIT_IGTL_TRACKING_MOST_US},
                 {INT32_MAX, LIMIT_IGTL_TRACKING_MOST_US}};

    for (uint32_t i = 0U; i < (sizeof cases / sizeof cases[0]); i++) {
        track(cases[i].asked_ms);
        pass_us(0U);
        EXPECT("TDATA probe 0.000 0.000 0.000");
        pass_us(cases[i].got_us - 1U);
        EXPECT("");
        pass_us(1U);
        EXPECT("TDATA probe 0.000 0.000 0.000");
    }
}

void test_SWR_IGTL_042_who_stops_is_sent_no_more(void)
{
    track(0);
    pass_us(0U);
    EXPECT("TDATA probe 0.000 0.000 0.000");
    TEST_ASSERT_TRUE(ask(IGTL_KIND_STP_TDATA, "STP_TDATA", "probe"));
    EXPECT("RTS_TDATA probe 0");
    pass_us(LIMIT_IGTL_TRACKING_MOST_US);
    EXPECT("");
}

void test_SWR_IGTL_014_no_pose_is_tracked_that_is_not_known(void)
{
    snapshot.pose_status = (uint32_t)STATUS_NOT_HOMED;
    track(0);
    pass_us(0U);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS probe 13 NOT_HOMED|", igtl_peer_next(&outbox), 26U);
    pass_us(LIMIT_IGTL_TRACKING_MOST_US);
    EXPECT("");
    snapshot.pose_status = (uint32_t)STATUS_NOT_REGISTERED;
    pass_us(1U);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS probe 13 NOT_REGISTERED|", igtl_peer_next(&outbox), 31U);
    snapshot.pose_status = (uint32_t)STATUS_OK;
    pass_us(1U);
    EXPECT("TDATA probe 0.000 0.000 0.000");
    snapshot.pose_status = (uint32_t)STATUS_NOT_HOMED;
    pass_us(1U);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS probe 13 NOT_HOMED|", igtl_peer_next(&outbox), 26U);
    moment.snapshot = NULL;
    pass_us(1U);
    TEST_ASSERT_EQUAL_STRING_LEN("STATUS probe 7 NO_ANSWER|", igtl_peer_next(&outbox), 25U);
    EXPECT("");
}

void test_SWR_IGTL_043_status_is_answered_with_the_same_id_and_name(void)
{
    snapshot.workphase = (uint32_t)WORKPHASE_MANUAL;
    snapshot.pose_status = (uint32_t)STATUS_NOT_REGISTERED;
    snapshot.is_homed = 1U;
    command(7U, "Status");
    EXPECT("RTS_COMMAND peer 7 Status <Status Workphase=\"MANUAL\" Pose=\"NOT_REGISTERED\" "
           "Homed=\"1\" Registered=\"0\" Target=\"0\" Moving=\"0\"/>");
    snapshot.pose_status = (uint32_t)STATUS_OK;
    snapshot.is_registered = 1U;
    snapshot.has_target = 1U;
    snapshot.order = (uint32_t)ARMING_STATE_MOVING;
    command(8U, "Status");
    EXPECT("RTS_COMMAND peer 8 Status <Status Workphase=\"MANUAL\" Pose=\"OK\" "
           "Homed=\"1\" Registered=\"1\" Target=\"1\" Moving=\"1\"/>");
    moment.snapshot = NULL;
    command(9U, "Status");
    EXPECT("RTS_COMMAND peer 9 Status <Status Pose=\"NO_ANSWER\"/>");
}

void test_SWR_IGTL_043_capabilities_are_answered(void)
{
    command(1U, "Capabilities");
    EXPECT("RTS_COMMAND peer 1 Capabilities <Capabilities Types=\"TRANSFORM STRING STATUS "
           "GET_TRANS GET_STATUS GET_CAPABIL GET_SENSOR STT_TDATA STP_TDATA COMMAND GET_POINT "
           "TRAJ\"/>");
}

void test_SWR_IGTL_043_every_other_command_is_not_supported(void)
{
    static const char *const names[] = {"START_UP", "MOVE_TO_TARGET", "status", "Statu", ""};

    for (uint32_t i = 0U; i < (sizeof names / sizeof names[0]); i++) {
        command(5U, names[i]);
        TEST_ASSERT_NOT_NULL(
            strstr(igtl_peer_next(&outbox), "<Unsupported Known=\"Status Capabilities\"/>"));
    }
    EXPECT("");
}

static uint32_t count_of(const uint8_t *bytes, uint32_t length, const char *text)
{
    uint32_t count = 0U;

    for (uint32_t i = 0U; (i + strlen(text)) <= length; i++) {
        count += (memcmp(&bytes[i], text, strlen(text)) == 0) ? 1U : 0U;
    }
    return count;
}

void test_SWR_IGTL_043_the_metadata_say_whether_it_was_answered(void)
{
    static const char *const names[] = {"Status", "STOP"};
    static const char *const verdicts[] = {"StatusSUCCESS", "StatusFAIL"};

    for (uint32_t i = 0U; i < 2U; i++) {
        uint32_t length;
        const uint8_t *bytes;

        command(1U, names[i]);
        bytes = igtl_outbox_next(&outbox, &length);
        TEST_ASSERT_EQUAL_UINT32(1U, count_of(bytes, length, verdicts[i]));
        igtl_outbox_advance(&outbox, length);
    }
}

/* The robot with a force sensor, both forces believed. */
static void feel(void)
{
    asker.robot = &robot_prostate;
    snapshot.forces[FORCE_CHANNEL_HAND].force_mn = 1250;
    snapshot.forces[FORCE_CHANNEL_NEEDLE].force_mn = -75;
}

static void ask_force(const char *name)
{
    const igtl_message_t question = igtl_peer_query(IGTL_KIND_GET_SENSOR, name);

    TEST_ASSERT_TRUE(igtl_questions_receive(&tracking, &asker, &question, &moment));
}

static void doubt(uint32_t channel, force_doubt_t doubt)
{
    snapshot.forces[channel].doubts |= UINT32_C(1) << (uint32_t)doubt;
}

void test_SWR_IGTL_610_a_force_is_sent_in_newton_on_request(void)
{
    static const igtl_language_t languages[] = {IGTL_LANGUAGE_BRP_2013, IGTL_LANGUAGE_BRP_2021,
                                                IGTL_LANGUAGE_CRTK};

    feel();
    for (uint32_t i = 0U; i < 3U; i++) {
        asker.language = languages[i];
        ask_force("FORCE_HAND");
        EXPECT("SENSOR FORCE_HAND 1 x 1.250");
        ask_force("FORCE_NEEDLE");
        EXPECT("SENSOR FORCE_NEEDLE 1 x -0.075");
        EXPECT("");
    }
}

void test_SWR_IGTL_610_without_a_name_both_are_sent(void)
{
    feel();
    ask_force("");
    EXPECT("SENSOR FORCE_HAND 1 x 1.250");
    EXPECT("SENSOR FORCE_NEEDLE 1 x -0.075");
    EXPECT("");
}

void test_SWR_IGTL_610_nothing_is_sent_of_another_name(void)
{
    feel();
    ask_force("FORCE");
    EXPECT("STATUS FORCE 4 NOT_FOUND|NOT_FOUND: There is nothing of this name.");
    EXPECT("");
}

void test_SWR_IGTL_611_a_doubtful_force_is_no_number(void)
{
    feel();
    doubt(FORCE_CHANNEL_HAND, FORCE_DOUBT_NOT_ZEROED);
    ask_force("");
    EXPECT_BEGIN("STATUS FORCE_HAND 13 FORCE_DOUBTFUL|NOT_ZEROED: Its zero was not taken");
    EXPECT("SENSOR FORCE_NEEDLE 1 x -0.075");
    EXPECT("");
}

void test_SWR_IGTL_611_each_doubt_by_itself_keeps_a_force_back(void)
{
    feel();
    for (uint32_t i = 0U; i < (uint32_t)FORCE_DOUBT_COUNT; i++) {
        snapshot.forces[FORCE_CHANNEL_NEEDLE].doubts = UINT32_C(1) << i;
        ask_force("FORCE_NEEDLE");
        EXPECT_BEGIN("STATUS FORCE_NEEDLE 13 FORCE_DOUBTFUL|");
        EXPECT("");
    }
}

void test_SWR_IGTL_611_all_doubts_are_named_as_far_as_there_is_room(void)
{
    feel();
    doubt(FORCE_CHANNEL_HAND, FORCE_DOUBT_STALE);
    doubt(FORCE_CHANNEL_HAND, FORCE_DOUBT_STEP);
    ask_force("FORCE_HAND");
    EXPECT_BEGIN("STATUS FORCE_HAND 13 FORCE_DOUBTFUL|STALE, STEP: No report of it comes");
    snapshot.forces[FORCE_CHANNEL_HAND].doubts = ALL_DOUBTS;
    ask_force("FORCE_HAND");
    EXPECT_BEGIN(
        "STATUS FORCE_HAND 13 FORCE_DOUBTFUL|NOT_ZEROED, STALE, STUCK, OUT_OF_RANGE, STEP");
    EXPECT("");
}

void test_SWR_IGTL_611_a_robot_without_a_sensor_refuses(void)
{
    feel();
    asker.robot = &robot_neuro;
    ask_force("FORCE_HAND");
    EXPECT("STATUS FORCE_HAND 10 NO_FORCE_SENSOR|NO_FORCE_SENSOR: The robot has no force sensor.");
    EXPECT("");
}

void test_SWR_IGTL_611_while_control_is_silent_no_force_is_known(void)
{
    feel();
    moment.snapshot = NULL;
    ask_force("FORCE_NEEDLE");
    EXPECT_BEGIN("STATUS FORCE_NEEDLE 7 NO_ANSWER|");
    EXPECT("");
}

void test_SWR_IGTL_612_the_status_has_the_forces_or_their_doubts(void)
{
    feel();
    command(1U, "Status");
    TEST_ASSERT_NOT_NULL(strstr(igtl_peer_next(&outbox),
                                " Moving=\"0\" ForceHand=\"1.250\" ForceNeedle=\"-0.075\" "));
    doubt(FORCE_CHANNEL_HAND, FORCE_DOUBT_BROKEN_WIRE);
    doubt(FORCE_CHANNEL_HAND, FORCE_DOUBT_ZERO_WANDERED);
    command(1U, "Status");
    TEST_ASSERT_NOT_NULL(
        strstr(igtl_peer_next(&outbox), " ForceHand=\"BROKEN_WIRE\" ForceNeedle=\"-0.075\" "));
    asker.robot = &robot_neuro;
    command(1U, "Status");
    TEST_ASSERT_NOT_NULL(strstr(igtl_peer_next(&outbox), " Moving=\"0\"/>"));
}

void test_SWR_IGTL_757_the_status_says_whether_a_puncture_can_be_found(void)
{
    feel();
    command(1U, "Status");
    TEST_ASSERT_NOT_NULL(strstr(igtl_peer_next(&outbox), "\" Sight=\"OFF\"/>"));
    snapshot.membranes.sight = (uint32_t)MEMBRANE_SIGHT_VIBRATING;
    command(1U, "Status");
    TEST_ASSERT_NOT_NULL(strstr(igtl_peer_next(&outbox), "\" Sight=\"VIBRATING\"/>"));
    asker.robot = &robot_neuro;
    command(1U, "Status");
    TEST_ASSERT_NULL(strstr(igtl_peer_next(&outbox), "Sight"));
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a force is sent to who asks for it, in newton, while it is believed; otherwise
 * the reason, and no number.
 */
#include "igtl/dialect/igtl_questions.h"
#include "interface/force_doubt.h"
#include "interface/snapshot.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "robot/robot_prostate.h"
#include "unit/support/igtl_peer.h"
#include "unity.h"

#include <string.h>

#define EXPECT(expected) TEST_ASSERT_EQUAL_STRING((expected), igtl_peer_next(&outbox))
#define EXPECT_BEGIN(expected)                                                                     \
    TEST_ASSERT_EQUAL_STRING_LEN((expected), igtl_peer_next(&outbox), strlen(expected))
#define ALL_DOUBTS ((UINT32_C(1) << (uint32_t)FORCE_DOUBT_COUNT) - 1U)

static igtl_outbox_t outbox;
static igtl_asker_t asker;
static igtl_tracking_t tracking;
static snapshot_t snapshot;
static igtl_moment_t moment;

void setUp(void)
{
    (void)memset(&snapshot, 0, sizeof snapshot);
    (void)memset(&tracking, 0, sizeof tracking);
    snapshot.forces[FORCE_CHANNEL_HAND].force_mn = 1250;
    snapshot.forces[FORCE_CHANNEL_NEEDLE].force_mn = -75;
    asker = (igtl_asker_t){&outbox, IGTL_LANGUAGE_CRTK, &robot_prostate};
    moment = (igtl_moment_t){.now_us = 1000000U, .snapshot = &snapshot};
    igtl_outbox_init(&outbox);
}

void tearDown(void)
{
}

static void ask(const char *name)
{
    const igtl_message_t question = igtl_peer_query(IGTL_KIND_GET_SENSOR, name);

    TEST_ASSERT_TRUE(igtl_questions_receive(&tracking, &asker, &question, &moment));
}

static void ask_for_status(void)
{
    igtl_message_t message = igtl_peer_query(IGTL_KIND_COMMAND, "peer");

    message.subject = "Status";
    message.subject_bytes = 6U;
    TEST_ASSERT_TRUE(igtl_questions_receive(&tracking, &asker, &message, &moment));
}

static void doubt(uint32_t channel, force_doubt_t doubt)
{
    snapshot.forces[channel].doubts |= UINT32_C(1) << (uint32_t)doubt;
}

void test_SWR_IGTL_610_a_force_is_sent_in_newton_on_request(void)
{
    static const igtl_language_t languages[] = {IGTL_LANGUAGE_BRP_2013, IGTL_LANGUAGE_BRP_2021,
                                                IGTL_LANGUAGE_CRTK};

    for (uint32_t i = 0U; i < 3U; i++) {
        asker.language = languages[i];
        ask("FORCE_HAND");
        EXPECT("SENSOR FORCE_HAND 1 x 1.250");
        ask("FORCE_NEEDLE");
        EXPECT("SENSOR FORCE_NEEDLE 1 x -0.075");
        EXPECT("");
    }
}

void test_SWR_IGTL_610_without_a_name_both_are_sent(void)
{
    ask("");
    EXPECT("SENSOR FORCE_HAND 1 x 1.250");
    EXPECT("SENSOR FORCE_NEEDLE 1 x -0.075");
    EXPECT("");
}

void test_SWR_IGTL_610_nothing_is_sent_of_another_name(void)
{
    ask("FORCE");
    EXPECT("STATUS FORCE 4 NOT_FOUND|NOT_FOUND: There is nothing of this name.");
    EXPECT("");
}

void test_SWR_IGTL_611_a_doubtful_force_is_no_number(void)
{
    doubt(FORCE_CHANNEL_HAND, FORCE_DOUBT_NOT_ZEROED);
    ask("");
    EXPECT_BEGIN("STATUS FORCE_HAND 13 FORCE_DOUBTFUL|NOT_ZEROED: Its zero was not taken");
    EXPECT("SENSOR FORCE_NEEDLE 1 x -0.075");
    EXPECT("");
}

void test_SWR_IGTL_611_each_doubt_by_itself_keeps_a_force_back(void)
{
    for (uint32_t i = 0U; i < (uint32_t)FORCE_DOUBT_COUNT; i++) {
        snapshot.forces[FORCE_CHANNEL_NEEDLE].doubts = UINT32_C(1) << i;
        ask("FORCE_NEEDLE");
        EXPECT_BEGIN("STATUS FORCE_NEEDLE 13 FORCE_DOUBTFUL|");
        EXPECT("");
    }
}

void test_SWR_IGTL_611_all_doubts_are_named_as_far_as_there_is_room(void)
{
    doubt(FORCE_CHANNEL_HAND, FORCE_DOUBT_STALE);
    doubt(FORCE_CHANNEL_HAND, FORCE_DOUBT_STEP);
    ask("FORCE_HAND");
    EXPECT_BEGIN("STATUS FORCE_HAND 13 FORCE_DOUBTFUL|STALE, STEP: No report of it comes");
    snapshot.forces[FORCE_CHANNEL_HAND].doubts = ALL_DOUBTS;
    ask("FORCE_HAND");
    EXPECT_BEGIN(
        "STATUS FORCE_HAND 13 FORCE_DOUBTFUL|NOT_ZEROED, STALE, STUCK, OUT_OF_RANGE, STEP");
    EXPECT("");
}

void test_SWR_IGTL_611_a_robot_without_a_sensor_refuses(void)
{
    asker.robot = &robot_neuro;
    ask("FORCE_HAND");
    EXPECT("STATUS FORCE_HAND 10 NO_FORCE_SENSOR|NO_FORCE_SENSOR: The robot has no force sensor.");
    EXPECT("");
}

void test_SWR_IGTL_611_while_control_is_silent_no_force_is_known(void)
{
    moment.snapshot = NULL;
    ask("FORCE_NEEDLE");
    EXPECT_BEGIN("STATUS FORCE_NEEDLE 7 NO_ANSWER|");
    EXPECT("");
}

void test_SWR_IGTL_612_the_status_has_the_forces_or_their_doubts(void)
{
    ask_for_status();
    TEST_ASSERT_NOT_NULL(strstr(igtl_peer_next(&outbox),
                                " Moving=\"0\" ForceHand=\"1.250\" ForceNeedle=\"-0.075\"/>"));
    doubt(FORCE_CHANNEL_HAND, FORCE_DOUBT_BROKEN_WIRE);
    doubt(FORCE_CHANNEL_HAND, FORCE_DOUBT_ZERO_WANDERED);
    ask_for_status();
    TEST_ASSERT_NOT_NULL(
        strstr(igtl_peer_next(&outbox), " ForceHand=\"BROKEN_WIRE\" ForceNeedle=\"-0.075\"/>"));
    asker.robot = &robot_neuro;
    ask_for_status();
    TEST_ASSERT_NOT_NULL(strstr(igtl_peer_next(&outbox), " Moving=\"0\"/>"));
}

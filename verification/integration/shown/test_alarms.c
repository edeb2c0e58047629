/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: each fault is listed with its part, its cause and its beginning, in the words
 * of the log.
 */
#include "unity.h"

#include "card/card_health.h"
#include "common/event_text.h"
#include "common/utc_text.h"
#include "http/view/alarm_json.h"
#include "integration/support/rig.h"
#include "robot/robot_neuro.h"

#include <cjson/cJSON.h>
#include <stdio.h>
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

void test_SWR_HTTP_064_nothing_is_listed_of_a_robot_that_is_well(void)
{
    rig_start_homed(&rig);
    look();
    TEST_ASSERT_EQUAL_INT(0, cJSON_GetArraySize(alarms));
    rig_start_moving(&rig);
    look();
    TEST_ASSERT_EQUAL_INT(0, cJSON_GetArraySize(alarms));
}

void test_SWR_HTTP_064_a_lost_card_is_named_with_its_axis_cause_and_time(void)
{
    char since[UTC_TEXT_SIZE];

    insert();
    rig_box(&rig, "card insertion silent");
    rig_cycles(&rig, 20U);
    const uint32_t lost = rig.events[0].cycle;
    look();
    utc_text_write((uint64_t)lost * US_PER_CYCLE, since);
    TEST_ASSERT_EQUAL_STRING("CARD_LOST", text_of(0, "event"));
    TEST_ASSERT_EQUAL_STRING("LINK_LOST", text_of(0, "reason"));
    TEST_ASSERT_EQUAL_STRING("insertion", text_of(0, "axis"));
    TEST_ASSERT_EQUAL_STRING("3 (insertion)", text_of(0, "subject"));
    TEST_ASSERT_EQUAL_STRING("Card 3 (insertion) is lost. No frame of it came for several cycles: "
                             "check its cable and its supply.",
                             text_of(0, "text"));
    TEST_ASSERT_EQUAL_STRING(since, text_of(0, "since"));
    TEST_ASSERT_EQUAL_DOUBLE((double)(rig.outputs.snapshot.cycle - lost) / 1000.0,
                             number_of(cJSON_GetArrayItem(alarms, 0), "age_s"));
}

void test_SWR_HTTP_064_an_axis_with_a_fault_is_reported_in_the_sentence_of_its_event(void)
{
    char sentence[EVENT_TEXT_SIZE];

    insert();
    rig_box(&rig, "encoder insertion stuck");
    while (rig_count(&rig, EVENT_AXIS_NO_COUNTS) == 0U) {
        rig_cycle(&rig);
    }
    event_t event = {.id = EVENT_STARTED};
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        event = (rig.events[i].id == (uint32_t)EVENT_AXIS_NO_COUNTS) ? rig.events[i] : event;
    }
    look();
    event_text_sentence(&rig.robot, &event, NULL, sentence, sizeof sentence);
    TEST_ASSERT_EQUAL_STRING("AXIS_NO_COUNTS", text_of(0, "event"));
    TEST_ASSERT_EQUAL_STRING("AXIS_FAULT", text_of(0, "reason"));
    TEST_ASSERT_EQUAL_STRING("insertion", text_of(0, "axis"));
    TEST_ASSERT_EQUAL_STRING(sentence, text_of(0, "text"));
}

void test_SWR_HTTP_064_the_most_pressing_comes_first_and_all_are_there(void)
{
    insert();
    rig_box(&rig, "card yaw warm");
    rig_box(&rig, "encoder insertion stuck");
    run(1000U);
    rig_box(&rig, "card 3 silent");
    rig_box(&rig, "estop pull");
    run(1000U);
    TEST_ASSERT_EQUAL_STRING("ESTOP_PULLED", text_of(0, "event"));
    TEST_ASSERT_EQUAL_STRING("The e-stop is pulled: release it.", text_of(0, "text"));
    TEST_ASSERT_EQUAL_INT(1, find("CARD_LOST"));
    TEST_ASSERT_EQUAL_INT(2, find("AXIS_NO_COUNTS"));
    TEST_ASSERT_GREATER_THAN_INT(2, find("CARD_UNWELL"));
    TEST_ASSERT_EQUAL_STRING("Card 5 (yaw) is not well. Its driver is warm: let it rest, look at "
                             "fan and load.",
                             text_of(find("CARD_UNWELL"), "text"));
}

void test_SWR_HTTP_064_what_is_over_is_not_listed(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "estop pull");
    run(200U);
    TEST_ASSERT_EQUAL_STRING("ESTOP_PULLED", text_of(0, "reason"));
    rig_box(&rig, "estop reset");
    run(200U);
    TEST_ASSERT_EQUAL_STRING("ESTOP_LATCHED", text_of(0, "reason"));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    run(200U);
    TEST_ASSERT_EQUAL_INT(0, cJSON_GetArraySize(alarms));
}

void test_SWR_HTTP_064_a_server_that_was_started_later_says_what_it_knows(void)
{
    insert();
    rig_box(&rig, "card insertion silent");
    rig_cycles(&rig, 100U);
    rig_forget(&rig);
    look();
    TEST_ASSERT_EQUAL_STRING("Card 3 (insertion) is lost. The cause is not known: check its cable "
                             "and its supply.",
                             text_of(0, "text"));
    TEST_ASSERT_NULL(text_of(0, "since"));
    rig_box(&rig, "card insertion normal");
    rig_start_moving(&rig);
    rig_box(&rig, "motor insertion stuck");
    rig_cycles(&rig, 3000U);
    rig_forget(&rig);
    (void)memset(&view, 0, sizeof view);
    look();
    TEST_ASSERT_EQUAL_STRING("Axis insertion: The axis has a fault: command START_UP.",
                             text_of(find("AXIS_REFERENCE_LOST"), "text"));
}

void test_SWR_HTTP_064_a_position_in_doubt_is_an_alarm_and_an_axis_never_homed_none(void)
{
    rig_start(&rig);
    rig_cycles(&rig, 100U);
    look();
    TEST_ASSERT_EQUAL_INT(0, cJSON_GetArraySize(alarms));
    rig_start_homed(&rig);
    look();
    rig_box(&rig, "card yaw silent");
    run(200U);
    rig_box(&rig, "card yaw normal");
    run(200U);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    run(200U);
    TEST_ASSERT_EQUAL_INT(0, find("AXIS_UNVERIFIED"));
    TEST_ASSERT_EQUAL_STRING("NOT_HOMED", text_of(0, "reason"));
    TEST_ASSERT_EQUAL_STRING("yaw", text_of(0, "axis"));
}

void test_SWR_HTTP_064_cards_that_never_answered_and_motors_that_are_too_hot_are_named(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "motor feet hot");
    run(3000U);
    TEST_ASSERT_EQUAL_STRING("AXIS_DISABLED", text_of(find("AXIS_HOT"), "reason"));
    TEST_ASSERT_EQUAL_STRING("feet", text_of(find("AXIS_HOT"), "axis"));
    view.snapshot.cards[rig.robot.axes[NEURO_AXIS_YAW].slot].link = CARD_LINK_STATE_ABSENT;
    cJSON_Delete(alarms);
    alarms = alarm_json_list(&view);
    TEST_ASSERT_EQUAL_STRING("yaw", text_of(find("CARD_LOST"), "axis"));
}

void test_SWR_HTTP_064_a_recorder_that_records_nothing_is_listed(void)
{
    rig_start_homed(&rig);
    rig.is_recorder_failing = 1U;
    run(200U);
    TEST_ASSERT_EQUAL_INT(0, find("RECORDING_STOPPED"));
    TEST_ASSERT_NULL(text_of(0, "reason"));
    TEST_ASSERT_EQUAL_STRING("Cycles are not recorded: the recorder is not writing them.",
                             text_of(0, "text"));
}

static bool is_over(int index)
{
    return cJSON_IsTrue(cJSON_GetObjectItem(cJSON_GetArrayItem(alarms, index), "is_over")) != 0;
}

static void of_each_card(const char *word)
{
    char order[32];

    for (uint32_t slot = 1U; slot <= rig.robot.axis_count; slot++) {
        (void)snprintf(order, sizeof order, "card %u %s", (unsigned)slot, word);
        rig_box(&rig, order);
    }
}

static int count_of(const char *event)
{
    int count = 0;
    for (int i = 0; i < cJSON_GetArraySize(alarms); i++) {
        count += (strcmp(text_of(i, "event"), event) == 0) ? 1 : 0;
    }
    return count;
}

void test_SWR_HTTP_150_a_lost_card_that_answers_again_is_said_to_until_it_is_taken_back(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "card 3 silent");
    run(200U);
    TEST_ASSERT_FALSE(is_over(0));
    rig_box(&rig, "card 3 normal");
    run(200U);
    TEST_ASSERT_EQUAL_STRING("Card 3 (insertion) answers again after it was lost: START_UP takes "
                             "it back.",
                             text_of(0, "text"));
    TEST_ASSERT_EQUAL_STRING("insertion", text_of(0, "axis"));
    TEST_ASSERT_NULL(text_of(0, "since")); /* That is when it was lost. */
    TEST_ASSERT_TRUE(is_over(0));
    TEST_ASSERT_EQUAL_INT(1, find("AXIS_UNVERIFIED"));
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    run(200U);
    TEST_ASSERT_EQUAL_INT(-1, find("CARD_LOST"));
}

void test_SWR_HTTP_150_a_card_that_answers_and_is_another_or_does_not_obey_is_lost(void)
{
    static const link_cause_t standing[] = {LINK_CAUSE_WRONG_CARD, LINK_CAUSE_ECHO,
                                            LINK_CAUSE_MEMORY};
    rig_start_homed(&rig);
    rig_box(&rig, "card 3 silent");
    run(200U);
    rig_box(&rig, "card 3 normal");
    run(200U);
    for (uint32_t i = 0U; i < (sizeof standing / sizeof standing[0]); i++) {
        view.alarms.cards[3].said.event.value = (int32_t)standing[i];
        look();
        TEST_ASSERT_FALSE(is_over(0));
    }
    /* The controller decides about a cause that is not known. */
    view.alarms.cards[3].is_known = false;
    look();
    TEST_ASSERT_TRUE(is_over(0));
    rig_box(&rig, "estop pull");
    run(200U);
    TEST_ASSERT_FALSE(is_over(find("CARD_LOST")));
}

void test_SWR_HTTP_151_all_cards_at_once_are_one_alarm(void)
{
    char since[UTC_TEXT_SIZE];

    rig_start_homed(&rig);
    of_each_card("silent");
    rig_cycles(&rig, 20U);
    const uint32_t lost = rig.events[0].cycle;
    look();
    utc_text_write((uint64_t)lost * US_PER_CYCLE, since);
    TEST_ASSERT_EQUAL_INT(1, count_of("CARD_LOST"));
    TEST_ASSERT_EQUAL_STRING("All cards are lost: check the box, its supply and its cable.",
                             text_of(0, "text"));
    TEST_ASSERT_EQUAL_STRING("all", text_of(0, "subject"));
    TEST_ASSERT_EQUAL_STRING(since, text_of(0, "since"));
    TEST_ASSERT_NULL(text_of(0, "axis"));
    rig_box(&rig, "card 3 normal");
    run(200U);
    TEST_ASSERT_EQUAL_INT((int)rig.robot.axis_count, count_of("CARD_LOST"));
    of_each_card("normal");
    run(200U);
    TEST_ASSERT_EQUAL_INT(1, count_of("CARD_LOST"));
    TEST_ASSERT_EQUAL_STRING("All cards answer again after they were lost: START_UP takes them "
                             "back.",
                             text_of(0, "text"));
    TEST_ASSERT_NULL(text_of(0, "since"));
    TEST_ASSERT_TRUE(is_over(0));
    TEST_ASSERT_EQUAL_INT(1, count_of("CARD_UNWELL")); /* All have tripped. */
    TEST_ASSERT_EQUAL_STRING("The watchdogs of all cards that answer have switched the drives off, "
                             "as no command came.",
                             text_of(find("CARD_UNWELL"), "text"));
}

void test_SWR_HTTP_151_a_trouble_of_all_cards_is_one_alarm_and_heat_is_of_each(void)
{
    static const struct {
        card_trouble_t trouble;
        const char *text;
    } common[] = {{CARD_TROUBLE_COMMANDS_REFUSED, "All cards that answer have refused commands"},
                  {CARD_TROUBLE_SUPPLY_LOW, "The supply of all cards that answer is too low"},
                  {CARD_TROUBLE_SUPPLY_HIGH, "The supply of all cards that answer is too high"}};
    rig_start_homed(&rig);
    for (uint32_t i = 0U; i < (sizeof common / sizeof common[0]); i++) {
        for (uint32_t slot = 1U; slot <= rig.robot.axis_count; slot++) {
            rig.outputs.snapshot.cards[slot].troubles = card_health_bit(common[i].trouble);
        }
        look();
        TEST_ASSERT_EQUAL_INT(1, cJSON_GetArraySize(alarms));
        TEST_ASSERT_EQUAL_STRING_LEN(common[i].text, text_of(0, "text"), strlen(common[i].text));
        rig.outputs.snapshot.cards[2].troubles = 0U;
        look();
        TEST_ASSERT_EQUAL_INT((int)rig.robot.axis_count - 1, cJSON_GetArraySize(alarms));
    }
    for (uint32_t slot = 1U; slot <= rig.robot.axis_count; slot++) {
        rig.outputs.snapshot.cards[slot].troubles = card_health_bit(CARD_TROUBLE_DRIVER_WARM);
    }
    look();
    TEST_ASSERT_EQUAL_INT((int)rig.robot.axis_count, cJSON_GetArraySize(alarms));
}

void test_SWR_HTTP_151_a_card_that_is_silent_takes_no_part_in_what_the_others_have(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "card 3 silent");
    run(200U);
    for (uint32_t slot = 1U; slot <= rig.robot.axis_count; slot++) {
        rig.outputs.snapshot.cards[slot].troubles =
            (slot == 3U) ? 0U : card_health_bit(CARD_TROUBLE_WATCHDOG_TRIPPED);
    }
    look();
    TEST_ASSERT_EQUAL_INT(1, count_of("CARD_LOST"));
    TEST_ASSERT_EQUAL_INT(1, count_of("CARD_UNWELL"));
}

void test_SWR_HTTP_152_what_a_silent_card_said_before_is_not_listed(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "card yaw warm");
    run(1000U);
    TEST_ASSERT_EQUAL_INT(1, count_of("CARD_UNWELL"));
    rig_box(&rig, "card yaw silent");
    run(200U);
    TEST_ASSERT_EQUAL_INT(0, count_of("CARD_UNWELL"));
    TEST_ASSERT_EQUAL_INT(0, find("CARD_LOST"));
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: of what a page asks of the simulated box one order is made, in words of the
 * tables alone, and the box knows each that can be made.
 */
#include "unity.h"

#include "bsp_bench.h"
#include "http/call/box_order.h"
#include "interface/app/requests.h"
#include "request/request_body.h"
#include "robot/robot_neuro.h"
#include "sim/box.h"
#include "sim/model/sim_encoder.h"
#include "sim/model/sim_motor.h"
#include "sim/model/sim_switch.h"

#include <stdio.h>
#include <string.h>

static box_t box;
static box_order_t order;

void setUp(void)
{
    box_init(&box, &robot_neuro, 1U);
    (void)memset(&order, 0, sizeof order);
}

void tearDown(void)
{
}

static box_order_verdict_t write(const char *json)
{
    request_box_order_t request = {.has_slot = false};
    const request_result_t result =
        request_read_body(&request_box_order, json, strlen(json), &request);

    TEST_ASSERT_EQUAL_INT_MESSAGE(REQUEST_OK, result.fault, json);
    return box_order_write(&request, &order);
}

static void expect_words(const char *words, const char *json)
{
    TEST_ASSERT_EQUAL_INT_MESSAGE(BOX_ORDER_WRITTEN, write(json), json);
    TEST_ASSERT_EQUAL_STRING(words, order.words);
}

static void expect_refused(box_order_verdict_t verdict, const char *place, const char *json)
{
    TEST_ASSERT_EQUAL_INT_MESSAGE(verdict, write(json), json);
    TEST_ASSERT_EQUAL_STRING(place, order.place);
}

void test_SWR_HTTP_038_a_request_is_one_order(void)
{
    expect_words("estop pull", "{\"estop\": \"pull\"}");
    expect_words("push -200", "{\"push_mm\": -200}");
    expect_words("card 3 silent", "{\"slot\": 3, \"card_fault\": \"silent\"}");
    expect_words("switch 0 open", "{\"switch_fault\": \"open\", \"slot\": 0}");
    expect_words("plug 9 high_frequency", "{\"slot\": 9, \"plug\": \"high_frequency\"}");
}

void test_SWR_HTTP_039_what_is_held_is_of_a_page(void)
{
    expect_words("pedal pulse", "{\"pedal\": \"pulse\"}");
    TEST_ASSERT_FALSE(order.is_of_page);
    expect_words("pedal hold", "{\"pedal\": \"hold\"}");
    TEST_ASSERT_TRUE(order.is_of_page);
    TEST_ASSERT_FALSE(order.is_safe);
    expect_words("button drop", "{\"button\": \"drop\"}");
    TEST_ASSERT_TRUE(order.is_of_page);
    TEST_ASSERT_TRUE(order.is_safe);
}

void test_SWR_HTTP_038_what_opens_or_pulls_the_e_stop_is_safe(void)
{
    static const char *const safe[] = {"{\"pedal\": \"drop\"}", "{\"button\": \"drop\"}",
                                       "{\"estop\": \"pull\"}"};
    static const char *const others[] = {"{\"pedal\": \"hold\"}", "{\"estop\": \"reset\"}",
                                         "{\"scanner\": \"off\"}"};

    for (uint32_t i = 0U; i < 3U; i++) {
        TEST_ASSERT_EQUAL_INT(BOX_ORDER_WRITTEN, write(safe[i]));
        TEST_ASSERT_TRUE_MESSAGE(order.is_safe, safe[i]);
        TEST_ASSERT_EQUAL_INT(BOX_ORDER_WRITTEN, write(others[i]));
        TEST_ASSERT_FALSE_MESSAGE(order.is_safe, others[i]);
    }
}

void test_SWR_HTTP_038_what_is_no_order_or_two_is_refused_at_its_place(void)
{
    expect_refused(BOX_ORDER_MISSING, "/pedal", "{}");
    expect_refused(BOX_ORDER_MISSING, "/pedal", "{\"slot\": 3}");
    expect_refused(BOX_ORDER_MISSING, "/slot", "{\"motor_fault\": \"hot\"}");
    expect_refused(BOX_ORDER_EXCESS, "/slot", "{\"pedal\": \"hold\", \"slot\": 3}");
    expect_refused(BOX_ORDER_EXCESS, "/estop", "{\"pedal\": \"drop\", \"estop\": \"pull\"}");
    expect_refused(BOX_ORDER_EXCESS, "/plug",
                   "{\"slot\": 9, \"card_fault\": \"silent\", \"plug\": \"pwm\"}");
}

static void expect_obeyed(const request_field_t *field, const char *word)
{
    static char reply[BOX_REPLY_SIZE];
    char json[96];
    char line[96];
    const bool is_plug = strcmp(field->name, "plug") == 0;
    const bool has_slot = is_plug || (strstr(field->name, "_fault") != NULL);

    (void)snprintf(json, sizeof json, "{\"%s\": \"%s\"%s}", field->name, word,
                   !has_slot ? ""
                   : is_plug ? ", \"slot\": 9"
                             : ", \"slot\": 3");
    TEST_ASSERT_EQUAL_INT(BOX_ORDER_WRITTEN, write(json));
    (void)snprintf(line, sizeof line, "%s%s", order.words, order.is_of_page ? " 7" : "");
    TEST_ASSERT_TRUE_MESSAGE(box_command(&box, line, reply, sizeof reply), line);
}

void test_SWR_HTTP_038_the_box_obeys_each_word_of_the_tables(void)
{
    for (uint32_t i = 0U; i < request_box_order.count; i++) {
        const request_field_t *field = &request_box_order.fields[i];
        for (uint32_t word = 0U; word < field->word_count; word++) {
            expect_obeyed(field, field->words[word].word);
        }
    }
}

/* Numbered alike, so that the state of the box is reported in the same words. */
void test_SWR_HTTP_038_faults_are_numbered_as_the_words_are(void)
{
    expect_words("motor 3 hot", "{\"slot\": 3, \"motor_fault\": \"hot\"}");
    TEST_ASSERT_EQUAL_STRING("hot", box_order_word("motor_fault", SIM_MOTOR_HOT));
    TEST_ASSERT_EQUAL_STRING("half", box_order_word("encoder_fault", SIM_ENCODER_HALF));
    TEST_ASSERT_EQUAL_STRING("foreign", box_order_word("card_fault", BOX_CARD_FOREIGN));
    TEST_ASSERT_EQUAL_STRING("reversed", box_order_word("switch_fault", SIM_SWITCH_REVERSED));
    TEST_ASSERT_EQUAL_STRING("stop", box_order_word("gate", BOX_GATE_STOP));
    TEST_ASSERT_EQUAL_STRING("free", box_order_word("probe", 1U));
    TEST_ASSERT_EQUAL_STRING("analog", box_order_word("plug", CARD_TYPE_ANALOG));
    TEST_ASSERT_EQUAL_STRING("normal", box_order_word("card_fault", 99U));
}

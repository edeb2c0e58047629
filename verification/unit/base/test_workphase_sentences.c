/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the sentence of a workphase stands beside any state of the robot, so it says
 * what the workphase is for, and of no motion, wait or plan that there may not be. */
#include "unity.h"

#include "interface/app/names.h"
#include "interface/workphase_list.h"

#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

void test_SWR_CON_062_the_sentence_of_a_workphase_says_what_it_is_for(void)
{
    for (int32_t i = (int32_t)WORKPHASE_START_UP; i <= (int32_t)WORKPHASE_MANUAL; i++) {
        const char *sentence = workphase_text(i);
        TEST_ASSERT_EQUAL_STRING_LEN("This workphase is for ", sentence, 22U);
        TEST_ASSERT_NULL_MESSAGE(strstr(sentence, "while"), sentence);
    }
}

void test_SWR_CON_062_the_sentences_of_the_others_say_how_they_were_entered(void)
{
    TEST_ASSERT_EQUAL_STRING("No workphase was entered since control started.",
                             workphase_text((int32_t)WORKPHASE_UNDEFINED));
    TEST_ASSERT_EQUAL_STRING("Stopped by command.", workphase_text((int32_t)WORKPHASE_STOP));
    TEST_ASSERT_EQUAL_STRING(
        "Stopped by the e-stop, by one that is not read, or by an emergency command.",
        workphase_text((int32_t)WORKPHASE_EMERGENCY));
}

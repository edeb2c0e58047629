/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: each expected membrane is found by the nearest puncture in its window, or missed
 * once the needle is beyond that window; every other puncture was unexpected.
 */
#include "unity.h"

#include "sensor/membrane_list.h"

#include <string.h>

#define WINDOW_UM ((int32_t)LIMIT_MEMBRANE_WINDOW_UM)
#define DEEPEST_UM ((int32_t)LIMIT_MEMBRANE_DEEPEST_UM)

static const int32_t two_um[] = {30000, 36000};
static membrane_list_t list;

void setUp(void)
{
    (void)memset(&list, 0, sizeof list);
    TEST_ASSERT_EQUAL(STATUS_OK, membrane_list_set(&list, two_um, 2U));
}

void tearDown(void)
{
}

void test_SWR_PUNCT_550_as_many_as_may_be_are_taken_from_end_to_end(void)
{
    int32_t depths_um[LIMIT_MEMBRANES_MOST];
    for (uint32_t i = 0U; i < LIMIT_MEMBRANES_MOST; i++) {
        depths_um[i] = (int32_t)i;
    }
    depths_um[LIMIT_MEMBRANES_MOST - 1U] = DEEPEST_UM;
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_NONE, membrane_list_take(&list, 0));
    TEST_ASSERT_EQUAL(STATUS_OK, membrane_list_set(&list, depths_um, LIMIT_MEMBRANES_MOST));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_MEMBRANES_MOST, membrane_list_left(&list));
    TEST_ASSERT_EQUAL_UINT32(0U, list.unexpected);
    TEST_ASSERT_EQUAL_INT32(DEEPEST_UM, list.membranes[LIMIT_MEMBRANES_MOST - 1U].depth_um);
    TEST_ASSERT_EQUAL(STATUS_OK, membrane_list_set(&list, depths_um, 0U));
    TEST_ASSERT_EQUAL_UINT32(0U, membrane_list_left(&list));
}

static void refuse(const int32_t depths_um[], uint32_t count)
{
    const membrane_list_t before = list;
    TEST_ASSERT_EQUAL(STATUS_OUT_OF_RANGE, membrane_list_set(&list, depths_um, count));
    TEST_ASSERT_EQUAL_MEMORY(&before, &list, sizeof list);
}

void test_SWR_PUNCT_550_a_list_that_is_wrong_changes_nothing(void)
{
    static const int32_t rising_um[LIMIT_MEMBRANES_MOST + 1U] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
    const int32_t equal_um[] = {10, 10};
    const int32_t falling_um[] = {10, 20, 19};
    const int32_t before_um[] = {-1, 10};
    const int32_t beyond_um[] = {10, DEEPEST_UM + 1};
    refuse(rising_um, LIMIT_MEMBRANES_MOST + 1U);
    refuse(equal_um, 2U);
    refuse(falling_um, 3U);
    refuse(before_um, 2U);
    refuse(beyond_um, 2U);
}

void test_SWR_PUNCT_548_a_puncture_is_the_nearest_one_that_is_ahead(void)
{
    TEST_ASSERT_EQUAL_UINT32(1U, membrane_list_take(&list, 34000));
    TEST_ASSERT_EQUAL_INT32(34000, list.membranes[1].found_um);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_FOUND, list.membranes[1].state);
    TEST_ASSERT_EQUAL_UINT32(1U, membrane_list_left(&list));
    TEST_ASSERT_EQUAL_UINT32(0U, membrane_list_take(&list, 34500));
    TEST_ASSERT_EQUAL_UINT32(0U, membrane_list_left(&list));
    TEST_ASSERT_EQUAL_UINT32(0U, list.unexpected);
}

void test_SWR_PUNCT_548_of_two_as_near_it_is_the_less_deep_one(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, membrane_list_take(&list, 33000));
}

void test_SWR_PUNCT_548_its_window_ends_on_both_sides(void)
{
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_NONE, membrane_list_take(&list, 30000 - WINDOW_UM - 1));
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_NONE, membrane_list_take(&list, 36000 + WINDOW_UM + 1));
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_NONE, membrane_list_take(&list, INT32_MIN));
    TEST_ASSERT_EQUAL_UINT32(3U, list.unexpected);
    TEST_ASSERT_EQUAL_UINT32(0U, membrane_list_take(&list, 30000 - WINDOW_UM));
    TEST_ASSERT_EQUAL_UINT32(1U, membrane_list_take(&list, 36000 + WINDOW_UM));
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_NONE, membrane_list_take(&list, 30000));
    TEST_ASSERT_EQUAL_UINT32(4U, list.unexpected);
}

void test_SWR_PUNCT_549_a_membrane_behind_its_window_is_missed_once(void)
{
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_NONE, membrane_list_pass(&list, 30000 + WINDOW_UM));
    TEST_ASSERT_EQUAL_UINT32(0U, membrane_list_pass(&list, 30000 + WINDOW_UM + 1));
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_MISSED, list.membranes[0].state);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_NONE, membrane_list_pass(&list, 30000 + WINDOW_UM + 1));
    TEST_ASSERT_EQUAL_UINT32(1U, membrane_list_left(&list));
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_NONE, membrane_list_take(&list, 30000));
}

void test_SWR_PUNCT_549_one_that_was_found_is_not_missed(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, membrane_list_take(&list, 30000));
    TEST_ASSERT_EQUAL_UINT32(1U, membrane_list_pass(&list, INT32_MAX));
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_NONE, membrane_list_pass(&list, INT32_MAX));
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_NONE, membrane_list_pass(&list, INT32_MIN));
}

void test_SWR_PUNCT_752_what_was_looked_at_stays_so_until_the_needle_is_deeper(void)
{
    static const int32_t depths_um[] = {19000, 24000};
    TEST_ASSERT_EQUAL_INT(STATUS_OK, membrane_list_set(&list, depths_um, 2U));
    membrane_list_look(&list, 20000);
    membrane_list_look(&list, 15000);
    membrane_list_blind(&list, 20050); /* The needle rests there. */
    TEST_ASSERT_EQUAL_UINT32(0U, membrane_list_end(&list));
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_MISSED, list.membranes[0].state);
    membrane_list_blind(&list, 25000);
    TEST_ASSERT_EQUAL_UINT32(1U, membrane_list_end(&list));
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_PASSED, list.membranes[1].state);
}

void test_SWR_PUNCT_752_a_membrane_behind_a_needle_that_was_not_looked_at_is_passed(void)
{
    static const int32_t depths_um[] = {10000, 20000, 30000};
    TEST_ASSERT_EQUAL_INT(STATUS_OK, membrane_list_set(&list, depths_um, 3U));
    membrane_list_blind(&list, 20001);
    membrane_list_blind(&list, 15000); /* Nothing that was unseen becomes seen. */
    TEST_ASSERT_EQUAL_UINT32(1U, membrane_list_take(&list, 21000));
    TEST_ASSERT_EQUAL_UINT32(0U, membrane_list_pass(&list, 21000));
    TEST_ASSERT_EQUAL_UINT32(2U, membrane_list_end(&list));
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_PASSED, list.membranes[0].state);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_FOUND, list.membranes[1].state);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_MISSED, list.membranes[2].state);
    membrane_list_renew(&list);
    TEST_ASSERT_EQUAL_UINT32(0U, membrane_list_end(&list));
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_MISSED, list.membranes[0].state);
}

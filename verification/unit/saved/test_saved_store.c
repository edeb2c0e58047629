/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: what was shown last is found by its token, for a while, and nothing else. */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "saved/saved_store.h"

#include <string.h>

static saved_store_t store;
static saved_view_t view;
static saved_view_t found;

void setUp(void)
{
    saved_store_init(&store);
    (void)memset(&view, 0, sizeof view);
    view.plan.axis_count = 7U;
}

void tearDown(void)
{
}

void test_SWR_STORE_030_before_anything_was_shown_nothing_is_found(void)
{
    TEST_ASSERT_FALSE(saved_store_find(&store, store.view.token, &found));
    TEST_ASSERT_FALSE(saved_store_find(&store, 0U, &found));
}

void test_SWR_STORE_030_what_was_shown_last_is_found_by_its_token(void)
{
    view.plan.axes = 5U;
    saved_store_show(&store, &view);
    const uint32_t first = view.token;
    TEST_ASSERT_TRUE(saved_store_find(&store, first, &found));
    TEST_ASSERT_EQUAL_UINT32(5U, found.plan.axes);
    TEST_ASSERT_FALSE(saved_store_find(&store, first + 1U, &found));
    saved_store_show(&store, &view);
    TEST_ASSERT_FALSE(saved_store_find(&store, first, &found));
    TEST_ASSERT_TRUE(saved_store_find(&store, view.token, &found));
}

void test_SWR_STORE_030_no_token_is_0(void)
{
    store.view.token = UINT32_MAX;
    saved_store_show(&store, &view);
    TEST_ASSERT_EQUAL_UINT32(1U, view.token);
}

void test_SWR_STORE_030_what_was_shown_counts_for_a_while(void)
{
    const uint64_t most_ms = (uint64_t)LIMIT_PREVIEW_S * 1000U;
    view.shown_ms = 77U;
    TEST_ASSERT_TRUE(saved_view_is_fresh(&view, 77U));
    TEST_ASSERT_TRUE(saved_view_is_fresh(&view, 77U + most_ms));
    TEST_ASSERT_FALSE(saved_view_is_fresh(&view, 78U + most_ms));
}

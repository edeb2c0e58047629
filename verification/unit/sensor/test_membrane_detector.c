/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a puncture is a fall of the filtered force, above its noise and steep for its
 * way, of a needle that moves forward; neither rest nor a change of speed is one.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "sensor/membrane_detector.h"

#include <math.h>
#include <string.h>

#define NOISE_UN 21000U
#define BEGIN_UM ((int32_t)LIMIT_MEMBRANE_BEGIN_UM)

static membrane_detector_t detector;
static membrane_list_t list;
static membrane_view_t view;
static membrane_event_t event; /* The last one. */
static uint32_t punctures;
static uint32_t missed;

void setUp(void)
{
    (void)memset(&list, 0, sizeof list);
    view = (membrane_view_t){.force_mn = 1000, .depth_um = 0, .is_inserting = true};
    membrane_detector_init(&detector, NOISE_UN);
    punctures = 0U;
    missed = 0U;
}

void tearDown(void)
{
}

static void step(void)
{
    const membrane_event_t now = membrane_detector_step(&detector, &list, &view);
    if (now.kind != (uint32_t)MEMBRANE_EVENT_NONE) {
        event = now;
        missed += (now.kind == (uint32_t)MEMBRANE_EVENT_MISSED) ? 1U : 0U;
        punctures += (now.kind != (uint32_t)MEMBRANE_EVENT_MISSED) ? 1U : 0U;
    }
}

/* Moves with this speed while the force changes by `change_mn` in all. */
static void move(uint32_t duration_ms, int32_t um_per_ms, int32_t change_mn)
{
    const int32_t from_mn = view.force_mn;
    for (uint32_t i = 1U; i <= duration_ms; i++) {
        view.depth_um += um_per_ms;
        view.force_mn = from_mn + (int32_t)(((int64_t)change_mn * i) / duration_ms);
        step();
    }
}

/* In motion, and past its beginning. */
static void begin(int32_t um_per_ms)
{
    move(500U, um_per_ms, 0);
}

/* Falls within a millisecond. */
static void fall(int32_t by_mn, int32_t um_per_ms)
{
    view.force_mn -= by_mn;
    move(300U, um_per_ms, 0);
}

void test_SWR_PUNCT_540_a_fall_is_a_puncture_at_its_depth(void)
{
    for (int32_t um_per_ms = 1; um_per_ms <= 10; um_per_ms++) {
        setUp();
        begin(um_per_ms);
        const int32_t depth_um = view.depth_um;
        fall(350, um_per_ms);
        TEST_ASSERT_EQUAL_UINT32(1U, punctures);
        TEST_ASSERT_EQUAL_UINT32(MEMBRANE_EVENT_UNEXPECTED, event.kind);
        TEST_ASSERT_EQUAL_UINT32(MEMBRANE_NONE, event.place);
        TEST_ASSERT_INT32_WITHIN(8 * um_per_ms, depth_um + (8 * um_per_ms), event.depth_um);
        TEST_ASSERT_INT32_WITHIN(100, 230, event.fall_mn);
    }
}

void test_SWR_PUNCT_540_a_force_that_rises_and_one_that_stays_is_none(void)
{
    begin(2);
    move(2000U, 2, 0);
    move(2000U, 2, 3000);
    view.force_mn += 1000;
    move(300U, 2, 0);
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
}

void test_SWR_PUNCT_540_a_fall_that_takes_too_much_way_is_none(void)
{
    /* Within the window, 600 mN for 1.2 mm are the slope itself. */
    begin(20);
    move(60U, 20, -540);
    move(300U, 20, 0);
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
    setUp();
    begin(20);
    move(60U, 20, -900);
    move(300U, 20, 0);
    TEST_ASSERT_EQUAL_UINT32(1U, punctures);
}

void test_SWR_PUNCT_540_a_fall_that_takes_longer_than_the_window_is_none(void)
{
    begin(1);
    move(1200U, 1, -1000);
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
    setUp();
    begin(1);
    move(200U, 1, -1000);
    TEST_ASSERT_EQUAL_UINT32(1U, punctures);
}

void test_SWR_PUNCT_541_a_fall_within_the_noise_is_none(void)
{
    TEST_ASSERT_UINT32_WITHIN(1U, LIMIT_MEMBRANE_FLOOR_SIGMAS * NOISE_UN,
                              membrane_detector_floor_un(&detector));
    begin(2);
    fall(155, 2);
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
    setUp();
    begin(2);
    fall(175, 2);
    TEST_ASSERT_EQUAL_UINT32(1U, punctures);
}

void test_SWR_PUNCT_541_without_noise_there_is_a_least_fall(void)
{
    membrane_detector_init(&detector, 0U);
    TEST_ASSERT_EQUAL_UINT32(1000U * LIMIT_MEMBRANE_LEAST_MN,
                             membrane_detector_floor_un(&detector));
    begin(2);
    fall(45, 2);
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
    fall(55, 2);
    TEST_ASSERT_EQUAL_UINT32(1U, punctures);
}

void test_SWR_PUNCT_541_more_noise_than_can_be_counts_as_that(void)
{
    membrane_detector_init(&detector, UINT32_MAX);
    TEST_ASSERT_UINT32_WITHIN(1U, LIMIT_MEMBRANE_FLOOR_SIGMAS * 10000000U,
                              membrane_detector_floor_un(&detector));
}

void test_SWR_PUNCT_544_at_rest_no_fall_is_a_puncture(void)
{
    begin(2);
    move(200U, 0, 0);
    fall(900, 0);
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
    move(300U, 2, 0);
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
}

void test_SWR_PUNCT_544_slower_than_the_slowest_is_rest(void)
{
    begin(2);
    for (uint32_t i = 0U; i < 2000U; i++) {
        view.depth_um += ((i % 6U) == 0U) ? 1 : 0;
        view.force_mn = (i > 1000U) ? 100 : 1000;
        step();
    }
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
    setUp();
    begin(2);
    for (uint32_t i = 0U; i < 2000U; i++) {
        view.depth_um += ((i % 4U) == 0U) ? 1 : 0;
        view.force_mn = (i > 1500U) ? 100 : 1000;
        step();
    }
    TEST_ASSERT_EQUAL_UINT32(1U, punctures);
}

void test_SWR_PUNCT_544_on_the_way_out_and_not_inserted_no_fall_is_one(void)
{
    view.depth_um = 50000;
    begin(-2);
    fall(500, -2);
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
    setUp();
    begin(2);
    view.is_inserting = false;
    fall(500, 2);
    view.is_inserting = true;
    move(300U, 2, 0);
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
}

void test_SWR_PUNCT_540_a_fall_on_the_way_back_is_none(void)
{
    view.force_mn = 0;
    begin(5);
    view.force_mn = -400;
    move(12U, -10, 0);
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
}

void test_SWR_PUNCT_544_a_peak_before_it_was_not_inserted_is_forgotten(void)
{
    begin(10);
    view.is_inserting = false;
    move(1U, 10, -900);
    view.is_inserting = true;
    move(300U, 10, 0);
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
}

void test_SWR_PUNCT_544_after_rest_it_begins_with_its_way(void)
{
    begin(2);
    move(200U, 0, 0);
    const int32_t rest_um = view.depth_um;
    while (view.depth_um < (rest_um + BEGIN_UM)) {
        view.force_mn = (view.depth_um < (rest_um + 60)) ? 3000 : 1000; /* It sticks. */
        move(1U, 2, 0);
    }
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
    begin(2);
    fall(400, 2);
    TEST_ASSERT_EQUAL_UINT32(1U, punctures);
}

void test_SWR_PUNCT_544_tissue_that_relaxes_at_a_stop_is_no_puncture(void)
{
    for (double tau_ms = 40.0; tau_ms <= 1000.0; tau_ms *= 1.5) {
        double relaxed = 0.0;
        double um_per_ms = 5.0;
        double depth_um = 0.0;
        setUp();
        for (uint32_t i = 0U; i < 4000U; i++) {
            const bool stops = (i >= 1000U) && (i < 2500U);
            um_per_ms = stops ? fmax(0.0, um_per_ms - 0.2) : fmin(5.0, um_per_ms + 0.05);
            depth_um += um_per_ms;
            relaxed += ((0.4 * (1.0 - (um_per_ms / 5.0))) - relaxed) / tau_ms;
            view.depth_um = (int32_t)lrint(depth_um);
            view.force_mn = (int32_t)lrint(5000.0 * (1.0 - relaxed));
            step();
        }
        TEST_ASSERT_EQUAL_UINT32(0U, punctures);
    }
}

/* Slows down from 5 to 1 mm/s, with a force of which this share is by speed. */
static void slow_down(double mm_per_s2, double share)
{
    double depth_um = 0.0;
    double um_per_ms = 5.0;
    setUp();
    for (uint32_t i = 0U; i < 3000U; i++) {
        um_per_ms -= ((i >= 1000U) && (um_per_ms > 1.0)) ? (mm_per_s2 / 1000.0) : 0.0;
        depth_um += um_per_ms;
        view.depth_um = (int32_t)lrint(depth_um);
        view.force_mn = (int32_t)lrint(5000.0 * (1.0 - (share * (1.0 - (um_per_ms / 5.0)))));
        step();
    }
}

void test_SWR_PUNCT_545_what_slowing_down_explains_is_no_puncture(void)
{
    for (double mm_per_s2 = 3.0; mm_per_s2 <= 200.0; mm_per_s2 *= 1.3) {
        for (double share = 0.0; share < 0.85; share += 0.1) {
            slow_down(mm_per_s2, share);
            TEST_ASSERT_EQUAL_UINT32(0U, punctures);
        }
    }
}

void test_SWR_PUNCT_545_what_it_does_not_explain_is_one(void)
{
    begin(5);
    move(1000U, 5, 4000);
    move(500U, 5, 0);
    view.force_mn = 1500;
    move(500U, 3, 0);
    TEST_ASSERT_EQUAL_UINT32(1U, punctures);
}

void test_SWR_PUNCT_545_that_it_has_slowed_down_is_forgotten(void)
{
    begin(5);
    move(1000U, 5, 4000);
    move(500U, 5, 0);
    move(1000U, 3, 0);
    fall(500, 3);
    TEST_ASSERT_EQUAL_UINT32(1U, punctures);
}

void test_SWR_PUNCT_546_while_it_is_blind_it_reports_nothing_and_says_so(void)
{
    begin(2);
    TEST_ASSERT_EQUAL_UINT32(0U, detector.is_blind);
    view.is_blind = true;
    fall(500, 2);
    TEST_ASSERT_EQUAL_UINT32(1U, detector.is_blind);
    view.is_blind = false;
    view.force_mn += 900;
    move(10U, 2, 0);
    fall(900, 2);
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
    TEST_ASSERT_EQUAL_UINT32(0U, detector.is_blind);
    fall(500, 2);
    TEST_ASSERT_EQUAL_UINT32(1U, punctures);
}

void test_SWR_PUNCT_546_it_stays_blind_through_rest_and_until_it_begins(void)
{
    begin(2);
    view.is_blind = true;
    step();
    view.is_blind = false;
    move(500U, 0, 0);
    TEST_ASSERT_EQUAL_UINT32(1U, detector.is_blind);
    move(90U, 2, 0);
    TEST_ASSERT_EQUAL_UINT32(1U, detector.is_blind);
    move(60U, 2, 0);
    TEST_ASSERT_EQUAL_UINT32(0U, detector.is_blind);
}

void test_SWR_PUNCT_547_near_a_puncture_there_is_no_other(void)
{
    view.force_mn = 5000;
    begin(5);
    fall(500, 5);
    const int32_t first_um = event.depth_um;
    fall(500, 5);
    TEST_ASSERT_EQUAL_UINT32(1U, punctures);
    while (view.depth_um < (first_um + (int32_t)LIMIT_MEMBRANE_REFRACTORY_UM)) {
        move(1U, 5, 0);
    }
    move(20U, 5, 0);
    fall(500, 5);
    TEST_ASSERT_EQUAL_UINT32(2U, punctures);
}

void test_SWR_PUNCT_547_a_puncture_before_the_last_one_is_another(void)
{
    view.depth_um = 50000;
    begin(5);
    fall(500, 5);
    view.force_mn = 1000;
    view.depth_um = 0;
    begin(5);
    fall(500, 5);
    TEST_ASSERT_EQUAL_UINT32(2U, punctures);
}

void test_SWR_PUNCT_548_a_puncture_in_a_window_is_that_membrane(void)
{
    static const int32_t depths_um[] = {4000, 30000};
    TEST_ASSERT_EQUAL(STATUS_OK, membrane_list_set(&list, depths_um, 2U));
    begin(5);
    fall(500, 5);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_EVENT_EXPECTED, event.kind);
    TEST_ASSERT_EQUAL_UINT32(0U, event.place);
    TEST_ASSERT_EQUAL_INT32(event.depth_um, list.membranes[0].found_um);
    TEST_ASSERT_EQUAL_UINT32(1U, membrane_list_left(&list));
    view.force_mn = 1000;
    move(2000U, 5, 0);
    fall(500, 5);
    TEST_ASSERT_EQUAL_UINT32(MEMBRANE_EVENT_UNEXPECTED, event.kind);
    TEST_ASSERT_EQUAL_UINT32(0U, missed);
}

void test_SWR_PUNCT_549_a_membrane_without_a_fall_is_reported_as_missed(void)
{
    static const int32_t depths_um[] = {1000, 2000, 30000};
    TEST_ASSERT_EQUAL(STATUS_OK, membrane_list_set(&list, depths_um, 3U));
    move(2000U, 5, 0);
    TEST_ASSERT_EQUAL_UINT32(2U, missed);
    TEST_ASSERT_EQUAL_UINT32(1U, event.place);
    TEST_ASSERT_EQUAL_INT32(2000, event.depth_um);
    TEST_ASSERT_EQUAL_INT32(0, event.fall_mn);
    TEST_ASSERT_EQUAL_UINT32(0U, punctures);
}

void test_SWR_PUNCT_549_a_missed_one_waits_for_a_puncture_of_its_millisecond(void)
{
    static const int32_t depths_um[] = {0};
    begin(5);
    view.force_mn -= 900;
    while (punctures == 0U) {
        TEST_ASSERT_EQUAL(STATUS_OK, membrane_list_set(&list, depths_um, 0U));
        if (view.depth_um > 2505) {
            list.count = 1U;
            list.membranes[0] = (membrane_t){.depth_um = -90000};
        }
        move(1U, 5, 0);
        missed = (punctures == 0U) ? 0U : missed;
    }
    TEST_ASSERT_EQUAL_UINT32(0U, missed);
    move(1U, 5, 0);
    TEST_ASSERT_EQUAL_UINT32(1U, missed);
}

void test_SWR_PUNCT_540_no_depth_and_no_force_is_beyond_it(void)
{
    static const int32_t depths_um[] = {INT32_MIN, INT32_MAX, 0, INT32_MAX, INT32_MIN};
    for (uint32_t i = 0U; i < 5000U; i++) {
        view.depth_um = depths_um[(i / 37U) % 5U];
        view.force_mn = depths_um[(i / 11U) % 5U];
        step();
    }
    setUp();
    begin(5);
    fall(500, 5);
    TEST_ASSERT_EQUAL_UINT32(1U, punctures);
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the detector in integers reports what its equations in double precision do.
 */
#include "unity.h"

#include "sensor/membrane_detector.h"
#include "sim/model/sim_random.h"
#include "unit/support/membrane_truth.h"
#include "unit/support/scenes.h"

#include <math.h>
#include <string.h>

#define INSERTIONS SCENES(40U)
#define NOISE_N 0.02

static sim_random_t chance;
static membrane_detector_t detector;
static membrane_list_t list;

void setUp(void)
{
    (void)memset(&list, 0, sizeof list);
}

void tearDown(void)
{
}

/* A force that rises and falls at random places, with waves and steps of speed. The first event of
 * each has to be followed by the other's within 4 ms. */
static void compare(uint64_t seed, double change_mm_per_s)
{
    double depth_mm = 0.0;
    double force_n = 1.0;
    int32_t ahead_ms = 0; /* One has reported and the other has not. */
    uint32_t truths = 0U;
    uint32_t reports = 0U;
    chance.state = seed;
    membrane_truth_init();
    membrane_detector_init(&detector, (uint32_t)(NOISE_N * 1e6));
    for (uint32_t i = 0U; i < 20000U; i++) {
        depth_mm += 0.001 * (3.0 + (change_mm_per_s * sin(0.004 * i)));
        force_n += 0.0005;
        if (sim_random_below(&chance, 700U) == 0U) {
            force_n *= 1.0 - (0.3 * fabs(sim_random_signed(&chance)));
        }
        const membrane_view_t view = {
            .force_mn = (int32_t)lrint(1000.0 * force_n + (60.0 * sim_random_signed(&chance))),
            .depth_um = (int32_t)lrint(1000.0 * depth_mm),
            .is_inserting = true};
        const membrane_event_t event = membrane_detector_step(&detector, &list, &view);
        reports += (event.kind != (uint32_t)MEMBRANE_EVENT_NONE) ? 1U : 0U;
        truths +=
            membrane_truth_step(view.force_mn / 1000.0, view.depth_um / 1000.0, NOISE_N) ? 1U : 0U;
        ahead_ms = (reports == truths) ? 0 : (ahead_ms + 1);
        TEST_ASSERT_LESS_THAN_INT32(5, ahead_ms);
    }
    TEST_ASSERT_GREATER_THAN_UINT32(3U, truths);
}

void test_SWR_PUNCT_540_it_follows_its_equations_at_a_constant_speed(void)
{
    for (uint32_t i = 0U; i < INSERTIONS; i++) {
        compare(i, 0.0);
    }
}

void test_SWR_PUNCT_545_it_follows_its_equations_while_the_speed_changes(void)
{
    for (uint32_t i = 0U; i < INSERTIONS; i++) {
        compare(1000U + i, 2.5);
    }
}

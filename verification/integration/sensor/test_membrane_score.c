/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: in 500 insertions of a needle into simulated tissue the membrane detector finds
 * the membranes and hardly anything else, however the needle moves. Real tissue is not judged here.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "sensor/membrane_detector.h"
#include "sensor/membrane_noise.h"
#include "sim/model/sim_random.h"
#include "sim/model/sim_tissue.h"
#include "unit/support/scenes.h"

#include <math.h>
#include <string.h>

#define STEP_S 0.001
#define SURFACE_MM 5.0
#define WAY_MM 60.0
#define NOISE_N ((double)LIMIT_MEMBRANE_SCORE_NOISE_MN / 1000.0)
/* From a rupture to its report. */
#define LATE_MM 0.2
#define SCORED                                                                                     \
    ((SCENES(LIMIT_MEMBRANE_SCORE_INSERTIONS) + (uint32_t)MOTIONS - 1U) / (uint32_t)MOTIONS)

/* How the needle moves. */
typedef enum { STEADY_1 = 0, STEADY_2, STEADY_5, WAVES, STEPS, STOPS, MOTIONS } motion_t;

/* One insertion. */
static struct {
    sim_random_t random;
    sim_phantom_t phantom;
    sim_tissue_t tissue;
    membrane_detector_t detector;
    membrane_list_t list;
    motion_t motion;
    double depth_mm;
    double speed_mm_per_s;
    double time_s;
    double wish_mm_per_s;
    double until_s; /* The wish lasts so long. */
    uint32_t reported;
} scene;

static struct {
    uint32_t membranes;
    uint32_t found;
    uint32_t expected; /* Reported as the membrane that was expected there. */
    uint32_t unwanted;
    uint32_t insertions;
    uint32_t unwanted_in_windows;
} score;

void setUp(void)
{
    (void)memset(&score, 0, sizeof score);
}

void tearDown(void)
{
}

static double between(double least, double most)
{
    const double share = (double)sim_random_next(&scene.random) / 4294967296.0;
    return least + ((most - least) * share);
}

/* Small values as often as large ones. */
static double ratio_between(double least, double most)
{
    return least * pow(most / least, between(0.0, 1.0));
}

/* Nearly normal. */
static int32_t measured_mn(double force_n)
{
    double sum = 0.0;
    for (uint32_t i = 0U; i < 4U; i++) {
        sum += sim_random_signed(&scene.random);
    }
    return (int32_t)lrint((force_n + (NOISE_N * sum * sqrt(0.75))) * 1000.0);
}

/* The cutting force of the layer before lasts through the fall. */
static sim_layer_t make_layer(double fall_n)
{
    sim_layer_t layer = {
        .thickness_mm = between(12.0, 20.0),
        .rupture_fast_share = 1.0,
        .rupture_half_speed_mm_per_s = 2.0,
        .cutting_n = ratio_between(0.05, 0.3),
        .friction_in_n_per_mm = ratio_between(0.003, 0.05),
        .viscous_in_n_s_per_mm2 = ratio_between(0.0001, 0.001),
        .relaxing_share = between(0.2, 0.45),
        .relaxing_s = ratio_between(0.04, 1.0),
    };
    const double dent_mm = between(0.5, 4.0);
    const double linear = between(0.2, 0.8);
    layer.friction_out_n_per_mm = layer.friction_in_n_per_mm;
    layer.viscous_out_n_s_per_mm2 = layer.viscous_in_n_s_per_mm2;
    layer.stick_in_n_per_mm = between(1.0, 1.5) * layer.friction_in_n_per_mm;
    layer.stick_out_n_per_mm = layer.stick_in_n_per_mm;
    layer.rupture_n = fall_n;
    layer.stiffness_n_per_mm = linear * layer.rupture_n / dent_mm;
    layer.stiffening_n_per_mm2 = (1.0 - linear) * layer.rupture_n / (dent_mm * dent_mm);
    return layer;
}

static void make_phantom(bool has_membranes)
{
    scene.phantom = (sim_phantom_t){.surface_mm = SURFACE_MM,
                                    .presliding_mm = 0.2,
                                    .stick_mm_per_s = 0.05,
                                    .layer_count = has_membranes ? 3U : 1U};
    for (uint32_t i = 0U; i < 3U; i++) {
        const double fall_n = ratio_between((double)LIMIT_MEMBRANE_SCORE_LEAST_MN / 1000.0,
                                            (double)LIMIT_MEMBRANE_SCORE_MOST_MN / 1000.0);
        scene.phantom.layers[i] = make_layer(has_membranes ? fall_n : 0.0);
    }
    scene.phantom.layers[scene.phantom.layer_count - 1].thickness_mm = WAY_MM;
}

static void zero(void)
{
    membrane_noise_t noise;
    (void)memset(&noise, 0, sizeof noise);
    while (!membrane_noise_is_done(&noise)) {
        membrane_noise_step(&noise, measured_mn(0.0));
    }
    membrane_detector_init(&scene.detector, membrane_noise_un(&noise));
}

static void wish_anew(void)
{
    static const double speeds[] = {1.0, 2.0, 5.0, 0.5};
    if (scene.motion == STOPS) {
        const bool stops = scene.wish_mm_per_s > 0.0;
        scene.wish_mm_per_s = stops ? 0.0 : speeds[sim_random_below(&scene.random, 3U)];
        scene.until_s = scene.time_s + (stops ? between(0.3, 2.0) : between(1.0, 5.0));
    } else {
        scene.wish_mm_per_s = speeds[sim_random_below(&scene.random, 4U)];
        scene.until_s = scene.time_s + between(0.5, 4.0);
    }
}

static double wished_mm_per_s(void)
{
    static const double steady[] = {1.0, 2.0, 5.0};
    if (scene.motion < WAVES) {
        return steady[scene.motion];
    }
    if (scene.motion == WAVES) {
        return 3.0 + (2.0 * sin(2.0 * 3.14159265358979323846 * 0.5 * scene.time_s));
    }
    if (scene.time_s >= scene.until_s) {
        wish_anew();
    }
    return scene.wish_mm_per_s;
}

/* Slowly up, quickly down. */
static void move(void)
{
    const double change = wished_mm_per_s() - scene.speed_mm_per_s;
    scene.speed_mm_per_s += fmax(-200.0 * STEP_S, fmin(50.0 * STEP_S, change));
    scene.depth_mm += scene.speed_mm_per_s * STEP_S;
    scene.time_s += STEP_S;
}

static bool is_true(double depth_mm)
{
    for (uint32_t i = scene.reported; i < scene.tissue.popped; i++) {
        const double late_mm = depth_mm - scene.tissue.popped_at_mm[i];
        if (late_mm <= LATE_MM) {
            scene.reported = i + 1U;
            return true;
        }
    }
    return false;
}

static void judge(const membrane_event_t *event)
{
    if ((event->kind != (uint32_t)MEMBRANE_EVENT_EXPECTED) &&
        (event->kind != (uint32_t)MEMBRANE_EVENT_UNEXPECTED)) {
        return;
    }
    const bool is_expected = event->kind == (uint32_t)MEMBRANE_EVENT_EXPECTED;
    if (is_true((double)event->depth_um / 1000.0)) {
        score.found++;
        score.expected += is_expected ? 1U : 0U;
    } else {
        score.unwanted++;
        score.unwanted_in_windows += is_expected ? 1U : 0U;
    }
}

static void expect_membranes(void)
{
    int32_t depths_um[LIMIT_MEMBRANES_MOST];
    for (uint32_t i = 0U; i < scene.phantom.layer_count; i++) {
        depths_um[i] = (int32_t)(sim_tissue_front_mm(&scene.phantom, i) * 1000.0);
    }
    (void)memset(&scene.list, 0, sizeof scene.list);
    TEST_ASSERT_EQUAL(STATUS_OK,
                      membrane_list_set(&scene.list, depths_um, scene.phantom.layer_count));
}

static void begin(motion_t motion, uint64_t seed)
{
    (void)memset(&scene, 0, sizeof scene);
    scene.random.state = seed;
    scene.motion = motion;
}

static void insert(void)
{
    sim_tissue_init(&scene.tissue, &scene.phantom, 0.0);
    expect_membranes();
    zero();
    while (scene.depth_mm < WAY_MM) {
        move();
        sim_tissue_step(&scene.tissue, &scene.phantom, STEP_S, scene.depth_mm,
                        scene.speed_mm_per_s);
        const membrane_view_t view = {.force_mn = measured_mn(scene.tissue.force_n),
                                      .depth_um = (int32_t)lrint(scene.depth_mm * 1000.0),
                                      .is_inserting = true};
        const membrane_event_t event = membrane_detector_step(&scene.detector, &scene.list, &view);
        judge(&event);
    }
    score.membranes += scene.tissue.popped;
    score.insertions++;
}

static void expect_score(void)
{
    const uint32_t least = score.membranes * LIMIT_MEMBRANE_SCORE_PERCENT;
    const uint32_t most = score.insertions * LIMIT_MEMBRANE_SCORE_FALSE_PERCENT;
    TEST_ASSERT_GREATER_OR_EQUAL_UINT32(least, 100U * score.found);
    TEST_ASSERT_GREATER_OR_EQUAL_UINT32(least, 100U * score.expected);
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(most, 100U * score.unwanted);
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(score.unwanted, score.unwanted_in_windows);
}

static void insert_many(motion_t motion, uint32_t count, bool has_membranes)
{
    for (uint32_t i = 0U; i < count; i++) {
        begin(motion, ((uint64_t)motion * 1000U) + i);
        make_phantom(has_membranes);
        insert();
    }
}

void test_SWR_PUNCT_551_membranes_are_found_and_little_else_in_each_motion(void)
{
    for (uint32_t motion = 0U; motion < (uint32_t)MOTIONS; motion++) {
        setUp();
        insert_many((motion_t)motion, SCORED, true);
        TEST_ASSERT_EQUAL_UINT32(3U * score.insertions, score.membranes);
        expect_score();
    }
}

void test_SWR_PUNCT_551_where_no_membrane_is_none_is_found(void)
{
    for (uint32_t motion = 0U; motion < (uint32_t)MOTIONS; motion++) {
        insert_many((motion_t)motion, SCORED / 4U, false);
    }
    TEST_ASSERT_EQUAL_UINT32(0U, score.membranes);
    expect_score();
}

void test_SWR_PUNCT_540_the_end_of_a_harder_layer_is_taken_for_a_puncture(void)
{
    begin(STEADY_2, 1U);
    make_phantom(false);
    scene.phantom.layer_count = 2U;
    scene.phantom.layers[0].thickness_mm = 15.0;
    scene.phantom.layers[0].cutting_n = 0.7;
    scene.phantom.layers[1].thickness_mm = WAY_MM;
    scene.phantom.layers[1].cutting_n = 0.2;
    insert();
    TEST_ASSERT_EQUAL_UINT32(0U, score.membranes);
    TEST_ASSERT_EQUAL_UINT32(1U, score.unwanted);
}

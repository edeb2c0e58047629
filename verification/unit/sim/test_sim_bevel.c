/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a needle with a bevel goes through tissue as a unicycle whose turn is behind
 * that of its base, here against closed forms and one in double precision with its exponentials.
 */
#include "unity.h"

#include "sim/model/sim_bevel.h"

#include <math.h>
#include <string.h>

#define SURFACE_MM 30.0
#define KAPPA 0.0041
#define PI 3.14159265358979323846
#define TURN_RAD (2.0 * PI)
#define DEG (PI / 180.0)
#define STEP_MM 0.01

static const sim_phantom_t tissue = {.surface_mm = SURFACE_MM,
                                     .layer_count = 2U,
                                     .layers = {{.thickness_mm = 20.0}, {.thickness_mm = 110.0}}};
static sim_bevel_config_t config;
static sim_bevel_t bevel;
static double depth_mm;
static double base_rad;

void setUp(void)
{
    config = (sim_bevel_config_t){.curvature_per_mm = KAPPA};
    depth_mm = 0.0;
    base_rad = 0.0;
    sim_bevel_init(&bevel, &tissue, depth_mm, base_rad);
}

void tearDown(void)
{
}

static void step(double to_mm, double to_rad)
{
    depth_mm = to_mm;
    base_rad = to_rad;
    sim_bevel_step(&bevel, &config, &tissue, depth_mm, base_rad);
}

/* Evenly in both. */
static void go(double to_mm, double to_rad, uint32_t steps)
{
    const double from_mm = depth_mm;
    const double from_rad = base_rad;

    for (uint32_t i = 1U; i <= steps; i++) {
        const double share = (double)i / (double)steps;
        step(from_mm + share * (to_mm - from_mm), from_rad + share * (to_rad - from_rad));
    }
}

static sim_tip_t tip(void)
{
    return sim_bevel_at(&bevel, &tissue, depth_mm);
}

static double off_mm(sim_vector_t a, sim_vector_t b)
{
    return sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
}

static void expect_place(double within_mm, double x, double y, double z)
{
    const sim_vector_t place_mm = tip().place_mm;

    TEST_ASSERT_DOUBLE_WITHIN(within_mm, x, place_mm.x);
    TEST_ASSERT_DOUBLE_WITHIN(within_mm, y, place_mm.y);
    TEST_ASSERT_DOUBLE_WITHIN(within_mm, z, place_mm.z);
}

void test_SWR_BOX_770_a_needle_that_does_not_turn_goes_along_a_circle(void)
{
    for (double in_mm = 10.0; in_mm < 121.0; in_mm += 10.0) {
        go(SURFACE_MM + in_mm, 0.0, 1000U);
        const double z = sin(KAPPA * in_mm) / KAPPA;
        const double y = (1.0 - sqrt(1.0 - KAPPA * KAPPA * z * z)) / KAPPA;
        expect_place(1e-9, 0.0, -y, SURFACE_MM + z);
        TEST_ASSERT_DOUBLE_WITHIN(1e-12, cos(KAPPA * in_mm), tip().z.z);
    }
}

void test_SWR_BOX_770_an_arc_does_not_depend_on_the_length_of_its_steps(void)
{
    go(SURFACE_MM + 100.0, 0.0, 1U);
    const sim_vector_t at_once = tip().place_mm;
    setUp();
    go(SURFACE_MM + 100.0, 0.0, 100000U);
    TEST_ASSERT_DOUBLE_WITHIN(1e-7, 0.0, off_mm(at_once, tip().place_mm));
}

void test_SWR_BOX_770_it_is_bent_to_where_its_bevel_is_turned(void)
{
    const double in_mm = 80.0;
    const double z = sin(KAPPA * in_mm) / KAPPA;
    const double side = (1.0 - cos(KAPPA * in_mm)) / KAPPA;

    for (double deg = -720.0; deg < 721.0; deg += 35.0) {
        setUp();
        go(0.0, deg * DEG, 10U);
        go(SURFACE_MM + in_mm, base_rad, 1000U);
        expect_place(1e-9, side * sin(deg * DEG), -side * cos(deg * DEG), SURFACE_MM + z);
        const sim_tip_t at = tip();
        const sim_vector_t towards = sim_bevel_towards(&bevel, &at);
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, -sin(KAPPA * in_mm), towards.z);
    }
}

void test_SWR_BOX_770_outside_of_the_tissue_it_goes_straight_on(void)
{
    go(SURFACE_MM, 3.0, 100U);
    expect_place(1e-12, 0.0, 0.0, SURFACE_MM);
    go(160.0, 3.0, 5000U);
    const sim_tip_t at_end = tip();
    go(200.0, 3.0, 5000U);
    const sim_vector_t on = sim_space_add(at_end.place_mm, 40.0, at_end.z);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.0, off_mm(on, tip().place_mm));
}

void test_SWR_BOX_770_without_tissue_it_is_straight(void)
{
    static const sim_phantom_t none = {.layer_count = 0U};

    for (double to_mm = 1.0; to_mm < 150.0; to_mm += 1.0) {
        sim_bevel_step(&bevel, &config, &none, to_mm, 2.0);
        const sim_vector_t place_mm = sim_bevel_at(&bevel, &none, to_mm).place_mm;
        TEST_ASSERT_EQUAL_DOUBLE(0.0, place_mm.x);
        TEST_ASSERT_EQUAL_DOUBLE(0.0, place_mm.y);
        TEST_ASSERT_EQUAL_DOUBLE(to_mm, place_mm.z);
    }
}

void test_SWR_BOX_770_a_needle_in_new_tissue_is_straight(void)
{
    sim_bevel_init(&bevel, &tissue, 90.0, 4.0);
    depth_mm = 90.0;
    base_rad = 4.0;
    expect_place(1e-12, 0.0, 0.0, 90.0);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, bevel.lag_rad);
    go(100.0, 4.0, 100U);
    const double side = (1.0 - cos(KAPPA * 10.0)) / KAPPA;
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, side, hypot(tip().place_mm.x, tip().place_mm.y));
}

/* Whole turns while it goes in: the tip is on a helix whose axis leans by kappa times the way of
 * one radian. */
void test_SWR_BOX_770_a_needle_that_turns_evenly_goes_nearly_straight(void)
{
    const double in_mm = 100.0;
    const double mm_per_rad = 2.0 / TURN_RAD;

    go(SURFACE_MM, 0.0, 10U);
    go(SURFACE_MM + in_mm, in_mm / mm_per_rad, 50000U);
    const sim_vector_t place_mm = tip().place_mm;
    const double bound_mm = KAPPA * mm_per_rad * (in_mm + mm_per_rad);
    TEST_ASSERT_TRUE(hypot(place_mm.x, place_mm.y) < 1.01 * bound_mm);
    TEST_ASSERT_TRUE(place_mm.z > SURFACE_MM + in_mm - 0.001);
}

typedef struct {
    double turn[3][3];
    double place[3];
} pose_t;

/* g exp((V1 u1 + V2 u2) dt) with w = (kappa u1, 0, u2) and v = (0, 0, u1), by Rodrigues. */
static void go_as_unicycle(pose_t *self, double way_mm, double rad)
{
    const double w[3] = {KAPPA * way_mm, 0.0, rad};
    const double n = sqrt(w[0] * w[0] + w[2] * w[2]);
    const double skew[3][3] = {{0.0, -w[2], 0.0}, {w[2], 0.0, -w[0]}, {0.0, w[0], 0.0}};
    const double a = sin(n) / n;
    const double b = (1.0 - cos(n)) / (n * n);
    const double c = (n - sin(n)) / (n * n * n);
    double turn[3][3];
    double along[3];
    pose_t next;

    for (uint32_t i = 0U; i < 3U; i++) {
        for (uint32_t j = 0U; j < 3U; j++) {
            double square = 0.0;
            for (uint32_t k = 0U; k < 3U; k++) {
                square += skew[i][k] * skew[k][j];
            }
            turn[i][j] = ((i == j) ? 1.0 : 0.0) + a * skew[i][j] + b * square;
            along[i] = (j == 2U)
                           ? (way_mm * (((i == 2U) ? 1.0 : 0.0) + b * skew[i][2] + c * square))
                           : 0.0;
        }
    }
    for (uint32_t i = 0U; i < 3U; i++) {
        next.place[i] = self->place[i];
        for (uint32_t j = 0U; j < 3U; j++) {
            next.place[i] += self->turn[i][j] * along[j];
            next.turn[i][j] = 0.0;
            for (uint32_t k = 0U; k < 3U; k++) {
                next.turn[i][j] += self->turn[i][k] * turn[k][j];
            }
        }
    }
    *self = next;
}

void test_SWR_BOX_770_it_goes_as_the_unicycle_of_webster(void)
{
    pose_t pose = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}, {0.0, 0.0, SURFACE_MM}};

    go(SURFACE_MM, 0.0, 10U);
    for (uint32_t i = 0U; i < 12000U; i++) {
        const double rad = 0.004 * sin(0.002 * (double)i) + 0.001;
        step(depth_mm + STEP_MM, base_rad + rad);
        go_as_unicycle(&pose, STEP_MM, rad);
    }
    expect_place(1e-5, pose.place[0], pose.place[1], pose.place[2]);
    TEST_ASSERT_TRUE(hypot(pose.place[0], pose.place[1]) > 1.0);
    const sim_tip_t at = tip();
    const sim_vector_t towards = sim_bevel_towards(&bevel, &at);
    TEST_ASSERT_DOUBLE_WITHIN(1e-5, -pose.turn[0][1], towards.x);
    TEST_ASSERT_DOUBLE_WITHIN(1e-5, -pose.turn[1][1], towards.y);
}

/* The rate law of Wartenberg et al.: 1 - alpha exp(-d^2 / (2 c^2)), c = 60 degrees. */
static double rate(double alpha, double rad)
{
    const double d = remainder(rad, TURN_RAD);
    const double c = 60.0 * DEG;

    return 1.0 - alpha * exp(-d * d / (2.0 * c * c));
}

/* Share of the curvature that is left over a turn, by the integrals of cos / rate and 1 / rate. */
static double share_of(double alpha)
{
    double pushed = 0.0;
    double passed = 0.0;

    for (uint32_t i = 0U; i < 36000U; i++) {
        const double rad = ((double)i + 0.5) * TURN_RAD / 36000.0;
        pushed += cos(rad) / rate(alpha, rad);
        passed += 1.0 / rate(alpha, rad);
    }
    return pushed / passed;
}

void test_SWR_BOX_770_the_rate_law_leaves_its_average_of_the_curvature(void)
{
    static const struct {
        double alpha;
        double share;
    } known[] = {{0.2, 0.054}, {0.5, 0.167}, {0.8, 0.375}, {0.9, 0.512}, {0.95, 0.628}};
    const double in_mm = 60.0;
    const double mm_per_s = 1.0;
    const double rad_per_s = 4.0 * TURN_RAD;
    const double step_s = 0.0005;

    for (uint32_t i = 0U; i < sizeof known / sizeof known[0]; i++) {
        setUp();
        go(SURFACE_MM, PI, 10U);
        while (depth_mm < SURFACE_MM + in_mm) {
            step(depth_mm + mm_per_s * step_s,
                 base_rad + rad_per_s * rate(known[i].alpha, base_rad) * step_s);
        }
        const sim_tip_t at = tip();
        const double share = atan2(-at.z.y, at.z.z) / (KAPPA * in_mm);
        TEST_ASSERT_DOUBLE_WITHIN(0.001, known[i].share, share_of(known[i].alpha));
        TEST_ASSERT_DOUBLE_WITHIN(0.01, known[i].share, share);
        TEST_ASSERT_DOUBLE_WITHIN(0.005 * in_mm, 0.0, at.place_mm.x);
    }
}

void test_SWR_BOX_771_the_tip_is_behind_by_the_torsion_of_the_length_in_the_tissue(void)
{
    config.torsion_deg_per_100_mm = 45.0;
    for (double in_mm = -10.0; in_mm < 131.0; in_mm += 10.0) {
        const double lag_rad = ((in_mm > 0.0) ? in_mm : 0.0) * 0.45 * DEG;
        go(SURFACE_MM + in_mm, base_rad + TURN_RAD, 500U);
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, lag_rad, bevel.lag_rad);
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, base_rad - lag_rad, bevel.tip_rad);
    }
    go(200.0, base_rad + TURN_RAD, 500U);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 130.0 * 0.45 * DEG, bevel.lag_rad);
}

void test_SWR_BOX_771_at_a_reversal_the_base_turns_by_twice_the_lag_before_the_tip_does(void)
{
    const double lag_rad = 45.0 * DEG;

    config.torsion_deg_per_100_mm = 45.0;
    go(SURFACE_MM + 100.0, 0.0, 1000U);
    go(depth_mm, 3.0, 1000U);
    const double stood_rad = bevel.tip_rad;
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 3.0 - lag_rad, stood_rad);
    go(depth_mm, 3.0 - 2.0 * lag_rad + 0.001, 1000U);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, stood_rad, bevel.tip_rad);
    go(depth_mm, 1.0, 1000U);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1.0 + lag_rad, bevel.tip_rad);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, -lag_rad, bevel.lag_rad);
}

void test_SWR_BOX_771_drawn_out_of_the_tissue_the_tip_is_at_the_angle_of_its_base(void)
{
    config.torsion_deg_per_100_mm = 45.0;
    go(SURFACE_MM + 100.0, 2.0, 1000U);
    TEST_ASSERT_TRUE(bevel.lag_rad > 0.7);
    go(SURFACE_MM - 1.0, 2.0, 1000U);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, bevel.lag_rad);
}

#define KEPT 400U
static sim_vector_t kept[KEPT];

/* Turning, with a place kept each quarter of a millimetre. */
static void go_in_and_keep(void)
{
    go(SURFACE_MM, 0.0, 10U);
    for (uint32_t i = 0U; i < KEPT; i++) {
        kept[i] = tip().place_mm;
        go(SURFACE_MM + 0.25 * (double)(i + 1U), base_rad + 0.01 * sin(0.05 * (double)i), 25U);
    }
}

void test_SWR_BOX_772_it_is_drawn_back_along_its_own_way_whatever_its_base_turns(void)
{
    config.torsion_deg_per_100_mm = 20.0;
    go_in_and_keep();
    TEST_ASSERT_TRUE(hypot(tip().place_mm.x, tip().place_mm.y) > 10.0);
    for (uint32_t i = KEPT; i > 0U; i--) {
        go(SURFACE_MM + 0.25 * (double)(i - 1U), base_rad + 0.3, 7U);
        TEST_ASSERT_DOUBLE_WITHIN(1e-4, 0.0, off_mm(kept[i - 1U], tip().place_mm));
    }
}

void test_SWR_BOX_772_it_goes_in_again_along_its_way_and_cuts_from_its_end_on(void)
{
    go_in_and_keep();
    const sim_tip_t deepest = tip();
    go(SURFACE_MM + 40.0, base_rad, 100U);
    go(SURFACE_MM + 75.0, base_rad + PI, 100U);
    TEST_ASSERT_DOUBLE_WITHIN(1e-4, 0.0, off_mm(kept[300], tip().place_mm));
    go(SURFACE_MM + 100.0, base_rad, 100U);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.0, off_mm(deepest.place_mm, tip().place_mm));
    go(SURFACE_MM + 110.0, base_rad, 100U);
    const sim_vector_t straight = sim_space_add(deepest.place_mm, 10.0, deepest.z);
    TEST_ASSERT_DOUBLE_WITHIN(0.001, (1.0 - cos(KAPPA * 10.0)) / KAPPA,
                              off_mm(straight, tip().place_mm));
}

void test_SWR_BOX_772_out_of_the_tissue_the_way_is_forgotten(void)
{
    go_in_and_keep();
    go(SURFACE_MM - 0.1, base_rad, 100U);
    go(SURFACE_MM, 0.0, 100U);
    go(SURFACE_MM + 75.0, 0.0, 1000U);
    const double side = (1.0 - cos(KAPPA * 75.0)) / KAPPA;
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, -side, tip().place_mm.y);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.0, tip().place_mm.x);
}

void test_SWR_BOX_772_tissue_that_is_whole_again_is_cut_anew_beyond_the_tip(void)
{
    go_in_and_keep();
    go(SURFACE_MM + 50.1, base_rad + 1.0, 1000U);
    const sim_tip_t at = tip();
    sim_bevel_heal(&bevel, &tissue);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.0, off_mm(at.place_mm, tip().place_mm));
    go(SURFACE_MM + 75.0, base_rad, 1000U);
    TEST_ASSERT_TRUE(off_mm(kept[300], tip().place_mm) > 0.5);
    go(SURFACE_MM + 40.0, base_rad, 1000U);
    TEST_ASSERT_DOUBLE_WITHIN(1e-4, 0.0, off_mm(kept[160], tip().place_mm));
}

void test_SWR_BOX_773_equal_steps_give_equal_bits(void)
{
    static sim_bevel_t first;

    config.torsion_deg_per_100_mm = 45.0;
    (void)memset(&bevel, 0, sizeof bevel);
    setUp();
    go_in_and_keep();
    first = bevel;
    (void)memset(&bevel, 0, sizeof bevel);
    setUp();
    go_in_and_keep();
    TEST_ASSERT_EQUAL_MEMORY(&first, &bevel, sizeof bevel);
}

void test_SWR_BOX_773_sine_and_cosine_are_those_of_the_mathematics_library(void)
{
    for (double rad = -200.0; rad < 200.0; rad += 0.0371) {
        TEST_ASSERT_DOUBLE_WITHIN(1e-13, sin(rad), sim_space_sine(rad));
        TEST_ASSERT_DOUBLE_WITHIN(1e-13, cos(rad), sim_space_cosine(rad));
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: sensor cards read the force of the hand and of the tissue, as orders and the
 * depth of the needle make them. */
#include "unity.h"

#include "bsp_bench.h"
#include "card/card_frame.h"
#include "limits/requirement_limits.h"
#include "robot/robot_prostate.h"
#include "sim/box.h"
#include "sim/box_grip.h"

#include <stdlib.h>
#include <string.h>

#define SENSOR_SLOT 3U
#define COUNTS_PER_N 113.0
#define NOISE_COUNTS 12.0 /* Five times the standard deviation. */
#define SECOND_US 1000000U

static box_t box;
static char reply[BOX_REPLY_SIZE];

void setUp(void)
{
    box_init(&box, &robot_prostate, 1U);
}

void tearDown(void)
{
}

static void order(const char *line)
{
    TEST_ASSERT_TRUE_MESSAGE(box_command(&box, line, reply, sizeof reply), reply);
}

static uint32_t converter(uint32_t number)
{
    uint8_t sent[CARD_SLOT_COUNT][CARD_FRAME_BYTES] = {{0U}};
    uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
    card_report_t report;

    (void)box_exchange(&box, 1U << SENSOR_SLOT, (const uint8_t(*)[CARD_FRAME_BYTES])sent, received);
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK,
                          card_frame_decode_report(received[SENSOR_SLOT], SENSOR_SLOT, &report));
    const uint32_t word = report.adc_words[(number - 1U) / 2U];
    return ((number % 2U) == 1U) ? (word >> 16U) : (word & 0xFFFFU);
}

static void expect_hand(double force_n)
{
    TEST_ASSERT_DOUBLE_WITHIN(NOISE_COUNTS, BOX_HAND_AT_REST + COUNTS_PER_N * force_n,
                              converter(2U));
}

static void expect_needle(double force_n)
{
    TEST_ASSERT_DOUBLE_WITHIN(NOISE_COUNTS, BOX_NEEDLE_AT_REST + COUNTS_PER_N * force_n,
                              converter(3U));
}

/* At 5 mm/s; the needle starts at 2 mm. */
static void go_to(int mm)
{
    const double way_mm = mm - box_depth_mm(&box);

    box_push(&box, way_mm);
    box_advance(&box, (uint32_t)(abs((int)(way_mm * 1000.0)) / 5 + 1) * 1000U);
}

void test_SWR_BOX_528_outside_of_tissue_and_without_a_hand_both_are_at_rest(void)
{
    expect_hand(0.0);
    expect_needle(0.0);
    go_to(29);
    expect_hand(0.0);
    expect_needle(0.0);
}

void test_SWR_BOX_528_the_needle_feels_membranes_at_their_depths(void)
{
    go_to(32);
    const uint32_t pressed = converter(3U);
    TEST_ASSERT_TRUE(pressed > BOX_NEEDLE_AT_REST + 0.9 * COUNTS_PER_N);
    go_to(34);
    TEST_ASSERT_EQUAL_UINT32(1U, box.force.tissue.popped);
    TEST_ASSERT_TRUE(converter(3U) < pressed - 60U);
    go_to(67);
    TEST_ASSERT_TRUE(converter(3U) > BOX_NEEDLE_AT_REST + 1.3 * COUNTS_PER_N);
    go_to(69);
    TEST_ASSERT_EQUAL_UINT32(2U, box.force.tissue.popped);
    expect_needle(box.force.tissue.force_n);
    go_to(60);
    TEST_ASSERT_TRUE(converter(3U) < BOX_NEEDLE_AT_REST);
    expect_hand(0.0);
}

void test_SWR_BOX_528_the_tissue_is_in_front_of_the_true_needle(void)
{
    order("encoder insertion stuck");
    go_to(32);
    TEST_ASSERT_DOUBLE_WITHIN(0.001, 32.0, box.force.tissue.depth_mm);
    TEST_ASSERT_TRUE(converter(3U) > BOX_NEEDLE_AT_REST + 0.9 * COUNTS_PER_N);
}

void test_SWR_BOX_528_tissue_is_taken_away_and_made_whole_again(void)
{
    go_to(40);
    TEST_ASSERT_EQUAL_UINT32(1U, box.force.tissue.popped);
    order("tissue whole");
    go_to(66);
    go_to(20);
    order("tissue whole");
    TEST_ASSERT_EQUAL_UINT32(0U, box.force.tissue.next);
    go_to(32);
    order("tissue none");
    expect_needle(0.0);
    go_to(60);
    TEST_ASSERT_EQUAL_UINT32(BOX_NEEDLE_AT_REST, converter(3U));
    order("tissue usual");
    TEST_ASSERT_EQUAL_UINT32(1U, box.force.tissue.next);
    go_to(69);
    TEST_ASSERT_EQUAL_UINT32(1U, box.force.tissue.popped);
}

void test_SWR_BOX_525_a_hand_presses_with_its_grip_until_it_lets_go(void)
{
    order("hand press");
    box_advance(&box, 10000U);
    expect_hand(3.0);
    order("grip -5000");
    box_advance(&box, 10000U);
    expect_hand(-5.0);
    order("hand release");
    box_advance(&box, 10000U);
    expect_hand(0.0);
    order("grip 1500");
    box_advance(&box, 10000U);
    expect_hand(0.0);
    order("hand press");
    box_advance(&box, 10000U);
    expect_hand(1.5);
}

void test_SWR_BOX_525_a_hand_like_a_spring_is_eased_by_the_axis(void)
{
    order("hand stiffness 2000");
    order("hand go 3000");
    box_advance(&box, 10000U);
    expect_hand(6.0);
    go_to(4);
    box_advance(&box, 10000U);
    expect_hand(2.0);
    order("hand speed 1000");
    box_advance(&box, SECOND_US);
    expect_hand(4.0);
    order("hand release");
    box_advance(&box, 10000U);
    expect_hand(0.0);
}

void test_SWR_BOX_020_a_handle_held_from_afar_is_let_go_by_itself(void)
{
    static box_grip_t grip;
    bsp_bench_t seen;

    (void)memset(&grip, 0, sizeof grip);
    order("hand hold 7");
    TEST_ASSERT_FALSE(box_command(&box, "hand hold 8", reply, sizeof reply));
    TEST_ASSERT_FALSE(box_grip_look(&grip, &box, SECOND_US));
    box_advance(&box, 10000U);
    expect_hand(3.0);
    box_show(&box, &seen);
    TEST_ASSERT_TRUE(seen.is_hand_pressed);
    TEST_ASSERT_EQUAL_UINT32(7U, seen.hand_holder);
    TEST_ASSERT_EQUAL_INT32(3000, seen.grip_mn);
    TEST_ASSERT_EQUAL_UINT32(2U, seen.layers);
    TEST_ASSERT_TRUE(box_grip_look(&grip, &box, SECOND_US + LIMIT_BOX_GRIP_US));
    box_advance(&box, 10000U);
    expect_hand(0.0);
    box_show(&box, &seen);
    TEST_ASSERT_FALSE(seen.is_hand_pressed);
    TEST_ASSERT_EQUAL_UINT32(0U, seen.hand_holder);
}

void test_SWR_BOX_020_a_person_takes_the_handle_from_a_page(void)
{
    order("hand hold 7");
    order("hand go 1000");
    order("hand drop 7");
    box_advance(&box, 10000U);
    expect_hand(1.0);
}

void test_SWR_BOX_527_faults_of_the_cells_obey(void)
{
    static const struct {
        const char *order;
        uint32_t reading;
    } faults[] = {{"force needle broken", 0U},
                  {"force needle full", SIM_LOAD_CELL_MOST},
                  {"force needle 777", 777U},
                  {"force needle stuck", 777U}};
    bsp_bench_t seen;

    for (uint32_t i = 0U; i < sizeof faults / sizeof faults[0]; i++) {
        order(faults[i].order);
        box_advance(&box, 10000U);
        TEST_ASSERT_EQUAL_UINT32(faults[i].reading, converter(3U));
        expect_hand(0.0);
    }
    order("force hand step");
    box_advance(&box, 10000U);
    expect_hand(SIM_LOAD_CELL_STEP_N);
    box_show(&box, &seen);
    TEST_ASSERT_EQUAL_UINT32(SIM_LOAD_CELL_STEP, seen.force_hand);
    TEST_ASSERT_EQUAL_UINT32(SIM_LOAD_CELL_STUCK, seen.force_needle);
    order("force hand normal");
    order("force needle normal");
    box_advance(&box, 10000U);
    expect_hand(0.0);
    expect_needle(0.0);
}

void test_SWR_BOX_003_orders_about_forces_that_are_wrong_change_nothing(void)
{
    static const char *const wrong[] = {"hand",
                                        "hand up",
                                        "hand go",
                                        "hand go far",
                                        "hand go 200001",
                                        "hand speed 1.5",
                                        "hand stiffness 99",
                                        "hand press 3000",
                                        "hand press now",
                                        "grip",
                                        "grip 30001",
                                        "grip hard",
                                        "force hand loose",
                                        "force foot stuck",
                                        "force hand",
                                        "tissue",
                                        "tissue soft",
                                        "tissue none now",
                                        "tissue show now"};
    static box_t before;

    for (uint32_t i = 0U; i < sizeof wrong / sizeof wrong[0]; i++) {
        before = box;
        TEST_ASSERT_FALSE_MESSAGE(box_command(&box, wrong[i], reply, sizeof reply), wrong[i]);
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(reply, "the orders are"), reply);
        TEST_ASSERT_EQUAL_MEMORY(&before, &box, sizeof box);
    }
}

void test_SWR_BOX_003_show_states_hand_tissue_and_cells(void)
{
    go_to(50);
    order("force hand noisy");
    order("show");
    TEST_ASSERT_NOT_NULL(strstr(reply, "hand off, needle at 50.0000 mm: "));
    TEST_ASSERT_NOT_NULL(strstr(reply, "1 of 2 layers, 1 ruptured\n"));
    TEST_ASSERT_NOT_NULL(strstr(reply, "load cell hand noisy, reads "));
    TEST_ASSERT_NOT_NULL(strstr(reply, "load cell needle normal, reads "));
    order("hand press");
    order("show");
    TEST_ASSERT_NOT_NULL(strstr(reply, "hand presses with 3.000 N"));
    order("hand go 2000");
    order("show");
    TEST_ASSERT_NOT_NULL(strstr(reply, "hand of 1.000 N/mm wishes 52.0000 mm and 0.000 mm/s"));
}

void test_SWR_BOX_529_the_phantom_is_shown_as_its_file(void)
{
    sim_phantom_file_t read;
    char reason[128];

    order("tissue show");
    TEST_ASSERT_TRUE_MESSAGE(sim_phantom_read(&read, reply, reason, sizeof reason), reason);
    TEST_ASSERT_EQUAL_MEMORY(&sim_phantom_usual, &read, sizeof read);
}

/* A course of hand, needle and faults, in strides of this length. */
static void run_course(uint32_t stride_us)
{
    static const struct {
        const char *order;
        uint32_t lasts_us;
    } course[] = {{"hand speed 2000", 2000000U},
                  {"push 80", 16000000U},
                  {"force needle noisy", 3000000U},
                  {"push -30", 6000000U},
                  {"hand release", 1000000U}};

    box_init(&box, &robot_prostate, 7U);
    for (uint32_t i = 0U; i < sizeof course / sizeof course[0]; i++) {
        order(course[i].order);
        for (uint32_t us = 0U; us < course[i].lasts_us; us += stride_us) {
            box_advance(&box, stride_us);
        }
    }
}

void test_SWR_BOX_533_strides_of_any_length_give_the_same_bits(void)
{
    static box_t other;

    run_course(100U);
    other = box;
    run_course(2000U);
    TEST_ASSERT_EQUAL_MEMORY(&other.force, &box.force, sizeof box.force);
    TEST_ASSERT_EQUAL_UINT32(2U, box.force.tissue.popped);
    box_init(&other, &robot_prostate, 8U);
    box_init(&box, &robot_prostate, 7U);
    TEST_ASSERT_TRUE(other.force.cells[0].random.state != box.force.cells[0].random.state);
}

void test_SWR_BOX_528_a_sensor_card_that_is_plugged_in_reads_the_same(void)
{
    order("hand press");
    box_advance(&box, 10000U);
    order("plug 9 sensor");
    TEST_ASSERT_EQUAL_MEMORY(box.sensors[SENSOR_SLOT].card.adc, box.sensors[9].card.adc,
                             sizeof box.sensors[9].card.adc);
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: both channels are zeroed together and judged apart, and a pair of forces that
 * the mechanism makes impossible is doubted.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "robot/robot_prostate.h"
#include "sensor/force_sensor.h"

#define HAND FORCE_CHANNEL_HAND
#define NEEDLE FORCE_CHANNEL_NEEDLE
#define HAND_AT_REST 1970U
#define NEEDLE_AT_REST 1780U
#define LOAD 200U  /* 1.77 N */
#define TREMBLE 2U /* Counts, up and down. */
#define TREMBLE_MN 20

static force_sensor_t sensor;
static const force_config_t *const config = &robot_prostate.force;

static void step(uint32_t hand, uint32_t needle)
{
    const uint32_t words[CARD_ADC_WORDS] = {hand, needle << 16U};
    force_sensor_step(&sensor, config, words, false);
}

static uint32_t doubts(force_channel_id_t channel)
{
    return sensor.sealed.channels[channel].doubts;
}

static force_zeroed_t zero(void)
{
    return force_sensor_zero(&sensor, config, true, true);
}

/* All readings but the last one that decides. */
static void zero_but_one(uint32_t tremble)
{
    force_sensor_begin_zero(&sensor);
    for (uint32_t i = 1U; i < LIMIT_FORCE_ZERO_CYCLES; i++) {
        const uint32_t counts = ((i % 2U) == 0U) ? 0U : (2U * tremble);
        step(HAND_AT_REST - tremble + counts, NEEDLE_AT_REST - tremble + counts);
        TEST_ASSERT_EQUAL_HEX32(0U, zero().ended);
    }
    step(HAND_AT_REST - tremble, NEEDLE_AT_REST - tremble);
}

static void zero_almost(void)
{
    zero_but_one(TREMBLE);
}

static void load(uint32_t hand, uint32_t needle)
{
    for (uint32_t i = 0U; i < 200U; i++) {
        step(hand, needle);
    }
}

void setUp(void)
{
    force_sensor_init(&sensor, config);
    step(HAND_AT_REST, NEEDLE_AT_REST);
}

void tearDown(void)
{
}

void test_SWR_FORCE_572_both_channels_are_zeroed_by_as_many_readings(void)
{
    zero_almost();
    TEST_ASSERT_TRUE(force_sensor_is_zeroing(&sensor));
    const force_zeroed_t zeroed = zero();
    TEST_ASSERT_EQUAL_HEX32(3U, zeroed.ended);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_DONE, zeroed.ends[HAND]);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_DONE, zeroed.ends[NEEDLE]);
    TEST_ASSERT_FALSE(force_sensor_is_zeroing(&sensor));
    TEST_ASSERT_EQUAL_HEX32(0U, doubts(HAND) | doubts(NEEDLE));
    TEST_ASSERT_INT32_WITHIN(TREMBLE_MN, 0, sensor.sealed.force_mn[HAND]);
    TEST_ASSERT_INT32_WITHIN(TREMBLE_MN, 0, sensor.sealed.force_mn[NEEDLE]);
}

void test_SWR_FORCE_700_a_channel_of_which_all_readings_are_the_same_is_doubted(void)
{
    zero_but_one(0U);
    const force_zeroed_t zeroed = zero();
    for (uint32_t i = 0U; i < ROBOT_FORCE_CHANNELS; i++) {
        TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_DONE, zeroed.ends[i]);
        TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_TOO_QUIET), doubts(i));
    }
    force_sensor_begin_zero(&sensor);
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_NOT_ZEROED),
                            doubts(HAND) & doubts(NEEDLE)); /* Judged anew. */
    zero_almost();
    (void)zero();
    TEST_ASSERT_EQUAL_HEX32(0U, doubts(HAND) | doubts(NEEDLE));
}

void test_SWR_FORCE_700_one_dead_channel_is_doubted_alone(void)
{
    force_sensor_begin_zero(&sensor);
    for (uint32_t i = 0U; i < LIMIT_FORCE_ZERO_CYCLES; i++) {
        step(HAND_AT_REST + (i % 2U), NEEDLE_AT_REST);
        (void)zero();
    }
    TEST_ASSERT_EQUAL_HEX32(0U, doubts(HAND));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_TOO_QUIET), doubts(NEEDLE));
}

void test_SWR_FORCE_700_a_hand_that_hardly_trembles_is_believed(void)
{
    zero_but_one(0U);
    step(HAND_AT_REST + 1U, NEEDLE_AT_REST);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_DONE, zero().ends[HAND]);
    TEST_ASSERT_LESS_THAN_UINT32(LIMIT_FORCE_STILL_NOISE / 16U,
                                 sensor.sealed.channels[HAND].noise_q8);
    TEST_ASSERT_EQUAL_HEX32(0U, doubts(HAND));
}

void test_SWR_FORCE_700_a_zeroing_that_has_failed_says_no_more(void)
{
    load(HAND_AT_REST + (4U * LOAD), NEEDLE_AT_REST);
    force_sensor_begin_zero(&sensor);
    for (uint32_t i = 0U; i < LIMIT_FORCE_ZERO_CYCLES; i++) {
        step(HAND_AT_REST + (4U * LOAD), NEEDLE_AT_REST);
        (void)zero();
    }
    TEST_ASSERT_NOT_EQUAL_HEX32(0U, doubts(HAND) & force_doubt_bit(FORCE_DOUBT_ZERO_WANDERED));
    TEST_ASSERT_EQUAL_HEX32(0U, doubts(HAND) & force_doubt_bit(FORCE_DOUBT_TOO_QUIET));
}

void test_SWR_FORCE_572_a_cycle_without_a_report_is_not_counted(void)
{
    zero_almost();
    TEST_ASSERT_EQUAL_HEX32(0U, force_sensor_zero(&sensor, config, false, true).ended);
    TEST_ASSERT_EQUAL_HEX32(3U, zero().ended);
}

void test_SWR_FORCE_574_what_moves_ends_it(void)
{
    zero_almost();
    const force_zeroed_t zeroed = force_sensor_zero(&sensor, config, true, false);
    TEST_ASSERT_EQUAL_HEX32(3U, zeroed.ended);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_MOVED, zeroed.ends[HAND]);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_MOVED, zeroed.ends[NEEDLE]);
    TEST_ASSERT_FALSE(force_sensor_is_zeroing(&sensor));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_NOT_ZEROED), doubts(HAND));
}

void test_SWR_FORCE_574_an_untrue_reading_ends_it_of_its_channel_alone(void)
{
    zero_almost();
    step(HAND_AT_REST, 0U);
    const force_zeroed_t zeroed = zero();
    TEST_ASSERT_EQUAL_HEX32(3U, zeroed.ended);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_DONE, zeroed.ends[HAND]);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_UNREAD, zeroed.ends[NEEDLE]);
    TEST_ASSERT_EQUAL_HEX32(0U, doubts(HAND));
    TEST_ASSERT_NOT_EQUAL_HEX32(0U, doubts(NEEDLE));
}

void test_SWR_FORCE_574_one_channel_goes_on_alone(void)
{
    force_sensor_begin_zero(&sensor);
    step(0U, NEEDLE_AT_REST);
    TEST_ASSERT_EQUAL_HEX32(1U, zero().ended);
    step(HAND_AT_REST, NEEDLE_AT_REST);
    TEST_ASSERT_EQUAL_HEX32(0U, zero().ended);
    TEST_ASSERT_TRUE(force_sensor_is_zeroing(&sensor));
}

void test_SWR_FORCE_574_stale_reports_end_it(void)
{
    zero_almost();
    force_sensor_miss(&sensor, false);
    const force_zeroed_t zeroed = force_sensor_zero(&sensor, config, false, true);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_UNREAD, zeroed.ends[HAND]);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_UNREAD, zeroed.ends[NEEDLE]);
}

void test_SWR_FORCE_563_a_new_zeroing_and_a_lost_card_take_the_zero_back(void)
{
    zero_almost();
    (void)zero();
    force_sensor_miss(&sensor, false);
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_STALE), doubts(HAND));
    step(HAND_AT_REST, NEEDLE_AT_REST);
    TEST_ASSERT_EQUAL_HEX32(0U, doubts(HAND));
    force_sensor_miss(&sensor, true);
    step(HAND_AT_REST, NEEDLE_AT_REST);
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_NOT_ZEROED), doubts(HAND));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_NOT_ZEROED), doubts(NEEDLE));
    zero_almost();
    (void)zero();
    force_sensor_begin_zero(&sensor);
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_NOT_ZEROED), doubts(HAND));
}

static void judge(uint32_t cycles, bool is_free, bool is_driven_in)
{
    for (uint32_t i = 0U; i < cycles; i++) {
        force_sensor_judge_pair(&sensor, is_free, is_driven_in);
    }
}

void test_SWR_FORCE_569_both_loaded_at_a_free_needle_is_doubted(void)
{
    zero_almost();
    (void)zero();
    load(HAND_AT_REST + LOAD, NEEDLE_AT_REST);
    TEST_ASSERT_FALSE(force_sensor_is_loaded(&sensor));
    load(HAND_AT_REST, NEEDLE_AT_REST + LOAD);
    TEST_ASSERT_FALSE(force_sensor_is_loaded(&sensor));
    load(HAND_AT_REST + LOAD, NEEDLE_AT_REST + LOAD);
    TEST_ASSERT_TRUE(force_sensor_is_loaded(&sensor));
    judge(LIMIT_FORCE_PAIR_CYCLES - 1U, true, false);
    TEST_ASSERT_EQUAL_HEX32(0U, doubts(HAND) | doubts(NEEDLE));
    judge(1U, false, false);
    judge(LIMIT_FORCE_PAIR_CYCLES - 1U, true, false);
    TEST_ASSERT_EQUAL_HEX32(0U, doubts(HAND) | doubts(NEEDLE));
    judge(1U, true, false);
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_FREE_NEEDLE_LOADED), doubts(HAND));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_FREE_NEEDLE_LOADED), doubts(NEEDLE));
    TEST_ASSERT_FALSE(force_sensor_is_loaded(&sensor));
}

void test_SWR_FORCE_569_one_doubtful_channel_is_no_pair(void)
{
    zero_almost();
    (void)zero();
    load(HAND_AT_REST + LOAD, NEEDLE_AT_REST + LOAD);
    sensor.sealed.channels[NEEDLE].doubts = force_doubt_bit(FORCE_DOUBT_STUCK);
    TEST_ASSERT_FALSE(force_sensor_is_loaded(&sensor));
    sensor.sealed.channels[NEEDLE].doubts = 0U;
    sensor.sealed.channels[HAND].doubts = force_doubt_bit(FORCE_DOUBT_STUCK);
    TEST_ASSERT_FALSE(force_sensor_is_loaded(&sensor));
}

void test_SWR_FORCE_569_a_needle_that_is_pulled_in_is_doubted(void)
{
    zero_almost();
    (void)zero();
    load(HAND_AT_REST + LOAD, NEEDLE_AT_REST - LOAD);
    TEST_ASSERT_TRUE(force_sensor_is_loaded(&sensor));
    judge(LIMIT_FORCE_PAIR_CYCLES, false, false);
    TEST_ASSERT_EQUAL_HEX32(0U, doubts(HAND) | doubts(NEEDLE));
    judge(LIMIT_FORCE_PAIR_CYCLES, false, true);
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_NEEDLE_PULLED_IN), doubts(HAND));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_NEEDLE_PULLED_IN), doubts(NEEDLE));
}

void test_SWR_FORCE_569_other_signs_are_possible_in_an_insertion(void)
{
    static const uint32_t hands[] = {HAND_AT_REST + LOAD, HAND_AT_REST - LOAD, HAND_AT_REST - LOAD};
    static const uint32_t needles[] = {NEEDLE_AT_REST + LOAD, NEEDLE_AT_REST + LOAD,
                                       NEEDLE_AT_REST - LOAD};
    zero_almost();
    (void)zero();
    for (uint32_t i = 0U; i < 3U; i++) {
        load(hands[i], needles[i]);
        judge(LIMIT_FORCE_PAIR_CYCLES, false, true);
        TEST_ASSERT_EQUAL_HEX32(0U, doubts(HAND) | doubts(NEEDLE));
    }
}

void test_SWR_FORCE_561_the_converter_is_that_of_the_robot_file(void)
{
    force_config_t other = *config;
    for (uint32_t converter = 0U; converter < 4U; converter++) {
        const uint32_t words[CARD_ADC_WORDS] = {(1000U << 16U) | 1001U, (1002U << 16U) | 1003U};
        other.channels[HAND].converter = converter;
        force_sensor_step(&sensor, &other, words, false);
        TEST_ASSERT_EQUAL_UINT32(1000U + converter, sensor.sealed.channels[HAND].counts[0]);
    }
}

void test_SWR_FORCE_610_a_zero_ages_with_its_reports_and_a_zeroing_makes_it_new(void)
{
    zero_almost();
    (void)zero();
    sensor.sealed.zero_cycles = LIMIT_FORCE_ZERO_AGE_CYCLES - 1U;
    TEST_ASSERT_FALSE(force_sensor_is_old(&sensor));
    load(HAND_AT_REST, NEEDLE_AT_REST);
    TEST_ASSERT_TRUE(force_sensor_is_old(&sensor));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_FORCE_ZERO_AGE_CYCLES, sensor.sealed.zero_cycles);
    force_sensor_grow_old(&sensor);
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_ZERO_OLD), doubts(HAND));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_ZERO_OLD), doubts(NEEDLE));
    zero_almost();
    (void)zero();
    TEST_ASSERT_FALSE(force_sensor_is_old(&sensor));
    TEST_ASSERT_EQUAL_HEX32(0U, doubts(HAND) | doubts(NEEDLE));
}

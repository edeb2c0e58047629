/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: which lengths a robot's probe may have, and the messages to clients about them.
 */
#include "unity.h"

#include "robot/probe.h"
#include "robot/robot_neuro.h"

extern const robot_t robot_bench2;
extern const robot_t robot_prostate;

static probe_t probe;

void setUp(void)
{
    probe = robot_neuro.probe;
}

void tearDown(void)
{
}

void test_SWR_PROBE_002_the_probe_of_each_robots_file_is_one_of_it(void)
{
    TEST_ASSERT_EQUAL(STATUS_OK, probe_judge(&robot_neuro, &robot_neuro.probe));
    TEST_ASSERT_EQUAL(STATUS_OK, probe_judge(&robot_prostate, &robot_prostate.probe));
    TEST_ASSERT_EQUAL(STATUS_OK, probe_judge(&robot_bench2, &robot_bench2.probe));
}

/* At an end, the others so that none is in its way. */
static status_t judge_end(uint32_t index, int32_t length_nm)
{
    probe = (probe_t){{0, 0, 0, 100000000}};
    probe.length_nm[index] = length_nm;
    return probe_judge(&robot_neuro, &probe);
}

void test_SWR_PROBE_002_a_length_beyond_an_end_of_its_range_is_refused(void)
{
    for (uint32_t i = 0U; i < robot_neuro.probe_length_count; i++) {
        const int32_t minimum_nm = robot_neuro.probe_minimum.length_nm[i];
        const int32_t maximum_nm = robot_neuro.probe_maximum.length_nm[i];
        TEST_ASSERT_EQUAL(STATUS_OK, judge_end(i, minimum_nm));
        TEST_ASSERT_EQUAL(STATUS_OK, judge_end(i, maximum_nm));
        TEST_ASSERT_EQUAL(STATUS_PROBE_LENGTH, judge_end(i, minimum_nm - 1));
        TEST_ASSERT_EQUAL(STATUS_PROBE_LENGTH, judge_end(i, maximum_nm + 1));
    }
}

void test_SWR_PROBE_002_a_length_that_the_robot_has_not_must_be_nothing(void)
{
    probe = robot_prostate.probe;
    probe.length_nm[2] = 1;
    TEST_ASSERT_EQUAL(STATUS_PROBE_LENGTH, probe_judge(&robot_prostate, &probe));
}

void test_SWR_PROBE_002_entry_point_and_cannula_end_at_the_treatment_point(void)
{
    static const uint32_t places[] = {NEURO_PROBE_ROBOT_TO_ENTRY, NEURO_PROBE_CANNULA_TO_TREATMENT};
    for (uint32_t i = 0U; i < 2U; i++) {
        probe = robot_neuro.probe;
        probe.length_nm[places[i]] = probe.length_nm[NEURO_PROBE_ROBOT_TO_TREATMENT];
        TEST_ASSERT_EQUAL(STATUS_OK, probe_judge(&robot_neuro, &probe));
        probe.length_nm[places[i]]++;
        TEST_ASSERT_EQUAL(STATUS_PROBE_ORDER, probe_judge(&robot_neuro, &probe));
    }
}

void test_SWR_PROBE_005_every_bit_of_the_lengths_counts_in_the_checksum(void)
{
    const uint32_t crc = probe_checksum(&probe);
    for (uint32_t i = 0U; i < ROBOT_PROBE_LENGTHS; i++) {
        for (uint32_t bit = 0U; bit < 31U; bit++) {
            probe.length_nm[i] ^= (int32_t)(1UL << bit);
            TEST_ASSERT_NOT_EQUAL_UINT32(crc, probe_checksum(&probe));
            probe.length_nm[i] ^= (int32_t)(1UL << bit);
        }
    }
    TEST_ASSERT_EQUAL_UINT32(crc, probe_checksum(&probe));
}

void test_SWR_PROBE_007_of_the_probe_the_present_length_is_reported_and_else_that_of_the_file(void)
{
    const reported_length_t of_probe = {"robot_to_entry", 5000000, 2U};
    const reported_length_t of_file = {"side_link", 60000000, 0U};
    probe.length_nm[1] = 7000000;
    TEST_ASSERT_EQUAL_INT32(7000000, probe_reported_nm(&of_probe, probe.length_nm));
    TEST_ASSERT_EQUAL_INT32(60000000, probe_reported_nm(&of_file, probe.length_nm));
}

/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a phantom is read from its text, and a bad one is refused with its line and the
 * reason. */
#include "unity.h"

#include "robot/robot_neuro.h"
#include "robot/robot_prostate.h"
#include "sim/box.h"
#include "sim/model/sim_phantom.h"

#include <stdio.h>
#include <string.h>

static sim_phantom_file_t phantom;
static char text[SIM_PHANTOM_SIZE];
static char reason[256];

void setUp(void)
{
    sim_phantom_write(&sim_phantom_usual, text, sizeof text);
}

void tearDown(void)
{
}

/* Replaces the first `old` of the text. */
static void replace(const char *old, const char *new)
{
    static char changed[SIM_PHANTOM_SIZE];
    const char *const at = strstr(text, old);

    TEST_ASSERT_NOT_NULL_MESSAGE(at, old);
    (void)snprintf(changed, sizeof changed, "%.*s%s%s", (int)(at - text), text, new,
                   at + strlen(old));
    (void)snprintf(text, sizeof text, "%s", changed);
}

static void expect_refused(const char *sentence)
{
    TEST_ASSERT_FALSE_MESSAGE(sim_phantom_read(&phantom, text, reason, sizeof reason), sentence);
    TEST_ASSERT_EQUAL_STRING(sentence, reason);
    setUp();
}

static void expect_read(void)
{
    TEST_ASSERT_TRUE_MESSAGE(sim_phantom_read(&phantom, text, reason, sizeof reason), reason);
}

void test_SWR_BOX_529_a_phantom_is_read_as_it_was_written(void)
{
    expect_read();
    TEST_ASSERT_EQUAL_MEMORY(&sim_phantom_usual, &phantom, sizeof phantom);
}

void test_SWR_BOX_529_blanks_and_remarks_have_no_meaning(void)
{
    replace("surface_mm 30", "# A remark\n\n  surface_mm \t 30 \r");
    expect_read();
    TEST_ASSERT_EQUAL_MEMORY(&sim_phantom_usual, &phantom, sizeof phantom);
}

void test_SWR_BOX_529_any_number_of_layers_up_to_eight_is_taken(void)
{
    sim_phantom_file_t many = sim_phantom_usual;

    for (uint32_t count = 0U; count <= SIM_LAYERS; count++) {
        many.tissue.layer_count = count;
        for (uint32_t i = 0U; i < SIM_LAYERS; i++) {
            many.tissue.layers[i] = (i < count) ? sim_phantom_usual.tissue.layers[i % 2U]
                                                : (sim_layer_t){.thickness_mm = 0.0};
        }
        sim_phantom_write(&many, text, sizeof text);
        expect_read();
        TEST_ASSERT_EQUAL_MEMORY(&many, &phantom, sizeof phantom);
    }
    (void)strcat(text, "\nlayer\n");
    expect_refused("line 174: there are too many parts called \"layer\".");
}

void test_SWR_BOX_530_a_number_that_is_none_or_out_of_range_is_refused(void)
{
    replace("surface_mm 30", "surface_mm deep");
    expect_refused("line 1: surface_mm is a number from -1000 to 1000, not \"deep\".");
    replace("surface_mm 30", "surface_mm");
    expect_refused("line 1: surface_mm is a number from -1000 to 1000, not \"\".");
    replace("surface_mm 30", "surface_mm 30 mm");
    expect_refused("line 1: surface_mm is a number from -1000 to 1000, not \"30 mm\".");
    replace("surface_mm 30", "surface_mm nan");
    expect_refused("line 1: surface_mm is a number from -1000 to 1000, not \"nan\".");
    replace("presliding_mm 0.2", "presliding_mm 0");
    expect_refused("line 2: presliding_mm is a number from 0.01 to 5, not \"0\".");
    replace("relaxing_share 0.45", "relaxing_share 0.91");
    expect_refused("line 19: relaxing_share is a number from 0 to 0.9, not \"0.91\".");
    replace("latency_ms 2", "latency_ms 17");
    expect_refused("line 43: latency_ms is a number from 0 to 16, not \"17\".");
}

void test_SWR_BOX_530_a_key_that_is_unknown_or_stands_twice_is_refused(void)
{
    replace("surface_mm 30", "surface_cm 3");
    expect_refused("line 1: a phantom has no \"surface_cm\".");
    replace("cutting_n 0.25", "surface_mm 30");
    expect_refused("line 12: a layer has no \"surface_mm\".");
    replace("offset_n 0", "cutting_n 0");
    expect_refused("line 42: a cell has no \"cutting_n\".");
    replace("cutting_n 0.25", "rupture_n 2");
    expect_refused("line 12: a second time there is \"rupture_n\".");
}

void test_SWR_BOX_530_a_key_or_part_that_is_missing_is_refused(void)
{
    replace("stick_mm_per_s 0.05", "");
    expect_refused("line 1: the phantom has no \"stick_mm_per_s\".");
    replace("cutting_n 0.25", "");
    expect_refused("line 5: the part that begins here has no \"cutting_n\".");
    replace("latency_ms 2\n\ncell needle", "latency_ms 2\n\ncell hand");
    expect_refused("line 45: there is a second part of the cell \"hand\".");
    replace("cell hand", "cell foot");
    expect_refused("line 39: a cell is \"hand\" or \"needle\", not \"foot\".");
    *strstr(text, "\ncell needle") = '\0';
    expect_refused("line 43: there is no part of the cell \"needle\".");
    replace("layer", "layer skin");
    expect_refused("line 5: nothing may stand behind layer, as does \"skin\".");
    text[0] = '\0';
    expect_refused("line 1: the phantom has no \"surface_mm\".");
}

void test_SWR_BOX_529_a_phantom_may_have_no_needle_target_or_images(void)
{
    static const sim_bevel_config_t straight = {0.0, 0.0};
    static const sim_imager_config_t none = {.period_ms = 0.0};

    *strstr(text, "\nneedle\n") = '\0';
    expect_read();
    TEST_ASSERT_EQUAL_MEMORY(&straight, &phantom.needle, sizeof straight);
    TEST_ASSERT_EQUAL_MEMORY(&none, &phantom.images, sizeof none);
    TEST_ASSERT_FALSE(sim_target_is_there(&phantom.target));
}

void test_SWR_BOX_529_a_target_is_read_as_it_was_written(void)
{
    sim_phantom_file_t moving = sim_phantom_usual;

    moving.target = sim_target_usual;
    sim_phantom_write(&moving, text, sizeof text);
    expect_read();
    TEST_ASSERT_EQUAL_MEMORY(&moving, &phantom, sizeof phantom);
}

void test_SWR_BOX_530_needle_target_and_images_stand_once_and_whole(void)
{
    replace("\nneedle\n", "\nneedle bent\n");
    expect_refused("line 51: nothing may stand behind needle, as does \"bent\".");
    replace("\ntarget\n", "\nneedle\n");
    expect_refused("line 55: there is a second part called \"needle\".");
    replace("period_ms 2000\n", "");
    expect_refused("line 66: the part that begins here has no \"period_ms\".");
    replace("curvature_per_mm 0.0041", "curvature_per_mm 0.021");
    expect_refused("line 52: curvature_per_mm is a number from 0 to 0.02, not \"0.021\".");
    replace("shift_to_mm 0", "period_ms 0");
    expect_refused("line 64: a target has no \"period_ms\".");
}

void test_SWR_BOX_530_a_line_that_is_too_long_is_refused(void)
{
    replace(
        "surface_mm 30",
        "surface_mm "
        "30."
        "0000000000000000000000000000000000000000000000000000000000000000000000000000000000000000");
    expect_refused("line 1: too long is \"surface_mm 30.00000000000000000000000000\".");
}

void test_SWR_BOX_529_a_text_without_room_is_cut(void)
{
    char small[64];

    (void)memset(small, 'x', sizeof small);
    sim_phantom_write(&sim_phantom_usual, small, 40U);
    TEST_ASSERT_EQUAL_UINT32(39U, strlen(small));
    TEST_ASSERT_EQUAL_CHAR('x', small[40]);
}

static double fall_in_a_second(sim_tissue_t *tissue, double depth_mm)
{
    const double before = tissue->force_n;

    for (uint32_t i = 0U; i < 10000U; i++) {
        sim_tissue_step(tissue, &sim_phantom_usual.tissue, 0.0001, depth_mm, 0.0);
    }
    return 1.0 - tissue->force_n / before;
}

/* A needle of 2 to 6 mm/s, stopped 2 mm into each membrane and in the middle of each layer. */
void test_SWR_BOX_531_the_usual_phantom_has_two_membranes_and_relaxes_as_soft_tissue_does(void)
{
    static const double stops_mm[] = {32.0, 50.0, 67.0, 90.0};

    for (double v = 2.0; v < 6.5; v += 1.0) {
        sim_tissue_t tissue;
        double depth_mm = 0.0;
        sim_tissue_init(&tissue, &sim_phantom_usual.tissue, depth_mm);
        for (uint32_t stop = 0U; stop < 4U; stop++) {
            while (depth_mm < stops_mm[stop]) {
                depth_mm += v * 0.0001;
                sim_tissue_step(&tissue, &sim_phantom_usual.tissue, 0.0001, depth_mm, v);
            }
            const double fallen = fall_in_a_second(&tissue, depth_mm);
            TEST_ASSERT_TRUE((fallen > 0.2) && (fallen < 0.4));
        }
        TEST_ASSERT_EQUAL_UINT32(2U, tissue.popped);
    }
}

void test_SWR_BOX_531_a_robot_with_a_force_sensor_has_the_usual_phantom(void)
{
    TEST_ASSERT_EQUAL_PTR(&sim_phantom_usual, box_usual_phantom(&robot_prostate));
    TEST_ASSERT_EQUAL_UINT32(0U, box_usual_phantom(&robot_neuro)->tissue.layer_count);
}

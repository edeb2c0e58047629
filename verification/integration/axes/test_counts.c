/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the way by which counts of an axis fall short of its motor is added up. No pause
 * of the pedal, no fault that comes and goes, no slow axis and no START_UP hides it, on the
 * simulated box, whose true positions are compared with those believed.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "robot/robot_bench2.h"
#include "robot/robot_neuro.h"
#include "robot/robot_prostate.h"
#include "unit/support/scenes.h"

#include <stdio.h>

#define MOST_CYCLES 120000U
#define ALWAYS MOST_CYCLES

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

/* True against believed position, in micrometres or thousandths of a degree, without sign. */
static double apart(uint32_t axis)
{
    const axis_config_t *const config = &robot_neuro.axes[axis];
    const double ticks = rig.box.axes[axis].motor.position_ticks - (double)rig_position(&rig, axis);
    const double units = ((ticks < 0.0) ? -ticks : ticks) * (double)config->unit_per_tick_q16;
    const bool is_mm = config->unit == (uint8_t)AXIS_UNIT_MM;
    return is_mm ? (units / 65536.0 / 1000.0) : (units / 65536.0 / 4294967296.0 * 360000.0);
}

/* A millimetre; an axis that turns counts more coarsely. */
static double most_apart(uint32_t axis)
{
    const bool is_mm = robot_neuro.axes[axis].unit == (uint8_t)AXIS_UNIT_MM;
    return is_mm ? 1000.0 : 2500.0;
}

static void set_encoder(uint32_t axis, const char *fault)
{
    char order[48];
    (void)snprintf(order, sizeof order, "encoder %s %s", robot_neuro.axes[axis].name, fault);
    rig_box(&rig, order);
}

static bool is_at_fault(uint32_t axis)
{
    return rig.outputs.snapshot.axes[axis].power == (uint32_t)AXIS_POWER_FAULT;
}

/* Ordered at the edges only: an order that is repeated begins anew. */
static void tap_pedal(uint32_t cycle, uint32_t on, uint32_t of)
{
    if ((cycle % of) == 0U) {
        rig_box(&rig, "pedal press");
    } else if ((cycle % of) == on) {
        rig_box(&rig, "pedal release");
    } else {
        /* As it is. */
    }
}

typedef struct {
    uint32_t axis;
    uint32_t pedal_on; /* ms of each pedal_of */
    uint32_t pedal_of;
    const char *fault;
    uint32_t broken_ms; /* of each 100 */
} play_t;

/* Plays until the axis is at fault. @return how far true and believed position have been apart */
static double play(const play_t *self)
{
    double most = 0.0;
    for (uint32_t i = 0U; !is_at_fault(self->axis); i++) {
        TEST_ASSERT_LESS_THAN_UINT32(MOST_CYCLES, i);
        TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_ORDER_DONE));
        set_encoder(self->axis, ((i % 100U) < self->broken_ms) ? self->fault : "normal");
        tap_pedal(i, self->pedal_on, self->pedal_of);
        rig_cycle(&rig);
        most = (apart(self->axis) > most) ? apart(self->axis) : most;
    }
    rig_release(&rig);
    rig_expect_nothing_known(&rig, self->axis);
    return most;
}

static void begin_jog(uint32_t axis, int32_t ticks)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = axis, .to_ticks = ticks}};
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
}

static void begin_move(int32_t x_nm, int32_t y_nm, int32_t z_nm)
{
    rigid_t identity;
    const rigid_t pose = rig_pose(x_nm, y_nm, z_nm);
    rigid_set_identity(&identity);
    rig_start_homed(&rig);
    rig_register(&rig, &identity);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &pose).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_forget(&rig);
}

void test_SWR_AXIS_018_an_encoder_that_is_stuck_under_a_tapped_pedal_is_found(void)
{
    begin_jog(NEURO_AXIS_INSERTION, 60000);
    TEST_ASSERT_TRUE(play(&(play_t){NEURO_AXIS_INSERTION, 35U, 95U, "stuck", 100U}) <= 500.0);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_NO_COUNTS));
}

void test_SWR_AXIS_019_half_the_counts_under_a_tapped_pedal_are_found(void)
{
    begin_jog(NEURO_AXIS_INSERTION, 60000);
    TEST_ASSERT_TRUE(play(&(play_t){NEURO_AXIS_INSERTION, 80U, 180U, "half", 100U}) <=
                     most_apart(NEURO_AXIS_INSERTION));
}

void test_SWR_AXIS_019_a_carriage_that_counts_half_beside_others_never_arrives(void)
{
    begin_move(-20000000, 170000000, 70000000);
    TEST_ASSERT_TRUE(play(&(play_t){NEURO_AXIS_FEET, ALWAYS, ALWAYS, "half", 100U}) <=
                     most_apart(NEURO_AXIS_FEET));
}

void test_SWR_AXIS_019_an_encoder_that_is_stuck_now_and_then_is_found(void)
{
    static const int32_t ends[ROBOT_AXIS_MAX] = {-5000, 4000, -2000, 100000, 5000, -300, -1100};
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        begin_jog(i, ends[i]);
        TEST_ASSERT_TRUE(play(&(play_t){i, ALWAYS, ALWAYS, "stuck", 10U}) <= most_apart(i));
    }
}

/* Half of the counts are lost for so many ms of each few, from the first cycle of a move on. */
static double flicker(uint32_t axis, uint32_t broken_ms, uint32_t of_ms, uint32_t pedal_on_ms)
{
    double most = 0.0;
    for (uint32_t i = 0U; !is_at_fault(axis); i++) {
        TEST_ASSERT_LESS_THAN_UINT32(MOST_CYCLES, i);
        TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_ORDER_DONE));
        tap_pedal(i, pedal_on_ms, (pedal_on_ms == ALWAYS) ? ALWAYS : (pedal_on_ms + 40U));
        set_encoder(axis, ((i % of_ms) < broken_ms) ? "half" : "normal");
        rig_cycle(&rig);
        most = (apart(axis) > most) ? apart(axis) : most;
    }
    rig_release(&rig);
    rig_expect_nothing_known(&rig, axis);
    return most;
}

/* Their motors have not yet shown how fast they are, of most axes not even in homing. */
void test_SWR_AXIS_027_counts_that_come_and_go_in_a_first_jog_are_found(void)
{
    static const int32_t ends[ROBOT_AXIS_MAX] = {-2400, 2400, -2300, 120000, 7000, -360, -1200};
    static const uint32_t rhythms[][2] = {{1U, 2U}, {1U, 10U}, {3U, 10U}, {4U, 8U}, {1U, 20U}};
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        for (uint32_t k = 0U; k < (sizeof rhythms / sizeof rhythms[0]); k++) {
            begin_jog(i, ends[i]);
            TEST_ASSERT_TRUE(flicker(i, rhythms[k][0], rhythms[k][1], ALWAYS) <=
                             (most_apart(i) / 2.0));
        }
    }
}

/* Pushes of a count or two are no way to hide them. */
void test_SWR_AXIS_027_counts_that_come_and_go_under_a_tapped_pedal_are_found(void)
{
    static const int32_t ends[ROBOT_AXIS_MAX] = {-2400, 2400, -2300, 60000, 3000, -360, -1200};
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        begin_jog(i, ends[i]);
        TEST_ASSERT_TRUE(flicker(i, 2U, 4U, 40U) <= (most_apart(i) / 2.0));
    }
}

void test_SWR_AXIS_027_a_target_is_not_reached_with_counts_that_come_and_go(void)
{
    begin_move(-8000000, 200000000, 90000000);
    TEST_ASSERT_TRUE(flicker(NEURO_AXIS_FEET, 4U, 8U, ALWAYS) <=
                     (most_apart(NEURO_AXIS_FEET) / 2.0));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_UNEVEN_COUNTS));
    begin_move(-8000000, 191000000, 61000000);
    TEST_ASSERT_TRUE(flicker(NEURO_AXIS_PITCH, 3U, 10U, ALWAYS) <=
                     (most_apart(NEURO_AXIS_PITCH) / 2.0));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_UNEVEN_COUNTS));
    begin_move(-8000000, 195000000, 40000000);
    TEST_ASSERT_TRUE(flicker(NEURO_AXIS_HEAD, 3U, 10U, ALWAYS) <=
                     (most_apart(NEURO_AXIS_HEAD) / 2.0));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_UNEVEN_COUNTS));
}

/* Its profile is so slow that its motor runs in short pushes. */
void test_SWR_AXIS_019_half_the_counts_of_an_axis_that_is_slower_than_its_motor_are_found(void)
{
    begin_move(16000000, 190000000, 60000000);
    const int32_t cruise_q8 =
        robot_neuro.axes[NEURO_AXIS_LATERAL].full_speed_ticks_per_s * 256 / 10;
    TEST_ASSERT_TRUE(play(&(play_t){NEURO_AXIS_LATERAL, ALWAYS, ALWAYS, "half", 100U}) <=
                     most_apart(NEURO_AXIS_LATERAL));
    TEST_ASSERT_INT32_WITHIN(
        cruise_q8, 0, rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].setpoint_speed_ticks_per_s_q8);
}

/* A short jog, and START_UP: it enables every axis anew, and a homed one is not homed again. */
static void push_and_start_up(void)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_INSERTION, .to_ticks = 60000}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_box(&rig, "pedal press");
    rig_cycles(&rig, 80U);
    rig_release(&rig);
    if (!is_at_fault(NEURO_AXIS_INSERTION)) {
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
        TEST_ASSERT_TRUE(axis_is_homed(&rig.controller.axes[NEURO_AXIS_INSERTION]));
    }
}

void test_SWR_AXIS_019_start_up_makes_no_missing_count_good(void)
{
    uint32_t pushes = 0U;
    rig_start_homed(&rig);
    set_encoder(NEURO_AXIS_INSERTION, "half");
    while (!is_at_fault(NEURO_AXIS_INSERTION)) {
        TEST_ASSERT_LESS_THAN_UINT32(40U, pushes);
        push_and_start_up();
        pushes++;
    }
    TEST_ASSERT_GREATER_THAN_UINT32(1U, pushes);
    TEST_ASSERT_TRUE(apart(NEURO_AXIS_INSERTION) <= most_apart(NEURO_AXIS_INSERTION));
}

/* How late a machine is that is no real-time one: mostly hardly, now and then by several cycles.
 * Never two of those in a row, which would stop the loop rightly. */
static uint32_t next_lateness(uint32_t *random)
{
    *random = (*random * 1664525U) + 1013904223U;
    const uint32_t chance = *random >> 16U;
    return ((chance % 64U) == 0U) ? (300U + (chance % 1500U)) : (chance % 150U);
}

void test_SWR_CTRL_014_cycles_that_come_late_make_no_sound_encoder_uneven(void)
{
    uint32_t random = 1U;
    rig_start(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    rig_forget(&rig);
    while (rig.answer_count == 0U) {
        TEST_ASSERT_LESS_THAN_UINT32(MOST_CYCLES, rig.controller.sealed.cycle);
        rig.late_us = next_lateness(&random);
        rig_cycle(&rig);
    }
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_UNEVEN_COUNTS));
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig.answers[0].kind);
    TEST_ASSERT_GREATER_THAN_UINT32(10U, rig.outputs.snapshot.overruns);
}

/* The cycle after a late one ends at once, and is one of those in which the servo is off. */
static void jog_with_brief_pauses(uint32_t axis, int32_t ticks)
{
    uint32_t pauses = 0U;
    begin_jog(axis, ticks);
    rig_press(&rig);
    rig_forget(&rig);
    for (uint32_t i = 0U; (i < MOST_CYCLES) && (rig.answer_count == 0U); i++) {
        const bool is_off = rig_sent(&rig, axis).drive.mode == (uint32_t)CARD_DRIVE_OFF;
        rig.early_us = (is_off && (rig.early_us == 0U)) ? 967U : 0U;
        pauses += (rig.early_us != 0U) ? 1U : 0U;
        rig_cycle(&rig);
    }
    rig.early_us = 0U;
    TEST_ASSERT_GREATER_THAN_UINT32(10U, pauses);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig.answers[0].kind);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_UNEVEN_COUNTS));
}

void test_SWR_AXIS_160_cycles_that_make_good_for_late_ones_make_no_sound_encoder_uneven(void)
{
    jog_with_brief_pauses(NEURO_AXIS_LATERAL, -2000);
    jog_with_brief_pauses(NEURO_AXIS_YAW, -600);
}

/* START_UP under the pedal, each exchange so much later than the wake-up at most. */
static void expect_even(const robot_t *robot, uint32_t jitter_us)
{
    rig_start_robot(&rig, robot);
    rig.jitter_us = jitter_us;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, MOST_CYCLES).kind);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_UNEVEN_COUNTS));
}

void test_SWR_CTRL_014_exchanges_apart_from_the_wake_ups_make_no_sound_encoder_uneven(void)
{
    static const robot_t *const robots[] = {&robot_neuro, &robot_prostate, &robot_bench2};
    static robot_t near;
    for (uint32_t i = 0U; i < SCENES(sizeof robots / sizeof robots[0]); i++) {
        near = *robots[i];
        rig_put_near_switches(&near);
        expect_even(&near, 400U);
    }
}

/* A frame sent while the box stood has not gone out; its first command took effect late. */
void test_SWR_AXIS_047_a_box_that_stands_for_some_cycles_makes_no_count_wrong(void)
{
    static robot_t near;
    near = robot_neuro;
    rig_put_near_switches(&near);
    rig_start_robot(&rig, &near);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    rig_forget(&rig);
    while (rig.answer_count == 0U) {
        rig.held_cycles = ((rig.controller.sealed.cycle % 97U) == 0U) ? 3U : rig.held_cycles;
        rig_cycle(&rig);
    }
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig.answers[0].kind);
    for (uint32_t i = 0U; i < near.axis_count; i++) {
        TEST_ASSERT_FALSE(axis_is_faulty(&rig.controller.axes[i]));
    }
}

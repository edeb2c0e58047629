/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/scenario/hands.h"

#include "charts/arming_chart.h"
#include "limits/requirement_limits.h"
#include "supervise/scenario/prng.h"
#include "supervise/scenario/targets.h"

#include "unity.h"

#include <stdio.h>

#define ORDER_SIZE 64U
#define UM_PER_MM 1000
#define MN_PER_N 1000
#define MS_PER_S 1000
#define DEPTH_NM 15000000    /* Of the needle at the target. */
#define BEFORE_NM 30000000   /* Way before the target, on the needle's line. */
#define ALIGN_CYCLES 120000U /* Of the slowest robot. */
#define AWAY_CYCLES 1500U
#define SETTLED_CYCLES 300U
#define ZERO_CYCLES (LIMIT_FORCE_ZERO_CYCLES + 20U)
#define BREAK_PARTS 2500U /* In one of so many cycles of a motion a cell breaks. */
#define MEND_CYCLES 4000U
#define JERK_CYCLES 12U
#define JUMP_MN ((int32_t)LIMIT_FORCE_STEP_MN * 9 / 10) /* Less than a step that is doubted. */

static uint32_t below(hands_t *self, uint32_t bound)
{
    return prng_below(&self->random, bound);
}

static int32_t between(hands_t *self, int32_t least, int32_t most)
{
    return least + (int32_t)below(self, (uint32_t)(most - least) + 1U);
}

static void order(rig_t *rig, const char *words, int32_t number)
{
    char line[ORDER_SIZE];
    (void)snprintf(line, sizeof line, "%s %d", words, (int)number);
    rig_box(rig, line);
}

void hands_begin(hands_t *self, uint32_t seed)
{
    *self = (hands_t){.random = (seed * 2246822519U) | 1U};
    for (uint32_t i = 0U; i < 8U; i++) {
        (void)below(self, 2U);
    }
    self->is_brittle = (seed % 2U) == 0U;
    self->is_careful = (seed % 3U) != 0U;
}

/* Its target is drawn near along the needle's line, so that a hand may come there. */
static rigid_t draw_near(rig_t *rig, const robot_t *robot)
{
    const axis_config_t *const along = &robot->axes[robot->needle_axis];
    rigid_t pose = targets_first(robot);
    rig_start_robot_targeted(rig, robot, &pose);
    const int64_t depth_nm = (int64_t)rig->controller.plan.target_ticks[robot->needle_axis] *
                             along->unit_per_tick_q16 / 65536;
    const point_t near = {0, 0, (int32_t)(DEPTH_NM - depth_nm)};
    pose.translation = rigid_apply(&pose, &near);
    return pose;
}

/* By the operator's own commands, under the pedal. */
static void align(rig_t *rig, const robot_t *robot)
{
    const rigid_t pose = draw_near(rig, robot);
    const point_t before = {0, 0, -BEFORE_NM};
    command_t entry = {.kind = (uint32_t)COMMAND_ENTRY, .as.pose = {.pose = pose}};
    entry.as.pose.pose.translation = rigid_apply(&pose, &before);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(rig, entry).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(rig, &pose).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK,
                             rig_command(rig, (command_t){.kind = (uint32_t)COMMAND_ALIGN}).status);
    rig_press(rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(rig, ALIGN_CYCLES).kind);
    rig_release(rig);
}

/* Two stiff layers in front of the target, the membrane of each where a hand comes. */
static void lay_tissue(hands_t *self, rig_t *rig)
{
    sim_phantom_file_t phantom = sim_phantom_usual;
    phantom.tissue.surface_mm = (double)between(self, 1000, 5000) / UM_PER_MM;
    phantom.tissue.layers[0].thickness_mm = (double)between(self, 4000, 7000) / UM_PER_MM;
    for (uint32_t i = 0U; i < phantom.tissue.layer_count; i++) {
        phantom.tissue.layers[i].stiffness_n_per_mm = (double)between(self, 500, 2000) / MN_PER_N;
    }
    box_force_lay(&rig->box.force, &phantom);
}

void hands_start(hands_t *self, rig_t *rig, const robot_t *robot, uint32_t seed)
{
    static rig_t aligned;
    static const robot_t *of;
    if (of != robot) {
        align(rig, robot);
        rig_cycles(rig, SETTLED_CYCLES);
        rig_forget(rig);
        aligned = *rig;
        of = robot;
    }
    *rig = aligned;
    for (uint32_t i = 0U; i < (uint32_t)SIM_CELLS; i++) {
        rig->box.force.cells[i].random = (sim_random_t){seed + i};
    }
    lay_tissue(self, rig);
}

static void press(hands_t *self, rig_t *rig, int32_t least_mn, int32_t most_mn)
{
    order(rig, "grip", between(self, least_mn, most_mn));
    rig_box(rig, "hand press");
}

/* Like a spring, soft or stiff. @return way on which its force grows by 1 N, um */
static int32_t hold_on(hands_t *self, rig_t *rig)
{
    const int32_t um_per_n = between(self, 200, 5000);
    order(rig, "hand stiffness", UM_PER_MM * MN_PER_N / um_per_n);
    return um_per_n;
}

static void swing(hands_t *self, rig_t *rig)
{
    const int32_t um = hold_on(self, rig) * between(self, 200, 5000) / MN_PER_N;
    self->swing_cycles = 20U + below(self, 150U);
    const int32_t um_per_s = um * MS_PER_S / (int32_t)self->swing_cycles;
    self->um_per_s = (um_per_s < BOX_WISH_MOST_UM_PER_S) ? um_per_s : BOX_WISH_MOST_UM_PER_S;
}

/* Another phantom, or the membranes of this one again. */
static void change_tissue(hands_t *self, rig_t *rig)
{
    if (below(self, 2U) == 0U) {
        lay_tissue(self, rig);
    } else {
        rig_box(rig, "tissue whole");
    }
}

static void act(hands_t *self, rig_t *rig)
{
    self->swing_cycles = 0U;
    self->wait_cycles = 20U + below(self, 1500U);
    switch (below(self, 16U)) {
    case 0:
    case 1:
    case 2:
        rig_box(rig, "hand release");
        break;
    case 3:
    case 4:
    case 5:
    case 6:
    case 7:
    case 8:
        press(self, rig, 200, 2000);
        break;
    case 9:
        press(self, rig, -5000, 7500);
        self->wait_cycles = JERK_CYCLES + below(self, JERK_CYCLES);
        break;
    case 10:
        order(rig, "hand go", hold_on(self, rig) * between(self, -1000, 4000) / MN_PER_N);
        break;
    case 11:
    case 12:
        (void)hold_on(self, rig);
        order(rig, "hand speed", between(self, -500, 2000));
        break;
    case 13:
        swing(self, rig);
        break;
    default:
        change_tissue(self, rig);
        break;
    }
}

static void keep_swinging(hands_t *self, rig_t *rig)
{
    if (self->swing_cycles == 0U) {
        return;
    }
    self->swung_cycles++;
    if (self->swung_cycles >= self->swing_cycles) {
        self->swung_cycles = 0U;
        self->um_per_s = -self->um_per_s;
        order(rig, "hand speed", self->um_per_s);
    }
}

/* Its zero jumps, as that of a cell which was bent. */
static void jump(hands_t *self, rig_t *rig)
{
    sim_load_cell_t *const hand = &rig->box.force.cells[SIM_CELL_HAND];
    rig_box(rig, "force hand drift");
    hand->config.offset_n += (double)between(self, -JUMP_MN, JUMP_MN) / MN_PER_N;
}

static void break_cell(hands_t *self, rig_t *rig)
{
    static const char *const cells[] = {"hand", "hand", "needle"};
    static const char *const faults[] = {"stuck", "broken", "full",  "step",
                                         "step",  "drift",  "drift", "noisy"};
    char line[ORDER_SIZE];
    const char *const cell = cells[below(self, (uint32_t)(sizeof cells / sizeof cells[0]))];
    const uint32_t fault = below(self, 1U + (uint32_t)(sizeof faults / sizeof faults[0]));
    if (fault < (uint32_t)(sizeof faults / sizeof faults[0])) {
        (void)snprintf(line, sizeof line, "force %s %s", cell, faults[fault]);
    } else {
        (void)snprintf(line, sizeof line, "force %s %d", cell, (int)between(self, 0, 4095));
    }
    if (below(self, 4U) == 0U) {
        jump(self, rig);
    } else {
        rig_box(rig, line);
    }
    self->mend_cycles = 1U + below(self, MEND_CYCLES);
}

static void let_cells_break(hands_t *self, rig_t *rig)
{
    if (self->mend_cycles > 0U) {
        self->mend_cycles--;
        if (self->mend_cycles == 0U) {
            rig->box.force.cells[SIM_CELL_HAND].config.offset_n =
                rig->box.force.phantom.cells[SIM_CELL_HAND].offset_n;
            rig_box(rig, "force hand normal");
            rig_box(rig, "force needle normal");
        }
    } else if (self->is_brittle && (rig->outputs.snapshot.order == (uint32_t)ARMING_STATE_MOVING) &&
               (below(self, BREAK_PARTS) == 0U)) {
        break_cell(self, rig);
    } else {
        /* They work. */
    }
}

void hands_play(hands_t *self, rig_t *rig)
{
    let_cells_break(self, rig);
    if (self->wait_cycles > 0U) {
        self->wait_cycles--;
        keep_swinging(self, rig);
    } else {
        act(self, rig);
    }
}

void hands_leave(hands_t *self, rig_t *rig)
{
    self->swing_cycles = 0U;
    self->wait_cycles = AWAY_CYCLES;
    rig_box(rig, "hand release");
}

bool hands_are_away(const hands_t *self, const rig_t *rig)
{
    return (rig->box.force.hand.act == SIM_HAND_OFF) && (self->wait_cycles > ZERO_CYCLES) &&
           (self->wait_cycles < (AWAY_CYCLES - SETTLED_CYCLES));
}

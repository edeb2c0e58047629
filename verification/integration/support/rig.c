/* SPDX-License-Identifier: Apache-2.0 */
#include "integration/support/rig.h"

#include "axis/follower.h"
#include "base/seal.h"
#include "card/card_dialect.h"
#include "card/card_words.h"
#include "integration/support/aim32_box.h"
#include "interface/app/answer_list.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "robot/robot_prostate.h"
#include "unity.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

/* So low that at home_speed a tick ahead still leaves more than the slowest speed. */
#define MAGNITUDE_GAIN_PER_S 24U
#define NEAR_SHARE 16 /* So much of a second at full speed away from its switch. */
#define TEXT_SIZE 128U
#define HOME_CYCLES 150000U /* Homing of the slowest robot. */

/* The axis whose magnitudes a card without pwm could take. */
static const axis_config_t *last_pwm(const robot_t *robot)
{
    const axis_config_t *found = &robot->axes[0];
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        found = (robot->axes[i].card_type == (uint8_t)CARD_TYPE_PWM) ? &robot->axes[i] : found;
    }
    return found;
}

void rig_set_magnitude_robot(robot_t *robot, const robot_t *from)
{
    const axis_config_t *const pwm = last_pwm(from);
    *robot = *from;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        axis_config_t *const row = &robot->axes[i];
        if (row->card_type == (uint8_t)CARD_TYPE_NON_PWM) {
            row->minimum_duty = pwm->minimum_duty;
            row->maximum_duty = pwm->maximum_duty;
            row->gain_per_s = MAGNITUDE_GAIN_PER_S;
            row->seal = seal_of(SEAL_START, (const uint8_t *)row, offsetof(axis_config_t, seal));
        }
    }
}

void rig_start_robot(rig_t *self, const robot_t *robot)
{
    (void)memset(self, 0, sizeof *self);
    box_init(&self->box, robot, 1U);
    self->robot = *robot;
    controller_init(&self->controller, &self->robot);
    self->elapsed_us = 1000U;
    rig_cycles(self, 20U);
}

void rig_start(rig_t *self)
{
    rig_start_robot(self, &robot_neuro);
}

/* OpenIGTLink's own; the page of the rig sends all else. */
static bool is_of_connection(uint32_t kind)
{
    return (kind == (uint32_t)COMMAND_PROPOSE_REGISTRATION) ||
           (kind == (uint32_t)COMMAND_PROPOSE_ENTRY) ||
           (kind == (uint32_t)COMMAND_PROPOSE_TARGET) || (kind == (uint32_t)COMMAND_NEEDLE);
}

static void sign(command_t *command)
{
    if ((command->source == (uint32_t)COMMAND_SOURCE_IGTL) && (command->peer == 0U)) {
        const bool is_its = is_of_connection(command->kind);
        command->source = is_its ? (uint32_t)COMMAND_SOURCE_IGTL : (uint32_t)COMMAND_SOURCE_HTTP;
        command->peer = is_its ? RIG_CONNECTION : RIG_PAGE;
    }
}

/* The page of the rig takes authority when it is free, and renews it. */
static void keep_authority(rig_t *self)
{
    const bool is_free = authority_is_free(&self->controller.authority);
    const bool is_due =
        (self->command_count == 0U) && ((self->controller.sealed.cycle % 1000U) == 0U);
    if (self->is_page_away || (!is_free && !is_due) ||
        (self->command_count >= CONTROLLER_COMMANDS)) {
        return;
    }
    for (uint32_t i = self->command_count; i > 0U; i--) {
        self->commands[i] = self->commands[i - 1U];
    }
    self->commands[0] = (command_t){
        .id = RIG_OWN_ID, .kind = is_free ? (uint32_t)COMMAND_TAKE : (uint32_t)COMMAND_RENEW};
    self->command_count++;
}

/* Answers of the cards to the frames of the cycle before. */
static void exchange(rig_t *self)
{
    self->inputs.frames_received =
        (self->dialect == (uint32_t)CARD_DIALECT_OWN)
            ? box_exchange(&self->box, self->outputs.frames_to_send,
                           (const uint8_t(*)[CARD_FRAME_BYTES])self->outputs.frames,
                           self->inputs.frames)
            : aim32_box_exchange(&self->box, &self->outputs, self->controller.sealed.sequence,
                                 self->inputs.frames);
    self->inputs.frames_received &= ~(self->frames_late | self->frames_failed);
    self->inputs.frames_late = self->frames_late;
    self->inputs.frames_failed = self->frames_failed;
}

/* A box that stands sends nothing in time, and what was sent meanwhile but for the first is not
 * sent at all. */
static void exchange_held(rig_t *self)
{
    static uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
    if (self->held_cycles == 0U) {
        exchange(self);
        return;
    }
    if (!self->is_held) {
        (void)memcpy(self->held_frames, self->outputs.frames, sizeof frames);
    }
    self->held_cycles--;
    self->is_held = self->held_cycles > 0U;
    if (!self->is_held) {
        (void)box_exchange(&self->box, self->outputs.frames_to_send,
                           (const uint8_t(*)[CARD_FRAME_BYTES])self->held_frames, frames);
    }
    self->inputs.frames_late = self->outputs.frames_to_send;
}

/* How much later the exchange comes than in the cycle before, beside what the cycle lasts. */
static int32_t next_shift(rig_t *self)
{
    const uint32_t before_us = self->shift_us;
    self->shift_us = sim_random_below(&self->random, self->jitter_us + 1U);
    return (int32_t)self->shift_us - (int32_t)before_us;
}

/* The frames of the last cycle leave in it; a test acts just before. */
static void gather(rig_t *self)
{
    keep_authority(self);
    for (uint32_t i = 0U; (i < self->command_count) && !self->is_page_away; i++) {
        sign(&self->commands[i]);
    }
    (void)memset(&self->inputs, 0, sizeof self->inputs);
    self->inputs.dialect = self->dialect;
    self->inputs.is_dialect_accepted = self->is_dialect_accepted;
    exchange_held(self);
    const uint32_t more_us = self->late_us - self->early_us;
    box_advance(&self->box, (uint32_t)((int32_t)(1000U + more_us) + next_shift(self)));
    bsp_inputs_t sampled = box_sample(&self->box);
    sampled.valid &= ~self->unread;
    self->inputs.elapsed_us = self->elapsed_us + more_us;
    self->exchanged_us += 1000U + self->was_late_us;
    self->was_late_us = more_us;
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        self->inputs.samples.sampled_us[slot] = self->exchanged_us;
    }
    self->inputs.samples.error_us = LIMIT_SAMPLE_ERROR_SIM_US;
    board_inputs_take(&self->board_inputs, &sampled, &self->inputs);
    self->inputs.has_button = self->has_no_button ? 0U : 1U;
    self->inputs.silent_sources = self->silent_sources;
    self->inputs.unfit = self->unfit;
    self->inputs.lacks_black_box = self->lacks_black_box;
    self->inputs.cycles_lost = self->cycles_lost;
    self->inputs.is_recorder_failing = self->is_recorder_failing;
    self->inputs.recording_left_min = self->recording_left_min;
    self->inputs.command_count = self->command_count;
    (void)memcpy(self->inputs.commands, self->commands, sizeof self->commands);
    self->command_count = 0U;
}

/* Its command's row of the interface lists it. */
static void expect_listed(const answer_t *answer)
{
    char text[TEXT_SIZE];
    if (answer_row_of(answer) == answer_row_count) {
        (void)snprintf(text, sizeof text,
                       "no row lists the answer to command %u: kind %u, status %u, final %u",
                       (unsigned)answer->command, (unsigned)answer->kind, (unsigned)answer->status,
                       (unsigned)answer->is_final);
        TEST_FAIL_MESSAGE(text);
    }
}

static void keep(rig_t *self)
{
    for (uint32_t i = 0U; i < self->outputs.answer_count; i++) {
        expect_listed(&self->outputs.answers[i]);
        if (self->outputs.answers[i].id != RIG_OWN_ID) {
            self->answers[self->answer_count % RIG_ANSWERS] = self->outputs.answers[i];
            self->answer_count++;
        }
    }
    for (uint32_t i = 0U; i < self->outputs.event_count; i++) {
        self->events[self->event_count % RIG_EVENTS] = self->outputs.events[i];
        self->event_count++;
    }
    const bool is_pedal_down = (self->inputs.pedal_a != 0U) && (self->inputs.pedal_b != 0U);
    if (!is_pedal_down && rig_is_driving(self)) {
        self->driven_without_pedal++;
    }
}

void rig_cycle(rig_t *self)
{
    gather(self);
    controller_step(&self->controller, &self->robot, &self->inputs, &self->outputs);
    keep(self);
}

void rig_cycles(rig_t *self, uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        rig_cycle(self);
    }
}

void rig_box(rig_t *self, const char *order)
{
    char reply[BOX_REPLY_SIZE];
    TEST_ASSERT_TRUE_MESSAGE(box_command(&self->box, order, reply, sizeof reply), order);
}

void rig_leave(rig_t *self)
{
    const command_t release = {.source = (uint32_t)COMMAND_SOURCE_HTTP,
                               .peer = RIG_PAGE,
                               .kind = (uint32_t)COMMAND_RELEASE};
    self->is_page_away = true;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(self, release).status);
    for (uint32_t i = 0U; !authority_is_free(&self->controller.authority); i++) {
        TEST_ASSERT_LESS_THAN_UINT32(2000U, i);
        rig_cycle(self);
    }
    rig_forget(self);
}

answer_t rig_command(rig_t *self, command_t command)
{
    self->next_id++;
    command.id = self->next_id;
    self->commands[0] = command;
    self->command_count = 1U;
    rig_cycle(self);
    for (uint32_t i = 0U; i < self->outputs.answer_count; i++) {
        if (self->outputs.answers[i].id == command.id) {
            return self->outputs.answers[i];
        }
    }
    TEST_FAIL_MESSAGE("the command was not answered in its cycle");
    return self->outputs.answers[0];
}

answer_t rig_workphase(rig_t *self, workphase_t workphase)
{
    const command_t command = {.kind = (uint32_t)COMMAND_WORKPHASE,
                               .as.workphase = {.workphase = (uint32_t)workphase}};
    return rig_command(self, command);
}

void rig_press(rig_t *self)
{
    rig_box(self, "pedal press");
    rig_cycles(self, 10U);
}

void rig_release(rig_t *self)
{
    rig_box(self, "pedal release");
    rig_cycles(self, 10U);
}

void rig_let_expire(rig_t *self)
{
    TEST_ASSERT_EQUAL_HEX32(
        0U, procedure_step(&self->controller.procedure, LIMIT_ARMED_HOLD_US - LIMIT_CYCLE_US));
    controller_seal(&self->controller);
    rig_cycles(self, 2U);
}

answer_t rig_finish(rig_t *self, uint32_t most)
{
    for (uint32_t i = 0U; i < most; i++) {
        const uint32_t before = self->answer_count;
        rig_cycle(self);
        if (self->answer_count != before) {
            return self->answers[before % RIG_ANSWERS];
        }
    }
    TEST_FAIL_MESSAGE("the command did not end in time");
    return self->answers[0];
}

void rig_home(rig_t *self)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(self, WORKPHASE_START_UP).status);
    rig_press(self);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(self, HOME_CYCLES).kind);
    rig_release(self);
}

void rig_start_robot_needle_homed(rig_t *self, const robot_t *robot)
{
    rig_start_robot(self, robot);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(self, WORKPHASE_START_UP).status);
    rig_press(self);
    while (!axis_is_homed(&self->controller.axes[robot->needle_axis])) {
        TEST_ASSERT_LESS_THAN_UINT32(20000U, self->controller.sealed.cycle);
        rig_cycle(self);
    }
    rig_release(self);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(self, WORKPHASE_MANUAL).status);
    rig_forget(self);
}

void rig_start_needle_homed(rig_t *self)
{
    rig_start_robot_needle_homed(self, &robot_neuro);
}

static int32_t place_near_switch(const robot_t *robot, uint32_t index)
{
    const axis_config_t *const axis = &robot->axes[index];
    const int32_t way = axis->full_speed_ticks_per_s / NEAR_SHARE;
    if (follower_is_in_block(robot, index) || (axis->limit_switch == (uint8_t)LIMIT_SWITCH_NONE)) {
        return robot->start_ticks[index];
    }
    return axis->home_ticks + ((axis->limit_switch == (uint8_t)LIMIT_SWITCH_LOWER) ? way : -way);
}

void rig_put_near_switches(robot_t *robot)
{
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        robot->start_ticks[i] = place_near_switch(robot, i);
    }
}

/* Where its switch is, a little beyond the pose that is nearest to it. */
static int32_t rail_end(const robot_t *robot, uint32_t index)
{
    const axis_config_t *const axis = &robot->axes[index];
    const bool is_upper = axis->limit_switch == (uint8_t)LIMIT_SWITCH_UPPER;
    const int32_t way = axis->full_speed_ticks_per_s / NEAR_SHARE;
    int32_t end = robot->poses[0].ticks[index];
    for (uint32_t i = 1U; i < (uint32_t)POSE_NAME_COUNT; i++) {
        const int32_t place = robot->poses[i].ticks[index];
        end = ((place > end) == is_upper) ? place : end;
    }
    return end + (is_upper ? way : -way);
}

static void shorten_rail(robot_t *robot, uint32_t index)
{
    axis_config_t *const axis = &robot->axes[index];
    const int32_t shift = rail_end(robot, index) - axis->home_ticks;
    axis->home_ticks += shift;
    if (axis->limit_switch == (uint8_t)LIMIT_SWITCH_UPPER) {
        axis->maximum_ticks += shift;
        axis->target_maximum_ticks += shift;
    } else {
        axis->minimum_ticks += shift;
        axis->target_minimum_ticks += shift;
    }
    axis->seal = seal_of(SEAL_START, (const uint8_t *)axis, offsetof(axis_config_t, seal));
    robot->start_ticks[index] = robot->poses[POSE_HOME].ticks[index];
}

void rig_shorten_rails(robot_t *robot)
{
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        if (follower_is_in_block(robot, i) &&
            (robot->axes[i].limit_switch != (uint8_t)LIMIT_SWITCH_NONE)) {
            shorten_rail(robot, i);
        }
    }
}

const robot_t *rig_short_prostate(void)
{
    static robot_t robot;
    if (robot.axis_count == 0U) {
        robot = robot_prostate;
        rig_shorten_rails(&robot);
    }
    return &robot;
}

void rig_start_robot_homed(rig_t *self, const robot_t *robot)
{
    static rig_t homed;
    if (homed.box.robot != robot) {
        rig_start_robot(&homed, robot);
        rig_home(&homed);
    }
    *self = homed;
    rig_forget(self);
}

static const robot_t *near_neuro(void)
{
    static robot_t robot;
    if (robot.axis_count == 0U) {
        robot = robot_neuro;
        rig_put_near_switches(&robot);
    }
    return &robot;
}

void rig_start_homed(rig_t *self)
{
    rig_start_robot_homed(self, near_neuro());
}

void rig_start_robot_targeted(rig_t *self, const robot_t *robot, const rigid_t *pose)
{
    rigid_t identity;
    rigid_set_identity(&identity);
    rig_start_robot_homed(self, robot);
    rig_register(self, &identity);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(self, pose).status);
    rig_forget(self);
}

void rig_start_targeted(rig_t *self)
{
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    rig_start_robot_targeted(self, near_neuro(), &pose);
}

void rig_start_moving(rig_t *self)
{
    rig_start_targeted(self);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(self, WORKPHASE_MOVE_TO_TARGET).status);
    rig_press(self);
    rig_cycles(self, 400U);
    TEST_ASSERT_TRUE(rig_is_driving(self));
}

void rig_start_arrived(rig_t *self)
{
    static rig_t arrived;
    if (arrived.box.robot == NULL) {
        rig_start_targeted(self);
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(self, WORKPHASE_MOVE_TO_TARGET).status);
        rig_press(self);
        TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(self, 60000U).kind);
        rig_release(self);
        rig_forget(self);
        arrived = *self;
    }
    *self = arrived;
}

answer_t rig_target(rig_t *self, const rigid_t *scanner_treatment)
{
    const command_t command = {.kind = (uint32_t)COMMAND_TARGET,
                               .as.pose = {.pose = *scanner_treatment}};
    return rig_command(self, command);
}

void rig_register(rig_t *self, const rigid_t *scanner_zframe)
{
    const command_t command = {.kind = (uint32_t)COMMAND_REGISTRATION,
                               .as.registration = {.pose = *scanner_zframe}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(self, WORKPHASE_CALIBRATION).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(self, command).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(self, WORKPHASE_TARGETING).status);
}

link_t *rig_link(rig_t *self, uint32_t axis)
{
    return &self->controller.links[self->box.robot->axes[axis].slot];
}

int32_t rig_position(const rig_t *self, uint32_t axis)
{
    return self->outputs.snapshot.axes[axis].position_ticks;
}

void rig_expect_nothing_known(const rig_t *self, uint32_t axis)
{
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, self->outputs.snapshot.axes[axis].power);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, self->outputs.snapshot.axes[axis].reference);
    TEST_ASSERT_EQUAL_UINT32(0U, self->outputs.snapshot.has_target);
}

/* The same frame is decoded once. */
static card_command_t decoded(const uint8_t frame[CARD_FRAME_BYTES], uint32_t slot)
{
    static struct {
        bool is_known;
        uint8_t frame[CARD_FRAME_BYTES];
        card_command_t command;
    } last[CARD_SLOT_COUNT];
    if (!last[slot].is_known || (memcmp(last[slot].frame, frame, CARD_FRAME_BYTES) != 0)) {
        last[slot].is_known = false;
        TEST_ASSERT_EQUAL(CARD_FRAME_OK,
                          card_frame_decode_command(frame, slot, &last[slot].command));
        (void)memcpy(last[slot].frame, frame, CARD_FRAME_BYTES);
        last[slot].is_known = true;
    }
    return last[slot].command;
}

card_command_t rig_sent(const rig_t *self, uint32_t axis)
{
    const uint32_t slot = self->box.robot->axes[axis].slot;
    if (self->dialect != (uint32_t)CARD_DIALECT_OWN) {
        return (card_command_t){.drive = aim32_drive(self->outputs.frames[slot],
                                                     self->box.robot->axes[axis].card_type)};
    }
    return decoded(self->outputs.frames[slot], slot);
}

/* A drive that is off has no bit in any of its words; the box decodes each frame anyhow. */
static bool has_drive(const rig_t *self, uint32_t axis)
{
    static const uint8_t off[(CARD_COMMAND_WATCHDOG - CARD_COMMAND_WAVES) * 4U];
    if (self->dialect != (uint32_t)CARD_DIALECT_OWN) {
        const card_drive_t drive = rig_sent(self, axis).drive;
        return (drive.mode != 0U) || (drive.direction != 0U) || (drive.duty != 0U);
    }
    const uint8_t *const frame = self->outputs.frames[self->box.robot->axes[axis].slot];
    return memcmp(&frame[CARD_COMMAND_WAVES * 4U], off, sizeof off) != 0;
}

bool rig_is_driving(const rig_t *self)
{
    for (uint32_t i = 0U; i < self->box.robot->axis_count; i++) {
        if (has_drive(self, i)) {
            return true;
        }
    }
    return false;
}

uint32_t rig_count(const rig_t *self, event_id_t id)
{
    uint32_t count = 0U;
    const uint32_t kept = (self->event_count < RIG_EVENTS) ? self->event_count : RIG_EVENTS;
    for (uint32_t i = 0U; i < kept; i++) {
        count += (self->events[i].id == (uint32_t)id) ? 1U : 0U;
    }
    return count;
}

void rig_forget(rig_t *self)
{
    self->answer_count = 0U;
    self->event_count = 0U;
}

rigid_t rig_pose(int32_t x_nm, int32_t y_nm, int32_t z_nm)
{
    /* The needle at home points along -y; its frame is R0 of the mechanism. */
    const int32_t one = 1073741824;
    const rigid_t pose = {
        .rotation_q30 = {{-one, 0, 0}, {0, 0, -one}, {0, -one, 0}},
        .translation = {.x_nm = x_nm, .y_nm = y_nm, .z_nm = z_nm},
    };
    return pose;
}

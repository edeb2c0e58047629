/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/homing/homing_mode.h"

#include "axis/follower.h"
#include "mode/move/move_mode.h"
#include "robot/coupled_path.h"
#include "robot/robot_damage.h"
#include "safety/coupled_guard.h"
#include "safety/needle.h"

#include <string.h>

static void leave(leg_t *leg, const mode_frame_t *frame, mode_result_t *result)
{
    const uint32_t needle = frame->robot->needle_axis;
    if (leg->is_running == 0U) {
        int32_t ends[ROBOT_AXIS_MAX] = {0};
        ends[needle] = needle_retracted_ticks(frame->robot);
        leg_begin(leg, frame, LEG_AXIS(needle), ends);
    }
    (void)leg_step(leg, frame, result);
}

/* One stage homes after the other: the needle leaves first. */
static uint8_t present_stage(const mode_frame_t *frame)
{
    uint8_t stage = ROBOT_HOME_STAGES;
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        const uint8_t own = frame->robot->axes[i].home_stage;
        if (!axis_is_homed(&frame->axes[i]) && (own < stage)) {
            stage = own;
        }
    }
    return stage;
}

void homing_mode_begin_axis(const mode_frame_t *frame, uint32_t index, mode_result_t *result)
{
    axis_t *const axis = &frame->axes[index];
    const bool was_homing = axis_is_homing(axis);
    if (coupled_guard_bars_homing(frame->robot, frame->axes, index)) {
        mode_fail(result, EVENT_HOMING_BARRED, index, 0);
    } else if (axis_begin_homing(axis, &frame->robot->axes[index]) != 0U) {
        mode_note(result, EVENT_AXIS_TAKEN, index, axis->sealed.home_correction_ticks);
    } else if (axis_is_homing(axis) && !was_homing) {
        follower_tie(frame->robot, frame->axes, index);
    } else {
        /* It is on its way. */
    }
}

static bool is_due(const mode_frame_t *frame, uint32_t index, uint8_t stage)
{
    return (frame->robot->axes[index].home_stage == stage) && !axis_is_homed(&frame->axes[index]);
}

static bool is_linked(const robot_t *robot, uint32_t index)
{
    return (robot->axes[index].home_method == (uint8_t)HOME_BY_SWITCH) &&
           follower_is_in_block(robot, index);
}

static bool is_any_homing(const mode_frame_t *frame)
{
    bool is_any = false;
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        is_any = is_any || axis_is_homing(&frame->axes[i]);
    }
    return is_any;
}

/* Axis of a linkage that homes with an escort; the count of axes for none. */
static uint32_t find_escorted(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX])
{
    uint32_t found = robot->axis_count;
    for (uint32_t i = robot->axis_count; i > 0U; i--) {
        if (escort_is_for(robot, axes, i - 1U)) {
            found = i - 1U;
        }
    }
    return found;
}

uint32_t homing_mode_unplaced(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX])
{
    uint32_t found = robot->axis_count;
    bool is_as_parked = find_escorted(robot, axes) < robot->axis_count;
    for (uint32_t i = robot->axis_count; i > 0U; i--) {
        const axis_t *const axis = &axes[i - 1U];
        if (is_linked(robot, i - 1U)) {
            is_as_parked = is_as_parked || axis_is_as_parked(axis);
            found = axis_is_placed(axis) ? found : (i - 1U);
        }
    }
    return is_as_parked ? robot->axis_count : found;
}

/* One axis of a linkage with an escort; or of one that stands as it was parked, of which no counts
 * say where it is, the whole stage as a block. */
static void begin_linkage(const mode_frame_t *frame, escort_t *escort, uint8_t stage,
                          mode_result_t *result)
{
    const uint32_t escorted = find_escorted(frame->robot, frame->axes);
    const uint32_t unplaced = homing_mode_unplaced(frame->robot, frame->axes);
    if (unplaced < frame->axis_count) {
        mode_fail(result, EVENT_HOMING_UNPLACED, unplaced, 0);
    } else if (escorted < frame->axis_count) {
        homing_mode_begin_axis(frame, escorted, result);
        if (axis_is_homing(&frame->axes[escorted])) {
            escort_begin(escort, frame->robot, frame->axes, escorted);
        }
    } else {
        for (uint32_t i = 0U; i < frame->axis_count; i++) {
            if (is_linked(frame->robot, i) && is_due(frame, i, stage)) {
                homing_mode_begin_axis(frame, i, result);
            }
        }
    }
}

static void begin_stage(const mode_frame_t *frame, escort_t *escort, mode_result_t *result)
{
    const uint8_t stage = present_stage(frame);
    bool is_linkage_due = false;
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        const bool is_due_now = is_due(frame, i, stage) && (result->progress == MODE_RUNNING);
        if (is_due_now && is_linked(frame->robot, i)) {
            is_linkage_due = true;
        } else if (is_due_now) {
            homing_mode_begin_axis(frame, i, result);
        } else {
            /* Later, or never. */
        }
    }
    if (is_linkage_due && !is_any_homing(frame)) {
        begin_linkage(frame, escort, stage, result);
    }
}

/* A leader that led the others to a place where none of them can be has met a false switch. */
static void doubt_leaders(const mode_frame_t *frame, mode_result_t *result)
{
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        axis_t *const axis = &frame->axes[i];
        if (axis_is_homed(axis) && follower_has_one(frame->robot, i) &&
            coupled_guard_is_missed(frame->robot, frame->axes, i)) {
            axis_doubt(axis);
            mode_fail(result, EVENT_HOMED_BEYOND_LIMIT, i, 0);
        }
    }
}

/* A block that meets an end stands otherwise than it was parked. */
static void doubt_parking(const mode_frame_t *frame, bool is_at_end)
{
    for (uint32_t i = 0U; is_at_end && (i < frame->axis_count); i++) {
        axis_t *const axis = &frame->axes[i];
        if (is_linked(frame->robot, i)) {
            axis_refuse_parking(axis);
        }
    }
}

static void follow(const mode_frame_t *frame, uint32_t index, const axis_t *leader, uint32_t pace,
                   mode_result_t *result)
{
    axis_t *const axis = &frame->axes[index];
    const axis_config_t *const config = &frame->robot->axes[index];
    card_drive_t *const request = &result->requests[index];
    *request = follower_step(axis, config, leader, pace, frame->elapsed_us);
    if ((result->progress == MODE_RUNNING) &&
        follower_is_stuck(axis, config, leader, pace, request)) {
        mode_fail(result, EVENT_FOLLOWER_STUCK, index, follower_apart_ticks(axis, leader, pace));
        doubt_parking(frame, follower_is_at_end(axis, config, request));
    }
}

/* With which axis axis `index` travels now; itself when there is none. */
static uint32_t leader_of(const mode_frame_t *frame, const escort_t *escort, uint32_t index)
{
    uint32_t leader = index;
    if (escort->leader == 0U) {
        leader = follower_leader(frame->robot, frame->axes, index);
    } else if (escort_pace(escort, index) > 0U) {
        leader = escort->leader - 1U;
    } else {
        /* It rests, or homes. */
    }
    return leader;
}

/* @return all rest in this cycle */
static bool is_at_a_loss(const mode_frame_t *frame, escort_t *escort, mode_result_t *result)
{
    const uint32_t leader = escort->leader - 1U;
    escort_verdict_t verdict = ESCORT_GOES;
    if ((escort->leader != 0U) && !axis_is_homing(&frame->axes[leader])) {
        escort_end(escort);
    } else if (escort->leader != 0U) {
        verdict = escort_step(escort, frame->robot, frame->axes);
    } else {
        /* Blocks home, or axes that share nothing. */
    }
    if (verdict == ESCORT_NONE) {
        mode_fail(result, EVENT_HOMING_NO_WAY, leader,
                  escort_way_by_hand_ticks(escort, frame->robot, frame->axes));
    }
    return verdict != ESCORT_GOES;
}

/* No axis of its escort goes faster than one that homes may. */
static card_drive_t home_axis(const mode_frame_t *frame, const escort_t *escort, uint32_t index)
{
    const axis_config_t *config = &frame->robot->axes[index];
    axis_t *const axis = &frame->axes[index];
    axis_config_t calm;
    if ((escort->leader == (index + 1U)) && escort_is_slow(escort)) {
        calm = *config;
        calm.home_speed_ticks_per_s /= 2;
        calm.acceleration_ticks_per_s2 /= 2;
        config = &calm;
    }
    return axis_home(axis, config, frame->elapsed_us);
}

/* A leader has its set-point of this cycle before its followers. */
static void drive(const mode_frame_t *frame, const escort_t *escort, mode_result_t *result)
{
    uint32_t leaders[ROBOT_AXIS_MAX];
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        axis_t *const axis = &frame->axes[i];
        leaders[i] = leader_of(frame, escort, i);
        if (axis_is_homing(axis)) {
            result->requests[i] = home_axis(frame, escort, i);
        } else if (leaders[i] == i) {
            result->requests[i] = axis_rest(axis, frame->elapsed_us);
        } else {
            /* Until it follows. */
            result->requests[i] = (card_drive_t){.mode = (uint32_t)CARD_DRIVE_OFF};
        }
    }
    for (uint32_t i = 0U; i < frame->axis_count; i++) {
        if (leaders[i] != i) {
            const uint32_t pace = (escort->leader == 0U) ? 1U : escort_pace(escort, i);
            follow(frame, i, &frame->axes[leaders[i]], pace, result);
        }
    }
}

static void home(const mode_frame_t *frame, escort_t *escort, mode_result_t *result)
{
    begin_stage(frame, escort, result);
    if ((result->progress == MODE_FAILED) || is_at_a_loss(frame, escort, result)) {
        mode_rest(frame, result);
    } else {
        drive(frame, escort, result);
    }
}

static bool has_pose(const mode_frame_t *frame)
{
    return robot_has_pose(frame->robot, (uint32_t)POSE_HOME);
}

/* May the axes go home in step from where they are? */
static status_t judge_way(const mode_frame_t *frame)
{
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    leg_positions(frame, ticks);
    return coupled_path_judge(frame->robot, ticks, frame->robot->poses[POSE_HOME].ticks).status;
}

static void go_home(leg_t *leg, const mode_frame_t *frame, mode_result_t *result)
{
    const status_t judged = (leg->is_running == 0U) ? judge_way(frame) : STATUS_OK;
    if (judged == STATUS_OK) {
        move_mode_t move;
        (void)memset(&move, 0, sizeof move);
        (void)memcpy(move.target_ticks, frame->robot->poses[POSE_HOME].ticks,
                     sizeof move.target_ticks);
        move_mode_go(&move, leg, frame, result);
    } else {
        mode_give_up(frame, result, judged);
    }
}

bool homing_mode_is_done(const leg_t *leg, const mode_frame_t *frame)
{
    const pose_t *const pose = &frame->robot->poses[POSE_HOME];
    bool is_done = frame->is_every_axis_homed;
    if (is_done && has_pose(frame)) {
        is_done = leg->is_running == 0U;
        for (uint32_t i = 0U; i < frame->axis_count; i++) {
            is_done =
                is_done && axis_is_at(&frame->axes[i], &frame->robot->axes[i], pose->ticks[i]);
        }
    }
    return is_done;
}

void homing_mode_step(leg_t *leg, escort_t *escort, const mode_frame_t *frame,
                      mode_result_t *result)
{
    doubt_leaders(frame, result);
    if (result->progress == MODE_FAILED) {
        mode_rest(frame, result);
    } else if (frame->is_every_axis_homed && has_pose(frame)) {
        go_home(leg, frame, result);
    } else if (needle_must_leave(frame->robot, frame->axes)) {
        leave(leg, frame, result);
    } else {
        leg_stop(leg);
        home(frame, escort, result);
    }
}

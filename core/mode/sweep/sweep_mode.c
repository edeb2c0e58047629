/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/sweep/sweep_mode.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "robot/coupled_limit.h"
#include "safety/needle.h"

#define MS_PER_S INT64_C(1000)
#define CYCLES(ms) (((ms)*1000U) / LIMIT_CYCLE_US)
#define PAUSE_CYCLES CYCLES(LIMIT_SWEEP_PAUSE_MS)
#define STEP_CYCLES (PAUSE_CYCLES + CYCLES(LIMIT_SWEEP_RUN_MS))
#define LOOK_CYCLES CYCLES(LIMIT_SWEEP_LOOK_MS)
#define CYCLES_PER_S (INT64_C(1000000) / (int64_t)LIMIT_CYCLE_US)
#define WORDS_PER_HZ 22009U

#define STAGE_NEW 0U
#define STAGE_COARSE 1U /* Faster in large steps, until it turns. */
#define STAGE_FINE 2U   /* Slower in small ones, until it does not. */
#define STAGE_UP 3U
#define STAGE_DOWN 4U

/* The way of a run at the axis' speed. */
static int64_t longest_ticks(const axis_config_t *config)
{
    return ((int64_t)config->speed_ticks_per_s * (int64_t)LIMIT_SWEEP_RUN_MS) / MS_PER_S;
}

static bool is_sweepable(const robot_t *robot, uint32_t index)
{
    const axis_config_t *const config = &robot->axes[index];
    bool is_its_own = (config->card_type == (uint8_t)CARD_TYPE_HIGH_FREQUENCY) &&
                      (config->unit == (uint8_t)AXIS_UNIT_RAD);
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        is_its_own = is_its_own && !coupled_limit_has(&robot->coupled_limits[i], index);
    }
    return is_its_own;
}

static bool has_room(const axis_config_t *config, const axis_t *axis)
{
    const int64_t longest = longest_ticks(config);
    const int64_t at = (int64_t)axis->sealed.encoder.position_ticks;
    return ((at + longest) <= (int64_t)config->maximum_ticks) &&
           ((at - longest) >= (int64_t)config->minimum_ticks);
}

solution_t sweep_mode_judge(const sweep_mode_t *asked, uint32_t index, const robot_t *robot,
                            const axis_t axes[ROBOT_AXIS_MAX])
{
    solution_t result = {.status = STATUS_OK, .axis = 0U, .is_maximum = 0U};
    if (index >= robot->axis_count) {
        result.status = STATUS_UNKNOWN_COMMAND;
        return result;
    }
    result.axis = (uint8_t)index;
    if (!is_sweepable(robot, index)) {
        result.status = STATUS_NO_SWEEP;
    } else if (asked->is_free != 1U) {
        result.status = STATUS_NOT_FREE;
    } else if (!needle_is_out(robot, axes)) {
        result.status = STATUS_NEEDLE_IN;
    } else if (!has_room(&robot->axes[index], &axes[index])) {
        result.status = STATUS_AXIS_LIMIT;
    } else {
        /* Nothing stands against it. */
    }
    return result;
}

static bool is_upwards(const sweep_mode_t *self)
{
    return self->stage != STAGE_DOWN;
}

static int32_t hertz_of(const sweep_mode_t *self)
{
    const uint32_t hertz = self->word / WORDS_PER_HZ;
    return (int32_t)hertz;
}

static card_drive_t drive_of(const sweep_mode_t *self, const axis_config_t *config)
{
    const bool is_inverted = config->is_motor_inverted != 0U;
    const int64_t word = fixed_within((int64_t)self->word, (int64_t)config->maximum_duty,
                                      (int64_t)LIMIT_WAVE_SLOWEST_WORD);
    const card_drive_t drive = {.mode = (uint32_t)CARD_DRIVE_HIGH_FREQUENCY,
                                .direction = (is_upwards(self) != is_inverted) ? 1U : 0U,
                                .duty = (uint32_t)word,
                                .amplitude = (uint32_t)config->amplitude};
    return drive;
}

/* In the direction of the drive. */
static int32_t way_of(const sweep_mode_t *self, const axis_t *axis)
{
    const int64_t way = (int64_t)axis->sealed.encoder.position_ticks - (int64_t)self->start_ticks;
    return fixed_saturate(is_upwards(self) ? way : -way);
}

/* Reason that ends it, other than its points. */
static status_t trouble(const sweep_mode_t *self, uint32_t index, uint32_t run_cycles,
                        const mode_frame_t *frame)
{
    const axis_config_t *const config = &frame->robot->axes[index];
    const axis_t *const axis = &frame->axes[index];
    const card_drive_t drive = drive_of(self, config);
    const uint32_t cycles = (run_cycles > LOOK_CYCLES) ? run_cycles : LOOK_CYCLES;
    const int64_t way = (int64_t)way_of(self, axis);
    const int64_t most = (int64_t)config->speed_ticks_per_s * (int64_t)cycles;
    status_t status = STATUS_OK;
    if (!needle_is_out(frame->robot, frame->axes)) {
        status = STATUS_NEEDLE_IN;
    } else if (frame->links[config->slot].report.current_ma > LIMIT_SWEEP_CURRENT_MA) {
        status = STATUS_SWEEP_CURRENT;
    } else if ((way * CYCLES_PER_S) > most) {
        status = STATUS_TOO_FAST;
    } else if (way <= -(int64_t)LIMIT_WRONG_WAY_TICKS) {
        status = STATUS_FAULT_PRESENT;
    } else if (axis_is_beyond_limit(axis, config, &drive)) {
        status = STATUS_AXIS_LIMIT;
    } else {
        /* It goes on. */
    }
    return status;
}

static void begin_step(leg_t *leg)
{
    leg->is_running = 1U;
    leg->profile.ramp_cycles = 0U;
    leg->profile.cruise_cycles = STEP_CYCLES;
    leg->profile.cycle = 0U;
}

/* A step that was stopped had begun already. */
static void begin(sweep_mode_t *self, uint32_t index, leg_t *leg, mode_result_t *result)
{
    if (self->stage == STAGE_NEW) {
        self->stage = STAGE_COARSE;
        self->word = LIMIT_WAVE_SLOWEST_WORD;
        mode_note(result, EVENT_SWEEP_BEGUN, index, 0);
    } else {
        mode_note(result, EVENT_SWEEP_AGAIN, index, hertz_of(self));
    }
    begin_step(leg);
}

static void end(uint32_t index, mode_result_t *result, sweep_end_t why)
{
    mode_note(result, EVENT_SWEEP_ENDED, index, (int32_t)why);
    result->progress = MODE_DONE;
}

static void give_up(uint32_t index, const mode_frame_t *frame, mode_result_t *result,
                    status_t status)
{
    mode_give_up(frame, result, status);
    result->axis = index;
}

/* The next word of a search, or none within the range. */
static status_t search(sweep_mode_t *self, const axis_config_t *config, bool is_turning)
{
    status_t status = STATUS_OK;
    if ((self->stage == STAGE_FINE) && !is_turning) {
        self->stage = STAGE_UP;
    } else if (is_turning) {
        self->stage = STAGE_FINE;
        self->word += LIMIT_SWEEP_FINE_WORDS;
    } else {
        self->word -= LIMIT_SWEEP_COARSE_WORDS;
    }
    if ((self->word > LIMIT_WAVE_SLOWEST_WORD) || (self->word < config->maximum_duty)) {
        status = STATUS_SWEEP_NO_START;
    }
    return status;
}

/* From one point to the next speed grows at most as it did to this one. */
static bool is_next_too_fast(const sweep_mode_t *self, const axis_config_t *config, int32_t most)
{
    return (self->most_ticks > 0) &&
           (((int64_t)most * (int64_t)most) > (longest_ticks(config) * (int64_t)self->most_ticks));
}

static void next_point(sweep_mode_t *self, uint32_t index, int32_t down_ticks,
                       const mode_frame_t *frame, mode_result_t *result)
{
    const int32_t most = (down_ticks > self->up_ticks) ? down_ticks : self->up_ticks;
    if ((self->point + 1U) >= LIMIT_SWEEP_POINTS) {
        end(index, result, SWEEP_END_POINTS);
    } else if (is_next_too_fast(self, &frame->robot->axes[index], most)) {
        end(index, result, SWEEP_END_SPEED);
    } else if ((self->word - LIMIT_SWEEP_FINE_WORDS) < frame->robot->axes[index].maximum_duty) {
        end(index, result, SWEEP_END_WORDS);
    } else {
        self->most_ticks = most;
        self->word -= LIMIT_SWEEP_FINE_WORDS;
        self->point++;
        self->stage = STAGE_UP;
    }
}

/* A run is over. */
static void conclude(sweep_mode_t *self, uint32_t index, const mode_frame_t *frame,
                     mode_result_t *result)
{
    const int32_t way = way_of(self, &frame->axes[index]);
    if (self->stage == STAGE_UP) {
        mode_note(result, EVENT_SWEEP_UPWARDS, index, way);
        self->up_ticks = way;
        self->stage = STAGE_DOWN;
    } else if (self->stage == STAGE_DOWN) {
        mode_note(result, EVENT_SWEEP_DOWNWARDS, index, way);
        next_point(self, index, way, frame, result);
    } else {
        const axis_config_t *const config = &frame->robot->axes[index];
        const bool is_turning = joints_is_beyond(config, (int64_t)way, 0U, LIMIT_SWEEP_STILL_BAM);
        const status_t status = search(self, config, is_turning);
        if (status != STATUS_OK) {
            give_up(index, frame, result, status);
        }
    }
}

/* Since the pause. */
static void run(sweep_mode_t *self, uint32_t index, uint32_t run_cycles, const mode_frame_t *frame,
                mode_result_t *result)
{
    if (run_cycles == 0U) {
        self->start_ticks = frame->axes[index].sealed.encoder.position_ticks;
        mode_note(result, EVENT_SWEEP_WORD, index, hertz_of(self));
    }
    const status_t status = trouble(self, index, run_cycles, frame);
    if (status == STATUS_OK) {
        result->requests[index] = drive_of(self, &frame->robot->axes[index]);
    } else {
        give_up(index, frame, result, status);
    }
}

void sweep_mode_step(sweep_mode_t *self, uint32_t index, leg_t *leg, const mode_frame_t *frame,
                     mode_result_t *result)
{
    mode_rest(frame, result);
    if (index >= frame->axis_count) {
        mode_give_up(frame, result, STATUS_UNKNOWN_COMMAND);
        return;
    }
    if (leg->is_running == 0U) {
        begin(self, index, leg, result);
    }
    if (leg->profile.cycle == STEP_CYCLES) {
        conclude(self, index, frame, result);
        begin_step(leg);
    } else if (leg->profile.cycle >= PAUSE_CYCLES) {
        run(self, index, leg->profile.cycle - PAUSE_CYCLES, frame, result);
    } else {
        /* It rests. */
    }
    leg->profile.cycle++;
}

uint32_t sweep_mode_ask(const mode_asked_t *asked, mode_way_t *way, sweep_mode_t *self)
{
    const command_sweep_t *const sent = command_as_sweep(asked->command);
    way->axis = sent->axis;
    self->is_free = sent->is_free;
    return mode_asked_axes(sent->axis);
}

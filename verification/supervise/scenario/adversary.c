/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/scenario/adversary.h"

#include "charts/arming_chart.h"
#include "charts/axis_chart.h"
#include "supervise/scenario/targets.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define ORDER_SIZE 48U
#define LOST_CYCLES (LIMIT_SILENT_KEPT_CYCLES + 60U) /* A card is silent for so long. */
#define MERCY_CYCLES 3000U                           /* Until it is broken again. */
#define STRAY_CYCLES 200U                            /* An impostor stays pressed after homing. */

enum { PART_ENCODER = 0, PART_MOTOR = 1, PART_SWITCH = 2, PART_LOAD = 3 };

static const char *const part_words[] = {"encoder", "motor", "switch", "load"};
static const char *const encoder_faults[] = {"stuck", "half", "reversed"};
static const char *const motor_faults[] = {"half", "twice", "stuck", "runs"};
static const char *const switch_faults[] = {"stuck", "chatter", "reversed"};
static const char *const plan_words[FOE_PLANS] = {"taps",    "flicker", "impostor", "motor",
                                                  "coupled", "rest",    "short"};
static const char *const wish_words[] = {"targets", "near targets", "jogs", "short jogs",
                                         "coupled axes jogged out"};
static const char *const when_words[] = {"always", "once homed", "while moving", "at rest"};

static uint32_t below(adversary_t *self, uint32_t bound)
{
    return sim_random_below(&self->random, bound);
}

static uint32_t between(adversary_t *self, uint32_t least, uint32_t most)
{
    return least + below(self, most - least + 1U);
}

static const char *fault_word(const adversary_t *self)
{
    const char *word = "";
    word = (self->part == (uint32_t)PART_ENCODER) ? encoder_faults[self->fault] : word;
    word = (self->part == (uint32_t)PART_MOTOR) ? motor_faults[self->fault] : word;
    return (self->part == (uint32_t)PART_SWITCH) ? switch_faults[self->fault] : word;
}

static void order(rig_t *rig, const char *part, uint32_t axis, const char *fault)
{
    char line[ORDER_SIZE];
    (void)snprintf(line, sizeof line, "%s %s %s", part, rig->box.robot->axes[axis].name, fault);
    rig_box(rig, line);
}

static void tap(adversary_t *self)
{
    self->on_ms = between(self, 20U, 200U);
    self->off_ms = between(self, 20U, 200U);
}

static void break_encoder(adversary_t *self, uint32_t faults)
{
    self->part = (uint32_t)PART_ENCODER;
    self->fault = below(self, faults);
    self->broken_ms = 1U;
}

static void plan_taps(adversary_t *self)
{
    static const adversary_wish_t wishes[] = {FOE_ASKS_TARGETS, FOE_ASKS_TARGETS, FOE_ASKS_JOGS};
    tap(self);
    break_encoder(self, 3U);
    self->wish = wishes[below(self, 3U)];
    self->when = (below(self, 2U) == 0U) ? FOE_ALWAYS : FOE_HOMED;
    if (below(self, 8U) == 0U) {
        self->broken_ms = 0U;
    }
}

static void plan_flicker(adversary_t *self)
{
    static const adversary_wish_t wishes[] = {FOE_ASKS_TARGETS, FOE_ASKS_TARGETS, FOE_ASKS_JOGS};
    const bool is_fast = below(self, 2U) == 0U;
    const uint32_t period_ms = is_fast ? between(self, 2U, 20U) : between(self, 10U, 200U);
    break_encoder(self, 2U);
    self->wish = wishes[below(self, 3U)];
    /* The fast ones from the first move on, before a motor has shown much of itself. */
    self->when = is_fast ? FOE_HOMED : (adversary_when_t)below(self, 3U);
    self->broken_ms = between(self, 1U, (period_ms < 60U) ? period_ms - 1U : 60U);
    self->whole_ms = period_ms - self->broken_ms;
    if (below(self, 4U) == 0U) {
        tap(self);
    }
}

/* The needle twice as often as another axis. */
static uint32_t some_switched(adversary_t *self)
{
    uint32_t axes[ROBOT_AXIS_MAX + 1U] = {self->robot->needle_axis, self->robot->needle_axis};
    uint32_t count = 2U;
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        if ((i != self->robot->needle_axis) &&
            (self->robot->axes[i].home_method == (uint8_t)HOME_BY_SWITCH)) {
            axes[count] = i;
            count++;
        }
    }
    return axes[below(self, count)];
}

static void plan_impostor(adversary_t *self)
{
    self->axis = some_switched(self);
    self->part = (uint32_t)PART_SWITCH;
    self->fault = (below(self, 6U) == 0U) ? between(self, 1U, 2U) : 0U;
    self->start = 2U; /* At the first homing nothing is known that it could contradict. */
    self->wish = (below(self, 2U) == 0U) ? FOE_ASKS_TARGETS : FOE_ASKS_JOGS;
    self->approach_ms = below(self, 3000U);
    self->free_ms = below(self, 80U);
    self->past_ticks = (int32_t)below(self, 15U) - 7;
    self->lose_cycle = between(self, 2000U, 12000U);
    self->lost_axis = self->axis;
}

static void plan_motor(adversary_t *self)
{
    self->part = (below(self, 5U) == 0U) ? (uint32_t)PART_LOAD : (uint32_t)PART_MOTOR;
    self->fault = below(self, 4U);
    self->load = (double)between(self, 20U, 95U) / 100.0;
    self->wish = (below(self, 3U) == 0U) ? FOE_ASKS_JOGS : FOE_ASKS_TARGETS;
    self->when = (adversary_when_t)between(self, (uint32_t)FOE_HOMED, (uint32_t)FOE_MOVING);
    self->broken_ms = between(self, 5U, 400U);
    self->whole_ms = between(self, 5U, 400U);
    if (below(self, 3U) == 0U) {
        tap(self);
    }
}

static void plan_coupled(adversary_t *self)
{
    self->start = 1U;
    self->wish = FOE_ASKS_APART;
    coupled_limit_jogs_begin(&self->apart, self->robot, &self->random);
    self->lost_axis = coupled_limit_jogs_some_axis(&self->apart, &self->random);
    self->lose_cycle = between(self, 6000U, 18000U);
}

static void plan_rest(adversary_t *self)
{
    self->part = (below(self, 2U) == 0U) ? (uint32_t)PART_ENCODER : (uint32_t)PART_MOTOR;
    self->fault = (self->part == (uint32_t)PART_MOTOR) ? 3U : below(self, 3U);
    self->wish = (adversary_wish_t)below(self, 3U);
    self->when = FOE_IDLE;
    self->broken_ms = between(self, 1U, 100U);
    self->whole_ms = between(self, 20U, 1000U);
}

static void plan_short(adversary_t *self)
{
    break_encoder(self, 2U);
    self->wish = (below(self, 3U) == 0U) ? FOE_ASKS_NEAR : FOE_ASKS_SHORT;
    self->when = FOE_HOMED;
    self->start = 2U;
}

static void start(adversary_t *self, rig_t *rig)
{
    if (self->start == 0U) {
        rig_start_robot(rig, self->robot);
    } else if (self->start == 1U) {
        rig_start_robot_homed(rig, self->robot);
    } else {
        const rigid_t pose = targets_first(self->robot);
        rig_start_robot_targeted(rig, self->robot, &pose);
    }
    /* Some motors are as their table says, others nearly; but none becomes another one later. */
    const uint32_t count = (self->start == 0U) ? self->robot->axis_count : 0U;
    for (uint32_t i = 0U; (i < count) && (below(self, 2U) == 0U); i++) {
        rig->box.axes[i].motor.full_speed_ticks_per_s *=
            1.0 + (0.2 * sim_random_signed(&self->random));
    }
}

void adversary_begin(adversary_t *self, rig_t *rig, const robot_t *robot, uint32_t seed)
{
    static void (*const plans[FOE_PLANS])(adversary_t *) = {
        plan_taps, plan_flicker, plan_impostor, plan_motor, plan_coupled, plan_rest, plan_short};
    *self = (adversary_t){.robot = robot, .random = {seed}, .lose_cycle = UINT32_MAX};
    self->plan = (adversary_plan_t)below(self, FOE_PLANS);
    if ((self->plan == FOE_COUPLED) && (robot->coupled_limit_count == 0U)) {
        self->plan = FOE_REST;
    }
    self->axis = (below(self, 3U) == 0U) ? robot->needle_axis : below(self, robot->axis_count);
    self->start = below(self, 3U);
    self->from_cycle = (below(self, 2U) == 0U) ? 0U : below(self, 8000U);
    self->has_mercy = below(self, 2U) == 0U;
    plans[self->plan](self);
    start(self, rig);
}

static void set_part(const adversary_t *self, rig_t *rig, bool is_broken)
{
    if (self->part == (uint32_t)PART_LOAD) {
        rig->box.axes[self->axis].motor.load = is_broken ? self->load : 0.0;
    } else {
        order(rig, part_words[self->part], self->axis, is_broken ? fault_word(self) : "normal");
    }
}

static bool is_time(const adversary_t *self, const rig_t *rig)
{
    const uint32_t armed = rig->outputs.snapshot.order;
    bool is_now =
        (self->broken_ms != 0U) && (self->cycle >= self->from_cycle) && (self->mercy_cycles == 0U);
    switch (self->when) {
    case FOE_HOMED:
        is_now = is_now && self->was_homed;
        break;
    case FOE_MOVING:
        is_now = is_now && (armed == (uint32_t)ARMING_STATE_MOVING);
        break;
    case FOE_IDLE:
        is_now = is_now && self->was_homed && (armed == (uint32_t)ARMING_STATE_NONE);
        break;
    case FOE_ALWAYS:
    default:
        break;
    }
    return is_now;
}

/* A share more or less each time. */
static uint32_t jittered(adversary_t *self, uint32_t ms)
{
    return ms + below(self, (ms / 4U) + 1U);
}

/* The part is broken and whole again, in its rhythm. */
static void keep_rhythm(adversary_t *self, rig_t *rig)
{
    bool is_broken = self->is_broken;
    if (!is_time(self, rig)) {
        is_broken = false;
        self->rhythm_cycles = 0U;
    } else if (self->rhythm_cycles > 0U) {
        self->rhythm_cycles--;
    } else {
        is_broken = !self->is_broken || (self->whole_ms == 0U);
        self->rhythm_cycles = (is_broken ? self->broken_ms : self->whole_ms) - 1U;
    }
    if (is_broken != self->is_broken) {
        set_part(self, rig, is_broken);
        self->is_broken = is_broken;
    }
}

static void have_mercy(adversary_t *self, const rig_t *rig)
{
    const bool is_found =
        rig->outputs.snapshot.axes[self->axis].power == (uint32_t)AXIS_POWER_FAULT;
    self->mercy_cycles -= (self->mercy_cycles > 0U) ? 1U : 0U;
    if (self->has_mercy && self->is_broken && is_found) {
        self->mercy_cycles = MERCY_CYCLES;
    }
}

static void work_pedal(adversary_t *self, rig_t *rig)
{
    const bool is_armed = rig->outputs.snapshot.order != (uint32_t)ARMING_STATE_NONE;
    if (self->on_ms == 0U) {
        return;
    }
    if (self->pedal_cycles > 0U) {
        self->pedal_cycles--;
    } else {
        self->is_pressing = is_armed && !self->is_pressing;
        self->pedal_cycles = jittered(self, self->is_pressing ? self->on_ms : self->off_ms);
    }
    rig_box(rig, self->is_pressing ? "pedal a close" : "pedal a open");
    rig_box(rig, self->is_pressing ? "pedal b close" : "pedal b open");
}

static void lose(adversary_t *self, rig_t *rig)
{
    if ((self->plan == FOE_COUPLED) && (self->lose_cycle == self->cycle) &&
        !coupled_limit_jogs_is_out(&self->apart, rig)) {
        self->lose_cycle++;
    }
    if (self->lose_cycle == self->cycle) {
        order(rig, "card", self->lost_axis, "silent");
    }
    if ((self->lose_cycle != UINT32_MAX) && (self->cycle == (self->lose_cycle + LOST_CYCLES))) {
        order(rig, "card", self->lost_axis, "normal");
    }
}

/* The switch, by the legs of homing: pressed far from its place, free, and pressed there again. */
static void pose_as_switch(adversary_t *self, rig_t *rig)
{
    const box_axis_t *const axis = &rig->box.axes[self->axis];
    const bool is_upper = axis->config->limit_switch == (uint8_t)LIMIT_SWITCH_UPPER;
    const uint32_t leg = rig->outputs.snapshot.axes[self->axis].reference;
    const double back = axis->motor.position_ticks - self->edge_ticks;
    bool is_pressed = self->is_broken;
    self->leg_cycles = (leg == self->leg) ? (self->leg_cycles + 1U) : 0U;
    self->leg = leg;
    if (leg == (uint32_t)AXIS_REFERENCE_APPROACH) {
        is_pressed = self->leg_cycles >= self->approach_ms;
        self->edge_ticks = axis->motor.position_ticks;
    } else if (leg == (uint32_t)AXIS_REFERENCE_BACK_OFF) {
        is_pressed = is_pressed && (self->leg_cycles < self->free_ms);
    } else if (leg == (uint32_t)AXIS_REFERENCE_LATCH) {
        is_pressed = is_pressed || ((is_upper ? back : -back) >= (double)self->past_ticks);
    } else {
        is_pressed = is_pressed && (self->leg_cycles < STRAY_CYCLES);
    }
    if (is_pressed != self->is_broken) {
        set_part(self, rig, is_pressed);
        self->is_broken = is_pressed;
    }
}

bool adversary_play(adversary_t *self, rig_t *rig)
{
    self->cycle++;
    self->was_homed = self->was_homed || (rig->outputs.snapshot.is_homed != 0U);
    have_mercy(self, rig);
    lose(self, rig);
    work_pedal(self, rig);
    if (self->plan == FOE_IMPOSTOR) {
        pose_as_switch(self, rig);
    } else {
        keep_rhythm(self, rig);
    }
    return self->is_broken || (self->on_ms != 0U) || (self->cycle >= self->lose_cycle);
}

static int32_t clamped(const axis_config_t *axis, int32_t ticks)
{
    const int32_t least = axis->target_minimum_ticks;
    const int32_t most = axis->target_maximum_ticks;
    return (ticks < least) ? least : (ticks > most) ? most : ticks;
}

command_t adversary_jog(adversary_t *self, const rig_t *rig)
{
    if (self->wish == FOE_ASKS_APART) {
        return coupled_limit_jogs_jog(&self->apart, rig, &self->random);
    }
    const axis_config_t *const axis = &self->robot->axes[self->axis];
    const uint32_t span = (uint32_t)(axis->target_maximum_ticks - axis->target_minimum_ticks);
    const int32_t at = rig->outputs.snapshot.axes[self->axis].position_ticks;
    int32_t ticks = axis->target_minimum_ticks + (int32_t)below(self, span + 1U);
    if (self->wish == FOE_ASKS_SHORT) {
        const int32_t way = (int32_t)between(self, 1U, (span / 500U) + 8U);
        const bool is_high = at > ((axis->minimum_ticks + axis->maximum_ticks) / 2);
        self->is_outwards = (below(self, 16U) == 0U) ? !is_high : self->is_outwards;
        ticks = clamped(axis, at + (self->is_outwards ? way : -way));
    }
    return (command_t){.kind = (uint32_t)COMMAND_JOG,
                       .as.jog = {.axis = self->axis, .to_ticks = ticks}};
}

static void add(char *text, size_t size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static void add(char *text, size_t size, const char *format, ...)
{
    const size_t length = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(text + length, size - length, format, arguments);
    va_end(arguments);
}

static void add_rhythm(const adversary_t *self, char *text, size_t size)
{
    add(text, size, ", %s %s", part_words[self->part], self->robot->axes[self->axis].name);
    if (self->part == (uint32_t)PART_LOAD) {
        add(text, size, " %.2f", self->load);
    } else {
        add(text, size, " %s", fault_word(self));
    }
    if (self->whole_ms != 0U) {
        add(text, size, " %u of %u ms", (unsigned)self->broken_ms,
            (unsigned)(self->broken_ms + self->whole_ms));
    }
    add(text, size, " %s from cycle %u%s", when_words[self->when], (unsigned)self->from_cycle,
        self->has_mercy ? ", whole for a while after a fault" : "");
}

void adversary_describe(const adversary_t *self, char *text, size_t size)
{
    static const char *const starts[] = {"from power-on", "homed", "with a target"};
    text[0] = '\0';
    add(text, size, "%s %s, %s", plan_words[self->plan], starts[self->start],
        wish_words[self->wish]);
    if (self->on_ms != 0U) {
        add(text, size, ", pedal %u on %u off ms", (unsigned)self->on_ms, (unsigned)self->off_ms);
    }
    if (self->lose_cycle != UINT32_MAX) {
        add(text, size, ", card of %s silent at cycle %u", self->robot->axes[self->lost_axis].name,
            (unsigned)self->lose_cycle);
    }
    if (self->plan == FOE_IMPOSTOR) {
        add(text, size,
            ", switch %s %s after %u ms of approach, free %u ms after its end, back at %d ticks",
            self->robot->axes[self->axis].name, fault_word(self), (unsigned)self->approach_ms,
            (unsigned)self->free_ms, (int)self->past_ticks);
    } else if (self->broken_ms != 0U) {
        add_rhythm(self, text, size);
    } else {
        /* Nothing but the pedal. */
    }
}

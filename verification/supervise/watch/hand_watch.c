/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/watch/hand_watch.h"

#include "supervise/watch/truth.h"

#include <math.h>

#define DEEPER_MM 0.1
#define VIBRATION_MM ((double)LIMIT_VIBRATION_MOST_UM / 1000.0)
#define PUSH_N 0.15 /* Half of a dead zone: less is no push, whatever the noise. */
#define TOUCH_N 0.02
#define TURNED_TICKS 24.0 /* 5 degrees of the ProstateRobot. */
#define UNTURNED_MM 0.5
#define LED_ON_MM 0.02   /* A third of a vibration; a motor may be faster than its table says. */
#define IDLE_CYCLES 120U /* Latency and filter of the sensor, and the time for hands off. */
#define OFF_CYCLES 100U  /* A slower drive than this is none. */
#define GHOST_CYCLES ((LIMIT_HAND_PUSH_US / LIMIT_CYCLE_US) + 300U)

static uint32_t rule(hand_rule_t which, bool is_broken)
{
    return is_broken ? ((uint32_t)1U << (uint32_t)which) : 0U;
}

static bool is_sent(const rig_t *rig, uint32_t axis)
{
    return rig_sent(rig, axis).drive.mode != (uint32_t)CARD_DRIVE_OFF;
}

static bool is_a_cell_broken(const rig_t *rig)
{
    bool is_any = false;
    for (uint32_t i = 0U; i < (uint32_t)SIM_CELLS; i++) {
        is_any = is_any || (rig->box.force.cells[i].fault != SIM_LOAD_CELL_NORMAL);
    }
    return is_any;
}

/* Faults for which the sensor cannot be believed, whether or not the core has noticed. */
static void doubt_sensor(hand_watch_t *self, const rig_t *rig)
{
    const bool is_zeroing = force_sensor_is_zeroing(&rig->controller.force);
    const bool is_touch = fabs(rig->box.force.hand.force_n) > TOUCH_N;
    const bool is_broken = is_a_cell_broken(rig);
    if (is_zeroing && !self->is_zeroing) {
        self->is_touched = false;
    }
    self->is_touched = self->is_touched || is_touch || is_broken;
    if (!is_zeroing && self->is_zeroing) {
        self->is_untrue = self->is_touched;
    }
    self->is_untrue = self->is_untrue || is_broken || (is_zeroing && is_touch);
    self->is_zeroing = is_zeroing;
}

static bool is_reported(const rig_t *rig, event_id_t id)
{
    bool is_one = false;
    for (uint32_t i = 0U; i < rig->outputs.event_count; i++) {
        is_one = is_one || (rig->outputs.events[i].id == (uint32_t)id);
    }
    return is_one;
}

/* Way of a needle that stops: its lag, and the slope of a stop. */
static double stop_way(const robot_t *robot, int32_t speed_q8)
{
    const double speed = fmax((double)speed_q8 / 256.0, 0.0);
    const double slope = (double)robot->hand.stop_ticks_per_s2;
    return (speed / (double)robot->axes[robot->needle_axis].gain_per_s) +
           (speed * speed / (2.0 * slope));
}

/* Between its report and the end of the push it goes no deeper than a stop takes it. */
static bool is_led_on(hand_watch_t *self, const rig_t *rig, double needle_ticks)
{
    const uint32_t needle = rig->box.robot->needle_axis;
    if (is_reported(rig, EVENT_VIBRATION_BEGUN)) {
        self->is_vibrating = true;
        self->stop_ticks = needle_ticks + stop_way(rig->box.robot, self->speed_q8);
    }
    self->is_vibrating = self->is_vibrating && (rig->outputs.snapshot.membranes.sight ==
                                                (uint32_t)MEMBRANE_SIGHT_VIBRATING);
    self->speed_q8 = rig->outputs.snapshot.axes[needle].setpoint_speed_ticks_per_s_q8;
    return self->is_vibrating && (truth_measure(&rig->box.robot->axes[needle],
                                                needle_ticks - self->stop_ticks) > LED_ON_MM);
}

/* Outwards it is driven by a vibration only, which no needle leaves its amplitude in. */
static bool is_drawn_out(const hand_watch_t *self, const rig_t *rig, double needle_ticks)
{
    const uint32_t needle = rig->box.robot->needle_axis;
    const axis_config_t *const config = &rig->box.robot->axes[needle];
    const card_drive_t drive = rig_sent(rig, needle).drive;
    const double out_mm = truth_measure(config, self->deepest_ticks - needle_ticks);
    return is_sent(rig, needle) && !motor_model_is_upwards(config, &drive) &&
           (out_mm > VIBRATION_MM);
}

static bool is_beside(const rig_t *rig)
{
    const uint32_t needle = rig->box.robot->needle_axis;
    bool is_any = false;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        is_any = is_any || ((i != needle) && !order_watch_is_steering(rig, i) && is_sent(rig, i));
    }
    return is_any;
}

/* Way that a needle that is steered has gained since its true rotation has last turned. */
static bool is_unturned(hand_watch_t *self, const rig_t *rig, const double truth[ROBOT_AXIS_MAX])
{
    const robot_t *const robot = rig->box.robot;
    const uint32_t needle = robot->needle_axis;
    const uint32_t rotation = robot->steering.axis;
    const bool is_watched = order_watch_is_steering(rig, rotation) &&
                            (rig->outputs.snapshot.workphase == (uint32_t)WORKPHASE_MOVE_TO_TARGET);
    if (!is_watched || (fabs(truth[rotation] - self->turned_ticks) > TURNED_TICKS)) {
        self->turned_ticks = truth[rotation];
        self->turned_needle_ticks = truth[needle];
    }
    return truth_measure(&robot->axes[needle], truth[needle] - self->turned_needle_ticks) >
           UNTURNED_MM;
}

/* A drive without a hand goes on once its time is over, or at all by a sensor that is true. */
static bool is_ghost(hand_watch_t *self, const rig_t *rig, bool is_armed)
{
    const bool is_pushed = rig->box.force.hand.force_n > PUSH_N;
    const bool is_driven = is_sent(rig, rig->box.robot->needle_axis);
    self->idle_cycles = is_pushed ? 0U : (self->idle_cycles + 1U);
    self->off_cycles = is_driven ? 0U : (self->off_cycles + 1U);
    if (!is_armed || (self->idle_cycles <= IDLE_CYCLES) || (self->off_cycles > OFF_CYCLES)) {
        self->ghost_cycles = 0U;
    } else {
        self->ghost_cycles += is_driven ? 1U : 0U;
    }
    return self->ghost_cycles > (self->is_untrue ? GHOST_CYCLES : 0U);
}

uint32_t hand_watch_look(hand_watch_t *self, const order_watch_t *order, const rig_t *rig,
                         const double truth[ROBOT_AXIS_MAX])
{
    const uint32_t needle = rig->box.robot->needle_axis;
    const bool is_armed = order->kind == (uint32_t)COMMAND_COOPERATE;
    doubt_sensor(self, rig);
    if (order->armed[COMMAND_COOPERATE] != self->armed) {
        self->armed = order->armed[COMMAND_COOPERATE];
        self->is_insertion = true;
        self->target_ticks = rig->controller.plan.target_ticks[needle];
        self->deepest_ticks = truth[needle];
    } else {
        self->is_insertion = self->is_insertion && (is_armed || (order->kind == COMMAND_NONE));
    }
    const double deeper =
        truth_measure(&rig->box.robot->axes[needle], truth[needle] - (double)self->target_ticks);
    const bool is_driven_on = is_ghost(self, rig, is_armed);
    const bool is_deeper = is_led_on(self, rig, truth[needle]);
    self->deepest_ticks = fmax(self->deepest_ticks, truth[needle]);
    return rule(HAND_ALONE,
                is_armed && (is_beside(rig) || is_drawn_out(self, rig, truth[needle]))) |
           rule(HAND_DEPTH, self->is_insertion && (deeper > DEEPER_MM)) |
           rule(HAND_PUSH, is_driven_on) | rule(HAND_ROTATION, is_unturned(self, rig, truth)) |
           rule(HAND_VIBRATION, is_deeper);
}

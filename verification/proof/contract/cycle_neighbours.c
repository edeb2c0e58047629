/* SPDX-License-Identifier: Apache-2.0 */
/* Contracts of the neighbours of authority, workphase and armed order in a cycle. Each answers
 * anything. What they write besides, axes, links, plan, mode, account, guard of the hand and
 * answer, is read by no sentence; none of them writes order, workphase, authority, e-stop, loop or
 * pedal. */
#include "prove.h"

#include "controller/controller_facts.h"
#include "controller/controller_order.h"
#include "controller/orders/controller_aim.h"
#include "robot/robot_damage.h"

void controller_note(controller_t *self, const cycle_t *cycle, event_id_t id, uint32_t subject,
                     int32_t value)
{
    (void)cycle;
    (void)subject;
    (void)value;
    self->last_event = (uint32_t)id;
}

cycle_t controller_with_cause(const cycle_t *cycle, event_cause_t cause, uint32_t peer)
{
    cycle_t because = *cycle;
    because.cause = cause;
    because.peer = peer;
    return because;
}

void axis_enable(axis_t *self, bool is_fault_present)
{
    axis_t after;
    (void)is_fault_present;
    *self = after;
}

card_drive_t axis_rest(axis_t *self, uint32_t elapsed_us)
{
    axis_t after;
    card_drive_t rest;
    (void)elapsed_us;
    *self = after;
    return rest;
}

void link_reset(link_t *self)
{
    link_t after;
    *self = after;
}

void rigid_set_identity(rigid_t *self)
{
    rigid_t after;
    *self = after;
}

void homing_account_init(homing_account_t *self)
{
    (void)self;
}

void homing_account_begin(homing_account_t *self, const robot_t *robot,
                          const axis_t axes[ROBOT_AXIS_MAX])
{
    (void)self;
    (void)robot;
    (void)axes;
}

void homing_account_charge(homing_account_t *self, const robot_t *robot,
                           const axis_t axes[ROBOT_AXIS_MAX], uint32_t failed)
{
    (void)robot;
    (void)axes;
    (void)failed;
    (void)self;
}

bool homing_account_is_beyond(const homing_account_t *self, const robot_t *robot)
{
    bool is_beyond;
    (void)self;
    (void)robot;
    return is_beyond;
}

mode_kind_t mode_of(workphase_t workphase)
{
    mode_kind_t kind;
    (void)workphase;
    return kind;
}

mode_aim_t mode_aim_of(uint32_t kind)
{
    mode_aim_t aim;
    (void)kind;
    return aim;
}

bool mode_is_by_hand(mode_kind_t kind)
{
    bool is_by_hand;
    (void)kind;
    return is_by_hand;
}

bool mode_wants_hand_off(const mode_state_t *self, mode_kind_t kind)
{
    bool is_wanted;
    (void)self;
    (void)kind;
    return is_wanted;
}

uint32_t mode_axes(mode_kind_t kind, uint32_t commanded, const robot_t *robot)
{
    uint32_t axes;
    (void)kind;
    (void)commanded;
    (void)robot;
    return axes;
}

void mode_begin(mode_state_t *self, mode_kind_t kind, const mode_request_t *request)
{
    (void)request;
    self->sealed.kind = (uint32_t)kind;
}

void mode_stop(mode_state_t *self, axis_t axes[ROBOT_AXIS_MAX], uint32_t axis_count)
{
    (void)self;
    (void)axes;
    (void)axis_count;
}

void mode_step(mode_state_t *self, const mode_frame_t *frame, mode_result_t *result)
{
    mode_result_t any;
    (void)self;
    (void)frame;
    assume(any.note_count <= MODE_NOTES);
    *result = any;
}

bool controller_is_homed(const controller_t *self)
{
    bool is_homed;
    (void)self;
    return is_homed;
}

bool controller_lacks_box(const controller_t *self, const cycle_t *cycle)
{
    bool lacks;
    (void)self;
    (void)cycle;
    return lacks;
}

workphase_inputs_t controller_guards(const controller_t *self, const cycle_t *cycle,
                                     mode_kind_t kind, uint32_t axes)
{
    workphase_inputs_t guards;
    (void)self;
    (void)cycle;
    (void)kind;
    (void)axes;
    return guards;
}

solution_t controller_judge_way(controller_t *self, const cycle_t *cycle)
{
    solution_t judged;
    (void)self;
    (void)cycle;
    return judged;
}

int32_t hand_guard_step(hand_guard_t *self, const hand_law_t *law, const hand_t *hand,
                        bool is_moving, uint32_t elapsed_us)
{
    int32_t felt_mn;
    hand_guard_t after;
    (void)law;
    (void)hand;
    (void)is_moving;
    (void)elapsed_us;
    *self = after;
    return felt_mn;
}

/* Membranes are shown and logged; a puncture is any. */
bool controller_feel_membranes(controller_t *self, const cycle_t *cycle)
{
    membrane_watch_t after;
    bool is_puncture;
    (void)cycle;
    self->membranes = after;
    return is_puncture;
}

bool robot_is_force_damaged(const robot_t *robot)
{
    bool is_damaged;
    (void)robot;
    return is_damaged;
}

/* SPDX-License-Identifier: Apache-2.0 */
/* Contracts of the neighbours of controller_drive(). Each may answer anything, the same in one
 * cycle; each asserts what it needs. */
#include "contract/drive_neighbours.h"

#include "prove.h"

#include "controller/controller_force.h"
#include "controller/cycle/controller_dialect.h"
#include "safety/coupled_guard.h"
#include "safety/needle.h"

drive_neighbours_t drive_neighbours;

uint32_t controller_hand_reasons(const controller_t *self, const cycle_t *cycle, mode_kind_t kind)
{
    (void)self;
    (void)cycle;
    (void)kind;
    return drive_neighbours.hand_reasons;
}

bool mode_may_be_unhomed(mode_kind_t kind)
{
    (void)kind;
    return drive_neighbours.may_be_unhomed;
}

uint32_t mode_heeding_needle(const mode_state_t *self, mode_kind_t kind, const robot_t *robot,
                             uint32_t driven)
{
    (void)self;
    (void)kind;
    (void)robot;
    (void)driven;
    return drive_neighbours.heeding_needle;
}

bool mode_waits_for_rotation(const mode_state_t *self, mode_kind_t kind, const robot_t *robot,
                             const axis_t axes[ROBOT_AXIS_MAX])
{
    (void)self;
    (void)kind;
    (void)robot;
    (void)axes;
    return drive_neighbours.is_waiting_for_rotation;
}

bool needle_forbids_jog(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index,
                        bool is_upwards)
{
    (void)robot;
    (void)axes;
    (void)is_upwards;
    PROVE(index < ROBOT_AXIS_MAX, "contract of needle_forbids_jog: an axis of the robot");
    return drive_neighbours.is_needle_in_way[index];
}

uint32_t coupled_guard_blocks(const robot_t *robot, const coupled_view_t *view)
{
    (void)robot;
    PROVE(view->axes == drive_neighbours.axes,
          "contract of coupled_guard_blocks: the axes of this cycle");
    return drive_neighbours.at_coupled_limit;
}

bool speed_cap_step(speed_cap_t *self, const axis_config_t *config, uint32_t percent,
                    int32_t position_ticks, uint32_t elapsed_us)
{
    uint32_t index = 0U;
    speed_cap_t after;
    (void)config;
    (void)position_ticks;
    (void)elapsed_us;
    PROVE(percent <= 100U, "contract of speed_cap_step: a share of the speed");
    while ((index < (ROBOT_AXIS_MAX - 1U)) &&
           (self != &drive_neighbours.records[index].sealed.speed_cap)) {
        index++;
    }
    *self = after;
    return drive_neighbours.is_too_fast[index];
}

void reason_hold_watch(reason_hold_t *self, uint32_t reasons, uint32_t elapsed_us)
{
    reason_hold_t after;
    (void)reasons;
    (void)elapsed_us;
    *self = after;
}

void card_frame_write_command(const card_command_t *command, uint8_t bytes[CARD_FRAME_BYTES])
{
    PROVE(command->slot < CARD_SLOT_COUNT,
          "contract of card_frame_write_command: a slot of the box");
    PROVE(bytes == drive_neighbours.frames[command->slot],
          "contract of card_frame_write_command: the frame of that slot");
    drive_neighbours.sent[command->slot].command = *command;
    drive_neighbours.sent[command->slot].count++;
}

void controller_translate(const cycle_t *cycle)
{
    (void)cycle;
}

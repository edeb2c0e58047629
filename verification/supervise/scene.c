/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/scene.h"

void scene_begin(scene_t *self, const robot_t *robot, play_t play, uint32_t seed)
{
    motion_oracle_begin(&self->oracle, seed);
    scenario_begin(&self->scenario, &self->rig, robot, play, seed);
}

void scene_cycle(scene_t *self)
{
    double truth[ROBOT_AXIS_MAX];
    scenario_play(&self->scenario, &self->rig);
    box_true_positions(&self->rig.box, truth);
    rig_cycle(&self->rig);
    self->oracle.is_sound = scenario_is_sound(&self->scenario);
    motion_oracle_look(&self->oracle, &self->rig, truth, scenario_is_disturbed(&self->scenario));
}

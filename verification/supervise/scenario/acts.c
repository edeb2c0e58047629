/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/scenario/acts.h"

#include "charts/axis_chart.h"
#include "supervise/scenario/prng.h"

#include <math.h>

#define ANYWHERE_PARTS 8U /* One of so many homes that are set is set wherever the axis stands. */

bool acts_is_shown_true(const rig_t *rig)
{
    double truth[ROBOT_AXIS_MAX];
    bool is_true = true;
    box_true_positions(&rig->box, truth);
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        const axis_config_t *const config = &rig->box.robot->axes[i];
        const double away = fabs(truth[i] - (double)rig->outputs.snapshot.axes[i].position_ticks);
        is_true = is_true && (!axis_is_confirmable(&rig->controller.axes[i], config) ||
                              (away <= (double)supervision_rest_ticks(config)));
    }
    return is_true;
}

static bool is_truly_at_home(const rig_t *rig, uint32_t axis)
{
    const axis_config_t *const config = &rig->box.robot->axes[axis];
    double truth[ROBOT_AXIS_MAX];
    box_true_positions(&rig->box, truth);
    return fabs(truth[axis] - (double)config->home_ticks) <= (double)supervision_rest_ticks(config);
}

/* This one, or one that waits for a confirmation. */
static uint32_t to_confirm(const rig_t *rig, uint32_t axis)
{
    uint32_t found = axis;
    for (uint32_t i = 0U; i < rig->box.robot->axis_count; i++) {
        if (axis_is_confirmable(&rig->controller.axes[i], &rig->box.robot->axes[i])) {
            found = i;
        }
    }
    return found;
}

command_t acts_choose(const rig_t *rig, uint32_t *chance)
{
    static const command_kind_t kinds[] = {COMMAND_HOME_AXIS, COMMAND_HOME_AXIS, COMMAND_CLEAR_AXIS,
                                           COMMAND_CONFIRM_AXIS, COMMAND_SET_HOME};
    command_kind_t kind = kinds[prng_below(chance, (uint32_t)(sizeof kinds / sizeof kinds[0]))];
    const uint32_t axis = prng_below(chance, rig->box.robot->axis_count);
    const bool is_bold = (kind == COMMAND_SET_HOME) && (prng_below(chance, ANYWHERE_PARTS) == 0U);
    const bool takes_place = (kind == COMMAND_SET_HOME) ||
                             ((kind == COMMAND_HOME_AXIS) &&
                              (rig->box.robot->axes[axis].home_method == (uint8_t)HOME_IN_PLACE));
    if (takes_place && !is_bold && !is_truly_at_home(rig, axis)) {
        kind = COMMAND_CONFIRM_AXIS;
    }
    return (command_t){
        .kind = (uint32_t)kind,
        .as.axis = {.axis = (kind == COMMAND_CONFIRM_AXIS) ? to_confirm(rig, axis) : axis}};
}

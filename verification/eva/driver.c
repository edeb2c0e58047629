/* SPDX-License-Identifier: Apache-2.0 */
/* What Frama-C's Eva follows: the controller from its start on for ever, with any kept positions,
 * any list of rows and, in each cycle, any inputs, into any memory. The seals of the state and of
 * the robot's table hold any value, so that each section may be found damaged in any cycle.
 * EVA_ROBOT is the table of the robot. */
#include "contracts.h"
#include "parts.h"
#include "state.h"
#include "sums.h"

#include "controller/controller.h"

#include <__fc_builtin.h>

static robot_t robot;
static controller_t controller;
static controller_inputs_t inputs;
static controller_outputs_t outputs;
static kept_positions_t kept;
static trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS];

/* A broken contract is an alarm where the contract stands. */
/*@ requires contract: \false;
    assigns \nothing;
    ensures \false; */
void contract_broken(const char *module, uint32_t id);

static void damage_seals(void)
{
    Frama_C_make_unknown((char *)controller.seals, sizeof controller.seals);
    Frama_C_make_unknown((char *)&robot.seal, sizeof robot.seal);
    /*@ loop unroll ROBOT_AXIS_MAX; */
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        Frama_C_make_unknown((char *)&robot.axes[i].seal, sizeof robot.axes[i].seal);
    }
    /*@ loop unroll POSE_NAME_COUNT; */
    for (uint32_t i = 0U; i < (uint32_t)POSE_NAME_COUNT; i++) {
        Frama_C_make_unknown((char *)&robot.poses[i].seal, sizeof robot.poses[i].seal);
    }
}

static void start(void)
{
    uint32_t row = 0U;
    robot = EVA_ROBOT;
    controller_init(&controller, &robot);
    if (Frama_C_nondet(0, 1) != 0) {
        Frama_C_make_unknown((char *)&kept, sizeof kept);
        controller_restore(&controller, &kept);
    }
    if (Frama_C_nondet(0, 1) != 0) {
        Frama_C_make_unknown((char *)rows, sizeof rows);
        (void)controller_hold(&controller, &robot, rows,
                              Frama_C_unsigned_int_interval(0U, LIMIT_TRAJECTORY_ROWS), &row);
    }
}

void run_controller(void)
{
    follow_sums();
    follow_frames();
    follow_trace();
    follow_axis_chart();
    follow_notes();
    start();
    if (Frama_C_nondet(0, 1) != 0) {
        age_state(&controller);
    }
    /*@ loop unroll 0; */
    for (;;) {
        damage_seals();
        Frama_C_make_unknown((char *)&outputs, sizeof outputs);
        Frama_C_make_unknown((char *)&inputs, sizeof inputs);
        inputs.command_count = Frama_C_unsigned_int_interval(0U, CONTROLLER_COMMANDS);
        controller_step(&controller, &robot, &inputs, &outputs);
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
/** @file The controller on the simulated control box in lock-step: simulated time, the same bytes
 * on every run. */
#ifndef BORESIGHT_RIG_H
#define BORESIGHT_RIG_H

#include "control/board_inputs.h"
#include "controller/controller.h"
#include "robot/robot.h"
#include "sim/box.h"
#include "sim/model/sim_random.h"

#include <stdbool.h>
#include <stdint.h>

#define RIG_ANSWERS 64U
#define RIG_EVENTS 512U
#define RIG_PAGE 1U            /**< The page that commands. */
#define RIG_CONNECTION 2U      /**< The connection that proposes. */
#define RIG_OWN_ID 4000000000U /**< Ids of the page's own acts; their answers are not kept. */

typedef struct {
    box_t box;
    controller_t controller;
    robot_t robot; /**< The controller's table; the box has its own. */
    controller_inputs_t inputs;
    controller_outputs_t outputs;
    command_t commands[CONTROLLER_COMMANDS]; /**< For the next cycle. */
    uint32_t command_count;
    uint32_t elapsed_us; /**< Length of every cycle; 1000 unless a test changes it. */
    uint32_t
        late_us; /**< So much longer than 1000 us lasts the next cycle, in the world as well. */
    uint32_t early_us; /**< So much shorter; with the jitter less than 1000. */
    uint32_t was_late_us;
    uint32_t exchanged_us; /**< When the last exchange was, by the wake-ups. */
    /** The exchange comes by a random part of this later than the wake-up of its cycle says. */
    uint32_t jitter_us;
    uint32_t shift_us; /**< So much later it comes in this cycle. */
    /** Cycles left in which the box stands: what was sent last is exchanged when it goes on, and
     * that answer comes too late. */
    uint32_t held_cycles;
    bool is_held;                                           /**< It stands. */
    sim_random_t random;                                    /**< Random numbers of the jitter. */
    uint8_t held_frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES]; /**< Frames that were sent last. */
    board_inputs_t board_inputs;
    uint32_t unread; /**< BSP_IN_ bits that the board does not read. */
    uint32_t next_id;
    uint32_t silent_sources;       /**< As controller_inputs_t. */
    uint32_t unfit;                /**< The same. */
    uint32_t lacks_black_box;      /**< The same. */
    uint32_t cycles_lost;          /**< The same. */
    uint32_t is_recorder_failing;  /**< The same. */
    uint32_t recording_left_min;   /**< The same. */
    uint32_t dialect;              /**< The same; the box's cards speak it. */
    uint32_t is_dialect_accepted;  /**< The same. */
    uint32_t frames_late;          /**< The same. */
    uint32_t frames_failed;        /**< The same. */
    bool has_no_button;            /**< The box has none, whatever it says. */
    bool is_page_away;             /**< The page does not take authority by itself, nor renew it. */
    answer_t answers[RIG_ANSWERS]; /**< All since rig_forget(). */
    uint32_t answer_count;
    event_t events[RIG_EVENTS];
    uint32_t event_count;
    uint32_t driven_without_pedal; /**< Cycles in which any drive word was not zero with the gate
                                      shut. */
} rig_t;

/** Powers the box and the controller on and lets the cards come alive. */
void rig_start(rig_t *self);

/** The same with another robot than the NeuroRobot; `robot` must outlive the rig. */
void rig_start_robot(rig_t *self, const robot_t *robot);

/** `from`, which has an axis with pwm, but for magnitudes that its cards without pwm take. */
void rig_set_magnitude_robot(robot_t *robot, const robot_t *from);

/** When it is powered on, its axes stand a little inside of their switches, from where homing is
 * short; those of a block, which has lengths to keep, stay where they are. */
void rig_put_near_switches(robot_t *robot);

/** The axes of a block cannot come nearer to all of their switches: homing takes them over their
 * whole travel. Their switches stand a little beyond where any pose has them, and they start at
 * home, so that the travel is short. All else is as the robot has it. */
void rig_shorten_rails(robot_t *robot);

/** The ProstateRobot with short rails: it homes in an eighth of the cycles. */
const robot_t *rig_short_prostate(void);

/** One cycle: what the one before made leaves, 1 ms of physics, inputs, controller. */
void rig_cycle(rig_t *self);
void rig_cycles(rig_t *self, uint32_t count);

/** An order to the box, as simctl takes it; fails the test when the box refuses it. */
void rig_box(rig_t *self, const char *order);

/** The page gives authority up and is away; it is free once the axes rest. */
void rig_leave(rig_t *self);

/** Queues a command for the next cycle and runs that cycle. One of peer 0 and
 * COMMAND_SOURCE_IGTL, that is of no peer, is signed by the page, a proposal by the connection,
 * unless the page is away.
 * @return its immediate answer */
answer_t rig_command(rig_t *self, command_t command);
answer_t rig_workphase(rig_t *self, workphase_t workphase);

/** Presses or releases the pedal and lets the contacts settle (10 cycles). */
void rig_press(rig_t *self);
void rig_release(rig_t *self);

/** The armed order expires in the second cycle from now: the time without the pedal until then has
 * passed at once. */
void rig_let_expire(rig_t *self);

/** Runs until the pending command is answered for good, at most `most` cycles. @return that answer
 */
answer_t rig_finish(rig_t *self, uint32_t most);

/** START_UP with the pedal held until every axis is homed, then the pedal is released. */
void rig_home(rig_t *self);

/** START_UP with the pedal held until the needle is homed; then MANUAL. Axes that are taken where
 * they stand, as the rotation, are homed as well. */
void rig_start_needle_homed(rig_t *self);
void rig_start_robot_needle_homed(rig_t *self, const robot_t *robot);

/** A rig that is homed; homed once and copied, until it is asked for another robot. Without a
 * robot: the NeuroRobot, near its switches when it was powered on. */
void rig_start_homed(rig_t *self);
void rig_start_robot_homed(rig_t *self, const robot_t *robot);

/** A homed rig, registered by the identity, with an accepted target, in TARGETING. */
void rig_start_targeted(rig_t *self);

/** The same with another robot and a target that it reaches. */
void rig_start_robot_targeted(rig_t *self, const robot_t *robot, const rigid_t *pose);

/** A targeted rig in the middle of MOVE_TO_TARGET, the pedal held. */
void rig_start_moving(rig_t *self);

/** A targeted rig after MOVE_TO_TARGET, the needle at the target, the pedal released; moved once
 * and copied. */
void rig_start_arrived(rig_t *self);

/** CALIBRATION with a registration, then TARGETING. */
void rig_register(rig_t *self, const rigid_t *scanner_zframe);

/** Commands `pose` as the target. @return the answer */
answer_t rig_target(rig_t *self, const rigid_t *scanner_treatment);

/** The controller's link to the card of `axis`. */
link_t *rig_link(rig_t *self, uint32_t axis);

/** Where the controller believes `axis` to be. */
int32_t rig_position(const rig_t *self, uint32_t axis);

/** `axis` has faulted: what it stands at is not known any more, and there is no target. */
void rig_expect_nothing_known(const rig_t *self, uint32_t axis);

/** The frame that goes to the card of `axis`, decoded. */
card_command_t rig_sent(const rig_t *self, uint32_t axis);

/** Any drive word of any outgoing frame is not zero. */
bool rig_is_driving(const rig_t *self);

/** How often `id` was noted since rig_forget(). */
uint32_t rig_count(const rig_t *self, event_id_t id);
void rig_forget(rig_t *self);

/** Registration and a reachable treatment pose for tests: needle straight down, treatment point as
 * given (nm). */
rigid_t rig_pose(int32_t x_nm, int32_t y_nm, int32_t z_nm);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The controller: one pure function of its state and the cycle's inputs. Everything that decides
 * about motion is inside it. No I/O, no clock, no heap, no float; equal inputs give equal outputs,
 * bit for bit.
 */
#ifndef BORESIGHT_CONTROLLER_H
#define BORESIGHT_CONTROLLER_H

#include "axis/axis.h"
#include "card/card_frame.h"
#include "card/card_health.h"
#include "card/link.h"
#include "controller/homing_account.h"
#include "controller/kept.h"
#include "controller/membrane_watch.h"
#include "interface/answer.h"
#include "interface/command.h"
#include "interface/event.h"
#include "interface/snapshot.h"
#include "limits/requirement_limits.h"
#include "mode/mode.h"
#include "procedure/plan.h"
#include "procedure/procedure.h"
#include "procedure/target_way.h"
#include "robot/robot.h"
#include "robot/robot_cards.h"
#include "safety/authority.h"
#include "safety/confirm_button.h"
#include "safety/estop_latch.h"
#include "safety/hand_guard.h"
#include "safety/loop_guard.h"
#include "safety/pedal_gate.h"
#include "safety/reason_hold.h"
#include "safety/speed_cap.h"
#include "sensor/force_sensor.h"

#include <stddef.h>
#include <stdint.h>

#define CONTROLLER_COMMANDS LIMIT_COMMANDS_PER_CYCLE
#define CONTROLLER_EVENTS LIMIT_EVENTS_PER_CYCLE
#define CONTROLLER_ANSWERS ((CONTROLLER_COMMANDS * 2U) + 1U) /**< Most answers of one cycle. */

/** Everything the controller may know of one cycle. Fixed layout, no padding; recorded. */
typedef struct {
    uint32_t elapsed_us; /**< Measured since the wake-up before; LIMIT_CYCLE_US nominally. */
    /** Stage that took longest in the cycle before, as control numbers them. */
    uint32_t late_stage;
    uint32_t pedal_a; /**< Channel A is closed (pressed): 0 or 1. */
    uint32_t pedal_b;
    uint32_t estop_open;        /**< The e-stop chain is open (pulled): 0 or 1. */
    uint32_t scanner_active;    /**< 0 or 1. */
    uint32_t has_button;        /**< The box has a button for the operator: 0 or 1. */
    uint32_t confirm_pressed;   /**< It is pressed: 0 or 1. */
    uint32_t dose_reached;      /**< The gate of the treatment says so: 0 or 1. */
    uint32_t treatment_stopped; /**< The same. */
    uint32_t unread; /**< Bits of box_input_t: those of these inputs that were not read. */
    /** Bit n: the process of command_source_t n has given no sign of life for
     * LIMIT_AUTHORITY_SILENT_US. */
    uint32_t silent_sources;
    /** Bits of computer_check_t: what the computer lacks for a real robot; 0 on a simulated one. */
    uint32_t unfit;
    /** Nothing is recorded, or the recorder gives no sign of life: 0 or 1; 0 without one. */
    uint32_t lacks_black_box;
    /** Cycles that could not be recorded since the start, up to this one; wraps. */
    uint32_t cycles_lost;
    /** The recorder cannot write, and no cycle is recorded: 0 or 1; 0 where there is none. */
    uint32_t is_recorder_failing;
    /** Minutes until the disk of the recordings is full, from 1; 0: no end is foreseen, or there is
     * no recorder. */
    uint32_t recording_left_min;
    uint32_t dialect; /**< card_dialect_t of all cards. */
    /** A named person accepts in writing the lacks of cards of another dialect than ours: 0 or 1.
     */
    uint32_t is_dialect_accepted;
    uint32_t frames_received; /**< Bit n: frames[n] was received in this cycle. */
    uint32_t frames_late;     /**< Bit n: it was not there in time. */
    uint32_t frames_failed;   /**< Bit n: the bus has failed. */
    card_samples_t samples;   /**< Times of frames[]. */
    uint32_t command_count;   /**< 0..CONTROLLER_COMMANDS. */
    command_t commands[CONTROLLER_COMMANDS];
    uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
} controller_inputs_t;

/** Everything the controller says in one cycle. Fixed layout, no padding; recorded. */
typedef struct {
    uint32_t frames_to_send; /**< Bit n: frames[n] goes out. */
    uint32_t answer_count;
    uint32_t event_count;
    uint32_t reserved;
    answer_t answers[CONTROLLER_ANSWERS];
    event_t events[CONTROLLER_EVENTS];
    snapshot_t snapshot;
    uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
} controller_outputs_t;

/** The long command that will be answered again. */
typedef struct {
    uint32_t id;
    uint32_t source;
    uint32_t kind;
    uint32_t asked;      /**< workphase_t of COMMAND_WORKPHASE. */
    uint32_t is_waiting; /**< 0 or 1. */
} pending_command_t;

/** Under seal. */
typedef struct {
    speed_cap_t speed_cap;
    reason_hold_t reason_hold;
    uint32_t permit_since_cycle; /**< Cycle of the last change of shown reasons. */
    uint32_t speed_cap_percent;  /**< permit_t's: 0 when it was not allowed. */
    uint32_t grade;              /**< axis_reference_t, as reported. */
} axis_record_sealed_t;

/** Decisions and reports on an axis of the last cycle. */
typedef struct {
    axis_record_sealed_t sealed;
} axis_record_t;

/** Sections of the state, each under its seal: axes, their cards, those without an
 * axis, and three more. The plan has a seal of its own. */
#define CONTROLLER_SECTIONS ((2U * ROBOT_AXIS_MAX) + 4U)

/** Positions from before the start; under seal while one of them is awaited. */
typedef struct {
    kept_axis_t sealed[ROBOT_AXIS_MAX]; /**< An axis that was compared is KEPT_LOST. */
} controller_kept_t;

/** What the controller knows besides its parts: the section EVENT_MEMORY_REST, with the records.
 * Under seal. */
typedef struct {
    pending_command_t pending;
    uint32_t power_on;     /**< The present one, as it was kept. */
    uint32_t kept_verdict; /**< kept_verdict_t. */
    uint32_t awaited;      /**< Axes of kept that have not been compared; 0: it counts no more. */
    uint32_t has_arrived;  /**< The last order led to the target, or through a program, and ended as
                              asked. */
    uint32_t vain_start_ups; /**< START_UPs that an axis or a card has ended since one was done. */
    uint32_t vain_moves;     /**< The same of MOVE_TO_TARGET; START_UP after service ends it too. */
    uint32_t vain_axis;     /**< Axis that ended the last of both; ROBOT_AXIS_MAX: it was a card. */
    uint32_t vain_card;     /**< Its slot; CARD_SLOT_COUNT: it was an axis. */
    uint32_t vain_event;    /**< event_id_t that ended it. */
    uint32_t account_state; /**< homing_account_state_t: of account. */
    uint32_t is_box_settled; /**< START_UP waits for no recording any more: 0 or 1. */
    uint32_t was_gate_open;
    uint32_t was_scanner_active;
    uint32_t unexpected_cards; /**< Bit n: a card that the robot does not name is in slot n. */
    uint32_t table_damage;     /**< As robot_damage() ever said: nothing moves any more. */
    uint32_t has_started;      /**< The first cycle has begun: 0 or 1. */
    uint32_t axis_count;       /**< Axes of the robot, as its undamaged table said last; at most
                                  ROBOT_AXIS_MAX. */
    hand_guard_t hand_guard;   /**< Of the needle's handle. */
    uint32_t is_steered;       /**< There was a steering in the cycle before: 0 or 1. */
    uint32_t cycle;            /**< This and the members below only count: any value is as good. */
    uint32_t time_us;
    uint32_t sequence; /**< Number of the outgoing frames. */
    uint32_t events;   /**< Number of the next event. */
    uint32_t events_lost;
} controller_sealed_t;

/** All state of the controller; holds no pointer, so that it can be stored and compared as bytes.
 * Members that it has once are divided into the sections of event_memory_t. */
typedef struct {
    link_t links[CARD_SLOT_COUNT]; /**< By slot. */
    pedal_gate_t pedal;
    loop_guard_t loop;
    confirm_button_t confirm;
    authority_t authority;
    estop_latch_chart_t estop;
    procedure_t procedure;
    plan_t plan;
    mode_state_t mode;
    axis_t axes[ROBOT_AXIS_MAX];
    axis_record_t records[ROBOT_AXIS_MAX];
    controller_kept_t kept;
    controller_sealed_t sealed;
    uint32_t seals[CONTROLLER_SECTIONS];
    card_health_t health[CARD_SLOT_COUNT]; /**< By slot; counts, too. */
    uint32_t cycles_lost;                  /**< Those of the inputs before; counts, too, */
    uint32_t unrecorded;                   /**< and those of them in the present gap. */
    uint32_t recording_left_min;           /**< That of the inputs before. */
    uint32_t is_end_reported;              /**< Its near end was reported: 0 or 1. */
    uint32_t unread;                       /**< That of the inputs before. */
    uint32_t is_estop_reported;            /**< Its pull was reported: 0 or 1. */
    force_sensor_t force;                  /**< Under the seal of the cards without an axis. */
    robot_cards_t cards;      /**< Cards of the robot, as its undamaged table says in each cycle. */
    target_way_t way;         /**< As it is shown; has a seal of its own. */
    program_list_t program;   /**< The treatment program that is held; has checksums of its own. */
    homing_account_t account; /**< Has a seal of its own. */
    membrane_watch_t membranes; /**< Of a robot with a force sensor; has seals of its own. */
    uint32_t last_event;    /**< event_id_t of the one noted last; it counts only, with the next. */
    uint32_t refused_cycle; /**< When the numbers of something refused were noted; the same. */
    /** Rows of mode.sealed.list; each has a checksum. The last member, as they are too many to be
     * copied with the rest: the members before are a checkpoint, to which those that the list has
     * belong.
     */
    trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS];
} controller_t;

/** Bytes of a checkpoint without rows. */
#define CONTROLLER_CHECKPOINT_BYTES offsetof(controller_t, rows)

/**
 * Starts in workphase UNDEFINED with nothing enabled. Of a table with more axes than there is room
 * for, which is damaged, the first ROBOT_AXIS_MAX.
 *
 * @satisfies SWR-MEMORY-380
 */
void controller_init(controller_t *self, const robot_t *robot);

/** Seals the state; a writer from outside calls this afterwards. */
void controller_seal(controller_t *self);

/**
 * Takes what was kept of the positions, once, between controller_init() and the first cycle
 * (contract 101). KEPT_FRESH and KEPT_KNOWN wait for the first report of their axis;
 * any other grade is lost.
 *
 * @satisfies SWR-STORE-003
 * @satisfies SWR-STORE-019
 */
void controller_restore(controller_t *self, const kept_positions_t *kept);

/**
 * Takes a trajectory of `count` rows of a file, once, between controller_init() and the first cycle
 * (contract 102), which notes it in the log. Nothing is held of one that is refused.
 *
 * @param row  the one that was refused
 * @return as mode/lists/trajectory_list.h says
 *
 * @satisfies SWR-TRAJ-020
 */
solution_t controller_hold(controller_t *self, const robot_t *robot, const trajectory_row_t *rows,
                           uint32_t count, uint32_t *row);

/**
 * One control cycle: frames -> links -> encoders -> interlocks -> commands -> mode -> permit ->
 * frames. `outputs` is completely rewritten. Requires (contract 100) at most
 * CONTROLLER_COMMANDS commands.
 *
 * @satisfies SWR-CMD-002
 * @satisfies SWR-CORE-002
 * @satisfies SWR-CTRL-020
 * @satisfies SWR-FORCE-760
 * @satisfies SWR-ROBOT-013
 */
void controller_step(controller_t *self, const robot_t *robot, const controller_inputs_t *inputs,
                     controller_outputs_t *outputs);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * What the controller shows of itself after each cycle. Fixed layout, no padding.
 */
#ifndef BORESIGHT_SNAPSHOT_H
#define BORESIGHT_SNAPSHOT_H

#include "rigid.h"
#include "robot.h"

#include <stdint.h>

/** States as the charts number them; their names are generated from the charts. */
typedef struct {
    uint32_t power;              /**< axis_power_t. */
    uint32_t reference;          /**< axis_reference_t. */
    uint32_t stall;              /**< stall_watchdog_state_t. */
    uint32_t permit_reasons;     /**< Bit mask of permit_reason_t; 0 = allowed. One that flickers
                                    stands. */
    uint32_t permit_since_cycle; /**< Cycle of the last change of permit_reasons. */
    uint32_t speed_cap_percent;
    int32_t reading_ticks; /**< The counter of the card, as last believed. */
    int32_t position_ticks;
    int32_t setpoint_ticks; /**< Where the profile wants it now; equals the position at rest. */
    int32_t target_ticks;   /**< The accepted target in MOVE_TO_TARGET; otherwise the set-point. */
    int32_t speed_ticks_per_s_q8; /**< Measured. */
    int32_t setpoint_speed_ticks_per_s_q8;
    uint32_t drive_mode; /**< As sent to the card in this cycle. */
    uint32_t drive_direction;
    uint32_t drive_duty;
    uint32_t limit_switches; /**< CARD_LIMIT_ bits. */
} snapshot_axis_t;

typedef struct {
    uint32_t link;         /**< card_link_state_t. */
    uint32_t age_cycles;   /**< Since the last valid frame, saturates. */
    uint32_t frame_errors; /**< Frames discarded. */
    uint32_t heartbeat;
    uint32_t status; /**< CARD_STATUS_ bits of the last valid frame. */
    uint32_t card_type;
} snapshot_card_t;

/** What the operator is asked to do next. */
typedef enum {
    NEXT_STEP_START_UP = 0,      /**< Command START_UP. */
    NEXT_STEP_RELEASE_ESTOP = 1, /**< Release the e-stop. */
    NEXT_STEP_CHECK_CARDS = 2,   /**< Check the cards, then command START_UP. */
    NEXT_STEP_RELEASE_PEDAL = 3, /**< Release the pedal. */
    NEXT_STEP_PRESS_PEDAL = 4,   /**< Press and hold the pedal. */
    NEXT_STEP_HOLD_PEDAL = 5,    /**< Keep the pedal pressed. */
    NEXT_STEP_SCANNER = 6,       /**< Wait until the scanner has finished. */
    NEXT_STEP_REGISTER = 7,      /**< Send a registration in CALIBRATION. */
    NEXT_STEP_TARGET = 8,        /**< Send a target in TARGETING. */
    NEXT_STEP_MOVE = 9,          /**< Command MOVE_TO_TARGET. */
    NEXT_STEP_NOTHING = 10,      /**< Nothing; the target is reached. */
    NEXT_STEP_PEDAL_FAULT = 11,  /**< Release the pedal, then command START_UP. */
    NEXT_STEP_TARGETING = 12,    /**< Return to TARGETING, then command MOVE_TO_TARGET. */
    NEXT_STEP_CONFIRM = 13, /**< Compare the positions shown with the robot, then hold the button
                              at the box for a second. */
    NEXT_STEP_MEMORY = 14   /**< Restart the programs: the table of the robot is damaged. */
} next_step_t;

typedef struct {
    uint32_t cycle;
    uint32_t time_us; /**< Controller time, wraps. */
    uint32_t robot_crc;
    uint32_t power_on;          /**< Id of the box's power-on. */
    uint32_t positions_awaited; /**< Axes whose kept reading waits for their first report. */
    uint32_t workphase;         /**< workphase_t. */
    uint32_t order;             /**< workphases_order_t: none, waiting for the pedal, moving. */
    uint32_t pedal;             /**< pedal_gate_state_t. */
    uint32_t estop;             /**< estop_latch_state_t. */
    uint32_t loop;              /**< loop_guard_state_t. */
    uint32_t next_step;         /**< next_step_t. */
    uint32_t is_scanner_active;
    uint32_t is_homed; /**< Every axis. */
    uint32_t is_registered;
    uint32_t has_target;
    uint32_t has_proposed_registration;
    uint32_t has_proposed_entry;
    uint32_t has_proposed_target;
    uint32_t is_proposal_reachable; /**< The proposed entry and target have joint values inside the
                                       limits. */
    uint32_t overruns;
    uint32_t events; /**< Number of the next event. */
    uint32_t events_lost;
    uint32_t pose_status;      /**< status_t: STATUS_OK while the two measured poses below are
                                  true, otherwise why they are not to be believed. */
    rigid_t zframe_treatment;  /**< Measured pose in the z-frame. */
    rigid_t scanner_treatment; /**< Measured pose in scanner coordinates; identity registration when
                                  none. */
    rigid_t scanner_zframe;    /**< The registration; identity when none. */
    rigid_t scanner_target;    /**< The accepted target, reachable pose; valid with has_target. */
    rigid_t proposed_registration;
    point_t proposed_entry;
    point_t proposed_target;
    rigid_t
        scanner_desired; /**< The pose the proposals ask for; valid with is_proposal_reachable. */
    int32_t desired_ticks[ROBOT_AXIS_COUNT]; /**< Its positions. */
    snapshot_axis_t axes[ROBOT_AXIS_COUNT];
    snapshot_card_t cards[ROBOT_SLOT_COUNT];
} snapshot_t;

#endif

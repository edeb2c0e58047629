/* SPDX-License-Identifier: Apache-2.0 */
/** @file What happened, numbered without gaps. Fixed layout, no padding. */
#ifndef BORESIGHT_EVENT_H
#define BORESIGHT_EVENT_H

#include <stdint.h>

typedef enum {
    EVENT_SEVERITY_INFORMATION = 0, /**< For the record. */
    EVENT_SEVERITY_WARNING = 1,     /**< Worth a look. */
    EVENT_SEVERITY_CRITICAL = 2     /**< Motion was stopped by a fault. */
} event_severity_t;

/** The charts, as the subject of EVENT_CHART_REPAIRED; `value` is the card's slot or the axis. */
typedef enum {
    EVENT_CHART_WORKPHASES = 0, /**< Workphases. */
    EVENT_CHART_LOOP_GUARD = 1, /**< Loop guard. */
    EVENT_CHART_PEDAL_GATE = 2, /**< Pedal gate. */
    EVENT_CHART_ESTOP = 3,      /**< E-stop latch. */
    EVENT_CHART_CARD = 4,       /**< Link of a card. */
    EVENT_CHART_AXIS = 5        /**< An axis or its stall watchdog. */
} event_chart_t;

/** Sections of the controller's state, as the subject of EVENT_MEMORY_DAMAGED; `value` is the axis.
 */
typedef enum {
    EVENT_MEMORY_AXIS = 0,       /**< What is known of an axis. */
    EVENT_MEMORY_CARD = 1,       /**< What is known of an axis' card. */
    EVENT_MEMORY_PLAN = 2,       /**< Registration and target. */
    EVENT_MEMORY_PROFILE = 3,    /**< The present motion. */
    EVENT_MEMORY_INTERLOCKS = 4, /**< Pedal, e-stop, loop guard, workphase. */
    EVENT_MEMORY_REST = 5        /**< The command that is waited for, counters. */
} event_memory_t;

/** Events. `subject` is an axis, a card slot, a workphase or a chart; `value` as said. */
typedef enum {
    EVENT_STARTED = 0,   /**< The controller started; kept positions: (value, kept_verdict_t). */
    EVENT_WORKPHASE = 1, /**< Workphase entered (subject). */
    EVENT_COMMAND_REFUSED = 2, /**< Command of kind (subject) refused, status (value). */
    EVENT_PEDAL_PRESSED = 3,   /**< The pedal gate opened. */
    EVENT_PEDAL_RELEASED = 4,  /**< The pedal gate closed. */
    EVENT_PEDAL_FAULT = 5,     /**< The pedal's channels disagreed too long. */
    EVENT_ESTOP_PULLED = 6,    /**< The e-stop was pulled. */
    EVENT_ESTOP_RELEASED = 7,  /**< The e-stop switch closed; it stays latched. */
    EVENT_ESTOP_CLEARED = 8,   /**< The e-stop latch was cleared. */
    EVENT_CARD_LIVE = 9,       /**< Card (subject) answers. */
    EVENT_CARD_LOST = 10,      /**< Card (subject) lost, cause (value, link_cause_t). */
    EVENT_FRAME_REFUSED =
        11, /**< Frame of card (subject) discarded, why (value, card_frame_result_t). */
    EVENT_AXIS_HOMED = 12,         /**< Axis (subject) homed, correction in ticks (value). */
    EVENT_AXIS_STALLED = 13,       /**< Axis (subject) stalled at position in ticks (value). */
    EVENT_AXIS_ENCODER_FAULT = 14, /**< Axis (subject) counted an impossible jump (value, ticks). */
    EVENT_AXIS_FOLLOWING_ERROR =
        15, /**< Axis (subject) strayed from its set-point by (value, ticks). */
    EVENT_AXIS_HOME_TIMEOUT = 16, /**< Axis (subject) did not find its switch in time. */
    EVENT_ORDER_ARMED = 17,       /**< Motion armed in workphase (subject): press the pedal. */
    EVENT_ORDER_DONE = 18,        /**< The armed motion ended as asked. */
    EVENT_ORDER_DISCARDED = 19,   /**< The armed motion was discarded. */
    EVENT_ORDER_EXPIRED = 20,     /**< The pedal was not pressed in time. */
    EVENT_REGISTERED = 21,        /**< A registration was accepted. */
    EVENT_TARGET_ACCEPTED = 22,   /**< A target was accepted. */
    EVENT_PROPOSAL = 23,          /**< A proposal of command kind (subject) was received. */
    EVENT_OVERRUN = 24,      /**< The loop was late, interval in us (value), stage (subject). */
    EVENT_LOOP_STOPPED = 25, /**< Late too often. */
    EVENT_CHART_REPAIRED =
        26,             /**< A chart's state was damaged; chart (subject) went to its safe state. */
    EVENT_SCANNER = 27, /**< The scanner started (value 1) or ended (0) acquiring. */
    EVENT_AXIS_SWITCH_FAULT =
        28, /**< Axis (subject) homed (value, ticks) and its switch had no edge where it must be. */
    EVENT_AXIS_WRONG_WAY = 29, /**< Axis (subject) went (value, ticks) against its drive. */
    EVENT_AXIS_MOVED_OFF = 30, /**< Axis (subject) moved (value, ticks) while its drive was off. */
    EVENT_AXIS_NO_COUNTS =
        31, /**< Axis (subject) should have made (value, ticks) and counted none. */
    EVENT_AXIS_WRONG_SPEED =
        32, /**< Axis (subject) counted (value, percent) of what its motor should make. */
    EVENT_ORDER_OVERDUE =
        33, /**< The motion did not end in time: axis (subject) is (value, ticks) off. */
    EVENT_AXIS_TAKEN =
        34, /**< Axis (subject) was taken where it stands, correction (value, ticks). */
    EVENT_AXIS_UNVERIFIED =
        35, /**< The position of axis (subject) is in doubt, it is shown at (value, ticks). */
    EVENT_AXIS_CONFIRMED =
        36, /**< The operator confirmed axis (subject) where it is shown, at (value, ticks). */
    EVENT_AXIS_REFERENCE_LOST =
        37, /**< The position of axis (subject) is lost, it was at (value, ticks). */
    EVENT_AXIS_RESTORED =
        38, /**< Axis (subject) stands where it was kept, at (value, ticks), unverified. */
    EVENT_AXIS_CONTRADICTED =
        39, /**< Axis (subject) is (value, ticks) away from where it was kept: lost. */
    EVENT_MEMORY_DAMAGED = 40, /**< Memory was damaged and forgotten: (subject). */
    EVENT_ROBOT_TABLE_DAMAGED =
        41, /**< The table of the robot is damaged in (subject): restart the programs. */
    EVENT_AXIS_DRIFTED = 42, /**< Axis (subject) has counted (value, ticks) while off since its last
                                reference and is unverified. */
    EVENT_SCAN_DRIFT = 43,   /**< In the scan axis (subject) has counted (value, ticks). */
    EVENT_HOMING_BARRED = 44, /**< Axis (subject) would leave a limit that it shares if it were
                                homed: jog the other back. */
    EVENT_AXIS_SWITCH_ELSEWHERE =
        45 /**< The switch of axis (subject) is (value, ticks) from where its counts have it. */
} event_id_t;

/** What made an event happen that does not say it itself; `peer` as said. */
typedef enum {
    EVENT_CAUSE_NONE = 0,    /**< The event says it itself. */
    EVENT_CAUSE_IGTL = 1,    /**< By OpenIGTLink peer (peer). */
    EVENT_CAUSE_CONSOLE = 2, /**< By the console. */
    EVENT_CAUSE_ESTOP = 3,   /**< By the e-stop. */
    EVENT_CAUSE_PEDAL = 4,   /**< By the pedal. */
    EVENT_CAUSE_SCANNER = 5, /**< By the scanner. */
    EVENT_CAUSE_CARD = 6,    /**< By card (peer). */
    EVENT_CAUSE_AXIS = 7,    /**< By axis (peer). */
    EVENT_CAUSE_LOOP = 8     /**< By late cycles. */
} event_cause_t;

typedef struct {
    uint32_t number;   /**< Grows by one per event. */
    uint32_t cycle;    /**< Controller cycle. */
    uint32_t id;       /**< event_id_t. */
    uint32_t severity; /**< event_severity_t. */
    uint32_t subject;
    int32_t value;
    uint32_t cause; /**< event_cause_t. */
    uint32_t peer; /**< Of the cause: command_t's peer, the card's slot or the axis; otherwise 0. */
} event_t;

#endif

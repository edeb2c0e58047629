/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Why something that was asked for was refused. One enumeration for the whole system: the core
 * returns it, answers carry it to the network, and its names and sentences are generated from this
 * file. On any value but STATUS_OK nothing has changed.
 */
#ifndef BORESIGHT_STATUS_H
#define BORESIGHT_STATUS_H

typedef enum {
    STATUS_OK = 0,              /**< Done as asked. */
    STATUS_UNKNOWN_COMMAND = 1, /**< No such command, workphase or axis. */
    STATUS_BUSY = 2,            /**< Too many commands are waiting; send it again. */
    STATUS_WRONG_WORKPHASE = 3, /**< The present workphase does not allow it. */
    STATUS_NOT_HOMED = 4,       /**< An axis is not homed; command START_UP and hold the pedal. */
    STATUS_NOT_REGISTERED = 5,  /**< There is no registration; send one in CALIBRATION. */
    STATUS_NO_TARGET = 6,       /**< There is no accepted target; send one in TARGETING. */
    STATUS_HARDWARE_NOT_READY = 7,  /**< A card, the e-stop or the pedal is not ready. */
    STATUS_FAULT_PRESENT = 8,       /**< A fault stands; remove its cause and command START_UP. */
    STATUS_NOT_FINITE = 9,          /**< A number is not finite. */
    STATUS_OUT_OF_RANGE = 10,       /**< A number is outside its range. */
    STATUS_NOT_RIGID = 11,          /**< The matrix is not a rotation and a translation. */
    STATUS_DEGENERATE_LINE = 12,    /**< Entry and target are the same point. */
    STATUS_SINGULAR_PITCH = 13,     /**< The needle would lie along the lateral axis. */
    STATUS_UNREACHABLE_HEIGHT = 14, /**< The carriage cannot rise or sink that far. */
    STATUS_AXIS_LIMIT = 15,         /**< An axis would leave its soft limits. */
    STATUS_SEPARATION_LIMIT =
        16,                /**< The two axial carriages would be too close or too far apart. */
    STATUS_CLOSURE = 17,   /**< Forward kinematics does not return the target; nothing was armed. */
    STATUS_DISCARDED = 18, /**< Discarded before it was done; command it again. */
    STATUS_EXPIRED = 19,   /**< The pedal was not pressed in time; command it again. */
    STATUS_NO_ANSWER = 20, /**< The controller did not answer in time. */
    STATUS_SWITCH_ZONE = 21,       /**< An axis would end where its limit switch may be active. */
    STATUS_CONFIRM_POSITIONS = 22, /**< An axis without a switch has lost its position: compare the
                                     positions shown with the robot, then hold the button at the
                                     box. */
    STATUS_NEEDLE_IN = 23,         /**< The needle is in, or may be: home or retract it first. */
    STATUS_JOG_TOO_FAR = 24,       /**< Before homing, an axis jogs a short way only. */
    STATUS_NOT_ALLOWED = 25,       /**< Who sent the command may not send it. */
    STATUS_MEMORY_DAMAGED = 26     /**< Memory was damaged; what it held is not used. */
} status_t;

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file The request to a mode, and its state. */
#ifndef BORESIGHT_MODE_STATE_H
#define BORESIGHT_MODE_STATE_H

#include "interface/mode_own.h"
#include "mode/jog/jog_mode.h"
#include "mode/leg/escort.h"
#include "mode/leg/leg.h"
#include "mode/leg/steer.h"
#include "mode/lists/trajectory_list.h"
#include "mode/move/move_mode.h"
#include "mode/program/program_mode.h"
#include "mode/trajectory/trajectory_mode.h"

#include <stdint.h>

/** Members that several modes read; under seal. */
typedef struct {
    uint32_t axes;  /**< Bit n: axis n is commanded. mode_axes() makes of it those that it needs. */
    mode_way_t way; /**< One axis, and where it goes if its mode asks for that. */
    move_mode_t move;
    trajectory_span_t span;
} mode_request_sealed_t;

/** Request to a mode; each reads the members that it needs. */
typedef struct {
    mode_request_sealed_t sealed;
    mode_own_t own; /**< Members of one mode alone, sealed while that was armed last. */
} mode_request_t;

/** Under seal. */
typedef struct {
    uint32_t kind; /**< mode_kind_t of the order that was armed last. */
    leg_t leg;
    escort_t escort; /**< Escort of homing. */
    steer_t steer;   /**< Rotation of a needle that is steered. */
    trajectory_mode_t trajectory;
    trajectory_list_t list; /**< Trajectory that is held, armed or not. */
    program_mode_t program;
} mode_sealed_t;

/** At first all zero. */
typedef struct {
    mode_sealed_t sealed;
    mode_request_t request; /**< With the axes that it needs. */
} mode_state_t;

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file Insertion by hand of the ProstateRobot on the simulated box: entry point and target, the
 * sensor, and the hand. */
#ifndef BORESIGHT_BY_HAND_H
#define BORESIGHT_BY_HAND_H

#include "integration/support/rig.h"

#include <stdint.h>

#define BY_HAND_NEEDLE 4U       /**< Its axis. */
#define BY_HAND_QUIET_N 0.004   /**< Noise of a cell of less than a count. */
#define BY_HAND_OFF_CYCLES 200U /**< In them the hand is seen off. */

/** The base stands at a target, the needle out; entry point and target are at these z. */
void by_hand_align(rig_t *rig, int32_t entry_z_nm, int32_t target_z_nm);

/** The force sensor is zeroed. */
void by_hand_zero(rig_t *rig);

/** Aligned and zeroed: once in a program, of which all tests name the same z, and copied. */
void by_hand_start(rig_t *rig, int32_t entry_z_nm, int32_t target_z_nm);

/** MOVE_TO_TARGET is entered, and the hand is seen off. */
void by_hand_enter(rig_t *rig);

/** The hand presses, inwards. */
void by_hand_push(rig_t *rig, int32_t force_mn);

#endif

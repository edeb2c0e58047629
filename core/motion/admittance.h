/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Admittance of the needle to the hand that pushes it: v = K * (F - F0), from 0 to the law's speed;
 * 0 for a hand that pushes less than the dead zone F0, and for one that pulls. Without a mass: the
 * slopes of the set-point stand in its place. The form is that of Wartenberg et al., "Closed-Loop
 * Active Compensation for Needle Deflection and Target Shift During Cooperatively Controlled
 * Robotic Needle Insertion", Annals of Biomedical Engineering 46 (2018); dead zone, gain and slopes
 * are a design of this project.
 *
 * A hand of stiffness k that holds the handle closes a loop of gain K k through the delay tau of
 * sensor and drive: K k exp(-s tau) / s has a phase margin of 60 degrees or more for
 * K k tau <= pi / 6.
 */
#ifndef BORESIGHT_ADMITTANCE_H
#define BORESIGHT_ADMITTANCE_H

#include "robot/robot.h"

#include <stdint.h>

/**
 * @param force_mn force of the hand, mN, positive towards the patient
 * @return the speed of the needle that it asks for, towards the patient, ticks/s, 8 fraction bits
 *
 * @satisfies SWR-COOP-001
 * @satisfies SWR-COOP-011
 */
int64_t admittance_speed_q8(const hand_law_t *law, int32_t force_mn);

#endif

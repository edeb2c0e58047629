/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Treatment programs: `PROGRAM STEP <index> <depth> mm <angle> deg <dwell> s GATE`, without the
 * angle where the robot turns no needle, without GATE where the dose does not end the step. An
 * array has the columns depth, angle where there is one, dwell, gate (0 or 1).
 */
#ifndef BORESIGHT_WORKPHASE_PROGRAM_H
#define BORESIGHT_WORKPHASE_PROGRAM_H

#include "igtl/lists/workphase_list_kind.h"

/**
 * @satisfies SWR-PROG-013
 * @satisfies SWR-PROG-014
 */
extern const workphase_list_t workphase_program;

#endif

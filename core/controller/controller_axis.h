/* SPDX-License-Identifier: Apache-2.0 */
/** @file What is commanded of a single axis, in MANUAL. */
#ifndef BORESIGHT_CONTROLLER_AXIS_H
#define BORESIGHT_CONTROLLER_AXIS_H

#include "controller/controller_events.h"

/**
 * JOG, HOME_AXIS, CLEAR_AXIS, CONFIRM_AXIS and SET_HOME.
 *
 * @return STATUS_OK; STATUS_UNKNOWN_COMMAND for no axis; STATUS_WRONG_WORKPHASE; for JOG and
 * HOME_AXIS as mode_judge() and procedure_request_axis_motion(); STATUS_NOT_AT_REST for CLEAR_AXIS
 * and SET_HOME; for CONFIRM_AXIS STATUS_NOTHING_TO_CONFIRM, STATUS_NO_BUTTON, and STATUS_BUSY while
 * another one's request waits; for SET_HOME STATUS_HOMES_OTHERWISE with a switch,
 * STATUS_HARDWARE_NOT_READY without its card and STATUS_NEEDLE_IN
 *
 * @satisfies SWR-AXIS-035
 * @satisfies SWR-AXIS-037
 * @satisfies SWR-AXIS-038
 * @satisfies SWR-AXIS-039
 * @satisfies SWR-AXIS-041
 * @satisfies SWR-AXIS-042
 * @satisfies SWR-AXIS-043
 */
status_t controller_obey_axis(controller_t *self, const cycle_t *cycle, const command_t *command,
                              answer_t *answer);

#endif

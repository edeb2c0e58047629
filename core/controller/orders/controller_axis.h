/* SPDX-License-Identifier: Apache-2.0 */
/** @file What is commanded of a single axis at rest, in MANUAL. */
#ifndef BORESIGHT_CONTROLLER_AXIS_H
#define BORESIGHT_CONTROLLER_AXIS_H

#include "controller/controller_events.h"

/** The reference of axis `index` is lost by command, and the target forgotten. Reported here, with
 * its cause. */
void controller_forget_reference(controller_t *self, const cycle_t *cycle, uint32_t index);

/**
 * CLEAR_AXIS, CONFIRM_AXIS, SET_HOME, ENABLE_AXIS and DISABLE_AXIS: they arm nothing.
 *
 * @return STATUS_OK; STATUS_UNKNOWN_COMMAND for no axis; STATUS_WRONG_WORKPHASE; STATUS_NOT_AT_REST
 * for CLEAR_AXIS and SET_HOME; for CONFIRM_AXIS STATUS_NOTHING_TO_CONFIRM, STATUS_NO_BUTTON, and
 * STATUS_BUSY while another one's request waits; for SET_HOME STATUS_HOMES_OTHERWISE with a switch,
 * STATUS_HARDWARE_NOT_READY without its card and STATUS_NEEDLE_IN; for ENABLE_AXIS
 * STATUS_FAULT_PRESENT while the e-stop is pulled or latched, STATUS_HARDWARE_NOT_READY while its
 * card is lost; for it and DISABLE_AXIS STATUS_NOT_AT_REST while something is armed
 *
 * @satisfies SWR-AXIS-037
 * @satisfies SWR-AXIS-038
 * @satisfies SWR-AXIS-039
 * @satisfies SWR-AXIS-041
 * @satisfies SWR-AXIS-042
 * @satisfies SWR-AXIS-043
 * @satisfies SWR-MODE-008
 * @satisfies SWR-MODE-060
 */
status_t controller_obey_axis(controller_t *self, const cycle_t *cycle, const command_t *command,
                              answer_t *answer);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file What is commanded of a single axis at rest, in MANUAL. */
#ifndef BORESIGHT_CONTROLLER_AXIS_H
#define BORESIGHT_CONTROLLER_AXIS_H

#include "controller/controller_events.h"

/** The reference of axis `index` is lost by command, and the target forgotten. Reported here, with
 * its cause. */
void controller_forget_reference(controller_t *self, const cycle_t *cycle, uint32_t index);

/**
 * The reference of an axis is forgotten. It arms nothing, as the following.
 *
 * @return STATUS_OK; STATUS_WRONG_WORKPHASE; STATUS_UNKNOWN_COMMAND for no axis; STATUS_NOT_AT_REST
 * while something is armed
 *
 * @satisfies SWR-AXIS-037
 */
status_t controller_obey_clear_axis(controller_t *self, const cycle_t *cycle,
                                    const command_t *command, answer_t *answer);

/**
 * The next press of the button confirms an axis.
 *
 * @return STATUS_OK; STATUS_WRONG_WORKPHASE; STATUS_UNKNOWN_COMMAND for no axis;
 * STATUS_NOTHING_TO_CONFIRM, STATUS_NO_BUTTON, and STATUS_BUSY while another one's request waits
 *
 * @satisfies SWR-AXIS-038
 * @satisfies SWR-AXIS-039
 */
status_t controller_obey_confirm_axis(controller_t *self, const cycle_t *cycle,
                                      const command_t *command, answer_t *answer);

/**
 * The place of an axis without a switch becomes its home.
 *
 * @return STATUS_OK; STATUS_WRONG_WORKPHASE; STATUS_UNKNOWN_COMMAND for no axis;
 * STATUS_HOMES_OTHERWISE with a switch; STATUS_HARDWARE_NOT_READY without its card;
 * STATUS_NOT_AT_REST; STATUS_NEEDLE_IN
 *
 * @satisfies SWR-AXIS-041
 * @satisfies SWR-AXIS-042
 * @satisfies SWR-AXIS-043
 */
status_t controller_obey_set_home(controller_t *self, const cycle_t *cycle,
                                  const command_t *command, answer_t *answer);

/**
 * An axis is enabled.
 *
 * @return STATUS_OK; STATUS_WRONG_WORKPHASE; STATUS_UNKNOWN_COMMAND for no axis;
 * STATUS_FAULT_PRESENT while the e-stop is pulled or latched; STATUS_NOT_AT_REST while something is
 * armed; STATUS_HARDWARE_NOT_READY while its card is lost
 *
 * @satisfies SWR-MODE-008
 * @satisfies SWR-MODE-060
 */
status_t controller_obey_enable_axis(controller_t *self, const cycle_t *cycle,
                                     const command_t *command, answer_t *answer);

/**
 * An axis is disabled.
 *
 * @return STATUS_OK; STATUS_WRONG_WORKPHASE; STATUS_UNKNOWN_COMMAND for no axis; STATUS_NOT_AT_REST
 * while something is armed
 *
 * @satisfies SWR-MODE-008
 */
status_t controller_obey_disable_axis(controller_t *self, const cycle_t *cycle,
                                      const command_t *command, answer_t *answer);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Notifications without a request, as differences of snapshots: the e-stop, a stop of another
 * client, a card or an axis that fails, a reference that is lost, a controller that falls silent.
 * The controlling peer is informed immediately, by a STATUS of the present workphase, once each.
 */
#ifndef BORESIGHT_WORKPHASE_NOTIFICATIONS_H
#define BORESIGHT_WORKPHASE_NOTIFICATIONS_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/workphase/workphase_state.h"
#include "interface/answer.h"

/**
 * Reports the changes. It waits for the answers that the controlling peer is owed, and for the end
 * of its order, IGTL_ANSWER_TIMEOUT_US at most.
 *
 * @satisfies SWR-IGTL-033
 */
void workphase_notifications_step(workphase_dialect_t *self, const igtl_moment_t *moment);

/** An answer was sent to the peer of `request`: its content and its effect are known there. */
void workphase_notifications_note(workphase_dialect_t *self, const igtl_request_t *request,
                                  const answer_t *answer, const igtl_moment_t *moment);

/** The controller does not answer; the controlling peer `is_reported` already. */
void workphase_notifications_control_lost(workphase_dialect_t *self, bool is_reported,
                                          const igtl_moment_t *moment);

/**
 * Why an order was ended by a fault: the cards and axes that have failed now, and `axis` if that
 * ended it without a fault of its own; ROBOT_AXIS_MAX when none did.
 *
 * @satisfies SWR-IGTL-032
 */
void workphase_notifications_fault_text(const workphase_dialect_t *self, uint32_t axis,
                                        const igtl_moment_t *moment, char text[IGTL_REASON_SIZE]);

#endif

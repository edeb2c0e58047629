/* SPDX-License-Identifier: Apache-2.0 */
/** @file Turns an answer of the controller into the messages of the workphase protocol. */
#ifndef BORESIGHT_WORKPHASE_ANSWER_H
#define BORESIGHT_WORKPHASE_ANSWER_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/workphase/workphase_state.h"
#include "interface/answer.h"
#include "interface/command.h"

/**
 * Sends `answer` to the peer of `request`, which is connected.
 *
 * @satisfies SWR-IGTL-007
 * @satisfies SWR-IGTL-008
 * @satisfies SWR-IGTL-030
 * @satisfies SWR-IGTL-031
 */
void workphase_answer_send(workphase_dialect_t *self, const igtl_request_t *request,
                           const answer_t *answer, const igtl_moment_t *moment);

/** Informs the peer of `request` that there is no answer. */
void workphase_answer_send_none(workphase_dialect_t *self, const igtl_request_t *request,
                                const igtl_moment_t *moment);

#endif

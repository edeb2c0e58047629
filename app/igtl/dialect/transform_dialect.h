/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The dialect of planning clients that send bare transforms (REGISTRATION, ENTRY_POINT,
 * TARGET_POINT) or a TRAJ and watch poses and joints (names of CRTK: measured_cp, desired_jp ...).
 * Everything that comes in is a proposal: checked, shown, never motion.
 */
#ifndef BORESIGHT_TRANSFORM_DIALECT_H
#define BORESIGHT_TRANSFORM_DIALECT_H

#include "igtl/wire/igtl_codec.h"
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_questions.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/dialect/transform_proposals.h"
#include "igtl/dialect/transform_show.h"
#include "limits/requirement_limits.h"
#include "igtl/wire/igtl_outbox.h"
#include "interface/answer.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** A name that nothing has, and was refused. */
typedef struct {
    char name[IGTL_NAME_SIZE];
    uint64_t next_us; /**< Not before this time again. */
} transform_refused_t;

typedef struct {
    igtl_outbox_t *outbox; /**< NULL: not connected. */
    uint32_t number;       /**< Number of its connection. */
    transform_shown_t shown;
    transform_proposals_t proposals;
    igtl_tracking_t tracking;
    transform_refused_t refused[LIMIT_IGTL_UNKNOWN_NAMES];
} transform_peer_t;

typedef struct {
    const robot_t *robot;
    igtl_requests_t requests;
    transform_peer_t peers[IGTL_SLOTS];
} transform_dialect_t;

/** `first_id` numbers the commands, odd. */
void transform_dialect_init(transform_dialect_t *self, const robot_t *robot, uint32_t first_id);

void transform_dialect_connected(void *dialect, uint32_t peer,
                                 const igtl_introduction_t *introduction);
void transform_dialect_disconnected(void *dialect, uint32_t peer);

/**
 * A message of `peer`. A proposal, a TRAJ that proposes entry point and target, or
 * STRING(REGISTRATION, ENTRY_POINT or TARGET_POINT) "WITHDRAW", goes to the controller; what cannot
 * be one is answered with a STATUS of its name, a name that nothing has once in
 * LIMIT_IGTL_UNKNOWN_US.
 *
 * @satisfies SWR-IGTL-008
 * @satisfies SWR-IGTL-009
 * @satisfies SWR-IGTL-045
 * @satisfies SWR-IGTL-067
 * @satisfies SWR-IGTL-068
 */
void transform_dialect_receive(void *dialect, uint32_t peer, const igtl_message_t *message,
                               const igtl_moment_t *moment);

/** An answer of the controller; false when it belongs to another. */
bool transform_dialect_answer(transform_dialect_t *self, const answer_t *answer,
                              const igtl_moment_t *moment);

/**
 * Time passes: proposals go on, and everybody is sent what has changed.
 *
 * @satisfies SWR-IGTL-012
 */
void transform_dialect_step(transform_dialect_t *self, const igtl_moment_t *moment);

#endif

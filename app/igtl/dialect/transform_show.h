/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Values that are sent to a peer of bare transforms: all once, then the changed ones, and those
 * that it asks for. They are states of which only the newest matters; a question has an answer of
 * its own.
 */
#ifndef BORESIGHT_TRANSFORM_SHOW_H
#define BORESIGHT_TRANSFORM_SHOW_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/transform_view.h"
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_outbox.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** The values that one peer has been shown. All zero: none. */
typedef struct {
    transform_view_t seen;     /**< The values that it has been sent. */
    uint64_t next_measured_us; /**< Not before this time again. */
    bool has_seen_lengths;
    bool must_send_measured; /**< Even if nothing has changed. */
} transform_shown_t;

/** Forgets what was shown: the next step sends everything. */
void transform_show_all(transform_shown_t *self);

/**
 * Sends what has changed: measured values each IGTL_STREAM_US while moving, and at once when they
 * become known or unknown. A value that ceases to exist is reported once: a point as a POINT
 * without one, a transform by a STATUS of its name, NOT_FOUND.
 *
 * @satisfies SWR-IGTL-012
 * @satisfies SWR-IGTL-037
 * @satisfies SWR-IGTL-039
 * @satisfies SWR-PROBE-007
 */
void transform_show_step(transform_shown_t *self, const robot_t *robot, igtl_outbox_t *outbox,
                         const transform_view_t *view, const igtl_moment_t *moment);

/**
 * The controller is silent: in place of measured values sends that reason, once.
 *
 * @satisfies SWR-IGTL-051
 */
void transform_show_silence(transform_shown_t *self, igtl_outbox_t *outbox,
                            const igtl_moment_t *moment);

/**
 * Answers GET_TRANS, GET_POINT or GET_STATUS.
 *
 * @satisfies SWR-IGTL-040
 */
void transform_show_answer(igtl_outbox_t *outbox, const igtl_message_t *question,
                           const igtl_moment_t *moment);

#endif

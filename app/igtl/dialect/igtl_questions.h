/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Questions that peers of every dialect ask in the same way: the known types (GET_CAPABIL), the
 * tracked needle (STT_TDATA, STP_TDATA), forces (GET_SENSOR), COMMAND, and types that do not exist.
 * Nothing here commands the robot. Types that some clients do not survive go only to those that
 * asked for them.
 */
#ifndef BORESIGHT_IGTL_QUESTIONS_H
#define BORESIGHT_IGTL_QUESTIONS_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_outbox.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** The stream of one peer. All zero: none. */
typedef struct {
    bool is_wanted;
    char name[IGTL_NAME_SIZE]; /**< As it was asked for. */
    uint64_t interval_us;
    uint64_t next_us;
    uint32_t reported_status; /**< status_t: why there is no pose, as last sent. */
} igtl_tracking_t;

/** The peer that asks. */
typedef struct {
    igtl_outbox_t *outbox;
    igtl_language_t language; /**< Of its port: the types that are known depend on it. */
    const robot_t *robot;
} igtl_asker_t;

/**
 * Answers `message` if it is one of these questions; false when it is another message.
 *
 * @satisfies SWR-IGTL-041
 * @satisfies SWR-IGTL-042
 * @satisfies SWR-IGTL-043
 */
bool igtl_questions_receive(igtl_tracking_t *tracking, const igtl_asker_t *asker,
                            const igtl_message_t *message, const igtl_moment_t *moment);

/**
 * Sends TDATA of the needle to who wants it, each time it is due and the pose is known; otherwise a
 * STATUS with the reason, once.
 *
 * @satisfies SWR-IGTL-014
 * @satisfies SWR-IGTL-042
 */
void igtl_questions_step(igtl_tracking_t *tracking, igtl_outbox_t *outbox,
                         const igtl_moment_t *moment);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The dialect of planning clients that send bare transforms (REGISTRATION, ENTRY_POINT,
 * TARGET_POINT) and watch poses and joints (names of CRTK: measured_cp, desired_jp ...). Everything
 * that comes in is a proposal: checked, shown, never motion.
 */
#ifndef BORESIGHT_TRANSFORM_DIALECT_H
#define BORESIGHT_TRANSFORM_DIALECT_H

#include "message/igtl_codec.h"
#include "dialect/igtl_dialect.h"
#include "dialect/igtl_requests.h"
#include "message/igtl_outbox.h"
#include "interface/answer.h"
#include "interface/command.h"
#include "interface/snapshot.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** What is shown to the peers, taken from one snapshot. Only words, no padding: compared as bytes.
 */
typedef struct {
    uint32_t pose_status;              /**< status_t: why there is no measured_cp. */
    rigid_t pose;                      /**< measured_cp */
    int32_t ticks[ROBOT_AXIS_MAX];     /**< measured_jp */
    int32_t speeds_q8[ROBOT_AXIS_MAX]; /**< measured_jv */
} transform_measured_t;

typedef struct {
    uint32_t is_valid;
    uint32_t pose_status;          /**< status_t: why there is no desired_cp. */
    rigid_t pose;                  /**< desired_cp */
    int32_t ticks[ROBOT_AXIS_MAX]; /**< desired_jp */
} transform_desired_t;

typedef struct {
    uint32_t is_valid;
    rigid_t pose; /**< scanner_to_robot_reg */
} transform_registration_t;

typedef struct {
    uint32_t is_valid;
    point_t point;
} transform_point_t;

typedef struct {
    transform_measured_t measured;
    transform_desired_t desired;
    transform_registration_t registration;
    transform_point_t entry;
    transform_point_t target;
} transform_view_t;

typedef struct {
    igtl_outbox_t *outbox;     /**< NULL: not connected. */
    uint32_t number;           /**< Of its connection. */
    transform_view_t shown;    /**< What it has been sent. */
    uint64_t next_measured_us; /**< Not before this time again. */
    bool must_send_measured;   /**< Even if nothing has changed. */
} transform_peer_t;

typedef struct {
    const robot_t *robot;
    igtl_requests_t requests;
    transform_peer_t peers[IGTL_PLACES];
} transform_dialect_t;

/** `first_id` numbers the commands, odd. */
void transform_dialect_init(transform_dialect_t *self, const robot_t *robot, uint32_t first_id);

void transform_dialect_connected(void *dialect, uint32_t peer,
                                 const igtl_introduction_t *introduction);
void transform_dialect_disconnected(void *dialect, uint32_t peer);

/**
 * A message of `peer`. A proposal goes to the controller; what cannot be one is answered with a
 * STATUS of its name.
 *
 * @satisfies SWR-IGTL-009
 */
void transform_dialect_receive(void *dialect, uint32_t peer, const igtl_message_t *message,
                               const igtl_moment_t *moment);

/** An answer of the controller; false when it belongs to another. */
bool transform_dialect_answer(transform_dialect_t *self, const answer_t *answer,
                              const igtl_moment_t *moment);

/**
 * Time passes: everybody is sent what has changed, and the measured values each IGTL_STREAM_US
 * while moving.
 *
 * @satisfies SWR-IGTL-012
 */
void transform_dialect_step(transform_dialect_t *self, const igtl_moment_t *moment);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/** @file The routes that change the workphase and arm motions. Each returns the status sent. */
#ifndef BORESIGHT_HTTP_MOTION_H
#define BORESIGHT_HTTP_MOTION_H

#include "http/http_call.h"
#include "http/http_server.h"

int http_motion_workphase(http_server_t *server, const http_call_t *call);

/**
 * To a position, or by a distance.
 *
 * @satisfies SWR-HTTP-029
 * @satisfies SWR-MODE-009
 */
int http_motion_jog(http_server_t *server, const http_call_t *call);

/**
 * An act on one axis: HOME_AXIS, CLEAR_AXIS, CONFIRM_AXIS, SET_HOME, ENABLE_AXIS or DISABLE_AXIS.
 * `id` of the body.
 *
 * @satisfies SWR-AXIS-044
 * @satisfies SWR-MODE-009
 */
int http_motion_axis(http_server_t *server, const http_call_t *call, command_kind_t kind,
                     uint32_t id);

/** @satisfies SWR-VEL-013 */
int http_motion_velocity(http_server_t *server, const http_call_t *call);

/**
 * An act that says nothing but itself: RETRACT, ALIGN or INSERT. `id` of the body.
 *
 * @satisfies SWR-ALIGN-007
 */
int http_motion_bare(http_server_t *server, const http_call_t *call, command_kind_t kind,
                     uint32_t id);

/** @satisfies SWR-POSE-006 */
int http_motion_pose(http_server_t *server, const http_call_t *call);

#endif

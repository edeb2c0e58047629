/* SPDX-License-Identifier: Apache-2.0 */
/** @file The routes that arm motions in the unit of an axis. Each returns the status sent. */
#include "interface/app/handlers.h"

#include "common/axis_terms.h"
#include "http/call/http_act.h"

#include <math.h>
#include <stdio.h>

#define MS_PER_S 1000.0
#define POINTER_SIZE 32U
#define UNIT_MM 0U /* As the requests of routes.yml have its words. */

static bool is_unit_of(const axis_config_t *axis, uint32_t unit)
{
    return (unit == UNIT_MM) == (axis->unit == (uint8_t)AXIS_UNIT_MM);
}

/**
 * To a position, or by a distance.
 *
 * @satisfies SWR-HTTP-029
 * @satisfies SWR-MODE-009
 */
int http_motion_jog(http_server_t *server, const http_call_t *call)
{
    const request_jog_t *body = &call->body.jog;
    const axis_config_t *axis = &exchange_robot(server->exchange)->axes[call->path.axis];
    const uint32_t index = call->path.axis;
    command_t command = {.id = body->id, .kind = (uint32_t)COMMAND_JOG, .as.jog = {.axis = index}};
    int32_t *ticks = &command.as.jog.to_ticks;
    if (body->has_distance) {
        command.kind = (uint32_t)COMMAND_JOG_BY;
        command.as.jog_by = (command_jog_by_t){.axis = index};
        ticks = &command.as.jog_by.by_ticks;
    }
    if (body->has_distance == body->has_position) {
        return http_act_refuse_choice(call, body->has_distance, "/position");
    }
    if (!is_unit_of(axis, body->unit)) {
        return http_act_refuse_unit(call, axis, "/unit");
    }
    return axis_terms_ticks(axis, body->has_distance ? body->distance : body->position, ticks)
               ? http_act_command(server, call, &command)
               : http_act_refuse_member(call, body->has_distance ? "/distance" : "/position");
}

/* One axis and its speed; false when the robot has none of this name, it comes twice, or no speed
 * is so far from 0. */
static bool read_speed(const robot_t *robot, const request_axis_speed_t *asked,
                       command_velocity_t *velocity)
{
    const uint32_t axis = axis_terms_find(robot, asked->axis);
    const uint32_t mask = (uint32_t)1U << axis;
    const bool is_new = (axis < robot->axis_count) && ((velocity->axes & mask) == 0U);
    velocity->axes |= mask;
    return is_new && axis_terms_ticks(&robot->axes[axis], asked->speed_per_s,
                                      &velocity->speeds_ticks_per_s[axis]);
}

/* 0, or the status of the refusal that was sent. */
static int read_speeds(const http_call_t *call, const robot_t *robot, command_velocity_t *velocity)
{
    const request_velocity_t *body = &call->body.velocity;
    char pointer[POINTER_SIZE];
    for (uint32_t i = 0U; i < body->speeds_count; i++) {
        const request_axis_speed_t *asked = &body->speeds[i];
        if (!read_speed(robot, asked, velocity)) {
            (void)snprintf(pointer, sizeof pointer, "/speeds/%u", (unsigned)i);
            return http_act_refuse_member(call, pointer);
        }
        const axis_config_t *axis = &robot->axes[axis_terms_find(robot, asked->axis)];
        if (!is_unit_of(axis, asked->unit)) {
            (void)snprintf(pointer, sizeof pointer, "/speeds/%u/unit", (unsigned)i);
            return http_act_refuse_unit(call, axis, pointer);
        }
    }
    return 0;
}

/* As COMMAND_VELOCITY says. 0, or the status of the refusal that was sent. */
static int read_bound(const http_call_t *call, const robot_t *robot, command_velocity_t *velocity)
{
    const request_velocity_t *body = &call->body.velocity;
    uint32_t axis = 0U;
    int32_t way_ticks = 0;
    if (body->has_time_s) {
        velocity->time_ms = (uint32_t)round(body->time_s * MS_PER_S);
        return 0;
    }
    while ((velocity->axes >> (axis + 1U)) != 0U) {
        axis++;
    }
    if (!body->has_unit || !is_unit_of(&robot->axes[axis], body->unit)) {
        return http_act_refuse_unit(call, &robot->axes[axis], "/unit");
    }
    const bool is_one = axis_terms_ticks(&robot->axes[axis], body->way, &way_ticks);
    velocity->way_ticks = (uint32_t)way_ticks;
    return is_one ? 0 : http_act_refuse_member(call, "/way");
}

/** @satisfies SWR-VEL-013 */
int http_motion_velocity(http_server_t *server, const http_call_t *call)
{
    const request_velocity_t *body = &call->body.velocity;
    const robot_t *robot = exchange_robot(server->exchange);
    command_t command = {.id = body->id, .kind = (uint32_t)COMMAND_VELOCITY};
    if (body->has_time_s == body->has_way) {
        return http_act_refuse_choice(call, body->has_way, "/time_s");
    }
    if (body->has_time_s && body->has_unit) {
        return http_act_refuse_choice(call, true, "/unit");
    }
    int status = read_speeds(call, robot, &command.as.velocity);
    status = (status == 0) ? read_bound(call, robot, &command.as.velocity) : status;
    return (status == 0) ? http_act_command(server, call, &command) : status;
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The dialect of bare transforms in a test: a robot of one axis, a peer that speaks to it, and a
 * scripted controller that answers. In the header alone, so that only the tests that include it
 * need the dialect.
 */
#ifndef BORESIGHT_TRANSFORM_WORLD_H
#define BORESIGHT_TRANSFORM_WORLD_H

#include "base/rigid.h"
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/transform_dialect.h"
#include "interface/command.h"
#include "interface/snapshot.h"
#include "robot/robot.h"
#include "unit/support/igtl_peer.h"
#include "unity.h"

#include <stdint.h>
#include <string.h>

/** The next message to the peer is this line; "" for none. */
#define EXPECT(peer, expected) TEST_ASSERT_EQUAL_STRING((expected), igtl_peer_next(&outboxes[peer]))

/** The next message to the peer begins with this. */
#define EXPECT_BEGIN(peer, expected)                                                               \
    TEST_ASSERT_EQUAL_STRING_LEN((expected), igtl_peer_next(&outboxes[peer]), strlen(expected))

#define NUMBER 21U /* Number of the first connection. */

static const robot_t robot = {
    .axis_count = 1U,
    .axes = {{.unit = (uint8_t)AXIS_UNIT_MM, .unit_per_tick_q16 = INT64_C(655360000)}}};

static transform_dialect_t dialect;
static igtl_outbox_t outboxes[2];
static snapshot_t snapshot;
static igtl_moment_t moment;
static command_t command;

/** One peer is connected; the robot is homed and registered. */
static inline void world_start(void)
{
    (void)memset(&snapshot, 0, sizeof snapshot);
    snapshot.axis_count = 7U;
    rigid_set_identity(&snapshot.scanner_treatment);
    moment = (igtl_moment_t){.now_us = 1000000U, .snapshot = &snapshot};
    transform_dialect_init(&dialect, &robot, 101U);
    igtl_outbox_init(&outboxes[0]);
    igtl_outbox_init(&outboxes[1]);
    transform_dialect_connected(
        &dialect, 0U,
        &(igtl_introduction_t){NUMBER + 0U, IGTL_LANGUAGE_CRTK, "ENTRY_", &outboxes[0]});
}

static inline void place(const char *name, float x)
{
    const igtl_message_t message = igtl_peer_transform(name, x, 2.0F, 3.0F);

    transform_dialect_receive(&dialect, 0U, &message, &moment);
}

static inline void pass_us(uint64_t time_us)
{
    moment.now_us += time_us;
    moment.answer_clock_us += time_us;
    transform_dialect_step(&dialect, &moment);
}

static inline void answer(answer_kind_t kind, status_t status)
{
    const answer_t given = {.id = command.id,
                            .command = command.kind,
                            .kind = (uint32_t)kind,
                            .status = (uint32_t)status,
                            .is_final = 1U};

    TEST_ASSERT_TRUE(transform_dialect_answer(&dialect, &given, &moment));
}

static inline void expect_measured(uint32_t peer)
{
    EXPECT_BEGIN(peer, "TRANSFORM measured_cp ");
    EXPECT_BEGIN(peer, "STRING measured_jp ");
    EXPECT_BEGIN(peer, "STRING measured_jv ");
    EXPECT(peer, "");
}

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The workphase dialect in a test: peers that speak to it, and a scripted controller that answers.
 * In the header alone, so that only the tests that include it need the dialect.
 */
#ifndef BORESIGHT_WORKPHASE_WORLD_H
#define BORESIGHT_WORKPHASE_WORLD_H

#include "base/rigid.h"
#include "card/card.h"
#include "charts/authority_chart.h"
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_questions.h"
#include "igtl/workphase/workphase_dialect.h"
#include "interface/command.h"
#include "interface/snapshot.h"
#include "procedure/command_kinds.h"
#include "unit/support/commands.h"
#include "unit/support/igtl_peer.h"
#include "unity.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

/** The next message to the peer is this line; "" for none. */
#define EXPECT(peer, expected) TEST_ASSERT_EQUAL_STRING((expected), igtl_peer_next(&outboxes[peer]))

/** The next message to the peer begins with this. */
#define EXPECT_BEGIN(peer, expected)                                                               \
    TEST_ASSERT_EQUAL_STRING_LEN((expected), igtl_peer_next(&outboxes[peer]), strlen(expected))

#define NUMBER 21U /* Number of the first connection. */

static robot_t robot;
static workphase_dialect_t dialect;
static igtl_outbox_t outboxes[IGTL_PEERS];
static igtl_language_t language;
static snapshot_t snapshot;
static igtl_moment_t moment;
static command_t command;

static inline void connect_peer(uint32_t peer)
{
    const igtl_introduction_t introduction = {NUMBER + peer, language, "ENTRY_", &outboxes[peer]};

    workphase_dialect_connected(&dialect, peer, &introduction);
}

/** Eight peers are connected; the robot stands at 5 mm, its target is at 0. */
static inline void world_start(igtl_language_t spoken)
{
    language = spoken;
    robot = (robot_t){
        .axis_count = 7U,
        .axes = {[3] = {.name = "insertion", .slot = 3U, .card_type = (uint8_t)CARD_TYPE_PWM}}};
    (void)memset(&snapshot, 0, sizeof snapshot);
    snapshot.axis_count = 7U;
    (void)memset(&command, 0, sizeof command);
    rigid_set_identity(&snapshot.scanner_treatment);
    rigid_set_identity(&snapshot.scanner_target);
    snapshot.scanner_treatment.translation.x_nm = 5000000;
    moment = (igtl_moment_t){.now_us = 1000000U, .snapshot = &snapshot};
    workphase_dialect_init(&dialect, &robot, 100U);
    dialect.is_new = false; /* Its first step is over. */
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        igtl_outbox_init(&outboxes[i]);
        connect_peer(i);
    }
}

static inline void say(uint32_t peer, const char *name, const char *text)
{
    const igtl_message_t message = igtl_peer_string(name, text);

    workphase_dialect_receive(&dialect, peer, &message, &moment);
}

static inline void place(uint32_t peer, const char *name, float x)
{
    const igtl_message_t message = igtl_peer_transform(name, x, 2.0F, 3.0F);

    workphase_dialect_receive(&dialect, peer, &message, &moment);
}

/** The next command to the controller, kept in `command`. */
static inline void expect_command(command_kind_t kind, uint32_t argument)
{
    TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
    TEST_ASSERT_EQUAL_UINT32(kind, command.kind);
    TEST_ASSERT_EQUAL_UINT32(argument, commands_number(&command));
    TEST_ASSERT_EQUAL_UINT32(COMMAND_SOURCE_IGTL, command.source);
}

static inline void expect_no_command(void)
{
    TEST_ASSERT_FALSE(igtl_requests_take(&dialect.requests, &command));
}

/** A message of the peer 0 is refused by this name of a reason, under its first word. */
static inline void expect_refusal(const char *text, const char *name)
{
    char begin[64];
    char reason[64];

    (void)snprintf(begin, sizeof begin, "STATUS %.*s ", (int)strcspn(text, " "), text);
    (void)snprintf(reason, sizeof reason, "|%s: ", name);
    say(0U, "Text", text);
    const char *const reported = igtl_peer_next(&outboxes[0]);
    TEST_ASSERT_EQUAL_STRING_LEN(begin, reported, strlen(begin));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(reported, reason), reported);
    expect_no_command();
}

/** `value` as an array has it. */
static inline void write_double(double value, uint8_t bytes[8])
{
    uint64_t bits;

    (void)memcpy(&bits, &value, sizeof bits);
    for (uint32_t i = 0U; i < 8U; i++) {
        bytes[i] = (uint8_t)(bits >> (56U - (8U * i)));
    }
}

/* As the controller does it. */
static inline void show_authority(const command_t *asked)
{
    const bool is_its = (asked->kind == (uint32_t)COMMAND_WORKPHASE)
                            ? !command_kinds_is_stop(asked)
                            : (asked->kind != (uint32_t)COMMAND_NEEDLE);

    if (asked->kind == (uint32_t)COMMAND_RELEASE) {
        snapshot.authority = (uint32_t)AUTHORITY_STATE_NOBODY;
    } else if (is_its && (snapshot.authority == (uint32_t)AUTHORITY_STATE_NOBODY)) {
        snapshot.authority = (uint32_t)AUTHORITY_STATE_HELD;
        snapshot.holder = asked->source;
        snapshot.holder_peer = asked->peer;
    } else {
        /* It changes nothing. */
    }
}

static inline void set_data(const command_t *asked, answer_t *answer)
{
    switch ((int)answer_form(answer)) {
    case ANSWER_FORM_POSE:
        answer->as.pose.pose = snapshot.scanner_target;
        break;
    case ANSWER_FORM_POINT:
        answer->as.point.point = snapshot.scanner_target.translation;
        break;
    case ANSWER_FORM_CHECKSUM:
        answer->as.checksum.checksum = asked->as.list.checksum;
        break;
    case ANSWER_FORM_ENDED:
        answer->as.ended.axis = 3U;
        break;
    default:
        if (answer->kind == (uint32_t)ANSWER_REFUSED) {
            answer_refuse(answer, answer->status, 3U, 1U);
        }
        break;
    }
}

static inline void answer_to(const command_t *asked, answer_kind_t kind, status_t status,
                             uint32_t is_final)
{
    answer_t answer = {.id = asked->id,
                       .source = asked->source,
                       .command = asked->kind,
                       .asked = (uint32_t)command_kinds_workphase(asked),
                       .kind = (uint32_t)kind,
                       .status = (uint32_t)status,
                       .is_final = is_final,
                       .workphase = snapshot.workphase};

    set_data(asked, &answer);
    if (kind == ANSWER_ACCEPTED) {
        show_authority(asked);
    }
    TEST_ASSERT_TRUE(workphase_dialect_answer(&dialect, &answer, &moment));
}

/** The connection of `peer` has ended: what authority it has is released. */
static inline void expect_released(uint32_t peer)
{
    expect_command(COMMAND_RELEASE, 0U);
    TEST_ASSERT_EQUAL_UINT32(NUMBER + peer, command.peer);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, 1U);
}

/** The controller goes into the workphase that was asked for. */
static inline void accept(uint32_t is_final)
{
    snapshot.workphase = (uint32_t)command_kinds_workphase(&command);
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, is_final);
}

static inline void pass_us(uint64_t time_us)
{
    moment.now_us += time_us;
    moment.answer_clock_us += time_us;
    workphase_dialect_step(&dialect, &moment);
}

/** The peer enters a workphase that is complete at once. */
static inline void enter(uint32_t peer, const char *name, const char *phase)
{
    say(peer, name, phase);
    TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
    accept(1U);
}

/** Peer 0 has armed a move; both answers are read. */
static inline void start_move(void)
{
    say(0U, "CMD_M", "MOVE_TO_TARGET");
    expect_command(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MOVE_TO_TARGET);
    accept(0U);
    EXPECT(0U, "STRING ACK_M MOVE_TO_TARGET");
    EXPECT(0U, "STATUS CURRENT_STATUS 1 MOVE_TO_TARGET|");
}

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: an entry point decides the depth of a target only when the commanding client has
 * sent or accepted it; a proposal decides nothing, and can be withdrawn.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "robot/robot_neuro.h"

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static command_t of(command_kind_t kind, uint32_t argument)
{
    return commands_of_number(kind, argument);
}

/* |target - entry| = d + 36 mm on a needle straight down to (5, 190, 60) mm. */
static command_t point_for(command_kind_t kind, int32_t depth_nm)
{
    return commands_of_pose(kind, rig_pose(5000000, 190000000 + 36000000 + depth_nm, 60000000));
}

static uint32_t status_of(command_t command)
{
    return rig_command(&rig, command).status;
}

static answer_t target(void)
{
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    return rig_target(&rig, &pose);
}

static int32_t depth_ticks(void)
{
    return rig.controller.plan.target_ticks[NEURO_AXIS_INSERTION];
}

void test_SWR_PLAN_017_an_entry_that_was_sent_decides_the_depth_and_is_shown(void)
{
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_entry);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(point_for(COMMAND_ENTRY, 20000000)));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ENTRY_TAKEN));
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_entry);
    TEST_ASSERT_EQUAL_INT32(246000000, rig.outputs.snapshot.entry.y_nm);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, target().status);
    TEST_ASSERT_INT32_WITHIN(1, 66667, depth_ticks());
}

void test_SWR_PLAN_017_a_proposed_entry_decides_after_it_was_accepted_and_not_before(void)
{
    rig_start_targeted(&rig);
    const int32_t free_ticks = depth_ticks();
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_PROPOSED, status_of(of(COMMAND_ACCEPT_ENTRY, 0U)));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(point_for(COMMAND_PROPOSE_ENTRY, 20000000)));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, target().status);
    TEST_ASSERT_EQUAL_INT32(free_ticks, depth_ticks());
    const command_t accept = of(COMMAND_ACCEPT_ENTRY, 0U);
    const answer_t accepted = rig_command(&rig, accept);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, accepted.status);
    TEST_ASSERT_EQUAL_INT32(246000000, answer_as_point(&accepted)->point.y_nm);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ENTRY_TAKEN));
    TEST_ASSERT_EQUAL_INT32(free_ticks, depth_ticks());
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, target().status);
    TEST_ASSERT_INT32_WITHIN(1, 66667, depth_ticks());
}

void test_SWR_PLAN_017_an_entry_is_taken_in_targeting_only(void)
{
    rig_start_targeted(&rig);
    (void)status_of(point_for(COMMAND_PROPOSE_ENTRY, 20000000));
    (void)rig_workphase(&rig, WORKPHASE_PLANNING);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, status_of(point_for(COMMAND_ENTRY, 20000000)));
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, status_of(of(COMMAND_ACCEPT_ENTRY, 0U)));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_entry);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    command_t wrong = point_for(COMMAND_ENTRY, 20000000);
    wrong.as.pose.pose.rotation_q30[0][0] = 0;
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_RIGID, status_of(wrong));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_entry);
}

typedef struct {
    uint32_t peer;
    uint32_t cycle;
} reported_t;

static reported_t reported_of(command_kind_t kind)
{
    const snapshot_t *const shown = &rig.outputs.snapshot;
    reported_t reported = {shown->registration_proposer_peer, shown->registration_proposed_cycle};
    if (kind == COMMAND_PROPOSE_ENTRY) {
        reported = (reported_t){shown->entry_proposer_peer, shown->entry_proposed_cycle};
    } else if (kind == COMMAND_PROPOSE_TARGET) {
        reported = (reported_t){shown->target_proposer_peer, shown->target_proposed_cycle};
    } else {
        /* The registration. */
    }
    return reported;
}

static void expect_reported(command_kind_t kind, reported_t expected)
{
    const reported_t reported = reported_of(kind);
    TEST_ASSERT_EQUAL_UINT32(expected.peer, reported.peer);
    TEST_ASSERT_EQUAL_UINT32(expected.cycle, reported.cycle);
}

/* One that is not for the log counts as well; one that is refused does not, and no other changes.
 */
void test_SWR_IGTL_070_a_proposal_is_shown_with_who_made_it_last_and_when(void)
{
    static const command_kind_t kinds[] = {COMMAND_PROPOSE_REGISTRATION, COMMAND_PROPOSE_ENTRY,
                                           COMMAND_PROPOSE_TARGET};
    reported_t before = {0U, 0U};
    rig_start_targeted(&rig);
    for (uint32_t i = 0U; i < (sizeof kinds / sizeof kinds[0]); i++) {
        command_t command = point_for(kinds[i], 20000000);
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(command));
        expect_reported(kinds[i], (reported_t){RIG_CONNECTION, rig.outputs.snapshot.cycle});
        command.peer = RIG_CONNECTION + 7U;
        command.as.seen_pose.is_one_of_many = 1U;
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(command));
        const reported_t last = {RIG_CONNECTION + 7U, rig.outputs.snapshot.cycle};
        expect_reported(kinds[i], last);
        command.peer = RIG_CONNECTION;
        command.as.seen_pose.pose.rotation_q30[0][0] = 0;
        TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_RIGID, status_of(command));
        expect_reported(kinds[i], last);
        if (i > 0U) {
            expect_reported(kinds[i - 1U], before);
        }
        before = last;
    }
}

/* From the needle's axis, at heights whose depths are none: what made accepted targets be refused.
 */
void test_SWR_PLAN_018_whoever_watches_cannot_block_the_one_who_commands(void)
{
    static const int32_t depths_nm[] = {-30000000, -6000000, 0, 41000000, 90000000};
    rig_start_targeted(&rig);
    const plan_t before = rig.controller.plan;
    for (uint32_t i = 0U; i < (sizeof depths_nm / sizeof depths_nm[0]); i++) {
        (void)status_of(point_for(COMMAND_PROPOSE_ENTRY, depths_nm[i]));
        TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, target().status);
        TEST_ASSERT_EQUAL_INT32_ARRAY(before.target_ticks, rig.controller.plan.target_ticks,
                                      ROBOT_AXIS_MAX);
    }
}

void test_SWR_PLAN_020_a_target_refused_because_of_an_entry_says_so_and_how_to_go_on(void)
{
    rig_start_targeted(&rig);
    (void)status_of(point_for(COMMAND_ENTRY, 45000000));
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    const answer_t answer = target();
    TEST_ASSERT_EQUAL_UINT32(STATUS_ENTRY_POINT, answer.status);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(of(COMMAND_WITHDRAW, COMMAND_ENTRY)));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, target().status);
}

void test_SWR_PLAN_021_what_was_proposed_is_withdrawn_by_its_kind(void)
{
    static const command_kind_t kinds[] = {COMMAND_PROPOSE_REGISTRATION, COMMAND_PROPOSE_ENTRY,
                                           COMMAND_PROPOSE_TARGET, COMMAND_ENTRY};
    const snapshot_t *const shown = &rig.outputs.snapshot;
    const uint32_t *const flags[] = {&shown->has_proposed_registration, &shown->has_proposed_entry,
                                     &shown->has_proposed_target, &shown->has_entry};
    rig_start_targeted(&rig);
    for (uint32_t i = 0U; i < (sizeof kinds / sizeof kinds[0]); i++) {
        const command_t withdrawal = of(COMMAND_WITHDRAW, (uint32_t)kinds[i]);
        rig_forget(&rig);
        TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_PROPOSED, status_of(withdrawal));
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(point_for(kinds[i], 20000000)));
        TEST_ASSERT_EQUAL_UINT32(1U, *flags[i]);
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(withdrawal));
        TEST_ASSERT_EQUAL_UINT32(0U, *flags[i]);
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_WITHDRAWN));
        TEST_ASSERT_EQUAL_UINT32(kinds[i], rig.events[rig.event_count - 1U].subject);
        TEST_ASSERT_EQUAL_UINT32(1U, shown->has_target);
    }
}

void test_SWR_PLAN_021_what_cannot_be_withdrawn_is_unknown(void)
{
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_UNKNOWN_COMMAND,
                             status_of(of(COMMAND_WITHDRAW, COMMAND_TARGET)));
    TEST_ASSERT_EQUAL_UINT32(STATUS_UNKNOWN_COMMAND,
                             status_of(of(COMMAND_WITHDRAW, COMMAND_REGISTRATION)));
    TEST_ASSERT_EQUAL_UINT32(STATUS_UNKNOWN_COMMAND, status_of(of(COMMAND_WITHDRAW, 0U)));
    TEST_ASSERT_EQUAL_UINT32(STATUS_UNKNOWN_COMMAND, status_of(of(COMMAND_WITHDRAW, UINT32_MAX)));
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
}

/* One kind after the other, obeyed and refused. */
void test_SWR_CTRL_023_one_of_many_is_obeyed_or_refused_without_an_event(void)
{
    static const command_kind_t kinds[] = {COMMAND_PROPOSE_REGISTRATION, COMMAND_PROPOSE_ENTRY,
                                           COMMAND_PROPOSE_TARGET, COMMAND_NEEDLE};
    rig_start_moving(&rig);
    for (uint32_t i = 0U; i < (sizeof kinds / sizeof kinds[0]); i++) {
        for (uint32_t is_unlogged = 0U; is_unlogged < 2U; is_unlogged++) {
            command_t command = point_for(kinds[i], 20000000);
            command.as.seen_pose.is_one_of_many = is_unlogged;
            rig_forget(&rig);
            TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(command));
            const bool is_noted = (is_unlogged == 0U) && (kinds[i] != COMMAND_NEEDLE);
            TEST_ASSERT_EQUAL_UINT32(is_noted ? 1U : 0U, rig.event_count);
            command.as.seen_pose.pose.rotation_q30[0][0] = 0;
            rig_forget(&rig);
            TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_RIGID, status_of(command));
            TEST_ASSERT_EQUAL_UINT32((is_unlogged == 0U) ? 1U : 0U, rig.event_count);
        }
    }
}

void test_SWR_CTRL_023_one_withdrawal_of_many_leaves_no_event(void)
{
    command_t withdrawal = of(COMMAND_WITHDRAW, COMMAND_PROPOSE_ENTRY);
    rig_start_targeted(&rig);
    (void)status_of(point_for(COMMAND_PROPOSE_ENTRY, 20000000));
    withdrawal.as.withdrawal.is_one_of_many = 1U;
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(withdrawal));
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_PROPOSED, status_of(withdrawal));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.event_count);
    withdrawal.as.withdrawal.is_one_of_many = 0U;
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_PROPOSED, status_of(withdrawal));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_COMMAND_REFUSED));
}

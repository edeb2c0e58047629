/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Workphases are entered only by the allow-list, stated here a second time as a table; each change
 * discards what was armed, and a damaged chart leaves nothing armed.
 */
#include "procedure/procedure.h"

#include "charts/arming_chart.h"
#include "charts/workphase_chart.h"
#include "limits/requirement_limits.h"
#include "unity.h"

static procedure_t procedure;
static procedure_actions_t actions;
static workphase_inputs_t inputs;

void setUp(void)
{
    procedure_init(&procedure);
    inputs = (workphase_inputs_t){.is_hardware_ready = true,
                                  .is_motion_allowed_here = true,
                                  .is_able = true,
                                  .is_homed = true,
                                  .is_registered = true,
                                  .has_target = true};
}

void tearDown(void)
{
}

/* Row: present workphase; column: requested. STOP and EMERGENCY are always allowed. */
static const char *const allowed[WORKPHASE_COUNT] = {
    /*                   USPCTMASE */
    /* UNDEFINED      */ ".S.....SE",
    /* START_UP       */ ".SPC..MSE",
    /* PLANNING       */ ".SPCT.MSE",
    /* CALIBRATION    */ ".SPCT.MSE",
    /* TARGETING      */ ".SPCTVMSE",
    /* MOVE_TO_TARGET */ ".SP.TVMSE",
    /* MANUAL         */ ".SPCT.MSE",
    /* STOP           */ ".SPCT.MSE",
    /* EMERGENCY      */ ".S.....SE",
};

static status_t request(workphase_t workphase)
{
    return procedure_request(&procedure, &inputs, (uint32_t)workphase, &actions);
}

/* The shortest way there. */
static void enter(workphase_t workphase)
{
    static const workphase_t way[] = {WORKPHASE_START_UP, WORKPHASE_PLANNING, WORKPHASE_TARGETING};
    procedure_init(&procedure);
    if (workphase == WORKPHASE_UNDEFINED) {
        return;
    }
    for (uint32_t i = 0U; i < (sizeof way / sizeof way[0]); i++) {
        TEST_ASSERT_EQUAL(STATUS_OK, request(way[i]));
    }
    if (workphase == WORKPHASE_START_UP) {
        procedure_init(&procedure);
    }
    TEST_ASSERT_EQUAL(STATUS_OK, request(workphase));
    TEST_ASSERT_EQUAL(workphase, procedure_workphase(&procedure));
}

/* Waiting for the pedal. */
static void arm(void)
{
    enter(WORKPHASE_MOVE_TO_TARGET);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_WAITING, procedure.arming.state);
}

void test_SWR_PHASE_001_every_request_in_every_workphase_follows_the_allow_list(void)
{
    for (uint32_t from = 0U; from < WORKPHASE_COUNT; from++) {
        for (uint32_t to = 1U; to < WORKPHASE_COUNT; to++) {
            enter((workphase_t)from);
            const bool is_allowed = allowed[from][to] != '.';
            const status_t status = request((workphase_t)to);
            TEST_ASSERT_EQUAL(is_allowed ? STATUS_OK : STATUS_WRONG_WORKPHASE, status);
            TEST_ASSERT_EQUAL_UINT32(is_allowed ? to : from,
                                     (uint32_t)procedure_workphase(&procedure));
        }
    }
}

void test_SWR_PHASE_007_emergency_is_left_only_by_start_up_and_stop(void)
{
    for (uint32_t to = 1U; to < WORKPHASE_COUNT; to++) {
        enter(WORKPHASE_EMERGENCY);
        (void)request((workphase_t)to);
        const bool has_left = procedure_workphase(&procedure) != WORKPHASE_EMERGENCY;
        const bool may_leave =
            (to == (uint32_t)WORKPHASE_START_UP) || (to == (uint32_t)WORKPHASE_STOP);
        TEST_ASSERT_EQUAL(may_leave, has_left);
    }
}

void test_SWR_PHASE_002_a_workphase_outside_the_enumeration_is_unknown(void)
{
    enter(WORKPHASE_PLANNING);
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND,
                      procedure_request(&procedure, &inputs, WORKPHASE_COUNT, &actions));
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND,
                      procedure_request(&procedure, &inputs, UINT32_MAX, &actions));
    TEST_ASSERT_EQUAL(WORKPHASE_PLANNING, procedure_workphase(&procedure));
}

/* In TARGETING, with all that is asked for but one thing. */
static void expect_refused(workphase_t to, bool *missing, bool value, status_t status)
{
    enter(WORKPHASE_TARGETING);
    *missing = value;
    TEST_ASSERT_EQUAL(status, request(to));
    TEST_ASSERT_EQUAL(WORKPHASE_TARGETING, procedure_workphase(&procedure));
    *missing = !value;
    TEST_ASSERT_EQUAL(STATUS_OK, request(to));
}

void test_SWR_PHASE_006_a_refusal_names_what_is_missing(void)
{
    const workphase_t move = WORKPHASE_MOVE_TO_TARGET;
    expect_refused(WORKPHASE_TARGETING, &inputs.is_registered, false, STATUS_NOT_REGISTERED);
    expect_refused(move, &inputs.has_target, false, STATUS_NO_TARGET);
    expect_refused(move, &inputs.is_homed, false, STATUS_NOT_HOMED);
    expect_refused(move, &inputs.is_able, false, STATUS_FAULT_PRESENT);
}

void test_SWR_PHASE_002_start_up_is_refused_with_the_reason(void)
{
    const workphase_t start_up = WORKPHASE_START_UP;
    expect_refused(start_up, &inputs.is_hardware_ready, false, STATUS_HARDWARE_NOT_READY);
    expect_refused(start_up, &inputs.is_confirmation_due, true, STATUS_CONFIRM_POSITIONS);
}

/* For any armed order, in any workphase, whether it waits or moves. */
void test_SWR_PHASE_005_every_change_discards_what_was_armed_and_a_refusal_does_not(void)
{
    static const workphase_t armed_in[] = {WORKPHASE_START_UP, WORKPHASE_MOVE_TO_TARGET,
                                           WORKPHASE_MANUAL};
    for (uint32_t i = 0U; i < (2U * (sizeof armed_in / sizeof armed_in[0])); i++) {
        const workphase_t from = armed_in[i / 2U];
        for (uint32_t to = 1U; to < WORKPHASE_COUNT; to++) {
            enter(from);
            if (from == WORKPHASE_MANUAL) {
                (void)procedure_request_motion(&procedure, &inputs, &actions);
            }
            if ((i % 2U) != 0U) {
                (void)procedure_notify(&procedure, ARMING_EVENT_PEDAL_DOWN);
            }
            const arming_state_t before = procedure.arming.state;
            TEST_ASSERT_TRUE(procedure_is_armed(&procedure));
            TEST_ASSERT_EQUAL((i % 2U) != 0U, procedure_is_moving(&procedure));
            const bool is_accepted = request((workphase_t)to) == STATUS_OK;
            const bool is_discarded = (actions.arming & ARMING_ACTION_REPORT_DISCARDED) != 0U;
            const bool is_renewed = (actions.arming & ARMING_ACTION_RENEW_PEDAL) != 0U;
            const bool arms =
                (to == (uint32_t)WORKPHASE_START_UP) || (to == (uint32_t)WORKPHASE_MOVE_TO_TARGET);
            TEST_ASSERT_EQUAL(is_accepted, is_discarded);
            TEST_ASSERT_EQUAL(is_accepted && arms, is_renewed);
            const arming_state_t after = arms ? ARMING_STATE_WAITING : ARMING_STATE_NONE;
            TEST_ASSERT_EQUAL(is_accepted ? after : before, procedure.arming.state);
        }
    }
}

void test_SWR_PHASE_005_the_e_stop_discards_what_was_armed(void)
{
    arm();
    TEST_ASSERT_EQUAL_HEX32(ARMING_ACTION_REPORT_DISCARDED, procedure_estop(&procedure));
    TEST_ASSERT_EQUAL(WORKPHASE_EMERGENCY, procedure_workphase(&procedure));
    TEST_ASSERT_FALSE(procedure_is_armed(&procedure));
    TEST_ASSERT_EQUAL_HEX32(0U, procedure_estop(&procedure));
}

void test_SWR_AXIS_010_a_second_jog_discards_the_first_one(void)
{
    enter(WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL(STATUS_OK, procedure_request_motion(&procedure, &inputs, &actions));
    TEST_ASSERT_EQUAL_HEX32(ARMING_ACTION_RENEW_PEDAL, actions.arming);
    TEST_ASSERT_EQUAL(STATUS_OK, procedure_request_motion(&procedure, &inputs, &actions));
    TEST_ASSERT_EQUAL_HEX32(ARMING_ACTION_RENEW_PEDAL | ARMING_ACTION_REPORT_DISCARDED,
                            actions.arming);
    inputs.is_able = false;
    TEST_ASSERT_EQUAL(STATUS_FAULT_PRESENT,
                      procedure_request_motion(&procedure, &inputs, &actions));
    TEST_ASSERT_TRUE(procedure_is_armed(&procedure));
}

void test_SWR_PHASE_008_a_retraction_takes_the_place_of_the_armed_move(void)
{
    for (uint32_t is_pressed = 0U; is_pressed < 2U; is_pressed++) {
        arm();
        if (is_pressed != 0U) {
            (void)procedure_notify(&procedure, ARMING_EVENT_PEDAL_DOWN);
        }
        TEST_ASSERT_EQUAL(STATUS_OK, procedure_request_motion(&procedure, &inputs, &actions));
        TEST_ASSERT_EQUAL_HEX32(ARMING_ACTION_RENEW_PEDAL | ARMING_ACTION_REPORT_DISCARDED,
                                actions.arming);
        TEST_ASSERT_EQUAL(WORKPHASE_MOVE_TO_TARGET, procedure_workphase(&procedure));
        TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_WAITING, procedure.arming.state);
    }
}

void test_SWR_PHASE_008_a_retraction_needs_no_target_and_a_move_may_follow_it(void)
{
    arm();
    (void)procedure_notify(&procedure, ARMING_EVENT_DONE);
    inputs.has_target = false;
    TEST_ASSERT_EQUAL(STATUS_OK, procedure_request_motion(&procedure, &inputs, &actions));
    TEST_ASSERT_EQUAL_HEX32(ARMING_ACTION_RENEW_PEDAL, actions.arming);
    inputs.has_target = true;
    TEST_ASSERT_EQUAL(STATUS_OK, request(WORKPHASE_MOVE_TO_TARGET));
}

void test_SWR_MODE_001_a_motion_is_armed_where_its_mode_may_be_and_never_in_undefined(void)
{
    for (uint32_t from = 0U; from < WORKPHASE_COUNT; from++) {
        for (uint32_t is_here = 0U; is_here < 2U; is_here++) {
            enter((workphase_t)from);
            inputs.is_motion_allowed_here = is_here != 0U;
            const bool is_allowed = (is_here != 0U) && (from != (uint32_t)WORKPHASE_UNDEFINED);
            const arming_state_t before = procedure.arming.state;
            TEST_ASSERT_EQUAL(is_allowed ? STATUS_OK : STATUS_WRONG_WORKPHASE,
                              procedure_request_motion(&procedure, &inputs, &actions));
            TEST_ASSERT_EQUAL(is_allowed ? ARMING_STATE_WAITING : before, procedure.arming.state);
            TEST_ASSERT_EQUAL(is_allowed, (actions.arming & ARMING_ACTION_RENEW_PEDAL) != 0U);
            TEST_ASSERT_EQUAL_UINT32(from, (uint32_t)procedure_workphase(&procedure));
        }
    }
}

static void expect_motion_refused(status_t status)
{
    TEST_ASSERT_EQUAL(status, procedure_request_motion(&procedure, &inputs, &actions));
    TEST_ASSERT_EQUAL_HEX32(0U, actions.arming);
    TEST_ASSERT_TRUE(procedure_is_armed(&procedure));
}

void test_SWR_MODE_002_a_motion_that_is_refused_names_the_first_that_is_missing_and_discards_nothing(
    void)
{
    arm();
    inputs.is_homed = false;
    expect_motion_refused(STATUS_NOT_HOMED);
    inputs.is_able = false;
    expect_motion_refused(STATUS_FAULT_PRESENT);
    inputs.is_motion_allowed_here = false;
    expect_motion_refused(STATUS_WRONG_WORKPHASE);
}

void test_SWR_PEDAL_006_an_order_that_waits_too_long_expires(void)
{
    arm();
    TEST_ASSERT_EQUAL_HEX32(0U, procedure_step(&procedure, LIMIT_ARMED_HOLD_US - LIMIT_CYCLE_US));
    TEST_ASSERT_TRUE(procedure_is_armed(&procedure));
    TEST_ASSERT_EQUAL_HEX32(ARMING_ACTION_REPORT_EXPIRED,
                            procedure_step(&procedure, LIMIT_CYCLE_US));
    TEST_ASSERT_FALSE(procedure_is_armed(&procedure));
    TEST_ASSERT_EQUAL(WORKPHASE_MOVE_TO_TARGET, procedure_workphase(&procedure));
}

static void expect_safe(uint32_t repaired)
{
    TEST_ASSERT_EQUAL_HEX32(repaired, procedure_check(&procedure));
    TEST_ASSERT_EQUAL(WORKPHASE_EMERGENCY, procedure_workphase(&procedure));
    TEST_ASSERT_FALSE(procedure_is_armed(&procedure));
    TEST_ASSERT_EQUAL_HEX32(0U, procedure_check(&procedure));
}

void test_SWR_CORE_004_either_chart_damaged_is_an_emergency_with_nothing_armed(void)
{
    arm();
    procedure.workphase.state_inverse ^= 1U;
    expect_safe(PROCEDURE_WORKPHASE_REPAIRED);
    arm();
    procedure.arming.state_inverse ^= 1U;
    expect_safe(PROCEDURE_ARMING_REPAIRED);
    arm();
    procedure.workphase.state_inverse ^= 1U;
    procedure.arming.state_inverse ^= 1U;
    expect_safe(PROCEDURE_WORKPHASE_REPAIRED | PROCEDURE_ARMING_REPAIRED);
}

void test_SWR_CORE_004_beside_a_damaged_chart_the_other_one_takes_no_event(void)
{
    arm();
    procedure.workphase.state_inverse ^= 1U;
    TEST_ASSERT_EQUAL_HEX32(0U, procedure_notify(&procedure, ARMING_EVENT_PEDAL_DOWN));
    TEST_ASSERT_FALSE(procedure_is_moving(&procedure));
    TEST_ASSERT_EQUAL_HEX32(0U, procedure_notify(&procedure, ARMING_EVENT_FAULT));
    TEST_ASSERT_TRUE(procedure_is_armed(&procedure));
}

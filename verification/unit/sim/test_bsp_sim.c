/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the control end of the wire never waits longer than it was asked to, believes
 * nothing of a box that does not answer, and says what to do when there is none. The box's end is
 * held by this test itself.
 */
#include "unity.h"
#include "bsp.h"
#include "limits/requirement_limits.h"
#include "unit/support/wire_world.inc"

void setUp(void)
{
    begin_wire();
}

void tearDown(void)
{
    end_wire();
}

static bsp_inputs_t sample(void)
{
    bsp_inputs_t inputs;
    bsp_sample_inputs(&inputs);
    return inputs;
}

/* Since the sample before, which this one is for the next. */
static bool was_high(uint32_t input)
{
    const bsp_inputs_t inputs = sample();
    return (inputs.levels & ~inputs.dropped & inputs.valid & input) != 0U;
}

/* Answers one exchange with slots 1 and 3, which return what they were sent. */
static void *answer_once(void *unused)
{
    wire_t *wire = served.wire;
    const uint32_t number = wire_load(&wire->reply) + 1U;

    (void)unused;
    for (uint32_t seen = wire_load(&wire->wake); wire_load(&wire->request) != number;
         seen = wire_load(&wire->wake)) {
        wire_sleep(&wire->wake, seen, LONG_TIMEOUT_US);
    }
    (void)memcpy(wire->replies, wire->frames, sizeof wire->replies);
    wire->received = 0x00AU;
    wire_announce(&wire->reply, number);
    return NULL;
}

void test_SWR_SUP_003_without_a_box_opening_says_what_to_start(void)
{
    stop_serving();
    TEST_ASSERT_FALSE(bsp_open(name, &identity, error, sizeof error));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "start the simulated control box first"), error);
}

void test_SWR_SUP_003_a_killed_box_leaves_a_wire_that_does_not_open(void)
{
    kill_box();
    TEST_ASSERT_FALSE(bsp_open(name, &identity, error, sizeof error));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "start the simulated control box first"), error);
    TEST_ASSERT_TRUE_MESSAGE(wire_serve(&served, name, real_time, error, sizeof error), error);
}

void test_SWR_SUP_003_a_second_box_of_the_same_name_is_refused(void)
{
    wire_port_t second;

    TEST_ASSERT_FALSE(wire_serve(&second, name, real_time, error, sizeof error));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "already runs"), error);
}

void test_SWR_SUP_003_a_second_control_process_is_refused_until_the_first_closes(void)
{
    wire_port_t second;

    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    TEST_ASSERT_FALSE(wire_attach(&second, name, WIRE_END_CONTROL, error, sizeof error));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "another process"), error);
    bsp_close();
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    bsp_close();
}

void test_SWR_SUP_003_impossible_names_are_refused(void)
{
    TEST_ASSERT_FALSE(bsp_open("", &identity, error, sizeof error));
    TEST_ASSERT_FALSE(bsp_open("a/b", &identity, error, sizeof error));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "no slash"), error);
    TEST_ASSERT_FALSE(bsp_open("a-name-of-a-box-that-is-much-too-long-for-a-shared-memory-segment",
                               &identity, error, sizeof error));
}

void test_SWR_SUP_003_a_wire_of_another_build_is_refused(void)
{
    served.wire->magic++;
    TEST_ASSERT_FALSE(bsp_open(name, &identity, error, sizeof error));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "another build"), error);
}

void test_SWR_LINK_001_an_exchange_without_answer_ends_at_its_timeout(void)
{
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    const uint64_t start_us = wire_now_us();
    TEST_ASSERT_EQUAL_HEX32(0U, exchange(0x3FFU, TIMEOUT_US));
    TEST_ASSERT_TRUE(wire_now_us() - start_us >= TIMEOUT_US);
    bsp_close();
}

void test_SWR_LINK_001_an_answer_fills_the_slots_that_answered_and_were_asked(void)
{
    pthread_t answering;

    (void)memset(sent, 0xA5, sizeof sent);
    (void)memset(received, 0, sizeof received);
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    TEST_ASSERT_EQUAL_INT(0, pthread_create(&answering, NULL, answer_once, NULL));
    TEST_ASSERT_EQUAL_HEX32(0x008U, exchange(0x3FDU, LONG_TIMEOUT_US));
    TEST_ASSERT_EQUAL_INT(0, pthread_join(answering, NULL));
    TEST_ASSERT_EACH_EQUAL_HEX8(0, received[1], CARD_FRAME_BYTES);
    TEST_ASSERT_EACH_EQUAL_HEX8(0xA5, received[3], CARD_FRAME_BYTES);
    bsp_close();
}

void test_SWR_LINK_001_a_late_answer_is_not_taken_for_the_next_one(void)
{
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    (void)exchange(0x3FFU, TIMEOUT_US);
    served.wire->received = 0x3FFU;
    wire_store(&served.wire->reply, wire_load(&served.wire->request));
    TEST_ASSERT_EQUAL_HEX32(0U, exchange(0x3FFU, TIMEOUT_US));
    bsp_close();
}

static void expect_results(uint32_t slots, bsp_slot_result_t among, bsp_slot_result_t others)
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        TEST_ASSERT_EQUAL(((slots & (1U << slot)) != 0U) ? among : others, result.results[slot]);
    }
}

void test_SWR_BSP_004_each_slot_has_a_result_of_its_own(void)
{
    pthread_t answering;

    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    (void)exchange(0x003U, TIMEOUT_US);
    expect_results(0x003U, BSP_SLOT_LATE, BSP_SLOT_NOT_SENT);
    (void)exchange(0x030U, TIMEOUT_US); /* The box has not ended the one before. */
    expect_results(0x030U, BSP_SLOT_NOT_IDLE, BSP_SLOT_NOT_SENT);
    TEST_ASSERT_EQUAL_HEX32(0x003U, served.wire->send);
    wire_store(&served.wire->reply, wire_load(&served.wire->request));
    TEST_ASSERT_EQUAL_INT(0, pthread_create(&answering, NULL, answer_once, NULL));
    (void)exchange(0x3FFU, LONG_TIMEOUT_US);
    TEST_ASSERT_EQUAL_INT(0, pthread_join(answering, NULL));
    expect_results(0x00AU, BSP_SLOT_OK, BSP_SLOT_NO_ANSWER);
    (void)finish(TIMEOUT_US); /* Once for each start. */
    expect_results(0U, BSP_SLOT_OK, BSP_SLOT_NOT_SENT);
    TEST_ASSERT_EQUAL_UINT64(0U, result.started_ns);
    bsp_close();
}

void test_SWR_BSP_004_beginning_an_exchange_waits_for_nobody(void)
{
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    for (uint32_t i = 0U; i < 100U; i++) {
        const uint64_t before_ns = wire_now_ns();
        start(0x3FFU);
        TEST_ASSERT_TRUE((wire_now_ns() - before_ns) < (UINT64_C(1000) * TIMEOUT_US));
    }
    (void)finish(TIMEOUT_US);
    TEST_ASSERT_TRUE(result.finished_ns >= result.started_ns);
    bsp_close();
}

void test_SWR_BSP_007_each_report_has_the_time_of_its_exchange(void)
{
    pthread_t answering;

    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_SAMPLE_ERROR_SIM_US, identity.sample_error_us);
    served.wire->replied_us = 4711U;
    TEST_ASSERT_EQUAL_INT(0, pthread_create(&answering, NULL, answer_once, NULL));
    TEST_ASSERT_EQUAL_HEX32(0x008U, exchange(0x3FDU, LONG_TIMEOUT_US));
    TEST_ASSERT_EQUAL_INT(0, pthread_join(answering, NULL));
    TEST_ASSERT_EQUAL_UINT64(4711000U, result.sampled_ns[3]);
    TEST_ASSERT_EQUAL_UINT64(0U, result.sampled_ns[1]);
    bsp_close();
}

static void expect_inputs(bool a, bool b, bool is_estop_closed, bool is_scanner_idle)
{
    const bsp_inputs_t inputs = sample();
    const uint32_t high = inputs.levels & ~inputs.dropped & inputs.valid;

    TEST_ASSERT_EQUAL(a, (high & BSP_IN_PEDAL_A) != 0U);
    TEST_ASSERT_EQUAL(b, (high & BSP_IN_PEDAL_B) != 0U);
    TEST_ASSERT_EQUAL(is_estop_closed, (high & BSP_IN_ESTOP_CHAIN) != 0U);
    TEST_ASSERT_EQUAL(is_scanner_idle, (high & BSP_IN_SCANNER_IDLE) != 0U);
}

void test_SWR_ESTOP_001_inputs_are_read_while_the_box_lives(void)
{
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    wire_store(&served.wire->inputs, BSP_IN_PEDAL_A | BSP_IN_ESTOP_CHAIN);
    for (uint32_t beat = 1U; beat < 100U; beat++) {
        wire_store(&served.wire->beat, beat);
        expect_inputs(true, false, true, false);
    }
    wire_store(&served.wire->inputs, BSP_IN_PEDAL_B | BSP_IN_SCANNER_IDLE);
    expect_inputs(false, true, false, true);
    bsp_close();
}

void test_SWR_ESTOP_004_what_was_unsafe_since_the_last_sample_is_sampled_once(void)
{
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    wire_store(&served.wire->inputs, BSP_IN_ALL);
    wire_latch(&served.wire->dropped, BSP_IN_PEDAL_B | BSP_IN_ESTOP_CHAIN);
    expect_inputs(true, false, false, true);
    expect_inputs(true, true, true, true);
    wire_latch(&served.wire->dropped, BSP_IN_PEDAL_A | BSP_IN_SCANNER_IDLE);
    expect_inputs(false, true, true, false);
    expect_inputs(true, true, true, true);
    bsp_close();
}

void test_SWR_ESTOP_001_inputs_of_a_dead_box_are_those_of_cut_wires(void)
{
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    wire_store(&served.wire->inputs, BSP_IN_ALL);
    for (uint32_t i = 0U; i < 9U; i++) {
        expect_inputs(true, true, true, true);
    }
    for (uint32_t i = 0U; i < 100U; i++) {
        expect_inputs(false, false, false, false);
        TEST_ASSERT_EQUAL_HEX32(0U, sample().valid);
    }
    wire_store(&served.wire->beat, 77U);
    expect_inputs(true, true, true, true);
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_ALL, sample().valid);
    bsp_close();
}

void test_SWR_REF_006_the_button_is_released_unless_it_was_held_since_the_last_sample(void)
{
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    wire_store(&served.wire->inputs, 0U);
    TEST_ASSERT_FALSE(was_high(BSP_IN_CONFIRM));
    wire_store(&served.wire->inputs, BSP_IN_CONFIRM);
    wire_store(&served.wire->beat, 77U);
    TEST_ASSERT_TRUE(was_high(BSP_IN_CONFIRM));
    wire_latch(&served.wire->dropped, BSP_IN_CONFIRM);
    TEST_ASSERT_FALSE(was_high(BSP_IN_CONFIRM));
    TEST_ASSERT_TRUE(was_high(BSP_IN_CONFIRM));
    for (uint32_t i = 0U; i < 100U; i++) {
        (void)sample();
    }
    TEST_ASSERT_FALSE(was_high(BSP_IN_CONFIRM));
    bsp_close();
}

void test_SWR_PROG_008_the_gate_speaks_however_short_and_a_silent_box_says_stop(void)
{
    const uint32_t gate = BSP_IN_DOSE_BELOW | BSP_IN_TREATMENT_MAY;

    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    wire_store(&served.wire->inputs, gate);
    wire_latch(&served.wire->dropped, BSP_IN_DOSE_BELOW);
    TEST_ASSERT_FALSE(was_high(BSP_IN_DOSE_BELOW));
    wire_latch(&served.wire->dropped, BSP_IN_TREATMENT_MAY);
    const bsp_inputs_t inputs = sample();
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_DOSE_BELOW, inputs.levels & ~inputs.dropped);
    for (uint32_t i = 0U; i < 100U; i++) {
        (void)sample();
    }
    TEST_ASSERT_FALSE(was_high(gate));
    bsp_close();
}

void test_SWR_BSP_005_the_amplifier_off_line_holds_until_the_board_is_opened_again(void)
{
    bsp_drives_off(); /* Nothing is open. */
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    TEST_ASSERT_EQUAL_HEX32(BSP_HAS_EDGE_LATCH | BSP_HAS_DRIVES_OFF | BSP_HAS_LAMPS,
                            identity.abilities);
    TEST_ASSERT_EQUAL_UINT32(0U, wire_load(&served.wire->is_off));
    const uint32_t wake = wire_load(&served.wire->wake);
    bsp_drives_off();
    TEST_ASSERT_EQUAL_UINT32(1U, wire_load(&served.wire->is_off));
    TEST_ASSERT_NOT_EQUAL_UINT32(wake, wire_load(&served.wire->wake));
    bsp_close();
    TEST_ASSERT_EQUAL_UINT32(1U, wire_load(&served.wire->is_off));
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    TEST_ASSERT_EQUAL_UINT32(0U, wire_load(&served.wire->is_off));
    bsp_close();
}

void test_SWR_BSP_002_the_lamps_go_to_the_box(void)
{
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    bsp_set_lamps(BSP_LAMP_ALIVE | BSP_LAMP_MOVING);
    TEST_ASSERT_EQUAL_HEX32(BSP_LAMP_ALIVE | BSP_LAMP_MOVING, wire_load(&served.wire->lamps));
    bsp_close();
}

void test_SWR_BSP_003_a_box_that_exchanges_nothing_fails_the_self_test(void)
{
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    TEST_ASSERT_FALSE(bsp_self_test(error, sizeof error));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "does not exchange frames"), error);
    bsp_close();
}

static void *answer_late(void *unused)
{
    (void)usleep(10U * LIMIT_EXCHANGE_TIMEOUT_US);
    return answer_once(unused);
}

/* A pause of the machine, as it would be too late for a cycle. */
void test_SWR_BSP_003_a_box_that_was_paused_passes_the_self_test_in_real_time(void)
{
    pthread_t answering;

    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    TEST_ASSERT_EQUAL_INT(0, pthread_create(&answering, NULL, answer_late, NULL));
    TEST_ASSERT_TRUE_MESSAGE(bsp_self_test(error, sizeof error), error);
    TEST_ASSERT_EQUAL_INT(0, pthread_join(answering, NULL));
    bsp_close();
}

void test_SWR_LINK_003_a_box_started_anew_answers_the_control_process_still_attached(void)
{
    pthread_t answering;

    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    (void)exchange(0x3FFU, TIMEOUT_US);
    kill_box();
    TEST_ASSERT_TRUE_MESSAGE(wire_serve(&served, name, real_time, error, sizeof error), error);
    TEST_ASSERT_EQUAL_INT(0, pthread_create(&answering, NULL, answer_once, NULL));
    TEST_ASSERT_EQUAL_HEX32(0x00AU, exchange(0x3FFU, LONG_TIMEOUT_US));
    TEST_ASSERT_EQUAL_INT(0, pthread_join(answering, NULL));
    bsp_close();
}

static bsp_identity_t power_on_now(void)
{
    TEST_ASSERT_TRUE_MESSAGE(bsp_open(name, &identity, error, sizeof error), error);
    bsp_close();
    return identity;
}

void test_SWR_STORE_001_each_power_on_has_an_id_of_its_own(void)
{
    const uint32_t first = power_on_now().power_on;

    TEST_ASSERT_NOT_EQUAL_UINT32(0U, first);
    TEST_ASSERT_EQUAL_UINT32(first, power_on_now().power_on);
    serve_anew(true, 1U);
    TEST_ASSERT_NOT_EQUAL_UINT32(0U, power_on_now().power_on);
    TEST_ASSERT_NOT_EQUAL_UINT32(first, power_on_now().power_on);
}

void test_SWR_STORE_001_a_box_taken_over_from_a_killed_one_is_another_power_on(void)
{
    const uint32_t first = power_on_now().power_on;

    kill_box();
    TEST_ASSERT_TRUE_MESSAGE(wire_serve(&served, name, real_time, error, sizeof error), error);
    TEST_ASSERT_NOT_EQUAL_UINT32(first, power_on_now().power_on);
}

void test_SWR_STORE_001_the_box_learns_that_the_board_was_opened(void)
{
    const uint32_t before = wire_load(&served.wire->openings);

    (void)power_on_now();
    TEST_ASSERT_EQUAL_UINT32(before + 1U, wire_load(&served.wire->openings));
}

void test_SWR_STORE_001_who_opens_the_board_learns_whether_frames_were_exchanged_before(void)
{
    TEST_ASSERT_FALSE(power_on_now().was_used);
    TEST_ASSERT_FALSE(power_on_now().was_used);
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    (void)exchange(0x3FFU, TIMEOUT_US);
    TEST_ASSERT_FALSE(identity.was_used);
    bsp_close();
    TEST_ASSERT_TRUE(power_on_now().was_used);
    serve_anew(true, 1U);
    TEST_ASSERT_FALSE(power_on_now().was_used);
}

/* Each box that is shown is made of one number alone. */
static void *show_always(void *until)
{
    const uint32_t *const end = until;
    bsp_bench_t bench;

    for (uint32_t i = 0U; wire_load(end) == 0U; i++) {
        (void)memset(&bench, (int)(i % 2U), sizeof bench);
        wire_show_bench(served.wire, &bench);
    }
    return NULL;
}

static bool is_of_one_number(const bsp_bench_t *seen)
{
    bsp_bench_t whole;

    (void)memset(&whole, (int)(seen->pedal_holder & 1U), sizeof whole);
    return memcmp(&whole, seen, sizeof whole) == 0;
}

void test_SWR_BOX_023_a_box_that_is_shown_anew_all_the_time_is_seen_whole(void)
{
    pthread_t showing;
    bsp_bench_t seen;
    uint32_t end = 0U;
    uint32_t looks = 0U;
    uint32_t torn = 0U;

    TEST_ASSERT_EQUAL_INT(0, pthread_create(&showing, NULL, show_always, &end));
    for (uint32_t i = 0U; i < 20000U; i++) {
        if (wire_see_bench(served.wire, &seen)) {
            looks++;
            torn += is_of_one_number(&seen) ? 0U : 1U;
        }
    }
    wire_store(&end, 1U);
    TEST_ASSERT_EQUAL_INT(0, pthread_join(showing, NULL));
    TEST_ASSERT_EQUAL_UINT32(0U, torn);
    TEST_ASSERT_GREATER_THAN_UINT32(1000U, looks);
}

void test_SWR_BOX_023_a_box_that_ended_while_it_was_shown_is_not_seen_until_the_next_one_is(void)
{
    bsp_bench_t bench = {.pedal_holder = 7U};
    bsp_bench_t seen;

    served.wire->bench_edition = 3U;
    TEST_ASSERT_FALSE(wire_see_bench(served.wire, &seen));
    wire_show_bench(served.wire, &bench);
    TEST_ASSERT_EQUAL_UINT32(4U, served.wire->bench_edition);
    TEST_ASSERT_TRUE(wire_see_bench(served.wire, &seen));
    TEST_ASSERT_EQUAL_UINT32(7U, seen.pedal_holder);
}

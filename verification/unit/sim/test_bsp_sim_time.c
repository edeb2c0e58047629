/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: slow, elastic and fast time are those of the box, and control never advances
 * faster than they permit.
 */
#include "unity.h"
#include "bsp.h"
#include "limits/requirement_limits.h"
#include "unit/support/wire_world.inc"

#define SPEEDUP 10U
#define FAST_SLEEPS 500U

void setUp(void)
{
    begin_wire();
}

void tearDown(void)
{
    end_wire();
}

/* Both clocks are read in turn; then 1 ms of the box' time is slept. */
static void expect_time_slower_by(uint32_t slowness)
{
    serve_anew(false, slowness);
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    const uint64_t world_before_ns = wire_now_ns();
    const uint64_t box_ns = bsp_now_ns();
    TEST_ASSERT_TRUE(box_ns >= world_before_ns / slowness);
    TEST_ASSERT_TRUE(box_ns <= wire_now_ns() / slowness);
    bsp_sleep_until_ns(box_ns + 1000000U);
    TEST_ASSERT_TRUE(bsp_now_ns() >= box_ns + 1000000U);
    bsp_close();
}

void test_SWR_BOX_005_control_lives_in_the_time_of_a_slow_box(void)
{
    expect_time_slower_by(1U);
    expect_time_slower_by(7U);
    expect_time_slower_by(LIMIT_BOX_SLOWEST);
}

void test_SWR_BOX_005_control_waits_longer_for_a_slow_box(void)
{
    serve_anew(false, 20U);
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    const uint64_t before_ns = wire_now_ns();
    TEST_ASSERT_EQUAL_HEX32(0U, exchange(0x3FFU, TIMEOUT_US));
    TEST_ASSERT_TRUE(wire_now_ns() - before_ns >= UINT64_C(20000) * TIMEOUT_US);
    bsp_close();
}

static pthread_t obeying;

static uint32_t calls; /* That the box obeys. */

/* A box that answers and comes at once. */
static void *obey(void *unused)
{
    wire_t *wire = served.wire;
    const uint32_t last = wire_load(&wire->come) + calls;

    (void)unused;
    while (wire_load(&wire->come) != last) {
        const uint32_t seen = wire_load(&wire->wake);
        const uint32_t called = wire_load(&wire->call);
        const uint32_t asked = wire_load(&wire->request);
        if (asked != wire_load(&wire->reply)) {
            wire_store_time(wire, wire->wanted_us);
            wire->received = 0x3FFU;
            wire_announce(&wire->reply, asked);
        }
        if (called != wire_load(&wire->come)) {
            wire_store_time(wire, wire->called_us);
            wire_announce(&wire->come, called);
        } else {
            wire_sleep(&wire->wake, seen, LONG_TIMEOUT_US);
        }
    }
    return NULL;
}

static void open_obeying_in(uint32_t count, box_time_t time)
{
    serve_in(time);
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    calls = count;
    TEST_ASSERT_EQUAL_INT(0, pthread_create(&obeying, NULL, obey, NULL));
}

static void open_obeying(uint32_t count, uint32_t slowness)
{
    open_obeying_in(count, (box_time_t){true, slowness, 1U});
}

static void close_obeying(void)
{
    TEST_ASSERT_EQUAL_INT(0, pthread_join(obeying, NULL));
    bsp_close();
}

void test_SWR_BOX_006_elastic_time_passes_only_in_sleep_and_is_reported_to_the_box(void)
{
    open_obeying(20U, 1U);
    TEST_ASSERT_TRUE(identity.is_elastic);
    const uint64_t start_ns = bsp_now_ns();
    for (uint32_t i = 1U; i <= 20U; i++) {
        start(0x3FFU);
        bsp_sleep_until_ns(start_ns + i * UINT64_C(1000000));
        TEST_ASSERT_EQUAL_UINT64(start_ns + i * UINT64_C(1000000), bsp_now_ns());
        TEST_ASSERT_EQUAL_UINT64(start_ns / 1000U + i * 1000U, wire_load_time(served.wire));
        TEST_ASSERT_EQUAL_UINT64(start_ns / 1000U + (i - 1U) * 1000U, served.wire->wanted_us);
        TEST_ASSERT_EQUAL_HEX32(0x3FFU, finish(TIMEOUT_US));
    }
    close_obeying();
}

/* One sleep may follow a late one at once; from there on the pace is kept. */
void test_SWR_BOX_006_elastic_time_is_never_faster_than_the_worlds_divided_by_the_slowness(void)
{
    const uint64_t world_ns = wire_now_ns(); /* The pace begins with the opening. */
    open_obeying(20U, 3U);
    const uint64_t start_ns = bsp_now_ns();
    for (uint32_t i = 1U; i <= 20U; i++) {
        bsp_sleep_until_ns(start_ns + i * UINT64_C(1000000));
    }
    TEST_ASSERT_TRUE(wire_now_ns() - world_ns >= UINT64_C(19) * 3U * 1000000U);
    close_obeying();
}

static const box_time_t fast = {.is_elastic = true, .slowness = 1U, .speedup = SPEEDUP};

/* As long in the box' time, from the opening, in which the pace begins. @return world's time, ns */
static uint64_t sleep_fast(void)
{
    const uint64_t world_ns = wire_now_ns();

    open_obeying_in(FAST_SLEEPS, fast);
    const uint64_t start_ns = bsp_now_ns();
    for (uint32_t i = 1U; i <= FAST_SLEEPS; i++) {
        bsp_sleep_until_ns(start_ns + i * UINT64_C(1000000));
        TEST_ASSERT_EQUAL_UINT64(start_ns / 1000U + i * 1000U, wire_load_time(served.wire));
    }
    const uint64_t passed_ns = wire_now_ns() - world_ns;
    close_obeying();
    return passed_ns;
}

void test_SWR_BOX_040_fast_time_is_never_faster_than_the_worlds_times_the_speedup(void)
{
    TEST_ASSERT_TRUE(sleep_fast() >= (FAST_SLEEPS - 1U) * UINT64_C(1000000) / SPEEDUP);
    TEST_ASSERT_EQUAL_UINT32(SPEEDUP, identity.speedup);
}

/* Other programs of the machine may hold it up: the fastest of some counts. */
void test_SWR_BOX_040_fast_time_is_faster_than_the_worlds(void)
{
    const uint64_t half_ns = FAST_SLEEPS * UINT64_C(500000);
    uint64_t least_ns = UINT64_MAX;

    for (uint32_t i = 0U; (i < 20U) && (least_ns >= half_ns); i++) {
        const uint64_t passed_ns = sleep_fast();
        least_ns = (passed_ns < least_ns) ? passed_ns : least_ns;
    }
    TEST_ASSERT_TRUE(least_ns < half_ns);
}

void test_SWR_BOX_046_the_pace_is_at_most_the_speedup_and_is_kept(void)
{
    serve_in(fast);
    TEST_ASSERT_EQUAL_UINT32(SPEEDUP, wire_pace(served.wire));
    TEST_ASSERT_FALSE(wire_set_pace(served.wire, 0U));
    TEST_ASSERT_FALSE(wire_set_pace(served.wire, SPEEDUP + 1U));
    TEST_ASSERT_EQUAL_UINT32(SPEEDUP, wire_pace(served.wire));
    served.wire->pace = 0U; /* Another program may have damaged it. */
    TEST_ASSERT_EQUAL_UINT32(1U, wire_pace(served.wire));
    open_obeying_in(100U, fast);
    TEST_ASSERT_TRUE(wire_set_pace(served.wire, 1U));
    const uint64_t world_ns = wire_now_ns();
    const uint64_t start_ns = bsp_now_ns();
    for (uint32_t i = 1U; i <= 100U; i++) {
        bsp_sleep_until_ns(start_ns + i * UINT64_C(1000000));
    }
    TEST_ASSERT_TRUE(wire_now_ns() - world_ns >= UINT64_C(98000000));
    close_obeying();
}

void test_SWR_BOX_006_elastic_time_does_not_hurry_after_a_pause(void)
{
    open_obeying(10U, 1U);
    const uint64_t paused_ns = wire_now_ns();
    while (wire_now_ns() < paused_ns + UINT64_C(30000000)) {
        /* Control is not called for 30 ms. */
    }
    const uint64_t world_ns = wire_now_ns();
    const uint64_t start_ns = bsp_now_ns();
    for (uint32_t i = 1U; i <= 10U; i++) {
        bsp_sleep_until_ns(start_ns + i * UINT64_C(1000000));
    }
    TEST_ASSERT_TRUE(wire_now_ns() - world_ns >= UINT64_C(9000000));
    close_obeying();
}

void test_SWR_BOX_007_control_follows_a_box_that_went_on_alone(void)
{
    serve_anew(true, 1U);
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    const uint64_t start_ns = bsp_now_ns();
    wire_store_time(served.wire, wire_load_time(served.wire) + 777000U);
    bsp_sleep_until_ns(start_ns);
    TEST_ASSERT_EQUAL_UINT64(start_ns + UINT64_C(777000000), bsp_now_ns());
    bsp_close();
}

void test_SWR_BOX_007_control_that_waits_informs_the_box_and_no_time_passes(void)
{
    serve_anew(true, 1U);
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    const uint64_t start_ns = bsp_now_ns();
    const uint32_t waits = wire_load(&served.wire->waits);
    const uint32_t called = wire_load(&served.wire->call);
    bsp_stand_still_ns(1000000U);
    bsp_stand_still_ns(1000000U);
    TEST_ASSERT_EQUAL_UINT32(waits + 2U, wire_load(&served.wire->waits));
    TEST_ASSERT_EQUAL_UINT32(called, wire_load(&served.wire->call));
    TEST_ASSERT_EQUAL_UINT64(start_ns, bsp_now_ns());
    bsp_close();
}

void test_SWR_BOX_006_a_box_that_stops_answering_is_waited_for_once(void)
{
    serve_anew(true, 1U);
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    const uint64_t before_ns = wire_now_ns();
    TEST_ASSERT_EQUAL_HEX32(0U, exchange(0x3FFU, TIMEOUT_US));
    const uint64_t patient_ns = wire_now_ns() - before_ns;
    TEST_ASSERT_TRUE(patient_ns >= UINT64_C(1000) * LIMIT_ELASTIC_ANSWER_CLOCK_US);
    for (uint32_t i = 1U; i < 10U; i++) {
        bsp_sleep_until_ns(bsp_now_ns() + UINT64_C(1000000));
        TEST_ASSERT_EQUAL_HEX32(0U, exchange(0x3FFU, TIMEOUT_US));
    }
    /* Ten times the timeout would be 5 s: a box given up is not waited for again. */
    TEST_ASSERT_TRUE(wire_now_ns() - before_ns < 5U * patient_ns);
    bsp_close();
}

void test_SWR_BOX_006_a_box_of_another_time_is_refused_while_control_lives_in_the_old_one(void)
{
    const box_time_t slow = {.is_elastic = true, .slowness = 50U, .speedup = 1U};

    serve_anew(true, 1U);
    TEST_ASSERT_TRUE(bsp_open(name, &identity, error, sizeof error));
    kill_box();
    is_serving = wire_serve(&served, name, slow, error, sizeof error);
    TEST_ASSERT_FALSE(is_serving);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "lives in another time"), error);
    is_serving = wire_serve(&served, name, fast, error, sizeof error);
    TEST_ASSERT_FALSE(is_serving);
    bsp_close();
    is_serving = wire_serve(&served, name, slow, error, sizeof error);
    TEST_ASSERT_TRUE_MESSAGE(is_serving, error);
}

void test_SWR_SUP_005_the_time_that_the_board_has_come_to_is_its_own(void)
{
    open_obeying(1U, 1U);
    bsp_sleep_until_ns(bsp_now_ns() + UINT64_C(5000000));
    TEST_ASSERT_EQUAL_UINT64(bsp_now_ns(), bsp_reached_ns());
    wire_store_time(served.wire, wire_load_time(served.wire) - 5000U);
    TEST_ASSERT_EQUAL_UINT64(bsp_now_ns(), bsp_reached_ns() + UINT64_C(5000000));
    close_obeying();
}

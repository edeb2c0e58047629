/* SPDX-License-Identifier: Apache-2.0 */
/** @file Rule under test: every answer is sent once and in request, of a state only the newest, and
 * memory is bounded. */
#include "igtl/wire/igtl_packet.h"
#include "igtl/wire/igtl_outbox.h"
#include "unity.h"

#include <string.h>

static igtl_outbox_t outbox;
static igtl_packet_t packet;

void setUp(void)
{
    igtl_outbox_init(&outbox);
}

void tearDown(void)
{
}

static void add(const char *name, const char *text)
{
    igtl_encode_string(&packet, name, text, 0U);
    igtl_outbox_add(&outbox, &packet);
}

static void add_state(const char *name, const char *text)
{
    igtl_encode_string(&packet, name, text, 0U);
    igtl_outbox_add_state(&outbox, &packet);
}

static void expect(const char *text)
{
    uint32_t length;
    const uint8_t *bytes = igtl_outbox_next(&outbox, &length);

    TEST_ASSERT_NOT_NULL(bytes);
    TEST_ASSERT_EQUAL_UINT32(62U + strlen(text), length);
    TEST_ASSERT_EQUAL_MEMORY(text, &bytes[62], strlen(text));
    igtl_outbox_advance(&outbox, length);
}

static void expect_nothing(void)
{
    uint32_t length;

    TEST_ASSERT_NULL(igtl_outbox_next(&outbox, &length));
    TEST_ASSERT_EQUAL_UINT32(0U, length);
}

void test_SWR_IGTL_005_messages_leave_whole_and_in_request(void)
{
    add("A", "one");
    add("A", "two");
    expect("one");
    expect("two");
    expect_nothing();
}

void test_SWR_IGTL_005_rest_of_a_message_goes_on_where_it_stopped(void)
{
    uint32_t length;
    const uint8_t *bytes;

    add("A", "one");
    igtl_outbox_advance(&outbox, 64U);
    bytes = igtl_outbox_next(&outbox, &length);
    TEST_ASSERT_EQUAL_UINT32(1U, length);
    TEST_ASSERT_EQUAL_HEX8('e', bytes[0]);
}

void test_SWR_IGTL_012_newer_state_replaces_the_unsent_one(void)
{
    add_state("pose", "old");
    add_state("joints", "j");
    add_state("pose", "new");
    expect("new");
    expect("j");
    expect_nothing();
}

void test_SWR_IGTL_012_state_that_is_leaving_is_not_changed(void)
{
    add_state("pose", "old");
    igtl_outbox_advance(&outbox, 10U);
    add_state("pose", "new");
    igtl_outbox_advance(&outbox, 55U);
    expect("new");
    expect_nothing();
}

void test_SWR_IGTL_008_answer_is_never_replaced(void)
{
    add("pose", "answer");
    add_state("pose", "state");
    expect("answer");
    expect("state");
}

void test_SWR_IGTL_011_peer_that_does_not_read_overflows_its_own_box(void)
{
    for (uint32_t i = 0U; i < IGTL_OUTBOX_PACKETS; i++) {
        add("A", "x");
    }
    TEST_ASSERT_FALSE(outbox.has_overflowed);
    add("A", "y");
    TEST_ASSERT_TRUE(outbox.has_overflowed);
}

void test_SWR_IGTL_005_box_wraps_round(void)
{
    for (uint32_t i = 0U; i < (3U * IGTL_OUTBOX_PACKETS); i++) {
        add("A", "x");
        add("A", "y");
        expect("x");
        expect("y");
    }
    expect_nothing();
}

static void expect_version(uint32_t version)
{
    uint32_t length;
    const uint8_t *bytes = igtl_outbox_next(&outbox, &length);

    TEST_ASSERT_NOT_NULL(bytes);
    TEST_ASSERT_EQUAL_HEX8(version, bytes[1]);
    igtl_outbox_advance(&outbox, length);
}

void test_SWR_IGTL_005_version_2_is_for_those_who_have_sent_it(void)
{
    add("A", "x");
    igtl_outbox_hear(&outbox, 1U);
    igtl_outbox_hear(&outbox, 3U);
    add("A", "x");
    igtl_outbox_hear(&outbox, 2U);
    igtl_outbox_hear(&outbox, 1U);
    add("A", "x");
    expect_version(1U);
    expect_version(1U);
    expect_version(2U);
}

void test_SWR_IGTL_005_newer_state_of_version_2_replaces_the_unsent_one(void)
{
    add_state("pose", "old");
    igtl_outbox_hear(&outbox, 2U);
    add_state("pose", "new");
    expect_version(2U);
    expect_nothing();
}

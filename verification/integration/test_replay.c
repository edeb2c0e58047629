/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the controller executed again on recorded inputs says the same, and where it
 * does not, the replay says so and where.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "replay/replay.h"
#include "robot/robot_neuro.h"

#include <string.h>

#define CYCLES 400U

static rig_t rig;
static replay_t replay;
static cycle_record_t record;

static void take_checkpoint(void)
{
    record.kind = CYCLE_RECORD_CHECKPOINT;
    record.cycle = rig.controller.cycle;
    (void)memcpy(record.body.checkpoint, &rig.controller, sizeof(rig.controller));
    TEST_ASSERT_TRUE(replay_take(&replay, &robot_neuro, &record));
}

static void make_cycle(void)
{
    record.kind = CYCLE_RECORD_CYCLE;
    record.cycle = rig.controller.cycle;
    rig_cycle(&rig);
    record.body.cycle.inputs = rig.inputs;
    record.body.cycle.outputs = rig.outputs;
}

static void replay_cycles(uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        make_cycle();
        TEST_ASSERT_TRUE(replay_take(&replay, &robot_neuro, &record));
    }
}

void setUp(void)
{
    rig_start(&rig);
    replay_init(&replay);
}

void tearDown(void)
{
}

void test_SWR_REPLAY_001_every_output_is_equal_when_replayed_from_a_checkpoint(void)
{
    take_checkpoint();
    rig_box(&rig, "pedal press");
    replay_cycles(CYCLES);
    TEST_ASSERT_EQUAL_UINT64(CYCLES, replay.replayed);
    TEST_ASSERT_EQUAL_UINT64(0U, replay.unreplayed);
}

static void expect_difference(size_t offset, const char *where)
{
    char text[256];

    take_checkpoint();
    make_cycle();
    ((uint8_t *)&record.body.cycle.outputs)[offset] ^= 0x01U;
    TEST_ASSERT_FALSE(replay_take(&replay, &robot_neuro, &record));
    replay_difference(&replay, &record, text, sizeof(text));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, where), text);
}

void test_SWR_REPLAY_001_one_other_bit_in_any_area_is_a_difference_with_its_place(void)
{
    expect_difference(offsetof(controller_outputs_t, event_count), "counts, word 2, byte 0");
    expect_difference(offsetof(controller_outputs_t, answers[1].status), "answers, answer 1");
    expect_difference(offsetof(controller_outputs_t, events[3].value), "events, event 3");
    expect_difference(offsetof(controller_outputs_t, snapshot) + 7U,
                      "snapshot, snapshot 0, byte 7");
    expect_difference(offsetof(controller_outputs_t, frames) + (4U * CARD_FRAME_BYTES) + 9U,
                      "frames, slot 4, byte 9");
    expect_difference(sizeof(controller_outputs_t) - 1U, "frames, slot 9, byte 255");
}

void test_SWR_REPLAY_001_another_input_gives_a_difference(void)
{
    take_checkpoint();
    make_cycle();
    record.body.cycle.inputs.elapsed_us++;
    TEST_ASSERT_FALSE(replay_take(&replay, &robot_neuro, &record));
}

void test_SWR_REPLAY_001_cycles_without_a_checkpoint_before_them_are_counted(void)
{
    replay_cycles(3U);
    TEST_ASSERT_EQUAL_UINT64(3U, replay.unreplayed);
    TEST_ASSERT_EQUAL_UINT64(0U, replay.replayed);
}

void test_SWR_REPLAY_001_after_a_gap_nothing_is_replayed_until_the_next_checkpoint(void)
{
    take_checkpoint();
    replay_cycles(5U);
    make_cycle(); /* Lost. */
    replay_cycles(4U);
    TEST_ASSERT_EQUAL_UINT32(1U, replay.gaps);
    TEST_ASSERT_EQUAL_UINT64(4U, replay.unreplayed);
    take_checkpoint();
    replay_cycles(2U);
    TEST_ASSERT_EQUAL_UINT64(7U, replay.replayed);
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the controller executed again on recorded inputs says the same, and where it
 * does not, the replay says so and where.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "base/seal.h"
#include "card/card_frame.h"
#include "controller/controller.h"
#include "recording/format/cycle_words.h"
#include "recording/format/proof.h"
#include "replay/verify/replay.h"
#include "robot/robot_neuro.h"

#include <stdio.h>
#include <string.h>

#define CYCLES 400U

static rig_t rig;
static replay_t replay;
static cycle_record_t record;
static cycle_known_t known;
static prover_t prover;
static robot_t broken; /* The table that is replayed with, where a test breaks it. */
static char words_named[96];
static uint32_t words[CYCLE_WORDS_CHECKED];

static void take_checkpoint(void)
{
    record.kind = CYCLE_RECORD_CHECKPOINT;
    record.cycle = rig.controller.sealed.cycle;
    (void)memcpy(record.body.checkpoint, &rig.controller, CONTROLLER_CHECKPOINT_BYTES);
    TEST_ASSERT_TRUE(replay_take(&replay, &robot_neuro, &record, &known));
}

static void make_cycle(void)
{
    record.kind = CYCLE_RECORD_CYCLE;
    record.cycle = rig.controller.sealed.cycle;
    rig_cycle(&rig);
    record.body.cycle.inputs = rig.inputs;
    record.body.cycle.outputs = rig.outputs;
}

/* As the recorder keeps it: the first after a checkpoint whole, of the others a proof. */
static void keep_proof(bool is_whole)
{
    known.is_whole = is_whole;
    if (is_whole) {
        prover_begin(&prover);
    }
    cycle_words_of_checked(&record.body.cycle.outputs, words);
    prover_take(&prover, record.body.cycle.inputs.elapsed_us, words, &known.proof);
    if (!is_whole) {
        (void)memset(&record.body.cycle.outputs.snapshot, 0,
                     sizeof(controller_outputs_t) - offsetof(controller_outputs_t, snapshot));
    }
}

/* Cycles of which proofs are kept, until one differs. False when none does. */
static bool differ_within(uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        make_cycle();
        keep_proof(false);
        if (!replay_take(&replay, &broken, &record, &known)) {
            return true;
        }
    }
    return false;
}

/* A checkpoint, a whole cycle and some with proofs, all equal. */
static void begin_proofs(void)
{
    take_checkpoint();
    make_cycle();
    keep_proof(true);
    TEST_ASSERT_TRUE(replay_take(&replay, &robot_neuro, &record, &known));
    TEST_ASSERT_FALSE(differ_within(5U));
}

static void replay_cycles(uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        make_cycle();
        TEST_ASSERT_TRUE(replay_take(&replay, &robot_neuro, &record, &known));
    }
}

void setUp(void)
{
    rig_start(&rig);
    replay_init(&replay);
    broken = robot_neuro;
    known = (cycle_known_t){.is_whole = true};
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

/* Commands, and the cycles after it. */
static void replay_act(command_kind_t kind, uint32_t argument, uint32_t cycles)
{
    rig.commands[0] = commands_of_number(kind, argument);
    rig.command_count = 1U;
    replay_cycles(cycles);
}

void test_SWR_REPLAY_001_acts_on_single_axes_are_replayed_as_well(void)
{
    const snapshot_axis_t *const axes = rig.outputs.snapshot.axes;
    rig_start_homed(&rig);
    rig_cycles(&rig, 500U);
    take_checkpoint();
    replay_act(COMMAND_WORKPHASE, WORKPHASE_MANUAL, 5U);
    replay_act(COMMAND_SET_HOME, NEURO_AXIS_FEET, 5U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, axes[NEURO_AXIS_FEET].reference);
    replay_act(COMMAND_CONFIRM_AXIS, NEURO_AXIS_FEET, 5U);
    rig_box(&rig, "button press");
    replay_cycles(LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US + 2U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, axes[NEURO_AXIS_FEET].reference);
    replay_act(COMMAND_CLEAR_AXIS, NEURO_AXIS_YAW, 5U);
    replay_act(COMMAND_HOME_AXIS, NEURO_AXIS_YAW, 5U);
    rig_box(&rig, "pedal press");
    replay_cycles(CYCLES);
    TEST_ASSERT_TRUE(axis_is_homing(&rig.controller.axes[NEURO_AXIS_YAW]));
}

void test_SWR_REPLAY_001_a_run_that_was_accepted_without_a_black_box_is_replayed_as_well(void)
{
    take_checkpoint();
    rig.lacks_black_box = 1U;
    replay_act(COMMAND_WORKPHASE, WORKPHASE_START_UP, 5U);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_UNDEFINED, rig.outputs.snapshot.workphase);
    replay_act(COMMAND_ACCEPT_NO_BLACK_BOX, 0U, 5U);
    replay_act(COMMAND_WORKPHASE, WORKPHASE_START_UP, 5U);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_START_UP, rig.outputs.snapshot.workphase);
}

static void expect_sentence(const char *where)
{
    char text[256];

    (void)replay_difference(&replay, &record, &known, text, sizeof(text));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, where), text);
}

/* In the data of an answer that the controller gives. */
static void expect_difference_of_target(size_t offset, const char *where)
{
    known.is_whole = true;
    rig_start_targeted(&rig);
    take_checkpoint();
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    rig.commands[rig.command_count] = (command_t){.id = 1U,
                                                  .kind = (uint32_t)COMMAND_TARGET,
                                                  .source = (uint32_t)COMMAND_SOURCE_HTTP,
                                                  .peer = RIG_PAGE,
                                                  .as.pose = {.pose = pose}};
    rig.command_count++;
    make_cycle();
    ((uint8_t *)&record.body.cycle.outputs)[offset] ^= 0x01U;
    TEST_ASSERT_FALSE(replay_take(&replay, &robot_neuro, &record, &known));
    expect_sentence(where);
}

static void expect_difference(size_t offset, const char *where)
{
    known.is_whole = true;
    take_checkpoint();
    make_cycle();
    ((uint8_t *)&record.body.cycle.outputs)[offset] ^= 0x01U;
    TEST_ASSERT_FALSE(replay_take(&replay, &robot_neuro, &record, &known));
    expect_sentence(where);
}

void test_SWR_REPLAY_037_a_checkpoint_is_compared_with_the_state_that_was_computed(void)
{
    char text[256];

    take_checkpoint();
    replay_cycles(5U);
    take_checkpoint();
    replay_cycles(5U);
    replay.controller.sealed.events += 3U;
    record.kind = CYCLE_RECORD_CHECKPOINT;
    record.cycle = rig.controller.sealed.cycle;
    (void)memcpy(record.body.checkpoint, &rig.controller, CONTROLLER_CHECKPOINT_BYTES);
    TEST_ASSERT_FALSE(replay_take(&replay, &robot_neuro, &record, &known));
    TEST_ASSERT_TRUE(replay_difference(&replay, &record, &known, text, sizeof text));
    (void)snprintf(words_named, sizeof words_named, "in 1 of %u words: %u; word %u is ",
                   (unsigned)(CONTROLLER_CHECKPOINT_BYTES / sizeof(uint32_t)),
                   (unsigned)(offsetof(controller_t, sealed.events) / sizeof(uint32_t)),
                   (unsigned)(offsetof(controller_t, sealed.events) / sizeof(uint32_t)));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, words_named), text);
}

void test_SWR_REPLAY_037_a_checkpoint_after_a_gap_is_adopted(void)
{
    take_checkpoint();
    replay_cycles(5U);
    make_cycle();
    replay.controller.sealed.events += 3U;
    take_checkpoint();
    replay_cycles(5U);
    TEST_ASSERT_EQUAL_UINT64(10U, replay.replayed);
}

void test_SWR_REPLAY_004_one_other_bit_in_any_area_is_a_difference_with_its_field(void)
{
    expect_difference(offsetof(controller_outputs_t, event_count), "counts, word 2, byte 0");
    expect_difference(offsetof(controller_outputs_t, answers[1].status),
                      "answers, answer 1, status");
    expect_difference(offsetof(controller_outputs_t, answers[1].as) + 5U,
                      "answers, answer 1, data, byte 5: ");
    expect_difference_of_target(offsetof(controller_outputs_t, answers[0].as.pose.pose.translation),
                                "answers, answer 0, pose, word 9: ");
    expect_difference(offsetof(controller_outputs_t, events[3].value),
                      "events, event 3, value (verdict): it is 0 (0x0), recorded 1 (0x1).");
    expect_difference(offsetof(controller_outputs_t, snapshot.time_us), "snapshot, time_us: ");
    expect_difference(offsetof(controller_outputs_t, snapshot.desired_ticks[2]) + 3U,
                      "snapshot, desired_ticks[2]: ");
    expect_difference(offsetof(controller_outputs_t, snapshot.axes[6].drive_duty),
                      "snapshot, axes[6].drive_duty: ");
    expect_difference(offsetof(controller_outputs_t, snapshot.scanner_target) + 36U,
                      "snapshot, scanner_target, word 9: ");
    expect_difference(offsetof(controller_outputs_t, frames) - 1U, "snapshot, cards[9].troubles: ");
    expect_difference(offsetof(controller_outputs_t, frames) + (4U * CARD_FRAME_BYTES) + 9U,
                      "frames, slot 4, byte 9: it is 0 (0x0), recorded 1 (0x1).");
    expect_difference(sizeof(controller_outputs_t) - 1U, "frames, slot 9, byte 255");
}

void test_SWR_REPLAY_004_a_field_that_was_as_expected_is_named_although_it_was_not_kept(void)
{
    char text[256];

    begin_proofs();
    const uint32_t expected = rig.outputs.snapshot.time_us + 1000U;
    replay.controller.sealed.time_us += 7U;
    controller_seal(&replay.controller);
    TEST_ASSERT_TRUE(differ_within(1U));
    TEST_ASSERT_TRUE(replay_difference(&replay, &record, &known, text, sizeof(text)));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, "differs first in its snapshot, time_us: it is "),
                                 text);
    char recorded[40];
    (void)snprintf(recorded, sizeof recorded, "recorded %u (", (unsigned)expected);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, recorded), text);
}

void test_SWR_REPLAY_004_a_hashed_part_is_named_and_its_field_by_the_next_whole_cycle(void)
{
    char text[256];

    rig_start_moving(&rig);
    begin_proofs();
    for (uint32_t i = 0U; i < broken.axis_count; i++) {
        axis_config_t *const row = &broken.axes[i];
        row->gain_per_s += (row->gain_per_s != 0U) ? 5U : 0U;
        row->seal = seal_of(SEAL_START, (const uint8_t *)row, offsetof(axis_config_t, seal));
    }
    TEST_ASSERT_TRUE(differ_within(8000U));
    TEST_ASSERT_FALSE(replay_difference(&replay, &record, &known, text, sizeof(text)));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, "in its snapshot, of which a hash was kept."), text);
    make_cycle();
    keep_proof(true);
    TEST_ASSERT_FALSE(replay_take(&replay, &broken, &record, &known));
    expect_sentence("differs first in its snapshot, axes[");
}

void test_SWR_REPLAY_004_a_frame_that_differs_alone_is_named_by_its_slot(void)
{
    begin_proofs();
    make_cycle();
    keep_proof(false);
    known.proof.surprises |= 1U << (PROOF_FRAMES + 2U);
    TEST_ASSERT_FALSE(replay_take(&replay, &robot_neuro, &record, &known));
    expect_sentence("differs first in its frames, slot 2, of which a hash was kept.");
    make_cycle();
    keep_proof(false);
    replay.controller.sealed.sequence += 5U;
    controller_seal(&replay.controller);
    TEST_ASSERT_FALSE(replay_take(&replay, &robot_neuro, &record, &known));
    expect_sentence("differs first in its frames, slot 1, which went on as expected.");
}

void test_SWR_REPLAY_004_an_event_is_kept_and_named_before_the_rest(void)
{
    begin_proofs();
    rig_box(&rig, "estop pull");
    for (uint32_t i = 0U; (i < 100U) && (rig.outputs.event_count == 0U); i++) {
        make_cycle();
        keep_proof(false);
        record.body.cycle.outputs.events[0].cause ^= (rig.outputs.event_count != 0U) ? 1U : 0U;
        TEST_ASSERT_EQUAL(rig.outputs.event_count == 0U,
                          replay_take(&replay, &robot_neuro, &record, &known));
    }
    TEST_ASSERT_NOT_EQUAL(0U, rig.outputs.event_count);
    expect_sentence("differs first in its events, event 0, cause: it is ");
}

void test_SWR_REPLAY_001_another_input_gives_a_difference(void)
{
    take_checkpoint();
    make_cycle();
    record.body.cycle.inputs.elapsed_us++;
    TEST_ASSERT_FALSE(replay_take(&replay, &robot_neuro, &record, &known));
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

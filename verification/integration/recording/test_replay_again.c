/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a recorder that is killed after it has written a block and before it releases
 * the cycles of it writes them again, whole and without a checkpoint, into the next file; their
 * records are compared with the first ones.
 */
#include "integration/support/recorded.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "recording/format/recording.h"
#include "recording/read/recording_verify.h"
#include "recording/write/recording_writer.h"
#include "replay/verify/again.h"
#include "replay/verify/walk.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define FIRST_CYCLES 60U /* Cycles of the first file, */
#define AGAIN_CYCLES 20U /* the last of which are in the second again. */
#define LATER_CYCLES 30U /* And these follow. */

static char paths[2][64];
static rig_t rig;
static recorded_t recorded;
static recording_writer_t writer;
static cycle_record_t again[AGAIN_CYCLES];
static walk_t walk;
static char notes[1024];

void setUp(void)
{
    for (uint32_t i = 0U; i < 2U; i++) {
        (void)snprintf(paths[i], sizeof paths[i], "/tmp/test-replay-again-%d-%u.bsr", (int)getpid(),
                       (unsigned)i);
        (void)unlink(paths[i]);
    }
    rig_start_moving(&rig);
    rig.controller.sealed.cycle = 0U;
    controller_seal(&rig.controller);
    (void)memset(notes, 0, sizeof notes);
    TEST_ASSERT_TRUE(recorded_begin(&recorded, &rig, paths[0]));
    TEST_ASSERT_TRUE(recorded_cycles(&recorded, FIRST_CYCLES - AGAIN_CYCLES));
    for (uint32_t i = 0U; i < AGAIN_CYCLES; i++) {
        TEST_ASSERT_TRUE(recorded_cycles(&recorded, 1U));
        again[i] = recorded.record;
    }
}

void tearDown(void)
{
    again_end(&walk.again);
    (void)unlink(paths[0]);
    (void)unlink(paths[1]);
}

/* The repeated cycles, then the rest of the run. */
static void write_second(void)
{
    const recording_header_t header = recorded.writer.header;

    TEST_ASSERT_TRUE(recorded_end(&recorded));
    TEST_ASSERT_TRUE(recording_writer_open(&writer, paths[1], &header));
    for (uint32_t i = 0U; i < AGAIN_CYCLES; i++) {
        TEST_ASSERT_TRUE(recording_writer_append(&writer, &again[i]));
    }
    recorded.writer = writer;
    TEST_ASSERT_TRUE(recorded_cycles(&recorded, LATER_CYCLES));
    recording_writer_note_run_end(&recorded.writer);
    TEST_ASSERT_TRUE(recorded_end(&recorded));
}

/* Goes through both files. The exit code. */
static int replay_both(void)
{
    FILE *const to = fmemopen(notes, sizeof notes, "w");
    int code = EXIT_EQUAL;

    walk_begin(&walk, true, to);
    for (uint32_t i = 0U; (i < 2U) && (code == EXIT_EQUAL); i++) {
        TEST_ASSERT_TRUE(walk_open(&walk, paths[i]));
        while ((code == EXIT_EQUAL) && walk_take(&walk)) {
            code = walk_replay(&walk) ? EXIT_EQUAL : walk_report_difference(&walk, to);
            (void)walk_count(&walk, walk_is_done(&walk));
        }
        walk_close(&walk);
    }
    code = (code == EXIT_EQUAL) ? walk_end(&walk) : code;
    (void)fclose(to);
    return code;
}

static void expect_note(const char *format, uint32_t cycle)
{
    char note[256];

    (void)snprintf(note, sizeof note, format, (unsigned)cycle);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(notes, note), notes);
}

void test_SWR_REPLAY_038_equal_records_that_are_there_again_need_no_checkpoint(void)
{
    write_second();
    TEST_ASSERT_EQUAL_INT_MESSAGE(EXIT_EQUAL, replay_both(), notes);
    TEST_ASSERT_TRUE(walk_is_whole_run(&walk));
    TEST_ASSERT_EQUAL_UINT64(FIRST_CYCLES + LATER_CYCLES, walk.coverage.done);
    expect_note("Cycles %u to ", FIRST_CYCLES - AGAIN_CYCLES);
    expect_note(" (%u).\n", AGAIN_CYCLES);
    TEST_ASSERT_NULL_MESSAGE(strstr(notes, "not compared"), notes);
}

static void expect_other(uint32_t place)
{
    write_second();
    TEST_ASSERT_EQUAL_INT_MESSAGE(EXIT_DIFFERENT, replay_both(), notes);
    expect_note(": Cycle %u is there again with another record than the first.\n",
                again[place].cycle);
}

void test_SWR_REPLAY_038_another_input_there_again_is_named_by_its_cycle(void)
{
    again[7].body.cycle.inputs.elapsed_us++;
    again[9].body.cycle.inputs.elapsed_us++;
    expect_other(7U);
}

void test_SWR_REPLAY_038_an_output_of_which_a_proof_was_kept_is_compared_when_there_again(void)
{
    again[11].body.cycle.outputs.snapshot.time_us++;
    expect_other(11U);
}

void test_SWR_REPLAY_038_what_the_board_said_is_compared_when_there_again(void)
{
    ((uint8_t *)&again[0].body.cycle.board)[0] ^= 1U;
    expect_other(0U);
}

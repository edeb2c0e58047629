/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * authority-stress-oracle: replays the recordings of clients that compete for authority and has
 * the oracle look at them.
 *
 *     authority-stress-oracle FILE ...        in their order
 *
 * Prints what the oracle counted as one line of JSON, and a line for each sentence that was
 * broken. Exit code 0: none was; 1: one was, or the recording does not replay; 2: it cannot be read
 * or is cut short.
 */
#include "base/contract.h"
#include "authority_stress/message_oracle.h"
#include "interface/interface_layout.h"
#include "recording/read/recording_reader.h"
#include "replay/verify/replay.h"
#include "robot/app/robots.h"

#include <stdio.h>
#include <stdlib.h>

#define EXIT_GOOD 0
#define EXIT_BROKEN 1
#define EXIT_UNREADABLE 2

static recording_reader_t reader;
static replay_t replay;
static cycle_record_t record;
static cycle_known_t known;
static message_oracle_t oracle;

void contract_broken(const char *module, uint32_t id)
{
    (void)printf("cycle %u breaks contract %s/%u\n", (unsigned)record.cycle, module, (unsigned)id);
    (void)fflush(stdout);
    _Exit(EXIT_BROKEN);
}

static const robot_t *open_recording(const char *path)
{
    recording_finding_t finding;
    if (recording_reader_open(&reader, path, &finding) != RECORDING_WHOLE) {
        (void)printf("%s\n", finding.sentence);
        return NULL;
    }
    const robot_t *robot = robots_find(reader.header.robot);
    if ((robot == NULL) || (robot->crc != reader.header.robot_crc) ||
        !recording_reader_fits(&reader, INTERFACE_LAYOUT, CONTROLLER_CHECKPOINT_BYTES)) {
        (void)puts("the recording is of another build");
        return NULL;
    }
    return robot;
}

static bool replay_all(const robot_t *robot)
{
    while (recording_reader_next(&reader, &record, &known)) {
        if (!replay_take(&replay, robot, &record, &known)) {
            return false;
        }
        if ((record.kind == (uint32_t)CYCLE_RECORD_CYCLE) && replay.is_running) {
            message_oracle_look(&oracle, record.cycle, &record.body.cycle.inputs, &replay.outputs);
        }
    }
    return (replay.unreplayed == 0U) && (replay.gaps == 0U);
}

static void print_counts(void)
{
    (void)printf("{\"cycles\": %u, \"driven\": %u, \"taken_igtl\": %u, \"taken_http\": %u, "
                 "\"released\": %u, \"unrenewed\": %u, \"silent\": %u, \"taken\": %u, "
                 "\"orders_igtl\": %u, \"orders_http\": %u, \"cut\": %u, \"refused\": %u, "
                 "\"stops\": %u}\n",
                 oracle.cycles, oracle.driven, oracle.takes[COMMAND_SOURCE_IGTL],
                 oracle.takes[COMMAND_SOURCE_HTTP], oracle.losses[AUTHORITY_LOSS_RELEASED],
                 oracle.losses[AUTHORITY_LOSS_UNRENEWED], oracle.losses[AUTHORITY_LOSS_SILENT],
                 oracle.losses[AUTHORITY_LOSS_TAKEN], oracle.orders[COMMAND_SOURCE_IGTL],
                 oracle.orders[COMMAND_SOURCE_HTTP], oracle.cut, oracle.refused, oracle.stops);
}

static bool judge(void)
{
    bool is_good = true;
    for (uint32_t i = 0U; i < SENTENCE_COUNT; i++) {
        if (oracle.broken[i] > 0U) {
            (void)printf("broken: %s; in %u cycles, first in cycle %u\n",
                         message_oracle_sentence((sentence_t)i), oracle.broken[i],
                         oracle.first_cycle[i]);
            is_good = false;
        }
    }
    return is_good;
}

int main(int count, char **arguments)
{
    bool is_whole = true;
    for (int i = 1; i < count; i++) {
        const robot_t *robot = open_recording(arguments[i]);
        if (robot == NULL) {
            return EXIT_UNREADABLE;
        }
        replay_init(&replay);
        is_whole = replay_all(robot) && is_whole;
        recording_reader_close(&reader);
    }
    print_counts();
    if (!is_whole || (oracle.cycles == 0U)) {
        (void)printf("broken: every cycle is there, and replays; last seen cycle %u\n",
                     (unsigned)record.cycle);
        is_whole = false;
    }
    return (judge() && is_whole) ? EXIT_GOOD : EXIT_BROKEN;
}

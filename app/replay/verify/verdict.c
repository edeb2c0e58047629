/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/verify/verdict.h"

#include <inttypes.h>

int verdict_take(walk_t *walk)
{
    if (!walk->is_of_run) {
        walk_report_lost(walk);
    }
    while (walk_take(walk)) {
        if (!walk_replay(walk)) {
            return walk_report_difference(walk, stdout);
        }
        (void)walk_count(walk, walk_is_done(walk));
    }
    return walk_check_end(walk) ? WALK_GOES_ON : EXIT_REFUSED;
}

static void report_run(const walk_t *walk)
{
    char name[RECORDING_RUN_SIZE];

    recording_run_name(walk->reader.header.run, name);
    (void)printf("Run %s: cycles %" PRIu32 " to %" PRIu32 "%s ", name, walk->coverage.first,
                 walk->coverage.next - 1U, walk->has_run_end ? ", its last," : "");
    if (walk->is_of_run) {
        (void)printf("in %" PRIu32 " recording%s.\n", walk->recordings,
                     (walk->recordings == 1U) ? "" : "s");
    } else {
        (void)printf("in this recording.\n");
    }
}

static void report_share(const walk_t *walk)
{
    (void)printf("%" PRIu64 " of %s%" PRIu32 " cycles replayed, %s\n", walk->coverage.done,
                 walk->has_run_end ? "" : "at least ", walk->coverage.next,
                 walk_is_whole_run(walk) ? "every output equal"
                                         : "their outputs equal; this is not the whole run");
}

int verdict_report(walk_t *walk)
{
    const int code = walk_end(walk);

    if (walk->coverage.done == 0U) {
        (void)printf("There is nothing to replay: no cycle follows a checkpoint.\n");
        return EXIT_REFUSED;
    }
    report_run(walk);
    report_share(walk);
    if (!walk->is_of_run && walk->is_cut_short) {
        (void)printf("The recording is cut short: only the %" PRIu64
                     " cycles before the cut were replayed.\n",
                     walk->coverage.done);
    }
    return code;
}

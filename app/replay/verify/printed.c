/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/verify/printed.h"

#include "replay/verify/board_table.h"
#include "replay/data/table.h"

static void report_table(walk_t *walk, void *to, const controller_outputs_t *shown)
{
    (void)to;
    if (shown != NULL) {
        table_print_row(walk->robot, walk->record.cycle, &shown->snapshot);
    }
}

static void report_board(walk_t *walk, void *to, const controller_outputs_t *shown)
{
    (void)to;
    if (shown != NULL) {
        board_table_print_row(&walk->record, &shown->snapshot);
    }
}

static bool is_first(const walk_t *walk)
{
    return walk->recordings == 1U;
}

int printed_motion(walk_t *walk)
{
    if (is_first(walk)) {
        table_print_names(walk->robot);
    }
    return walk_report_part(walk, report_table, NULL);
}

int printed_board(walk_t *walk)
{
    if (is_first(walk)) {
        board_table_print_names();
    }
    return walk_report_part(walk, report_board, NULL);
}

int printed_events(walk_t *walk)
{
    while (walk_take(walk)) {
        if (walk_count(walk, true)) {
            table_print_events(walk->robot, &walk->record);
        }
    }
    return walk_check_end(walk) ? WALK_GOES_ON : EXIT_REFUSED;
}

int printed_intervals(walk_t *walk)
{
    if (is_first(walk)) {
        table_print_interval_names();
    }
    while (walk_take(walk)) {
        if (walk_count(walk, true)) {
            table_print_interval(&walk->record);
        }
    }
    return walk_check_end(walk) ? WALK_GOES_ON : EXIT_REFUSED;
}

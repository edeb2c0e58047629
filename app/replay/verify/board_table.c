/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/verify/board_table.h"

#include "bsp.h"
#include "card/card_frame.h"

#include <inttypes.h>
#include <stdio.h>

static const char *const inputs[] = {"pedal_a", "pedal_b",    "estop_chain",  "scanner_idle",
                                     "confirm", "dose_below", "treatment_may"};
#define INPUTS (sizeof inputs / sizeof inputs[0])

void board_table_print_names(void)
{
    (void)printf("cycle,sampled_us,high,dropped,not_read,started_us,finished_us,results,error,"
                 "frames_drive,cards_drive\n");
}

static void print_inputs(uint32_t bits)
{
    const char *before = "";

    for (uint32_t i = 0U; i < INPUTS; i++) {
        if ((bits & (1U << i)) != 0U) {
            (void)printf("%s%s", before, inputs[i]);
            before = " ";
        }
    }
    (void)putchar(',');
}

static void print_results(const cycle_board_t *board)
{
    static const char letters[] = {
        [BSP_SLOT_NOT_SENT] = '-', [BSP_SLOT_OK] = 'o',       [BSP_SLOT_NO_ANSWER] = 'n',
        [BSP_SLOT_LATE] = 'l',     [BSP_SLOT_NOT_IDLE] = 'i', [BSP_SLOT_BUS_ERROR] = 'b'};

    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        const uint32_t result = board->results[slot];
        (void)putchar((result < sizeof letters) ? letters[result] : '?');
    }
}

static uint32_t frames_drive(const snapshot_t *shown)
{
    uint32_t count = 0U;

    for (uint32_t i = 0U; (i < shown->axis_count) && (i < ROBOT_AXIS_MAX); i++) {
        count += (shown->axes[i].drive_mode != (uint32_t)CARD_DRIVE_OFF) ? 1U : 0U;
    }
    return count;
}

static uint32_t cards_drive(const controller_inputs_t *given)
{
    uint32_t count = 0U;

    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        card_report_t report;
        if (((given->frames_received & (1U << slot)) != 0U) &&
            (card_frame_decode_report(given->frames[slot], slot, &report) == CARD_FRAME_OK)) {
            count += (report.applied.mode != (uint32_t)CARD_DRIVE_OFF) ? 1U : 0U;
        }
    }
    return count;
}

void board_table_print_row(const cycle_record_t *record, const snapshot_t *shown)
{
    const cycle_board_t *board = &record->body.cycle.board;

    (void)printf("%" PRIu32 ",%" PRIu32 ",", record->cycle, board->sampled_us);
    print_inputs(board->levels & ~board->dropped & board->valid);
    print_inputs(board->dropped & board->valid);
    print_inputs(~board->valid);
    (void)printf("%" PRIu32 ",%" PRIu32 ",", board->started_us, board->finished_us);
    print_results(board);
    (void)printf(",%" PRId32 ",%" PRIu32 ",%" PRIu32 "\n", board->error, frames_drive(shown),
                 cards_drive(&record->body.cycle.inputs));
}

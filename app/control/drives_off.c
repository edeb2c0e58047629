/* SPDX-License-Identifier: Apache-2.0 */
#include "control/drives_off.h"

#include "bsp.h"
#include "limits/requirement_limits.h"
#include "robot/robot_cards.h"

#include <stdio.h>

static uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
static uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES];

static uint32_t finish(void)
{
    bsp_exchange_t result;
    bsp_finish(bsp_now_ns() + (UINT64_C(1000) * LIMIT_EXCHANGE_TIMEOUT_US), received, &result);
    return result.received;
}

static uint32_t write_frames(const robot_t *robot, uint32_t dialect, uint32_t sequence,
                             uint32_t time_us)
{
    uint32_t slots = 0U;
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        const uint32_t axis = robot_cards_axis(robot, slot);
        const card_command_t off = {.slot = slot,
                                    .sequence = sequence,
                                    .time_us = time_us,
                                    .control = CARD_CONTROL_CLEAR_FAULT, /* Tripped cards hear. */
                                    .watchdog_us = LIMIT_CARD_WATCHDOG_US,
                                    .axis_id = (axis < ROBOT_AXIS_MAX) ? axis : CARD_NO_AXIS};
        if (robot_cards_type(robot, slot) != (uint32_t)CARD_TYPE_NONE) {
            card_dialect_encode_command(dialect, &off, frames[slot]);
            slots |= 1U << slot;
        }
    }
    return slots;
}

/* A report speaks of the frame before: of those received, the cards that apply "off" since `first`.
 */
static uint32_t confirmed(uint32_t answered, uint32_t first, uint32_t sequence)
{
    uint32_t slots = 0U;
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        card_report_t report;
        if (((answered & (1U << slot)) != 0U) &&
            (card_frame_decode_report(received[slot], slot, &report) == CARD_FRAME_OK) &&
            ((report.accepted_sequence - first) < (sequence - first)) &&
            (report.applied.mode == (uint32_t)CARD_DRIVE_OFF)) {
            slots |= 1U << slot;
        }
    }
    return slots;
}

drives_off_t drives_off(const robot_t *robot, uint32_t dialect, uint32_t sequence, uint32_t time_us)
{
    drives_off_t done = {.dialect = dialect};
    (void)finish(); /* The exchange under way, whose frames were no "off". */
    for (uint32_t i = 0U; i < LIMIT_OFF_EXCHANGES; i++) {
        done.sent = write_frames(robot, dialect, sequence + i, time_us);
        /* C99 adds no const through an array pointer by itself. */
        bsp_start(done.sent, (const uint8_t(*)[CARD_FRAME_BYTES])frames);
        done.confirmed |= confirmed(finish(), sequence, sequence + i);
        if (done.confirmed == done.sent) {
            break;
        }
    }
    return done;
}

static unsigned count_bits(uint32_t bits)
{
    unsigned count = 0U;
    for (uint32_t left = bits; left != 0U; left &= left - 1U) {
        count++;
    }
    return count;
}

void drives_off_report(const drives_off_t *done, char text[DRIVES_OFF_TEXT_SIZE])
{
    const unsigned sent = count_bits(done->sent);
    const unsigned off = count_bits(done->confirmed);
    if (off == sent) {
        (void)snprintf(text, DRIVES_OFF_TEXT_SIZE,
                       "all %u cards confirm that their drive is off.\n", sent);
    } else if (done->dialect != (uint32_t)CARD_DIALECT_OWN) {
        (void)snprintf(
            text, DRIVES_OFF_TEXT_SIZE,
            "\"off\" was sent to all %u cards, which can neither confirm it nor switch off "
            "by a watchdog of their own: make sure that nothing moves.\n",
            sent);
    } else {
        (void)snprintf(text, DRIVES_OFF_TEXT_SIZE,
                       "\"off\" was sent to all %u cards, %u confirm it; the others' own watchdogs "
                       "switch off within %u ms of their time.\n",
                       sent, off, LIMIT_CARD_WATCHDOG_US / 1000U);
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "recorder/card_counts.h"

#include "limits/requirement_limits.h"

#include <stdio.h>
#include <string.h>

#define US_PER_MS UINT64_C(1000)

static bool is_time(const card_counts_t *self, uint64_t now_us)
{
    return (self->told_us == 0U) || (now_us == CARD_COUNTS_END) ||
           ((now_us - self->told_us) >= (LIMIT_CARD_COUNTS_PAUSE_MS * US_PER_MS));
}

bool card_counts_look(card_counts_t *self, uint32_t slot, const snapshot_card_t *card,
                      uint64_t now_us, char text[CARD_COUNTS_SIZE])
{
    const uint32_t numbers[] = {card->frame_errors - card->frames_out_of_order,
                                card->frames_out_of_order,
                                card->frames_missed,
                                card->rx_crc_errors,
                                card->sequence_gaps,
                                card->watchdog_trips};

    if ((memcmp(numbers, self->numbers, sizeof numbers) == 0) || !is_time(self, now_us)) {
        return false;
    }
    (void)memcpy(self->numbers, numbers, sizeof self->numbers);
    self->told_us = now_us;
    (void)snprintf(
        text, CARD_COUNTS_SIZE,
        "CARD_COUNTS value=%u Frames of card %u: %u damaged, %u out of order, %u missed. "
        "Commands to it: %u damaged, %u out of order. Its watchdog has tripped %u times.",
        (unsigned)slot, (unsigned)slot, (unsigned)numbers[0], (unsigned)numbers[1],
        (unsigned)numbers[2], (unsigned)numbers[3], (unsigned)numbers[4], (unsigned)numbers[5]);
    return true;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/write/card_counts.h"

#include "limits/requirement_limits.h"

#include <stdio.h>
#include <string.h>

#define US_PER_MS UINT64_C(1000)
#define OF_CARD 3U /* From here on the card itself counts. */

static bool is_time(const card_counts_t *self, uint64_t now_us)
{
    return (self->reported_us == 0U) || (now_us == CARD_COUNTS_END) ||
           ((now_us - self->reported_us) >= (LIMIT_CARD_COUNTS_PAUSE_MS * US_PER_MS));
}

/* All counts of a card are 0 until its first answer. */
static void settle(card_counts_t *self, uint32_t heartbeat, const uint32_t *numbers)
{
    if (self->is_settled || (heartbeat == 0U)) {
        return;
    }
    self->first_heartbeat = (self->first_heartbeat == 0U) ? heartbeat : self->first_heartbeat;
    self->is_settled = (heartbeat - self->first_heartbeat) >= LIMIT_CARD_COUNTS_SETTLE_FRAMES;
    (void)memcpy(&self->numbers[OF_CARD], &numbers[OF_CARD],
                 sizeof self->numbers - (OF_CARD * sizeof numbers[0]));
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

    settle(self, card->heartbeat, numbers);
    if ((memcmp(numbers, self->numbers, sizeof numbers) == 0) || !is_time(self, now_us)) {
        return false;
    }
    (void)memcpy(self->numbers, numbers, sizeof self->numbers);
    self->reported_us = now_us;
    (void)snprintf(
        text, CARD_COUNTS_SIZE,
        "CARD_COUNTS value=%u Frames of card %u: %u damaged, %u out of order, %u missed. "
        "Commands to it: %u damaged, %u out of order. Its watchdog has tripped %u times.",
        (unsigned)slot, (unsigned)slot, (unsigned)numbers[0], (unsigned)numbers[1],
        (unsigned)numbers[2], (unsigned)numbers[3], (unsigned)numbers[4], (unsigned)numbers[5]);
    return true;
}

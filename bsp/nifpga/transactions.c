/* SPDX-License-Identifier: Apache-2.0 */
#include "nifpga/transactions.h"

#include "card/aim32_frame.h"

#include <string.h>
#include <time.h>

#define NS_PER_S UINT64_C(1000000000)
#define LOOK_AGAIN_NS 20000L

uint64_t transactions_now_ns(void)
{
    struct timespec now = {0};

    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return ((uint64_t)now.tv_sec * NS_PER_S) + (uint64_t)now.tv_nsec;
}

void transactions_init(transactions_t *self, const fpga_t *fpga, const fabric_t *fabric)
{
    *self = (transactions_t){.fpga = fpga, .fabric = fabric};
}

static void to_words(const uint8_t bytes[CARD_FRAME_BYTES], uint32_t words[AIM32_FRAME_WORDS])
{
    for (uint32_t i = 0U; i < AIM32_FRAME_WORDS; i++) {
        const uint8_t *const at = &bytes[i * 4U];
        words[i] = ((uint32_t)at[0] << 24U) | ((uint32_t)at[1] << 16U) | ((uint32_t)at[2] << 8U) |
                   (uint32_t)at[3];
    }
}

static void to_bytes(const uint32_t words[AIM32_FRAME_WORDS], uint8_t bytes[CARD_FRAME_BYTES])
{
    (void)memset(bytes, 0, CARD_FRAME_BYTES);
    for (uint32_t i = 0U; i < CARD_FRAME_BYTES / 2U; i++) {
        bytes[i] = (uint8_t)((words[i / 4U] >> (24U - (8U * (i % 4U)))) & 0xFFU);
    }
}

/* All words 0, or all of them 0xFFFFFFFF. */
static bool stands_still(const uint32_t words[AIM32_FRAME_WORDS])
{
    for (uint32_t i = 1U; i < AIM32_FRAME_WORDS; i++) {
        if (words[i] != words[0]) {
            return false;
        }
    }
    return (words[0] == 0U) || (words[0] == UINT32_MAX);
}

static bool is_good(transactions_t *self, uint32_t slot, int32_t status)
{
    if (status < 0) {
        self->begun.error = status;
        self->begun.results[slot] = (uint8_t)BSP_SLOT_BUS_ERROR;
        self->awaited &= ~(1U << slot);
    }
    return status >= 0;
}

/* The state of a card is idle; it is not believed when it could not be read. */
static bool is_idle(transactions_t *self, uint32_t slot)
{
    const fabric_card_t *const card = &self->fabric->cards[slot];
    uint16_t state = 0U;
    const int32_t status = self->fpga->calls.read_u16(self->fpga->session, card->state, &state);

    return is_good(self, slot, status) && (state == card->idle);
}

static void begin(transactions_t *self, uint32_t slot, const uint8_t frame[CARD_FRAME_BYTES])
{
    const fabric_card_t *const card = &self->fabric->cards[slot];
    const fpga_calls_t *const calls = &self->fpga->calls;
    uint32_t words[AIM32_FRAME_WORDS];

    self->begun.results[slot] = (uint8_t)BSP_SLOT_NOT_IDLE;
    if (!is_idle(self, slot)) {
        return;
    }
    to_words(frame, words);
    if (is_good(
            self, slot,
            calls->write_words(self->fpga->session, card->outgoing, words, AIM32_FRAME_WORDS)) &&
        is_good(self, slot, calls->write_bool(self->fpga->session, card->transact, 1U))) {
        self->begun.results[slot] = (uint8_t)BSP_SLOT_LATE;
        self->begun.sampled_ns[slot] = transactions_now_ns();
        self->awaited |= 1U << slot;
    }
}

void transactions_start(transactions_t *self, uint32_t send,
                        const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES])
{
    const uint32_t slots = send & self->fabric->slots;

    self->begun = (bsp_exchange_t){.started_ns = transactions_now_ns()};
    self->awaited = 0U;
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (((slots >> slot) & 1U) != 0U) {
            begin(self, slot, frames[slot]);
        }
    }
}

static void collect(transactions_t *self, uint32_t slot, uint8_t received[CARD_FRAME_BYTES])
{
    const fabric_card_t *const card = &self->fabric->cards[slot];
    uint32_t words[AIM32_FRAME_WORDS];

    if (!is_good(self, slot,
                 self->fpga->calls.read_words(self->fpga->session, card->incoming, words,
                                              AIM32_FRAME_WORDS))) {
        return;
    }
    self->awaited &= ~(1U << slot);
    if (stands_still(words)) {
        self->begun.results[slot] = (uint8_t)BSP_SLOT_NO_ANSWER;
        return;
    }
    self->begun.results[slot] = (uint8_t)BSP_SLOT_OK;
    self->begun.received |= 1U << slot;
    to_bytes(words, received);
}

static void look(transactions_t *self, uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES])
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if ((((self->awaited >> slot) & 1U) != 0U) && is_idle(self, slot)) {
            collect(self, slot, received[slot]);
        }
    }
}

void transactions_finish(transactions_t *self, uint64_t deadline_ns,
                         uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                         bsp_exchange_t *result)
{
    const struct timespec pause = {.tv_nsec = LOOK_AGAIN_NS};

    look(self, received);
    while ((self->awaited != 0U) && (transactions_now_ns() < deadline_ns)) {
        (void)clock_nanosleep(CLOCK_MONOTONIC, 0, &pause, NULL);
        look(self, received);
    }
    *result = self->begun;
    result->finished_ns = (self->begun.started_ns == 0U) ? 0U : transactions_now_ns();
    self->begun = (bsp_exchange_t){.started_ns = 0U};
    self->awaited = 0U;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "sbrio/bus_check.h"

#include <stdio.h>

#define SHIFTS 7U
#define HZ_PER_MHZ 1e6
#define MORE_US 20U

static uint64_t first_bits(const uint8_t bytes[CARD_FRAME_BYTES])
{
    uint64_t bits = 0U;
    for (uint32_t i = 0U; i < sizeof bits; i++) {
        bits = (bits << 8U) | bytes[i];
    }
    return bits;
}

/* A late answer begins some bits behind its place, an early one has lost its first bits. */
static uint32_t shift_of(const uint8_t bytes[CARD_FRAME_BYTES])
{
    const uint64_t bits = first_bits(bytes);
    for (uint32_t shift = 1U; shift <= SHIFTS; shift++) {
        const uint32_t late = (uint32_t)(bits >> (32U - shift));
        const uint32_t early = (uint32_t)(bits >> (32U + shift));
        if ((late == CARD_FRAME_START) || (early == (CARD_FRAME_START & (UINT32_MAX >> shift)))) {
            return shift;
        }
    }
    return 0U;
}

/* @return the slot whose report it is; CARD_SLOT_COUNT: none's */
static uint32_t owner_of(const uint8_t bytes[CARD_FRAME_BYTES])
{
    card_report_t report;
    uint32_t slot = 0U;
    while ((slot < CARD_SLOT_COUNT) &&
           (card_frame_decode_report(bytes, slot, &report) != CARD_FRAME_OK)) {
        slot++;
    }
    return slot;
}

bool bus_check_stands_still(const uint8_t bytes[CARD_FRAME_BYTES])
{
    for (uint32_t i = 1U; i < CARD_FRAME_BYTES; i++) {
        if (bytes[i] != bytes[0]) {
            return false;
        }
    }
    return (bytes[0] == 0x00U) || (bytes[0] == 0xFFU);
}

bus_check_seen_t bus_check_look(uint32_t slot, const uint8_t bytes[CARD_FRAME_BYTES])
{
    bus_check_seen_t seen = {.shift_bits = shift_of(bytes), .slot = owner_of(bytes)};

    if (bus_check_stands_still(bytes)) {
        seen.answer = BUS_CHECK_EMPTY;
    } else if (seen.slot == slot) {
        seen.answer = BUS_CHECK_ALIVE;
        seen.heartbeat = card_frame_heartbeat(bytes);
    } else if (seen.slot < CARD_SLOT_COUNT) {
        seen.answer = BUS_CHECK_OTHER;
    } else if ((uint32_t)(first_bits(bytes) >> 32U) == CARD_FRAME_START) {
        seen.answer = BUS_CHECK_DAMAGED;
    } else if (seen.shift_bits != 0U) {
        seen.answer = BUS_CHECK_SHIFTED;
    } else {
        seen.answer = BUS_CHECK_NOISE;
    }
    return seen;
}

/* Reports the fault of an answer that came with frames far apart. */
static bool judge_apart(const wiring_spi_t *wiring, uint32_t slot, const bus_check_seen_t *seen,
                        char *error, uint32_t error_size)
{
    const double clock_mhz = wiring->clock_hz / HZ_PER_MHZ;

    switch (seen->answer) {
    case BUS_CHECK_SHIFTED:
        (void)snprintf(error, error_size,
                       "Slot %u of %s answers %u bits beside its place: the clock of %.1f MHz is "
                       "probably too high, or mode=%u is not that of the card.",
                       (unsigned)slot, wiring->path, (unsigned)seen->shift_bits, clock_mhz,
                       (unsigned)wiring->mode);
        return false;
    case BUS_CHECK_OTHER:
        (void)snprintf(
            error, error_size,
            "Where slot %u of %s should answer, the card of slot %u does; compare slots= "
            "with the wires and the multiplexer.",
            (unsigned)slot, wiring->path, (unsigned)seen->slot);
        return false;
    case BUS_CHECK_DAMAGED:
        (void)snprintf(error, error_size,
                       "Slot %u of %s answers with damaged reports: check shield and ground of its "
                       "wires, and the firmware of the card, or lower the clock of %.1f MHz.",
                       (unsigned)slot, wiring->path, clock_mhz);
        return false;
    case BUS_CHECK_NOISE:
        (void)snprintf(error, error_size,
                       "Slot %u of %s answers without a start word: its card has another protocol, "
                       "or its wires are open.",
                       (unsigned)slot, wiring->path);
        return false;
    case BUS_CHECK_EMPTY:
    case BUS_CHECK_ALIVE:
    default:
        return true;
    }
}

bool bus_check_judge(const wiring_spi_t *wiring, uint32_t slot, const bus_check_seen_t *apart,
                     const bus_check_seen_t *apart_again, const bus_check_seen_t *together,
                     char *error, uint32_t error_size)
{
    if (!judge_apart(wiring, slot, apart, error, error_size) ||
        !judge_apart(wiring, slot, apart_again, error, error_size)) {
        return false;
    }
    if (apart->answer != apart_again->answer) {
        (void)snprintf(error, error_size,
                       "Slot %u of %s answers only sometimes; check its plug and its supply.",
                       (unsigned)slot, wiring->path);
        return false;
    }
    if ((apart->answer == BUS_CHECK_ALIVE) && (apart->heartbeat == apart_again->heartbeat)) {
        (void)snprintf(error, error_size,
                       "Slot %u of %s gives the same report twice: its card does not run; switch "
                       "the box off and on.",
                       (unsigned)slot, wiring->path);
        return false;
    }
    if (together->answer != apart->answer) {
        (void)snprintf(error, error_size,
                       "Slot %u of %s answers while frames are far apart, and not as they are: the "
                       "chip select's pause is too short for it; give gap=%u.",
                       (unsigned)slot, wiring->path, (unsigned)(wiring->gap_us + MORE_US));
        return false;
    }
    return true;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "nifpga/fabric.h"

#include <stdio.h>
#include <string.h>

#define NAME_SIZE 24U
#define NEEDED_INPUTS 4U
#define CARD_REGISTERS 4U
#define MOST_REGISTERS ((CARD_SLOT_COUNT * CARD_REGISTERS) + (uint32_t)FABRIC_BITS)

static const char *const bit_names[FABRIC_BITS] = {
    "PedalA",      "PedalB",       "EstopClosed", "ScannerIdle", "Confirm",
    "DoseBelow",   "TreatmentMay", "DrivesPower", "Alive",       "LampAlive",
    "LampMayMove", "LampMoving",   "LampFault"};
static const char *const types[] = {[BITFILE_BOOLEAN] = "Boolean",
                                    [BITFILE_PACKET] = "array of 32 U32",
                                    [BITFILE_STATE] = "enumeration (U16)"};

/* The bitfile that is searched, and the text for an error. */
typedef struct {
    const bitfile_t *bitfile;
    char *error;
    uint32_t error_size;
} search_t;

static bool refuse(const search_t *self, const bitfile_query_t *query, bitfile_answer_t answer)
{
    if (answer == BITFILE_TWICE) {
        (void)snprintf(self->error, self->error_size,
                       "The bitfile has two registers \"%s\"; name one of them otherwise in the "
                       "VI, or give another bitfile.",
                       query->name);
        return false;
    }
    (void)snprintf(
        self->error, self->error_size,
        "The bitfile lacks the %s \"%s\" (%s); add it to the VI, or give another bitfile.",
        query->is_indicator ? "indicator" : "control", query->name, types[query->type]);
    return false;
}

static bool need(const search_t *self, const bitfile_query_t *query, uint32_t *address)
{
    const bitfile_answer_t answer = bitfile_find(self->bitfile, query, address);

    return (answer == BITFILE_FOUND) || refuse(self, query, answer);
}

/* A register of the card in `slot`. */
static bool need_of_card(const search_t *self, const char *kind, uint32_t slot,
                         bitfile_query_t query, uint32_t *address)
{
    char name[NAME_SIZE];

    (void)snprintf(name, sizeof name, "%s%u", kind, (unsigned)slot);
    query.name = name;
    return need(self, &query, address);
}

static bool find_idle(const search_t *self, uint32_t slot, uint16_t *idle)
{
    char name[NAME_SIZE];

    (void)snprintf(name, sizeof name, "CurrentState%u", (unsigned)slot);
    if (!bitfile_number(self->bitfile, name, "Idle", idle)) {
        (void)snprintf(self->error, self->error_size,
                       "The indicator \"%s\" of the bitfile has no value \"Idle\"; name it so.",
                       name);
        return false;
    }
    return true;
}

static bool find_card(const search_t *self, uint32_t slot, fabric_card_t *card)
{
    const bitfile_query_t to_card = {.type = BITFILE_PACKET};
    const bitfile_query_t from_card = {.type = BITFILE_PACKET, .is_indicator = true};
    const bitfile_query_t begin = {.type = BITFILE_BOOLEAN};
    const bitfile_query_t state = {.type = BITFILE_STATE, .is_indicator = true};

    return need_of_card(self, "OutgoingPacket", slot, to_card, &card->outgoing) &&
           need_of_card(self, "IncomingPacket", slot, from_card, &card->incoming) &&
           need_of_card(self, "Transact", slot, begin, &card->transact) &&
           need_of_card(self, "CurrentState", slot, state, &card->state) &&
           find_idle(self, slot, &card->idle);
}

static bool find_cards(fabric_t *self, const search_t *search)
{
    char name[NAME_SIZE];
    const bitfile_query_t query = {.name = name, .type = BITFILE_PACKET};
    uint32_t address = 0U;

    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        (void)snprintf(name, sizeof name, "OutgoingPacket%u", (unsigned)slot);
        if (bitfile_find(search->bitfile, &query, &address) == BITFILE_MISSING) {
            continue;
        }
        if (!find_card(search, slot, &self->cards[slot])) {
            return false;
        }
        self->slots |= 1U << slot;
    }
    (void)snprintf(name, sizeof name, "OutgoingPacket1");
    return (self->slots != 0U) || refuse(search, &query, BITFILE_MISSING);
}

static bool find_bits(fabric_t *self, const search_t *search)
{
    for (uint32_t i = 0U; i < (uint32_t)FABRIC_BITS; i++) {
        const bitfile_query_t query = {.name = bit_names[i],
                                       .type = BITFILE_BOOLEAN,
                                       .is_indicator = i < (uint32_t)FABRIC_INPUTS};
        const bitfile_answer_t answer = bitfile_find(search->bitfile, &query, &self->bits[i]);
        if (answer == BITFILE_FOUND) {
            self->has |= 1U << i;
        } else if ((answer != BITFILE_MISSING) || (i < NEEDED_INPUTS)) {
            return refuse(search, &query, answer);
        } else {
            /* The box does without. */
        }
    }
    return true;
}

/* Addresses of all registers that were found. */
static uint32_t list_addresses(const fabric_t *self, uint32_t addresses[MOST_REGISTERS])
{
    uint32_t count = 0U;

    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (((self->slots >> slot) & 1U) != 0U) {
            const fabric_card_t *const card = &self->cards[slot];
            addresses[count] = card->outgoing;
            addresses[count + 1U] = card->incoming;
            addresses[count + 2U] = card->transact;
            addresses[count + 3U] = card->state;
            count += CARD_REGISTERS;
        }
    }
    for (uint32_t i = 0U; i < (uint32_t)FABRIC_BITS; i++) {
        if (((self->has >> i) & 1U) != 0U) {
            addresses[count] = self->bits[i];
            count++;
        }
    }
    return count;
}

/* One register would be read as both channels of the pedal. */
static bool are_apart(const fabric_t *self, const search_t *search)
{
    uint32_t addresses[MOST_REGISTERS];
    const uint32_t count = list_addresses(self, addresses);

    for (uint32_t i = 0U; i < count; i++) {
        for (uint32_t k = 0U; k < i; k++) {
            if (((addresses[i] ^ addresses[k]) & ~BITFILE_MAY_TIME_OUT) == 0U) {
                (void)snprintf(search->error, search->error_size,
                               "Two registers of the bitfile are at the same address %u; give the "
                               ".lvbitx as LabVIEW FPGA has made it.",
                               (unsigned)(addresses[i] & ~BITFILE_MAY_TIME_OUT));
                return false;
            }
        }
    }
    return true;
}

bool fabric_find(fabric_t *self, const bitfile_t *bitfile, char *error, uint32_t error_size)
{
    const search_t search = {bitfile, error, error_size};

    (void)memset(self, 0, sizeof *self);
    return find_cards(self, &search) && find_bits(self, &search) && are_apart(self, &search);
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A stand-in for NI's library with a box behind it: registers, and cards that answer with the count
 * of their encoder. It is in no product: a test puts functions of its own in place of dlopen() and
 * dlsym(), which find it.
 */
#ifndef BORESIGHT_FPGA_WORLD_H
#define BORESIGHT_FPGA_WORLD_H

#include "card/card.h"

#include <dlfcn.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define FPGA_WORLD_BASE 98304U
#define FPGA_WORLD_WORDS 32U
#define FPGA_WORLD_FIRST_SLOT 1U
#define FPGA_WORLD_END_SLOT 8U
#define FPGA_WORLD_BITS 13U
#define FPGA_WORLD_SESSION 4711U
#define FPGA_WORLD_BROKEN (-61003)
#define FPGA_WORLD_FOREVER 1000000U

/* Kinds of registers of a card; address: 1000 for each, 100 for each slot. */
enum { FPGA_OUT = 1, FPGA_IN = 2, FPGA_TRANSACT = 3, FPGA_STATE = 4 };

static const char *const fpga_world_bits[FPGA_WORLD_BITS] = {
    "PedalA",      "PedalB",       "EstopClosed", "ScannerIdle", "Confirm",
    "DoseBelow",   "TreatmentMay", "DrivesPower", "Alive",       "LampAlive",
    "LampMayMove", "LampMoving",   "LampFault"};

typedef struct {
    uint32_t sent[FPGA_WORLD_WORDS];
    uint32_t answer[FPGA_WORLD_WORDS];
    uint32_t transacts;
    uint32_t busy_looks;  /* As often as its state is still not Idle. */
    uint32_t takes_looks; /* The same for each exchange. */
    uint32_t count;       /* Count of its encoder. */
    bool is_dead;         /* The wire stands still. */
    bool is_damaged;
    bool flickers;
} fpga_world_card_t;

typedef struct {
    fpga_world_card_t cards[CARD_SLOT_COUNT];
    uint8_t bits[FPGA_WORLD_BITS];
    uint32_t writes[FPGA_WORLD_BITS]; /* How often each was written. */
    bool is_missing;                  /* The library. */
    const char *lacks;                /* Entry point that it has not. */
    int32_t refuses;                  /* Status of opening. */
    uint32_t broken;                  /* Address that fails; 0: none. */
    uint32_t opened;
    uint32_t closed;
    uint32_t libraries; /* That are loaded. */
    char said[256];     /* Path, signature and resource of the last session. */
} fpga_world_t;

static fpga_world_t fpga_world;

static inline uint32_t fpga_world_address(uint32_t kind, uint32_t slot)
{
    return FPGA_WORLD_BASE + (kind * 1000U) + (slot * 100U);
}

static inline uint32_t fpga_world_bit(uint32_t bit)
{
    return FPGA_WORLD_BASE + 10000U + (bit * 4U);
}

/* The register at an address, which may say that it is in another clock domain. */
static inline bool fpga_world_find(uint32_t address, uint32_t kind, fpga_world_card_t **card)
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if ((address & 0x7FFFFFFFU) == fpga_world_address(kind, slot)) {
            *card = &fpga_world.cards[slot];
            return address != fpga_world.broken;
        }
    }
    return false;
}

static inline int32_t fpga_world_open(const char *bitfile, const char *signature,
                                      const char *resource, uint32_t attribute, uint32_t *session)
{
    (void)snprintf(fpga_world.said, sizeof fpga_world.said, "%s %s %s %u", bitfile, signature,
                   resource, (unsigned)attribute);
    *session = FPGA_WORLD_SESSION;
    fpga_world.opened++;
    return fpga_world.refuses;
}

static inline int32_t fpga_world_close(uint32_t session, uint32_t attribute)
{
    fpga_world.closed += ((session == FPGA_WORLD_SESSION) && (attribute == 0U)) ? 1U : 0U;
    return 0;
}

static inline int32_t fpga_world_read_bool(uint32_t session, uint32_t address, uint8_t *value)
{
    for (uint32_t i = 0U; i < FPGA_WORLD_BITS; i++) {
        if ((session == FPGA_WORLD_SESSION) && (address == fpga_world_bit(i)) &&
            (address != fpga_world.broken)) {
            *value = fpga_world.bits[i];
            return 0;
        }
    }
    return FPGA_WORLD_BROKEN;
}

static inline void fpga_world_transact(fpga_world_card_t *card)
{
    const bool is_silent = card->is_dead || (card->flickers && ((card->transacts % 2U) != 0U));
    uint32_t sum = 0U;

    (void)memset(card->answer, 0, sizeof card->answer);
    if (!is_silent) {
        card->answer[0] = 0xFEFEFE01U;
        card->answer[2] = 0x00080000U;
        card->answer[3] = card->count;
        for (uint32_t i = 0U; i < 31U; i++) {
            sum += card->answer[i];
        }
        card->answer[31] = (0xFFFFFFFFU - sum) ^ (card->is_damaged ? 4U : 0U);
    }
    card->transacts++;
    card->busy_looks = card->takes_looks;
}

static inline int32_t fpga_world_write_bool(uint32_t session, uint32_t address, uint8_t value)
{
    fpga_world_card_t *card = NULL;

    if (fpga_world_find(address, FPGA_TRANSACT, &card) && (value != 0U)) {
        fpga_world_transact(card);
        return 0;
    }
    for (uint32_t i = 0U; i < FPGA_WORLD_BITS; i++) {
        if ((session == FPGA_WORLD_SESSION) && (address == fpga_world_bit(i)) &&
            (address != fpga_world.broken)) {
            fpga_world.bits[i] = value;
            fpga_world.writes[i]++;
            return 0;
        }
    }
    return FPGA_WORLD_BROKEN;
}

/* Idle is its third value. */
static inline int32_t fpga_world_read_u16(uint32_t session, uint32_t address, uint16_t *value)
{
    fpga_world_card_t *card = NULL;

    if (!fpga_world_find(address, FPGA_STATE, &card) || (session != FPGA_WORLD_SESSION)) {
        return FPGA_WORLD_BROKEN;
    }
    *value = (card->busy_looks == 0U) ? 2U : 1U;
    card->busy_looks -= (card->busy_looks == 0U) ? 0U : 1U;
    return 0;
}

static inline int32_t fpga_world_read_words(uint32_t session, uint32_t address, uint32_t *words,
                                            size_t count)
{
    fpga_world_card_t *card = NULL;

    if (!fpga_world_find(address, FPGA_IN, &card) || (session != FPGA_WORLD_SESSION) ||
        (count != FPGA_WORLD_WORDS) || (card->busy_looks != 0U)) {
        return FPGA_WORLD_BROKEN;
    }
    (void)memcpy(words, card->answer, sizeof card->answer);
    return 0;
}

static inline int32_t fpga_world_write_words(uint32_t session, uint32_t address,
                                             const uint32_t *words, size_t count)
{
    fpga_world_card_t *card = NULL;

    if (!fpga_world_find(address, FPGA_OUT, &card) || (session != FPGA_WORLD_SESSION) ||
        (count != FPGA_WORLD_WORDS) || (card->busy_looks != 0U)) {
        return FPGA_WORLD_BROKEN;
    }
    (void)memcpy(card->sent, words, sizeof card->sent);
    return 0;
}

static inline void *fpga_world_symbol(const char *name)
{
    static const struct {
        const char *name;
        void (*call)(void);
    } entries[] = {
        {"NiFpgaDll_Open", (void (*)(void))fpga_world_open},
        {"NiFpgaDll_Close", (void (*)(void))fpga_world_close},
        {"NiFpgaDll_ReadBool", (void (*)(void))fpga_world_read_bool},
        {"NiFpgaDll_WriteBool", (void (*)(void))fpga_world_write_bool},
        {"NiFpgaDll_ReadU16", (void (*)(void))fpga_world_read_u16},
        {"NiFpgaDll_ReadArrayU32", (void (*)(void))fpga_world_read_words},
        {"NiFpgaDll_WriteArrayU32", (void (*)(void))fpga_world_write_words},
    };
    void *found = NULL;
    for (size_t i = 0U; i < (sizeof entries / sizeof entries[0]); i++) {
        const bool is_lacking = (fpga_world.lacks != NULL) && (strcmp(name, fpga_world.lacks) == 0);
        if ((strcmp(name, entries[i].name) == 0) && !is_lacking) {
            (void)memcpy(&found, &entries[i].call, sizeof found);
        }
    }
    return found;
}

/* A file as LabVIEW FPGA writes it, with elements that no program asks for. */
typedef struct {
    const char *without; /* Register that it lacks; NULL: none. */
    const char *other;   /* Register of another type or direction; NULL: none. */
    const char *idle;    /* Name of the state. */
} fpga_world_file_t;

static inline bool fpga_world_is(const char *name, const char *asked)
{
    return (asked != NULL) && (strcmp(name, asked) == 0);
}

static inline void fpga_world_register(FILE *file, const fpga_world_file_t *made, const char *name,
                                       bool is_indicator, const char *type, uint32_t address)
{
    const bool is_other = fpga_world_is(name, made->other);
    if (fpga_world_is(name, made->without)) {
        return;
    }
    (void)fprintf(file,
                  "<Register>\n <Name>%s</Name>\n <Hidden>false</Hidden>\n"
                  " <Indicator>%s</Indicator>\n <Datatype>\n%s</Datatype>\n"
                  " <FlattenedType/>\n <Offset> %u </Offset>\n <Class>0</Class>\n"
                  " <AccessMayTimeout>%s</AccessMayTimeout>\n</Register>\n",
                  name, (is_indicator != is_other) ? "true" : "false", type,
                  (unsigned)(address - FPGA_WORLD_BASE),
                  (strncmp(name, "Incoming", 8U) == 0) ? "true" : "false");
}

static inline void fpga_world_write_card(FILE *file, const fpga_world_file_t *made, uint32_t slot)
{
    static const char *const kinds[] = {[FPGA_OUT] = "OutgoingPacket",
                                        [FPGA_IN] = "IncomingPacket",
                                        [FPGA_TRANSACT] = "Transact",
                                        [FPGA_STATE] = "CurrentState"};
    char states[256];
    (void)snprintf(states, sizeof states,
                   "<EnumU16><Name/><StringList><String>Start</String><String>Wait</String>"
                   "<String>%s</String></StringList></EnumU16>",
                   made->idle);
    for (uint32_t kind = FPGA_OUT; kind <= FPGA_STATE; kind++) {
        const char *const packet = "<Array><Name>x</Name><Size>32</Size><Type><U32><Name/></U32>"
                                   "</Type></Array>";
        const char *const type = (kind <= FPGA_IN)         ? packet
                                 : (kind == FPGA_TRANSACT) ? "<Boolean><Name/></Boolean>"
                                                           : states;
        char name[24];
        (void)snprintf(name, sizeof name, "%s%u", kinds[kind], (unsigned)slot);
        fpga_world_register(file, made, name, (kind == FPGA_IN) || (kind == FPGA_STATE), type,
                            fpga_world_address(kind, slot));
    }
}

static inline void fpga_world_write(const char *path, const fpga_world_file_t *made)
{
    FILE *const file = fopen(path, "we");
    (void)fprintf(file, "<?xml version=\"1.0\"?>\n<Bitfile>\n<BitfileVersion>4.0</BitfileVersion>\n"
                        "<SignatureRegister>\n a1b2c3d4e5f60718293a4b5c6d7e8f90 "
                        "</SignatureRegister>\n<VI>\n<Name>box.vi</Name>\n<RegisterList>\n");
    for (uint32_t slot = FPGA_WORLD_FIRST_SLOT; slot < FPGA_WORLD_END_SLOT; slot++) {
        fpga_world_write_card(file, made, slot);
    }
    for (uint32_t i = 0U; i < FPGA_WORLD_BITS; i++) {
        fpga_world_register(file, made, fpga_world_bits[i], i < 7U, "<Boolean>\n</Boolean>",
                            fpga_world_bit(i));
    }
    (void)fprintf(file,
                  "</RegisterList></VI><Project><CompilationResultsTree><NiFpga>\n"
                  "<BaseAddressOnDevice>%u</BaseAddressOnDevice></NiFpga>\n"
                  "</CompilationResultsTree></Project><Bitstream>AAAA</Bitstream></Bitfile>\n",
                  FPGA_WORLD_BASE);
    (void)fclose(file);
}

/* Seven cards that count 100 times their slot, the e-stop closed, the scanner idle. A card
 * is idle again at the first look, so that no test waits for a clock. */
static inline void fpga_world_init(void)
{
    (void)memset(&fpga_world, 0, sizeof fpga_world);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        fpga_world.cards[slot].count = 100U * slot;
    }
    fpga_world.bits[2] = 1U;
    fpga_world.bits[3] = 1U;
}

#endif

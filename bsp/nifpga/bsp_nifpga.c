/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The board support of the thesis' own box: cards and digital lines are registers of an FPGA, which
 * speaks SPI to the cards. The cards speak aim32.
 */
#include "bsp.h"

#include "card/aim32_frame.h"
#include "nifpga/address.h"
#include "nifpga/bitfile.h"
#include "nifpga/fabric.h"
#include "nifpga/fpga.h"
#include "nifpga/transactions.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#define NS_PER_S UINT64_C(1000000000)
#define NS_PER_MS UINT64_C(1000000)
#define TRIALS 5U
#define TRIAL_NS (UINT64_C(10) * NS_PER_MS)

static fpga_t fpga;
static fabric_t fabric;
static transactions_t transactions;
static volatile sig_atomic_t is_open;
static volatile sig_atomic_t is_cut; /* The power of the drives, until the board is opened again. */
static uint8_t beat;
static uint32_t shown_lamps; /* After loading, none. */

/* Not getrandom(): the box's C library is older. */
static uint32_t any_number(void)
{
    FILE *const file = fopen("/dev/urandom", "re");
    uint32_t number = 0U;

    if (file != NULL) {
        (void)!fread(&number, sizeof number, 1U, file);
        (void)fclose(file);
    }
    return number | 1U;
}

static bool has(uint32_t bit)
{
    return ((fabric.has >> bit) & 1U) != 0U;
}

static bool has_lamp(void)
{
    return (fabric.has >> (uint32_t)FABRIC_LAMPS) != 0U;
}

static bool write_bit(uint32_t bit, bool is_set)
{
    return has(bit) &&
           (fpga.calls.write_bool(fpga.session, fabric.bits[bit], is_set ? 1U : 0U) >= 0);
}

/* The time at which the box was switched on is unknown: no axis is where it was believed to be. */
static void identify(bsp_identity_t *identity, const address_t *address, const bitfile_t *bitfile)
{
    *identity = (bsp_identity_t){.board = "nifpga",
                                 .abilities = (has(FABRIC_POWER) ? BSP_HAS_DRIVES_OFF : 0U) |
                                              (has(FABRIC_ALIVE) ? BSP_HAS_WATCHDOG : 0U) |
                                              (has_lamp() ? BSP_HAS_LAMPS : 0U),
                                 .power_on = any_number(),
                                 .was_used = true,
                                 .slowness = 1U,
                                 .speedup = 1U,
                                 .dialect = (uint32_t)CARD_DIALECT_AIM32};
    (void)snprintf(identity->firmware, sizeof identity->firmware, "%s", bitfile->signature);
    (void)snprintf(identity->accepted, sizeof identity->accepted, "%s", address->accepted);
}

/*
 * Nothing has power before the self test.
 *
 * @satisfies SWR-NI-014
 */
static bool take_power(char *error, uint32_t error_size)
{
    const bool is_taken = !has(FABRIC_POWER) || write_bit(FABRIC_POWER, false);

    if (!is_taken) {
        (void)snprintf(error, error_size,
                       "The register DrivesPower cannot be cleared; check the bitfile and the "
                       "FPGA.");
        fpga_close(&fpga);
    }
    return is_taken;
}

/** @satisfies SWR-NI-008 */
bool bsp_open(const char *address, bsp_identity_t *identity, char *error, uint32_t error_size)
{
    address_t box;
    bitfile_t bitfile;

    if (!address_read(&box, address, error, error_size) ||
        !bitfile_open(&bitfile, box.bitfile, error, error_size)) {
        return false;
    }
    const bool is_found =
        fabric_find(&fabric, &bitfile, error, error_size) &&
        fpga_open(&fpga, box.resource, box.bitfile, &bitfile, error, error_size) &&
        take_power(error, error_size);
    if (is_found) {
        transactions_init(&transactions, &fpga, &fabric);
        identify(identity, &box, &bitfile);
        shown_lamps = 0U;
        is_cut = 0;
        is_open = 1;
    }
    bitfile_close(&bitfile);
    return is_found;
}

/* Results of the trials in all slots. */
typedef struct {
    uint32_t valid[CARD_SLOT_COUNT];
    uint32_t damaged[CARD_SLOT_COUNT];
    bsp_exchange_t last;
} trial_t;

static void try_once(trial_t *trial)
{
    uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
    uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
    const card_command_t off = {.control = 0U};

    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        aim32_frame_encode_command(&off, frames[slot]);
    }
    bsp_start(CARD_EVERY_SLOT, (const uint8_t(*)[CARD_FRAME_BYTES])frames);
    bsp_finish(bsp_now_ns() + TRIAL_NS, received, &trial->last);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        card_report_t report;
        const bool is_received = ((trial->last.received >> slot) & 1U) != 0U;
        const bool is_valid =
            is_received && (aim32_frame_decode_report(received[slot], &report) == CARD_FRAME_OK);
        trial->valid[slot] += is_valid ? 1U : 0U;
        trial->damaged[slot] += (is_received && !is_valid) ? 1U : 0U;
    }
}

static bool judge_slot(const trial_t *trial, uint32_t slot, char *error, uint32_t error_size)
{
    const bsp_slot_result_t result = (bsp_slot_result_t)trial->last.results[slot];
    const char *what = NULL;

    if (result == BSP_SLOT_BUS_ERROR) {
        what = "cannot be reached through the FPGA";
    } else if ((result == BSP_SLOT_LATE) || (result == BSP_SLOT_NOT_IDLE)) {
        what = "does not come to its state Idle";
    } else if (trial->damaged[slot] != 0U) {
        what = "sends damaged reports";
    } else if ((trial->valid[slot] != 0U) && (trial->valid[slot] != TRIALS)) {
        what = "answers only sometimes";
    } else {
        return true;
    }
    (void)snprintf(error, error_size, "The card of slot %u %s (NI's status %d); check its cable.",
                   (unsigned)slot, what, (int)trial->last.error);
    return false;
}

static bool judge(const trial_t *trial, char *error, uint32_t error_size)
{
    uint32_t answers = 0U;

    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (!judge_slot(trial, slot, error, error_size)) {
            return false;
        }
        answers += trial->valid[slot];
    }
    if (answers == 0U) {
        (void)snprintf(error, error_size, "No card answers; check the supply of the cards.");
    }
    return answers != 0U;
}

/*
 * The drives get their power as the last thing, and never after it was cut.
 *
 * @satisfies SWR-NI-014
 */
static bool give_power(char *error, uint32_t error_size)
{
    const bool is_given = !has(FABRIC_POWER) || ((is_cut == 0) && write_bit(FABRIC_POWER, true));

    if (is_cut != 0) {
        (void)write_bit(FABRIC_POWER, false);
    }
    if (!is_given) {
        (void)snprintf(error, error_size, "The register DrivesPower cannot be written.");
    }
    return is_given;
}

/** @satisfies SWR-NI-013 */
bool bsp_self_test(char *error, uint32_t error_size)
{
    trial_t trial = {.valid = {0U}};

    for (uint32_t i = 0U; i < TRIALS; i++) {
        try_once(&trial);
    }
    return judge(&trial, error, error_size) && give_power(error, error_size);
}

void bsp_start(uint32_t send, const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES])
{
    transactions_start(&transactions, send, frames);
}

void bsp_finish(uint64_t deadline_ns, uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                bsp_exchange_t *result)
{
    transactions_finish(&transactions, deadline_ns, received, result);
}

/** @satisfies SWR-NI-015 */
void bsp_sample_inputs(bsp_inputs_t *inputs)
{
    *inputs = (bsp_inputs_t){.sampled_ns = bsp_now_ns()};
    for (uint32_t i = 0U; i < (uint32_t)FABRIC_INPUTS; i++) {
        uint8_t level = 0U;
        if (has(i) && (fpga.calls.read_bool(fpga.session, fabric.bits[i], &level) >= 0)) {
            inputs->valid |= 1U << i;
            inputs->levels |= (level != 0U) ? (1U << i) : 0U;
        }
    }
}

void bsp_set_lamps(uint32_t lamps)
{
    for (uint32_t i = 0U; (i < (uint32_t)(FABRIC_BITS - FABRIC_LAMPS)) && (lamps != shown_lamps);
         i++) {
        (void)write_bit((uint32_t)FABRIC_LAMPS + i, ((lamps >> i) & 1U) != 0U);
    }
    shown_lamps = lamps;
}

/** @satisfies SWR-NI-014 */
void bsp_drives_off(void)
{
    is_cut = 1;
    if (is_open != 0) {
        (void)write_bit(FABRIC_POWER, false);
    }
}

/** @satisfies SWR-NI-014 */
void bsp_kick(void)
{
    beat ^= 1U;
    (void)write_bit(FABRIC_ALIVE, beat != 0U);
}

uint64_t bsp_now_ns(void)
{
    return transactions_now_ns();
}

uint64_t bsp_reached_ns(void)
{
    return bsp_now_ns();
}

void bsp_sleep_until_ns(uint64_t deadline_ns)
{
    const struct timespec deadline = {.tv_sec = (time_t)(deadline_ns / NS_PER_S),
                                      .tv_nsec = (long)(deadline_ns % NS_PER_S)};

    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, NULL) == EINTR) {
    }
}

void bsp_stand_still_ns(uint64_t world_ns)
{
    (void)world_ns; /* It does not wait for control. */
}

void bsp_close(void)
{
    bsp_drives_off();
    is_open = 0;
    fpga_close(&fpga);
}

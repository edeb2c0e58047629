/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the board finds every register by its name in the bitfile and names what is
 * missing, exchanges packets with each card that is idle without any process waiting for it, and
 * gives the drives power only while its cards were found good. Below is a library in NI's place.
 */
#include "unity.h"

#include "bsp.h"
#include "card/aim32_frame.h"
#include "card/card_frame.h"
#include "limits/requirement_limits.h"
#include "nifpga/address.h"
#include "nifpga/bitfile.h"
#include "nifpga/bsp_nifpga.c"
#include "nifpga/fabric.h"
#include "nifpga/transactions.h"

#include "unit/support/fpga_world.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static void *open_library(const char *name, int mode)
{
    (void)mode;
    const bool is_there = !fpga_world.is_missing && (strcmp(name, "libNiFpga.so") == 0);
    fpga_world.libraries += is_there ? 1U : 0U;
    return is_there ? &fpga_world : NULL;
}

static int close_library(void *handle)
{
    fpga_world.libraries -= (handle == &fpga_world) ? 1U : 0U;
    return 0;
}

static void *find_symbol(void *handle, const char *name)
{
    TEST_ASSERT_EQUAL_PTR(&fpga_world, handle);
    return fpga_world_symbol(name);
}

/* For the board alone: the C library's own are needed by the sanitizers. */
#define dlopen open_library
#define dlclose close_library
#define dlsym find_symbol
#include "nifpga/fpga.c"

#define OUR_SLOTS 0xFEU
#define WHO "does not say who accepts the cards, and when (\"A. Engineer, 2026-11-23\")"
#define TIMEOUT_NS (UINT64_C(60000) * NS_PER_MS)
#define POWER_BIT 7U
#define ALIVE_BIT 8U
#define LAMP_BIT 9U
#define GIVE_UP_S 60U

static char path[64];
static char address[160];
static fpga_world_file_t made;
static bsp_identity_t identity;
static uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
static uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
static bsp_exchange_t result;
static char error[256];

static bool open_box(void)
{
    fpga_world_write(path, &made);
    return bsp_open(address, &identity, error, sizeof error);
}

static void open_good_box(void)
{
    TEST_ASSERT_TRUE_MESSAGE(open_box(), error);
}

static void expect_refused(const char *expected)
{
    TEST_ASSERT_FALSE(open_box());
    TEST_ASSERT_EQUAL_STRING(expected, error);
    TEST_ASSERT_EQUAL_UINT32(0U, fpga_world.libraries);
}

static void start(uint32_t send)
{
    const card_command_t command = {
        .control = CARD_CONTROL_AMPLIFIER,
        .drive = {.mode = CARD_DRIVE_PWM, .direction = 1U, .duty = 0x1234U}};
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        aim32_frame_encode_command(&command, frames[slot]);
    }
    bsp_start(send, (const uint8_t(*)[CARD_FRAME_BYTES])frames);
}

static void finish(void)
{
    bsp_finish(bsp_now_ns() + TIMEOUT_NS, received, &result);
}

/* The deadline has passed already: each state is looked at once. */
static void finish_at_once(void)
{
    bsp_finish(0U, received, &result);
}

void setUp(void)
{
    fpga_world_init();
    made = (fpga_world_file_t){.idle = "Idle"};
    (void)snprintf(path, sizeof path, "/tmp/nifpga-%d.lvbitx", (int)getpid());
    (void)snprintf(address, sizeof address, "nifpga:RIO0,%s,accepted=A. Engineer, 2026-11-23",
                   path);
    (void)memset(received, 0xEE, sizeof received);
    (void)memset(&identity, 0, sizeof identity);
    error[0] = '\0';
}

void tearDown(void)
{
    bsp_close();
    (void)unlink(path);
}

void test_SWR_NI_008_the_box_says_what_it_is_and_who_accepts_its_cards(void)
{
    char expected[256];
    open_good_box();
    (void)snprintf(expected, sizeof expected, "%s A1B2C3D4E5F60718293A4B5C6D7E8F90 RIO0 0", path);
    TEST_ASSERT_EQUAL_STRING(expected, fpga_world.said);
    TEST_ASSERT_EQUAL_STRING("nifpga", identity.board);
    TEST_ASSERT_EQUAL_STRING("A1B2C3D4E5F60718293A4B5C6D7E8F90", identity.firmware);
    TEST_ASSERT_EQUAL_UINT32(CARD_DIALECT_AIM32, identity.dialect);
    TEST_ASSERT_EQUAL_STRING("A. Engineer, 2026-11-23", identity.accepted);
    TEST_ASSERT_EQUAL_HEX32(BSP_HAS_DRIVES_OFF | BSP_HAS_WATCHDOG | BSP_HAS_LAMPS,
                            identity.abilities);
    TEST_ASSERT_TRUE(identity.was_used);
    TEST_ASSERT_NOT_EQUAL(0U, identity.power_on);
    TEST_ASSERT_EQUAL_UINT32(1U, identity.slowness);
    TEST_ASSERT_EQUAL_UINT32(1U, identity.speedup);
}

void test_SWR_NI_008_without_a_name_nobody_accepts(void)
{
    const char *const ends[] = {"", ",accepted=", ",accepted=-"};
    for (uint32_t i = 0U; i < 3U; i++) {
        (void)snprintf(address, sizeof address, "nifpga:RIO0,%s%s", path, ends[i]);
        open_good_box();
        TEST_ASSERT_EQUAL_STRING("", identity.accepted);
        bsp_close();
    }
}

void test_SWR_NI_008_a_wrong_address_is_refused_in_one_sentence(void)
{
    static const char *const wrong[][2] = {
        {"sim:x", "does not begin with nifpga:"},
        {"nifpga:RIO0", "names no FPGA"},
        {"nifpga:,/x.lvbitx", "names no FPGA"},
        {"nifpga:RIO0,x.lvbitx", "names no bitfile by its whole path"},
        {"nifpga:RIO0,", "names no bitfile by its whole path"},
        {"nifpga:RIO0,/x,accepted=0123456789012345678901234567890123456789012345678901234567890123",
         "says too long who accepts the cards (at most 63 letters)"},
        {"nifpga:RIO0,/x,accepted=no", WHO},
        {"nifpga:RIO0,/x,accepted= ", WHO},
        {"nifpga:RIO0,/x,accepted=A. Engineer", WHO},
        {"nifpga:RIO0,/x,accepted=2026-11-23", WHO},
        {"nifpga:RIO0,/x,accepted=A. Engineer, 2026-11-2", WHO},
    };
    for (uint32_t i = 0U; i < (sizeof wrong / sizeof wrong[0]); i++) {
        char expected[200];
        (void)snprintf(address, sizeof address, "%s", wrong[i][0]);
        (void)snprintf(expected, sizeof expected,
                       "The box's address %s; expected nifpga:RIO0,/path/NAME.lvbitx.",
                       wrong[i][1]);
        expect_refused(expected);
    }
}

/* Options are put together to an address; one of them is not the other. */
void test_SWR_NI_008_what_the_path_of_the_bitfile_says_accepts_nothing(void)
{
    (void)snprintf(address, sizeof address, "nifpga:RIO0,%s,accepted=A. Engineer, 2026-11-23%s",
                   path, ",accepted=-");
    TEST_ASSERT_FALSE(open_box());
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "2026-11-23\" cannot be read"), error);
}

void test_SWR_NI_009_each_register_that_is_missing_is_named(void)
{
    static const char *const missing[][2] = {
        {"IncomingPacket3", "indicator \"IncomingPacket3\" (array of 32 U32)"},
        {"Transact1", "control \"Transact1\" (Boolean)"},
        {"CurrentState7", "indicator \"CurrentState7\" (enumeration (U16))"},
        {"PedalA", "indicator \"PedalA\" (Boolean)"},
        {"PedalB", "indicator \"PedalB\" (Boolean)"},
        {"EstopClosed", "indicator \"EstopClosed\" (Boolean)"},
        {"ScannerIdle", "indicator \"ScannerIdle\" (Boolean)"},
    };
    for (uint32_t i = 0U; i < (sizeof missing / sizeof missing[0]); i++) {
        char expected[200];
        (void)snprintf(expected, sizeof expected,
                       "The bitfile lacks the %s; add it to the VI, or give another bitfile.",
                       missing[i][1]);
        made.without = missing[i][0];
        expect_refused(expected);
    }
    TEST_ASSERT_EQUAL_UINT32(0U, fpga_world.opened);
}

void test_SWR_NI_009_a_register_of_another_direction_is_as_one_that_is_missing(void)
{
    made.other = "OutgoingPacket2";
    expect_refused("The bitfile lacks the control \"OutgoingPacket2\" (array of 32 U32); add it to "
                   "the VI, or give another bitfile.");
    made.other = "DrivesPower";
    expect_refused("The bitfile lacks the control \"DrivesPower\" (Boolean); add it to the VI, or "
                   "give another bitfile.");
}

/* Writes what `made` says, with `as` in the place of the first `what` behind `from`. */
static void write_changed(const char *from, const char *what, const char *as)
{
    static char text[32768];
    fpga_world_write(path, &made);
    FILE *file = fopen(path, "re");
    text[fread(text, 1U, sizeof text - 1U, file)] = '\0';
    (void)fclose(file);
    char *const start = strstr(text, from);
    TEST_ASSERT_NOT_NULL(start);
    char *const at = strstr(start, what);
    TEST_ASSERT_NOT_NULL(at);
    file = fopen(path, "we");
    (void)fprintf(file, "%.*s%s%s", (int)(at - text), text, as, at + strlen(what));
    (void)fclose(file);
}

void test_SWR_NI_009_two_registers_at_one_address_are_refused(void)
{
    write_changed("<Name>PedalB<", " 10004 ", " 10000 ");
    TEST_ASSERT_FALSE(bsp_open(address, &identity, error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("Two registers of the bitfile are at the same address 108304; give "
                             "the .lvbitx as LabVIEW FPGA has made it.",
                             error);
    write_changed("<Name>IncomingPacket3<", " 2300 ", " 1300 ");
    TEST_ASSERT_FALSE(bsp_open(address, &identity, error, sizeof error));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "at the same address"), error);
    TEST_ASSERT_EQUAL_UINT32(0U, fpga_world.opened);
}

void test_SWR_NI_009_a_cluster_is_not_what_it_is_made_of(void)
{
    static const char *const changes[][3] = {
        {"PedalA", "<Boolean>\n</Boolean>", "<Cluster><U32/><Boolean></Boolean></Cluster>"},
        {"CurrentState2", "<EnumU16>", "<Cluster><EnumU16>"},
        {"OutgoingPacket2", "<Type><U32>", "<Type><Cluster><U32>"},
        {"OutgoingPacket2", "<Array>", "<Cluster><Array>"}};
    for (uint32_t i = 0U; i < (sizeof changes / sizeof changes[0]); i++) {
        char name[32];
        (void)snprintf(name, sizeof name, "<Name>%s<", changes[i][0]);
        write_changed(name, changes[i][1], changes[i][2]);
        TEST_ASSERT_FALSE_MESSAGE(bsp_open(address, &identity, error, sizeof error), changes[i][0]);
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, changes[i][0]), error);
    }
}

void test_SWR_NI_009_a_state_without_idle_is_refused(void)
{
    made.idle = "Ready";
    expect_refused("The indicator \"CurrentState1\" of the bitfile has no value \"Idle\"; name it "
                   "so.");
}

void test_SWR_NI_009_a_slot_without_a_packet_is_none_and_what_is_optional_may_be_missing(void)
{
    made.without = "OutgoingPacket4";
    open_good_box();
    start(OUR_SLOTS);
    finish();
    TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS & ~0x10U, result.received);
    TEST_ASSERT_EQUAL_UINT32(BSP_SLOT_NOT_SENT, result.results[4]);
    bsp_close();
    made.without = "DrivesPower";
    open_good_box();
    TEST_ASSERT_EQUAL_HEX32(BSP_HAS_WATCHDOG | BSP_HAS_LAMPS, identity.abilities);
    TEST_ASSERT_TRUE_MESSAGE(bsp_self_test(error, sizeof error), error);
}

void test_SWR_NI_009_what_is_no_bitfile_is_refused(void)
{
    char expected[256];
    (void)snprintf(expected, sizeof expected,
                   "The bitfile \"%s\" cannot be read; give the .lvbitx of the box.", path);
    TEST_ASSERT_FALSE(bsp_open(address, &identity, error, sizeof error));
    TEST_ASSERT_EQUAL_STRING(expected, error);
    static const char *const texts[] = {
        "",
        "<Bitfile>",
        "<SignatureRegister></SignatureRegister>",
        "<SignatureRegister>AB</SignatureRegister><BaseAddressOnDevice>x</BaseAddressOnDevice>",
        ("<SignatureRegister>AB</SignatureRegister><BaseAddressOnDevice>99999999999999999999"
         "</BaseAddressOnDevice>"),
        "<SignatureRegister>0123456789012345678901234567890123456789</SignatureRegister>"};
    (void)snprintf(expected, sizeof expected, "The bitfile \"%s\" lacks SignatureRegister or ",
                   path);
    for (uint32_t i = 0U; i < (sizeof texts / sizeof texts[0]); i++) {
        FILE *const file = fopen(path, "we");
        (void)fputs(texts[i], file);
        (void)fclose(file);
        TEST_ASSERT_FALSE(bsp_open(address, &identity, error, sizeof error));
        TEST_ASSERT_EQUAL_MEMORY_MESSAGE(expected, error, strlen(expected), error);
    }
}

void test_SWR_NI_009_a_file_that_ends_anywhere_is_refused_or_is_whole(void)
{
    static char text[32768];
    fpga_world_write(path, &made);
    FILE *file = fopen(path, "re");
    const size_t size = fread(text, 1U, sizeof text, file);
    (void)fclose(file);
    TEST_ASSERT_LESS_THAN_size_t(sizeof text, size);
    for (size_t length = 0U; length < size; length += 97U) {
        file = fopen(path, "we");
        (void)fwrite(text, 1U, length, file);
        (void)fclose(file);
        if (bsp_open(address, &identity, error, sizeof error)) {
            bsp_close();
            TEST_ASSERT_GREATER_THAN_size_t(size - 150U, length);
        }
    }
}

void test_SWR_NI_017_two_registers_of_one_name_are_refused_by_it(void)
{
    static const char *const doubles[][2] = {{"<Name>Confirm<", "PedalA"},
                                             {"<Name>LampFault<", "DrivesPower"},
                                             {"<Name>LampFault<", "OutgoingPacket3"},
                                             {"<Name>LampFault<", "CurrentState3"},
                                             {"<Name>LampMoving<", "LampFault"}};
    for (uint32_t i = 0U; i < (sizeof doubles / sizeof doubles[0]); i++) {
        char expected[200];
        char name[32];
        (void)snprintf(expected, sizeof expected,
                       "The bitfile has two registers \"%s\"; name one of them otherwise in the "
                       "VI, or give another bitfile.",
                       doubles[i][1]);
        (void)snprintf(name, sizeof name, "<Name>%s<", doubles[i][1]);
        write_changed(doubles[i][0], doubles[i][0], name);
        TEST_ASSERT_FALSE(bsp_open(address, &identity, error, sizeof error));
        TEST_ASSERT_EQUAL_STRING(expected, error);
    }
    TEST_ASSERT_EQUAL_UINT32(0U, fpga_world.opened);
}

void test_SWR_NI_018_what_is_no_regular_file_is_refused_without_waiting(void)
{
    char expected[256];
    (void)snprintf(expected, sizeof expected,
                   "The bitfile \"%s\" cannot be read; give the .lvbitx of the box.", path);
    TEST_ASSERT_EQUAL_INT(0, mkfifo(path, 0600));
    (void)alarm(GIVE_UP_S);
    TEST_ASSERT_FALSE(bsp_open(address, &identity, error, sizeof error));
    (void)alarm(0U);
    TEST_ASSERT_EQUAL_STRING(expected, error);
    (void)snprintf(address, sizeof address, "nifpga:RIO0,/tmp");
    TEST_ASSERT_FALSE(bsp_open(address, &identity, error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("The bitfile \"/tmp\" cannot be read; give the .lvbitx of the box.",
                             error);
}

void test_SWR_NI_010_without_nis_library_the_box_does_not_open(void)
{
    fpga_world.is_missing = true;
    expect_refused("libNiFpga.so is not on this computer; this board runs on NI Linux RT only.");
}

void test_SWR_NI_010_a_library_without_an_entry_is_refused_by_its_name(void)
{
    fpga_world.lacks = "NiFpgaDll_ReadArrayU32";
    expect_refused("libNiFpga.so has no NiFpgaDll_ReadArrayU32; install the library that NI "
                   "delivers for this box.");
}

void test_SWR_NI_010_an_fpga_that_refuses_the_bitfile_is_reported_with_its_status(void)
{
    char expected[256];
    fpga_world.refuses = -61206;
    (void)snprintf(expected, sizeof expected,
                   "The FPGA RIO0 does not take the bitfile \"%s\" (NI's status -61206); check its "
                   "name and that the bitfile was made for it.",
                   path);
    expect_refused(expected);
}

void test_SWR_NI_010_closing_resets_the_fpga(void)
{
    open_good_box();
    bsp_close();
    TEST_ASSERT_EQUAL_UINT32(1U, fpga_world.closed);
    TEST_ASSERT_EQUAL_UINT32(0U, fpga_world.libraries);
}

void test_SWR_BSP_007_each_report_has_the_time_at_which_its_packet_began(void)
{
    open_good_box();
    start(OUR_SLOTS);
    finish();
    for (uint32_t slot = FPGA_WORLD_FIRST_SLOT; slot < FPGA_WORLD_END_SLOT; slot++) {
        TEST_ASSERT_TRUE((result.sampled_ns[slot] >= result.started_ns) &&
                         (result.sampled_ns[slot] <= result.finished_ns));
    }
}

void test_SWR_NI_011_each_card_gets_its_packet_and_is_heard(void)
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        fpga_world.cards[slot].takes_looks = slot;
    }
    open_good_box();
    start(OUR_SLOTS);
    finish();
    TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS, result.received);
    TEST_ASSERT_EQUAL_INT32(0, result.error);
    TEST_ASSERT_TRUE(result.started_ns <= result.finished_ns);
    for (uint32_t slot = FPGA_WORLD_FIRST_SLOT; slot < FPGA_WORLD_END_SLOT; slot++) {
        card_report_t report = {.slot = 0U};
        TEST_ASSERT_EQUAL_HEX32(0xFEFEFE01U, fpga_world.cards[slot].sent[0]);
        TEST_ASSERT_EQUAL_HEX32(0x1234U, fpga_world.cards[slot].sent[3]);
        TEST_ASSERT_EQUAL_HEX32(1U, fpga_world.cards[slot].sent[14]);
        TEST_ASSERT_EQUAL_HEX32(0xFFFFFFFFU - (0xFEFEFE01U + 0x1235U),
                                fpga_world.cards[slot].sent[31]);
        TEST_ASSERT_EQUAL(CARD_FRAME_OK, aim32_frame_decode_report(received[slot], &report));
        TEST_ASSERT_EQUAL_INT32((int32_t)(100U * slot), report.encoder_count);
        TEST_ASSERT_EACH_EQUAL_HEX8(0U, &received[slot][128], 128U);
    }
    TEST_ASSERT_EACH_EQUAL_HEX8(0xEEU, received[8], CARD_FRAME_BYTES);
}

void test_SWR_NI_011_only_who_is_asked_is_transacted(void)
{
    open_good_box();
    start(0x08U);
    finish();
    TEST_ASSERT_EQUAL_HEX32(0x08U, result.received);
    TEST_ASSERT_EQUAL_UINT32(1U, fpga_world.cards[3].transacts);
    TEST_ASSERT_EQUAL_UINT32(0U, fpga_world.cards[2].transacts);
    TEST_ASSERT_EQUAL_UINT32(BSP_SLOT_NOT_SENT, result.results[2]);
}

void test_SWR_NI_011_a_card_that_hangs_is_late_then_not_idle_and_never_heard_for_another(void)
{
    open_good_box();
    fpga_world.cards[3].takes_looks = FPGA_WORLD_FOREVER;
    start(OUR_SLOTS);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        fpga_world.cards[slot].busy_looks = (slot == 3U) ? FPGA_WORLD_FOREVER : 0U;
    }
    finish_at_once();
    TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS & ~0x08U, result.received);
    TEST_ASSERT_EQUAL_UINT32(BSP_SLOT_LATE, result.results[3]);
    fpga_world.cards[3].sent[3] = 0U;
    start(OUR_SLOTS);
    TEST_ASSERT_EQUAL_UINT32(1U, fpga_world.cards[3].transacts);
    TEST_ASSERT_EQUAL_HEX32(0U, fpga_world.cards[3].sent[3]);
    fpga_world.cards[3].busy_looks = 0U;
    finish();
    TEST_ASSERT_EQUAL_UINT32(BSP_SLOT_NOT_IDLE, result.results[3]);
    TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS & ~0x08U, result.received);
    start(OUR_SLOTS);
    fpga_world.cards[3].busy_looks = 0U;
    finish();
    TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS, result.received);
}

void test_SWR_NI_011_a_wire_that_stands_still_is_no_answer(void)
{
    open_good_box();
    fpga_world.cards[5].is_dead = true;
    start(OUR_SLOTS);
    finish();
    TEST_ASSERT_EQUAL_UINT32(BSP_SLOT_NO_ANSWER, result.results[5]);
    TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS & ~0x20U, result.received);
}

void test_SWR_NI_011_a_register_that_fails_is_a_bus_error_with_nis_status(void)
{
    const uint32_t failing[] = {
        fpga_world_address(FPGA_OUT, 2U), fpga_world_address(FPGA_IN, 2U) | 0x80000000U,
        fpga_world_address(FPGA_TRANSACT, 2U), fpga_world_address(FPGA_STATE, 2U)};
    open_good_box();
    for (uint32_t i = 0U; i < 4U; i++) {
        fpga_world.broken = failing[i];
        start(OUR_SLOTS);
        finish();
        TEST_ASSERT_EQUAL_UINT32(BSP_SLOT_BUS_ERROR, result.results[2]);
        TEST_ASSERT_EQUAL_INT32(FPGA_WORLD_BROKEN, result.error);
        TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS & ~0x04U, result.received);
        fpga_world.cards[2].busy_looks = 0U;
    }
}

void test_SWR_NI_011_without_an_exchange_nothing_is_received(void)
{
    open_good_box();
    finish();
    TEST_ASSERT_EQUAL_HEX32(0U, result.received);
    TEST_ASSERT_EQUAL_UINT64(0U, result.started_ns);
    TEST_ASSERT_EQUAL_UINT64(0U, result.finished_ns);
}

void test_SWR_NI_013_the_self_test_passes_on_good_cards_and_asks_no_drive(void)
{
    open_good_box();
    TEST_ASSERT_TRUE_MESSAGE(bsp_self_test(error, sizeof error), error);
    TEST_ASSERT_EQUAL_HEX32(0U, fpga_world.cards[1].sent[3]);
    TEST_ASSERT_EQUAL_HEX32(0U, fpga_world.cards[1].sent[14]);
    TEST_ASSERT_EQUAL_UINT32(5U, fpga_world.cards[1].transacts);
}

void test_SWR_NI_013_an_empty_slot_is_fine_and_a_box_without_any_card_is_not(void)
{
    open_good_box();
    fpga_world.cards[6].is_dead = true;
    TEST_ASSERT_TRUE_MESSAGE(bsp_self_test(error, sizeof error), error);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        fpga_world.cards[slot].is_dead = true;
    }
    TEST_ASSERT_FALSE(bsp_self_test(error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("No card answers; check the supply of the cards.", error);
}

static void expect_test_fails(const char *expected)
{
    TEST_ASSERT_FALSE(bsp_self_test(error, sizeof error));
    TEST_ASSERT_EQUAL_STRING(expected, error);
    TEST_ASSERT_EQUAL_UINT8(0U, fpga_world.bits[POWER_BIT]);
}

void test_SWR_NI_013_what_is_wrong_with_a_card_is_named(void)
{
    open_good_box();
    fpga_world.cards[2].is_damaged = true;
    expect_test_fails("The card of slot 2 sends damaged reports (NI's status 0); check its cable.");
    fpga_world.cards[2].is_damaged = false;
    fpga_world.cards[2].flickers = true;
    expect_test_fails(
        "The card of slot 2 answers only sometimes (NI's status 0); check its cable.");
    fpga_world.cards[2].flickers = false;
    fpga_world.broken = fpga_world_address(FPGA_STATE, 2U);
    expect_test_fails("The card of slot 2 cannot be reached through the FPGA (NI's status -61003); "
                      "check its cable.");
    fpga_world.broken = 0U;
    fpga_world.cards[2].takes_looks = FPGA_WORLD_FOREVER;
    expect_test_fails("The card of slot 2 does not come to its state Idle (NI's status 0); check "
                      "its cable.");
}

void test_SWR_NI_014_drives_have_power_after_the_self_test_until_they_are_switched_off(void)
{
    fpga_world.bits[POWER_BIT] = 1U;
    open_good_box();
    TEST_ASSERT_EQUAL_UINT8(0U, fpga_world.bits[POWER_BIT]);
    TEST_ASSERT_TRUE_MESSAGE(bsp_self_test(error, sizeof error), error);
    TEST_ASSERT_EQUAL_UINT8(1U, fpga_world.bits[POWER_BIT]);
    bsp_drives_off();
    TEST_ASSERT_EQUAL_UINT8(0U, fpga_world.bits[POWER_BIT]);
    expect_test_fails("The register DrivesPower cannot be written.");
}

void test_SWR_NI_014_a_box_whose_power_cannot_be_taken_does_not_open(void)
{
    fpga_world.broken = fpga_world_bit(POWER_BIT);
    expect_refused("The register DrivesPower cannot be cleared; check the bitfile and the FPGA.");
    TEST_ASSERT_EQUAL_UINT32(1U, fpga_world.closed);
    fpga_world.broken = 0U;
    open_good_box();
}

void test_SWR_NI_014_switching_off_before_a_box_is_open_does_nothing(void)
{
    bsp_drives_off();
    TEST_ASSERT_EQUAL_UINT32(0U, fpga_world.writes[POWER_BIT]);
}

void test_SWR_NI_014_each_kick_changes_the_register_that_the_fpga_watches(void)
{
    open_good_box();
    for (uint32_t i = 0U; i < 4U; i++) {
        const uint8_t before = fpga_world.bits[ALIVE_BIT];
        bsp_kick();
        TEST_ASSERT_NOT_EQUAL(before, fpga_world.bits[ALIVE_BIT]);
    }
}

void test_SWR_NI_015_inputs_are_read_and_what_is_not_is_not_valid(void)
{
    bsp_inputs_t inputs;
    made.without = "Confirm";
    fpga_world.bits[0] = 1U;
    open_good_box();
    bsp_sample_inputs(&inputs);
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_PEDAL_A | BSP_IN_ESTOP_CHAIN | BSP_IN_SCANNER_IDLE,
                            inputs.levels);
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_ALL & ~BSP_IN_CONFIRM, inputs.valid);
    TEST_ASSERT_EQUAL_HEX32(0U, inputs.dropped);
    fpga_world.broken = fpga_world_bit(2U);
    bsp_sample_inputs(&inputs);
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_PEDAL_A | BSP_IN_SCANNER_IDLE, inputs.levels);
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_ALL & ~(BSP_IN_CONFIRM | BSP_IN_ESTOP_CHAIN), inputs.valid);
}

void test_SWR_NI_015_lamps_are_written_when_they_change(void)
{
    open_good_box();
    bsp_set_lamps(BSP_LAMP_ALIVE | BSP_LAMP_MOVING);
    bsp_set_lamps(BSP_LAMP_ALIVE | BSP_LAMP_MOVING);
    TEST_ASSERT_EQUAL_UINT8(1U, fpga_world.bits[LAMP_BIT]);
    TEST_ASSERT_EQUAL_UINT8(0U, fpga_world.bits[LAMP_BIT + 1U]);
    TEST_ASSERT_EQUAL_UINT8(1U, fpga_world.bits[LAMP_BIT + 2U]);
    TEST_ASSERT_EQUAL_UINT32(1U, fpga_world.writes[LAMP_BIT]);
    bsp_set_lamps(0U);
    TEST_ASSERT_EQUAL_UINT8(0U, fpga_world.bits[LAMP_BIT]);
}

void test_SWR_NI_015_time_goes_on_and_sleep_lasts(void)
{
    const uint64_t before_ns = bsp_now_ns();
    bsp_sleep_until_ns(before_ns + NS_PER_MS);
    TEST_ASSERT_TRUE(bsp_reached_ns() >= before_ns + NS_PER_MS);
}

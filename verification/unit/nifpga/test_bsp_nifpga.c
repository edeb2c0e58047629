/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the board finds every register by its name in the bitfile, names what is
 * missing, and refuses a bitfile or a library that does not fit. Below is a library in NI's place.
 */
#include "unity.h"

#include "bsp.h"

#include "unit/support/fpga_world.h"

#include <sys/stat.h>
#include <unistd.h>

#include "unit/nifpga/nifpga_world.inc"

#define WHO "does not say who accepts the cards, and when (\"A. Engineer, 2026-11-23\")"
#define GIVE_UP_S 60U

void setUp(void)
{
    begin_nifpga();
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

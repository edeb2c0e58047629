/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the key of the box is made once, whole, for its owner alone, and seals every bit
 * of a record. */
#include "unity.h"

#include "positions/position_record.h"
#include "saved/saved_seal.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[40];
static char path[64];
static char error[256];
static saved_key_t key;
static saved_key_t other;
static position_record_t record;

void setUp(void)
{
    (void)strcpy(folder, "/tmp/test-seal-XXXXXX");
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    (void)snprintf(path, sizeof path, "%s/key", folder);
    error[0] = '\0';
    (void)memset(&key, 0, sizeof key);
    record = (position_record_t){.utc_us = 1700000000000000U, .power_on = 7U, .robot_crc = 9U};
}

void tearDown(void)
{
    (void)chmod(folder, 0700);
    (void)unlink(path);
    (void)rmdir(path);
    (void)rmdir(folder);
}

static bool open_key(saved_key_t *self)
{
    return saved_key_open(self, path, error, sizeof error);
}

static void write_key(size_t size, mode_t mode)
{
    FILE *file = fopen(path, "w");
    TEST_ASSERT_NOT_NULL(file);
    for (size_t i = 0U; i < size; i++) {
        (void)fputc((int)i, file);
    }
    (void)fclose(file);
    TEST_ASSERT_EQUAL_INT(0, chmod(path, mode));
}

static void expect_refused(const char *words)
{
    TEST_ASSERT_FALSE(open_key(&key));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, words), error);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, path), error);
}

void test_SWR_STORE_025_the_key_is_made_once_for_its_owner_alone(void)
{
    struct stat made;
    TEST_ASSERT_TRUE_MESSAGE(open_key(&key), error);
    TEST_ASSERT_EQUAL_INT(0, stat(path, &made));
    TEST_ASSERT_EQUAL_HEX32(0600U, made.st_mode & 07777U);
    TEST_ASSERT_EQUAL_INT(SAVED_KEY_SIZE, made.st_size);
    TEST_ASSERT_TRUE(open_key(&other));
    TEST_ASSERT_EQUAL_MEMORY(&key, &other, sizeof key);
    TEST_ASSERT_EQUAL_INT(0, unlink(path));
    TEST_ASSERT_TRUE(open_key(&other));
    TEST_ASSERT_NOT_EQUAL(0, memcmp(&key, &other, sizeof key));
}

void test_SWR_STORE_025_a_draft_that_was_left_is_no_hindrance(void)
{
    char draft[80];
    (void)snprintf(draft, sizeof draft, "%s.new", path);
    FILE *file = fopen(draft, "w");
    TEST_ASSERT_NOT_NULL(file);
    (void)fclose(file);
    TEST_ASSERT_TRUE_MESSAGE(open_key(&key), error);
    TEST_ASSERT_NOT_EQUAL(0, access(draft, F_OK));
}

void test_SWR_STORE_025_a_key_that_others_can_read_is_refused(void)
{
    write_key(SAVED_KEY_SIZE, 0640);
    expect_refused("chmod 600");
    TEST_ASSERT_EQUAL_INT(0, chmod(path, 0600));
    TEST_ASSERT_TRUE_MESSAGE(open_key(&key), error);
    TEST_ASSERT_EQUAL_UINT8(31U, key.bytes[31]);
}

void test_SWR_STORE_025_a_key_of_another_length_is_refused(void)
{
    write_key(SAVED_KEY_SIZE - 1U, 0600);
    expect_refused("damaged");
    write_key(SAVED_KEY_SIZE + 1U, 0600);
    expect_refused("damaged");
}

void test_SWR_STORE_025_what_is_no_file_is_refused(void)
{
    TEST_ASSERT_EQUAL_INT(0, mkfifo(path, 0600));
    expect_refused("no file");
    TEST_ASSERT_EQUAL_INT(0, unlink(path));
    TEST_ASSERT_EQUAL_INT(0, symlink("elsewhere", path));
    expect_refused(":");
    TEST_ASSERT_EQUAL_INT(0, unlink(path));
    TEST_ASSERT_EQUAL_INT(0, mkdir(path, 0700));
    expect_refused("no file");
}

void test_SWR_STORE_025_where_no_key_can_be_made_that_is_said(void)
{
    TEST_ASSERT_EQUAL_INT(0, rmdir(folder));
    expect_refused("No such file");
    TEST_ASSERT_EQUAL_INT(0, mkdir(folder, 0700));
}

void test_SWR_STORE_026_the_seal_is_that_of_the_standard(void)
{
    /* HMAC-SHA-256 over the bytes of the record, with the key 00 01 .. 1f. */
    uint8_t seal[SAVED_SEAL_SIZE];
    uint8_t again[SAVED_SEAL_SIZE];
    write_key(SAVED_KEY_SIZE, 0600);
    TEST_ASSERT_TRUE(open_key(&key));
    TEST_ASSERT_TRUE(saved_seal_make(&key, &record, seal));
    TEST_ASSERT_TRUE(saved_seal_make(&key, &record, again));
    TEST_ASSERT_EQUAL_MEMORY(seal, again, sizeof seal);
    TEST_ASSERT_TRUE(saved_seal_fits(&key, &record, seal));
    static const uint8_t wanted[] = {0x9b, 0xd2, 0xb8, 0xca, 0x33, 0xc8, 0x33, 0x31,
                                     0xc5, 0x2f, 0x9c, 0x2c, 0x7a, 0x89, 0x93, 0x60,
                                     0xf0, 0xc6, 0xfc, 0x76, 0x3b, 0xec, 0xab, 0xc4,
                                     0x71, 0xf6, 0x82, 0x1d, 0xe9, 0x47, 0xd0, 0xd3};
    TEST_ASSERT_EQUAL_HEX8_ARRAY(wanted, seal, sizeof wanted);
}

static void expect_broken(const uint8_t *seal)
{
    TEST_ASSERT_FALSE(saved_seal_fits(&key, &record, seal));
}

void test_SWR_STORE_026_whatever_is_changed_breaks_the_seal(void)
{
    uint8_t seal[SAVED_SEAL_SIZE];
    TEST_ASSERT_TRUE(open_key(&key));
    TEST_ASSERT_TRUE(saved_seal_make(&key, &record, seal));
    record.utc_us++;
    expect_broken(seal);
    record.utc_us--;
    record.power_on++;
    expect_broken(seal);
    record.power_on--;
    record.robot_crc++;
    expect_broken(seal);
    record.robot_crc--;
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        record.axes[i].position_ticks++;
        expect_broken(seal);
        record.axes[i].position_ticks--;
        record.axes[i].reading_ticks++;
        expect_broken(seal);
        record.axes[i].reading_ticks--;
        record.axes[i].grade++;
        expect_broken(seal);
        record.axes[i].grade--;
    }
    for (uint32_t i = 0U; i < SAVED_SEAL_SIZE; i++) {
        seal[i] ^= 1U;
        expect_broken(seal);
        seal[i] ^= 1U;
    }
    TEST_ASSERT_TRUE(saved_seal_fits(&key, &record, seal));
    key.bytes[31] ^= 1U;
    expect_broken(seal);
}

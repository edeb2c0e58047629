/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a file of accounts is read whole or refused with its line, no other user may
 * read it, and it changes all at once. */
#include "unity.h"

#include "http/login/account.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define HASH "$y$j9T$F5Jx5fExrKuPp53xLKQ..1$X3DX6M94c7o.9agCG9G317fhZg9SqC.5i5rd.RhAtQ7"

static accounts_t accounts;
static char error[256];
static char folder[] = "/tmp/accounts-XXXXXX";
static char file[64];

void setUp(void)
{
    (void)memcpy(&folder[sizeof folder - 7U], "XXXXXX", 6U);
    TEST_ASSERT_NOT_NULL(mkdtemp(folder));
    (void)snprintf(file, sizeof file, "%s/accounts", folder);
    error[0] = '\0';
}

void tearDown(void)
{
    (void)unlink(file);
    (void)rmdir(folder);
}

static bool parse(const char *text)
{
    return accounts_parse(&accounts, "F", text, strlen(text), error, sizeof error);
}

static void write_file(const char *text, mode_t mode)
{
    FILE *stream = fopen(file, "w");
    TEST_ASSERT_NOT_NULL(stream);
    (void)fputs(text, stream);
    (void)fclose(stream);
    TEST_ASSERT_EQUAL_INT(0, chmod(file, mode));
}

void test_SWR_SESS_001_accounts_are_read_with_their_roles(void)
{
    TEST_ASSERT_TRUE(parse("# who\n\nanna:operator:" HASH "\nb-2_:service:" HASH));
    TEST_ASSERT_EQUAL_UINT32(2U, accounts.count);
    TEST_ASSERT_EQUAL_INT(ROLE_OPERATOR, accounts_find(&accounts, "anna")->role);
    TEST_ASSERT_EQUAL_STRING(HASH, accounts_find(&accounts, "b-2_")->hash);
    TEST_ASSERT_NULL(accounts_find(&accounts, "b-2"));
    TEST_ASSERT_TRUE(parse(""));
    TEST_ASSERT_EQUAL_UINT32(0U, accounts.count);
}

void test_SWR_SESS_001_what_is_no_account_is_refused_with_its_line(void)
{
    static const char *const wrong[] = {
        "anna:operator",
        "anna:operator:" HASH ":",
        ":operator:" HASH,
        "Anna:operator:" HASH,
        "an na:operator:" HASH,
        "a234567890123456789012345678901b:operator:" HASH,
        "anna:Operator:" HASH,
        "anna::" HASH,
        "anna:operator:",
        "anna:operator:$y$",
        "anna:operator:$6$abc$def",
        "anna:operator:" HASH " ",
        "anna:operator:" HASH "\r",
        "anna:operator:" HASH HASH,
        " # comment",
    };
    for (size_t i = 0U; i < (sizeof wrong / sizeof wrong[0]); i++) {
        char text[512];
        (void)snprintf(text, sizeof text, "first:observer:" HASH "\n%s\n", wrong[i]);
        TEST_ASSERT_FALSE_MESSAGE(parse(text), wrong[i]);
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(error, "F, line 2: "), error);
        TEST_ASSERT_EQUAL_UINT32(0U, accounts.count);
    }
}

void test_SWR_SESS_001_a_name_stands_there_once(void)
{
    TEST_ASSERT_FALSE(parse("anna:observer:" HASH "\nanna:service:" HASH "\n"));
    TEST_ASSERT_EQUAL_STRING("F, line 2: the name stands there a second time.", error);
}

void test_SWR_SESS_001_a_nul_and_a_long_line_are_refused(void)
{
    static const char text[] = "anna:observer:" HASH "\0x\n";
    char line[400];
    TEST_ASSERT_FALSE(accounts_parse(&accounts, "F", text, sizeof text - 1U, error, sizeof error));
    (void)memset(line, '#', sizeof line);
    TEST_ASSERT_FALSE(accounts_parse(&accounts, "F", line, sizeof line, error, sizeof error));
}

void test_SWR_SESS_001_there_are_so_many_accounts(void)
{
    char text[ACCOUNTS_FILE_SIZE] = "";
    for (unsigned i = 0U; i <= LIMIT_ACCOUNTS; i++) {
        TEST_ASSERT_EQUAL(i <= LIMIT_ACCOUNTS, parse(text));
        (void)snprintf(&text[strlen(text)], sizeof text - strlen(text), "a%u:observer:" HASH "\n",
                       i);
    }
    TEST_ASSERT_FALSE(parse(text));
    TEST_ASSERT_EQUAL_STRING("F, line 33: there are too many accounts.", error);
}

void test_SWR_SESS_002_a_file_that_others_may_read_or_write_is_refused(void)
{
    static const mode_t wrong[] = {0640, 0604, 0620, 0602, 0610, 0777};
    for (size_t i = 0U; i < (sizeof wrong / sizeof wrong[0]); i++) {
        write_file("anna:operator:" HASH "\n", wrong[i]);
        TEST_ASSERT_FALSE(accounts_read(&accounts, file, error, sizeof error));
        TEST_ASSERT_NOT_NULL(strstr(error, "chmod 600"));
        TEST_ASSERT_EQUAL_UINT32(0U, accounts.count);
    }
    write_file("anna:operator:" HASH "\n", 0600);
    TEST_ASSERT_TRUE(accounts_read(&accounts, file, error, sizeof error));
    TEST_ASSERT_EQUAL_UINT32(1U, accounts.count);
}

void test_SWR_SESS_002_what_is_no_file_is_refused(void)
{
    TEST_ASSERT_FALSE(accounts_read(&accounts, file, error, sizeof error));
    TEST_ASSERT_NOT_NULL(strstr(error, "cannot be read"));
    TEST_ASSERT_FALSE(accounts_read(&accounts, folder, error, sizeof error));
}

void test_SWR_SESS_001_a_long_file_is_refused(void)
{
    char text[ACCOUNTS_FILE_SIZE + 2U];
    (void)memset(text, '\n', sizeof text);
    text[sizeof text - 1U] = '\0';
    write_file(text, 0600);
    TEST_ASSERT_FALSE(accounts_read(&accounts, file, error, sizeof error));
    TEST_ASSERT_NOT_NULL(strstr(error, "longer than 8192 bytes"));
    text[sizeof text - 2U] = '\0';
    write_file(text, 0600);
    TEST_ASSERT_TRUE(accounts_read(&accounts, file, error, sizeof error));
}

void test_SWR_SESS_004_what_is_written_is_read_again_by_its_owner_alone(void)
{
    struct stat about;
    accounts_t again;
    write_file("", 0644);
    TEST_ASSERT_TRUE(parse("anna:operator:" HASH "\nbert:observer:" HASH "\n"));
    account_t anna = *accounts_find(&accounts, "anna");
    anna.role = ROLE_ENGINEER;
    TEST_ASSERT_TRUE(accounts_put(&accounts, &anna));
    TEST_ASSERT_TRUE(accounts_remove(&accounts, "bert"));
    TEST_ASSERT_FALSE(accounts_remove(&accounts, "bert"));
    TEST_ASSERT_TRUE(accounts_write(&accounts, file, error, sizeof error));
    TEST_ASSERT_TRUE(accounts_read(&again, file, error, sizeof error));
    TEST_ASSERT_EQUAL_UINT32(1U, again.count);
    TEST_ASSERT_EQUAL_INT(ROLE_ENGINEER, accounts_find(&again, "anna")->role);
    TEST_ASSERT_EQUAL_INT(0, stat(file, &about));
    TEST_ASSERT_EQUAL_UINT32(0600U, about.st_mode & 0777U);
}

void test_SWR_SESS_004_what_cannot_be_written_leaves_the_old_file(void)
{
    char draft[80];
    write_file("anna:operator:" HASH "\n", 0600);
    (void)snprintf(draft, sizeof draft, "%s.new", file);
    TEST_ASSERT_EQUAL_INT(0, mkdir(draft, 0700));
    TEST_ASSERT_TRUE(parse(""));
    TEST_ASSERT_FALSE(accounts_write(&accounts, file, error, sizeof error));
    TEST_ASSERT_EQUAL_INT(0, rmdir(draft));
    TEST_ASSERT_TRUE(accounts_read(&accounts, file, error, sizeof error));
    TEST_ASSERT_EQUAL_UINT32(1U, accounts.count);
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a file says what a command line would; the command line wins, and what is wrong
 * is refused with its line.
 */
#include "unity.h"

#include "common/command_line.h"
#include "common/config_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define TEXT_SIZE 2048U

enum { NAME = 0, TIMES, IS_DRY, ASKS, OPTIONS };

static const command_option_t options[OPTIONS] = {
    [NAME] = {"name", "NAME", .says = "what it is called"},
    [TIMES] = {"times", "NUMBER", .says = "how often", .least = 2U, .most = 9U},
    [IS_DRY] = {"dry", NULL, .says = "nothing is done"},
    [ASKS] = {"ask", NULL, .says = "asks", .is_by_hand = true},
};
static const command_line_t line = {
    .program = "any", .says = "", .usage = "", .options = options, .count = OPTIONS};

static char path[] = "/tmp/test_config_file_XXXXXX";
static const char *values[OPTIONS];
static config_file_t config;
static char errors[TEXT_SIZE];

void setUp(void)
{
    (void)memset(values, 0, sizeof values);
    (void)strcpy(&path[sizeof path - 7U], "XXXXXX");
    (void)close(mkstemp(path));
}

void tearDown(void)
{
    (void)unlink(path);
}

/* The standard error is in `errors` afterwards. */
static int read_path(const char *file)
{
    FILE *const said = tmpfile();
    const int before = dup(STDERR_FILENO);

    (void)dup2(fileno(said), STDERR_FILENO);
    const int code = config_file_read(&config, file, &line, values);
    (void)fflush(stderr);
    (void)dup2(before, STDERR_FILENO);
    (void)close(before);
    rewind(said);
    errors[fread(errors, 1U, sizeof errors - 1U, said)] = '\0';
    (void)fclose(said);
    return code;
}

static int read_file(const char *text)
{
    FILE *const file = fopen(path, "w");

    (void)fputs(text, file);
    (void)fclose(file);
    return read_path(path);
}

static void assert_refused(const char *text, const char *sentence)
{
    char whole[TEXT_SIZE];

    TEST_ASSERT_EQUAL_INT(COMMAND_LINE_WRONG, read_file(text));
    (void)snprintf(whole, sizeof whole, "any: %s, %s See any --help.\n", path, sentence);
    TEST_ASSERT_EQUAL_STRING(whole, errors);
}

void test_SWR_PACK_001_each_line_is_an_option_of_the_command_line(void)
{
    TEST_ASSERT_EQUAL_INT(COMMAND_LINE_GO_ON,
                          read_file("# how it is\n\n  name \t of two words \r\ntimes 3\n \ndry"));
    TEST_ASSERT_EQUAL_STRING("of two words", values[NAME]);
    TEST_ASSERT_EQUAL_STRING("3", values[TIMES]);
    TEST_ASSERT_NOT_NULL(values[IS_DRY]);
    TEST_ASSERT_NULL(values[ASKS]);
    TEST_ASSERT_EQUAL_STRING("", errors);
}

void test_SWR_PACK_001_the_command_line_wins(void)
{
    values[NAME] = "said";
    TEST_ASSERT_EQUAL_INT(COMMAND_LINE_GO_ON, read_file("name written\ntimes 4\n"));
    TEST_ASSERT_EQUAL_STRING("said", values[NAME]);
    TEST_ASSERT_EQUAL_STRING("4", values[TIMES]);
}

void test_SWR_PACK_001_what_is_no_option_is_refused_with_its_line(void)
{
    assert_refused("\nnome x\n", "line 2: \"nome\" is no option of this file.");
    assert_refused("name=x\n", "line 1: \"name=x\" is no option of this file.");
    assert_refused("--name x\n", "line 1: \"--name\" is no option of this file.");
    assert_refused("help\n", "line 1: \"help\" is no option of this file.");
    assert_refused("ask\n", "line 1: \"ask\" is no option of this file.");
}

void test_SWR_PACK_001_what_is_no_value_is_refused_with_its_line(void)
{
    assert_refused("times 10\n", "line 1: \"10\" is no number for --times; give one from 2 to 9.");
    assert_refused("name\n", "line 1: --name lacks its value, NAME.");
    assert_refused("dry yes\n", "line 1: --dry takes no value.");
}

void test_SWR_PACK_001_what_stands_there_twice_is_refused(void)
{
    assert_refused("name a\n#\nname a\n", "line 3: \"name\" stands there twice.");
}

/* The longest one is whole. */
void test_SWR_PACK_001_a_line_that_is_too_long_is_refused(void)
{
    char text[CONFIG_FILE_LINE_SIZE + 8U];

    (void)memset(text, 'x', sizeof text);
    (void)memcpy(text, "name ", 5U);
    text[sizeof text - 1U] = '\0';
    assert_refused(text, "line 1: It is too long.");
    text[CONFIG_FILE_LINE_SIZE - 6U] = '\0';
    TEST_ASSERT_EQUAL_INT(COMMAND_LINE_GO_ON, read_file(text));
    TEST_ASSERT_EQUAL_UINT(CONFIG_FILE_LINE_SIZE - 11U, strlen(values[NAME]));
}

void test_SWR_PACK_001_a_file_that_cannot_be_read_is_reported(void)
{
    TEST_ASSERT_EQUAL_INT(COMMAND_LINE_WRONG, read_path("/none"));
    TEST_ASSERT_EQUAL_STRING("any: The file /none cannot be read (No such file or directory). See "
                             "any --help.\n",
                             errors);
}

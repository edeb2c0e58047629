/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a program gets what it was given or learns that it has no more to do; help and
 * version are answers, a wrong word is refused by name, and each stream hears only what is its own.
 */
#include "unity.h"

#include "common/command_line.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define TEXT_SIZE 1024U
#define WORDS 8U

enum { NAME = 0, TIMES, IS_DRY, OPTIONS };

static const command_option_t options[OPTIONS] = {
    [NAME] = {"name", "NAME", .says = "what it is called", .is_needed = true},
    [TIMES] = {"times", "NUMBER", .says = "how often; default 3", .least = 2U, .most = 9U},
    [IS_DRY] = {"this-is-only-tried", NULL, .says = "nothing is done"},
};
static const command_line_t line = {.program = "any",
                                    .says = "Does anything.",
                                    .usage = "--name NAME FILE\n--this-is-only-tried",
                                    .options = options,
                                    .count = OPTIONS,
                                    .fewest_words = 0,
                                    .most_words = 1,
                                    .more = "That is all.\n"};

static const char *values[OPTIONS];
static int first;
static char output[TEXT_SIZE];
static char errors[TEXT_SIZE];

void setUp(void)
{
    first = -1;
}

void tearDown(void)
{
}

/* Sends what is written to `stream` into a file instead; returns where it went before. */
static int divert(FILE *stream, FILE *file)
{
    (void)fflush(stream);
    const int before = dup(fileno(stream));
    (void)dup2(fileno(file), fileno(stream));
    return before;
}

static void restore(FILE *stream, int before, FILE *file, char text[TEXT_SIZE])
{
    (void)fflush(stream);
    (void)dup2(before, fileno(stream));
    (void)close(before);
    rewind(file);
    text[fread(text, 1U, TEXT_SIZE - 1U, file)] = '\0';
    (void)fclose(file);
}

/* The words are those after the program's, separated by spaces. */
static int read_line(const command_line_t *self, const char *given)
{
    static char text[TEXT_SIZE];
    static char program[] = "any";
    char *words[WORDS + 1U] = {program};
    int count = 1;
    FILE *const files[2] = {tmpfile(), tmpfile()};

    (void)snprintf(text, sizeof text, "%s", given);
    for (char *word = strtok(text, " "); word != NULL; word = strtok(NULL, " ")) {
        words[count] = word;
        count++;
    }
    const int out = divert(stdout, files[0]);
    const int err = divert(stderr, files[1]);
    const int code = command_line_read(self, count, words, values, &first);
    restore(stdout, out, files[0], output);
    restore(stderr, err, files[1], errors);
    return code;
}

static void expect_refused(const char *given, const char *sentence)
{
    char expected[TEXT_SIZE];

    (void)snprintf(expected, sizeof expected, "any: %s See any --help.\n", sentence);
    TEST_ASSERT_EQUAL_INT_MESSAGE(2, read_line(&line, given), given);
    TEST_ASSERT_EQUAL_STRING(expected, errors);
    TEST_ASSERT_EQUAL_STRING("", output);
}

void test_SWR_RUN_001_help_says_what_the_program_does_and_takes(void)
{
    static const char *const asked[] = {"-h", "--help", "--name x --help", "-h --nonsense"};

    for (size_t i = 0U; i < (sizeof asked / sizeof asked[0]); i++) {
        TEST_ASSERT_EQUAL_INT(0, read_line(&line, asked[i]));
        TEST_ASSERT_EQUAL_STRING("Does anything.\n"
                                 "\n"
                                 "usage: any --name NAME FILE\n"
                                 "       any --this-is-only-tried\n"
                                 "\n"
                                 "  --name NAME           what it is called (needed)\n"
                                 "  --times NUMBER        how often; default 3\n"
                                 "  --this-is-only-tried  nothing is done\n"
                                 "  -h, --help            say this\n"
                                 "  --version             say which version and build this is\n"
                                 "\n"
                                 "That is all.\n",
                                 output);
        TEST_ASSERT_EQUAL_STRING("", errors);
    }
}

void test_SWR_RUN_001_what_is_too_wide_for_its_column_has_a_line_of_its_own(void)
{
    static const command_option_t wide[] = {
        {"this-is-only-tried-with", "NAME", .says = "nothing is done"}};
    const command_line_t self = {
        .program = "any", .usage = "", .says = "", .options = wide, .count = 1U};

    TEST_ASSERT_EQUAL_INT(0, read_line(&self, "--help"));
    TEST_ASSERT_NOT_NULL(strstr(output, "\n  --this-is-only-tried-with NAME\n"
                                        "                        nothing is done\n"));
}

void test_SWR_RUN_001_version_says_program_version_and_build(void)
{
    char version[32];
    char build[32];
    char reported[96];

    TEST_ASSERT_EQUAL_INT(0, read_line(&line, "--version"));
    TEST_ASSERT_EQUAL_INT(2, sscanf(output, "any %31s (build %31[^)])", version, build));
    (void)snprintf(reported, sizeof reported, "any %s (build %s)\n", version, build);
    TEST_ASSERT_EQUAL_STRING(reported, output);
    TEST_ASSERT_EQUAL_STRING("", errors);
}

void test_SWR_RUN_002_what_was_given_is_handed_over(void)
{
    static const char *const ways[] = {"--name x --times 9 --this-is-only-tried --no-option",
                                       "--times=9 --this-is-only-tried --name=x y"};

    TEST_ASSERT_EQUAL_INT(COMMAND_LINE_GO_ON, read_line(&line, ways[1]));
    TEST_ASSERT_EQUAL_STRING("x", values[NAME]);
    TEST_ASSERT_EQUAL_STRING("9", values[TIMES]);
    TEST_ASSERT_EQUAL_STRING("--this-is-only-tried", values[IS_DRY]);
    TEST_ASSERT_EQUAL_INT(4, first);
    TEST_ASSERT_EQUAL_STRING("", errors);
    TEST_ASSERT_EQUAL_INT(2, read_line(&line, ways[0]));
}

void test_SWR_RUN_002_a_missing_value_is_distinguished_from_an_empty_one(void)
{
    TEST_ASSERT_EQUAL_INT(COMMAND_LINE_GO_ON, read_line(&line, "--name= -"));
    TEST_ASSERT_EQUAL_STRING("", values[NAME]);
    TEST_ASSERT_NULL(values[TIMES]);
    TEST_ASSERT_NULL(values[IS_DRY]);
    TEST_ASSERT_EQUAL_INT(2, first);
}

void test_SWR_RUN_002_a_value_may_look_like_an_option_and_the_last_one_counts(void)
{
    TEST_ASSERT_EQUAL_INT(COMMAND_LINE_GO_ON, read_line(&line, "--name a --name --times"));
    TEST_ASSERT_EQUAL_STRING("--times", values[NAME]);
    TEST_ASSERT_NULL(values[TIMES]);
}

void test_SWR_RUN_002_what_is_no_option_is_named(void)
{
    expect_refused("--nonsense", "\"--nonsense\" is no option.");
    expect_refused("--nam x", "\"--nam\" is no option.");
    expect_refused("--names x", "\"--names\" is no option.");
    expect_refused("-name x", "\"-name\" is no option.");
    expect_refused("-=", "\"-=\" is no option.");
    expect_refused("--", "\"--\" is no option.");
    expect_refused("--help=yes", "\"--help=yes\" is no option.");
}

void test_SWR_RUN_002_what_lacks_or_has_a_value_is_named(void)
{
    expect_refused("--name", "--name lacks its value, NAME.");
    expect_refused("--name x --this-is-only-tried=yes", "--this-is-only-tried takes no value.");
    expect_refused("--times 2", "--name NAME is missing.");
    expect_refused("--name x y z", "\"z\" is not expected here.");
}

void test_SWR_RUN_002_a_number_is_one_in_its_bounds(void)
{
    static const char *const wrong[] = {"1",  "10", "",    "3x",
                                        "-3", "+3", "0x3", "18446744073709551619"};
    char given[64];
    char sentence[128];

    for (size_t i = 0U; i < (sizeof wrong / sizeof wrong[0]); i++) {
        (void)snprintf(given, sizeof given, "--times=%s", wrong[i]);
        (void)snprintf(sentence, sizeof sentence,
                       "\"%s\" is no number for --times; give one from 2 to 9.", wrong[i]);
        expect_refused(given, sentence);
    }
    TEST_ASSERT_EQUAL_INT(COMMAND_LINE_GO_ON, read_line(&line, "--name x --times 2"));
}

void test_SWR_RUN_002_words_that_are_needed_are_missed(void)
{
    const command_line_t self = {.program = "any", .fewest_words = 2, .most_words = 3};

    TEST_ASSERT_EQUAL_INT(2, read_line(&self, "one"));
    TEST_ASSERT_EQUAL_STRING("any: Something is missing. See any --help.\n", errors);
    TEST_ASSERT_EQUAL_INT(COMMAND_LINE_GO_ON, read_line(&self, "one -two --three"));
    TEST_ASSERT_EQUAL_INT(1, first);
}

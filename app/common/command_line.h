/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The command line of a program, in one style for all of them: options first, each `--name`,
 * `--name VALUE` or `--name=VALUE`, then the other words that the program takes.
 */
#ifndef BORESIGHT_COMMAND_LINE_H
#define BORESIGHT_COMMAND_LINE_H

#include <limits.h>
#include <stdbool.h>
#include <stdint.h>

#define COMMAND_LINE_GO_ON (-1)   /**< The program has something to do. */
#define COMMAND_LINE_WRONG 2      /**< Exit code of each program for a wrong command line. */
#define COMMAND_LINE_MANY INT_MAX /**< Number of words: without a bound. */

/** An option. */
typedef struct {
    const char *name;  /**< Without its hyphens. */
    const char *value; /**< Name of its value in the help; NULL: it takes none. */
    const char *says;  /**< Its purpose, with its default. */
    uint32_t least;    /**< Least number, with `most`. */
    uint32_t most;     /**< 0: its value is any text. */
    bool is_needed;
    bool is_by_hand; /**< It stands in no file of options. */
} command_option_t;

/** A program. */
typedef struct {
    const char *program;             /**< As it is called: "boresight-http". */
    const char *says;                /**< Its purpose, a sentence. */
    const char *usage;               /**< Words behind its name, a line for each way to call it. */
    const command_option_t *options; /**< Without help and version, which each program has. */
    uint32_t count;                  /**< Number of options. */
    int fewest_words;                /**< After the options. */
    int most_words;
    const char *more;  /**< Further lines of its help; NULL: none. */
    const char *place; /**< Where the words stand that are refused; NULL: on a command line. */
} command_line_t;

/**
 * Reads `words` as main() gets them, or answers what is asked of every program: `-h` and `--help`
 * its help, `--version` its name, version and build, on the standard output; a wrong option a
 * sentence on the standard error.
 *
 * `values` holds as many as there are options: the value of each, the option itself where it takes
 * none, NULL where it was not given. `*first` is the place of the first word after the options;
 * NULL where a program takes none.
 *
 * @return COMMAND_LINE_GO_ON, or the exit code of a program that has no more to do: 0 or
 *         COMMAND_LINE_WRONG
 *
 * @satisfies SWR-RUN-001
 * @satisfies SWR-RUN-002
 */
int command_line_read(const command_line_t *self, int count, char *const words[],
                      const char *values[], int *first);

/**
 * Takes the option at `words[*at]` into `values`, and sets `*at` behind it and its value; `words`
 * ends with NULL.
 *
 * @return COMMAND_LINE_GO_ON, or COMMAND_LINE_WRONG after a sentence on the standard error
 */
int command_line_take(const command_line_t *self, char *const words[], int *at,
                      const char *values[]);

/**
 * Says a sentence about what was given, which ends with a full stop, and where there is help.
 *
 * @return COMMAND_LINE_WRONG
 */
int command_line_refuse(const command_line_t *self, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/** Whether `text` is a decimal number from `least` to `most`. */
bool command_line_is_number(const char *text, uint32_t least, uint32_t most);

#endif

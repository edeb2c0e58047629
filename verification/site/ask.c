/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The server of a page in native code, asked as served.mjs asks that of served.wasm; what comes out
 * must be the same bytes.
 *
 *     served-ask <CALLS
 *
 * A call is a line, and behind `start` and `ask` the bytes that it counts: `start SEED UTC SIZE`,
 * `step CYCLES`, `ask SIZE`, `listen`. Printed is of each but `step` the size of the answer, a line
 * feed, and the answer.
 */
#include "site/served/served.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void take_text(uint32_t size)
{
    if ((size >= served_text_size()) || (fread(served_text(), 1U, size, stdin) != size)) {
        (void)fprintf(stderr, "served-ask: %" PRIu32 " bytes are missing or too many.\n", size);
        exit(EXIT_FAILURE);
    }
    served_text()[size] = '\0';
}

static void print_answer(uint32_t size)
{
    (void)printf("%" PRIu32 "\n", size);
    (void)fwrite(served_answer(), 1U, size, stdout);
}

static void start(uint32_t seed, uint32_t utc_s, uint32_t size)
{
    take_text(size);
    if (!served_start(seed, utc_s)) {
        (void)fprintf(stderr, "served-ask: there is no robot %s\n", served_text());
        exit(EXIT_FAILURE);
    }
    print_answer((uint32_t)strlen(served_answer()));
}

static void call(const char *line)
{
    uint32_t numbers[3] = {0U, 0U, 0U};

    (void)sscanf(line, "%*s %" SCNu32 " %" SCNu32 " %" SCNu32, &numbers[0], &numbers[1],
                 &numbers[2]);
    if (strncmp(line, "start", 5U) == 0) {
        start(numbers[0], numbers[1], numbers[2]);
    } else if (strncmp(line, "step", 4U) == 0) {
        served_step(numbers[0]);
    } else if (strncmp(line, "ask", 3U) == 0) {
        take_text(numbers[0]);
        print_answer(served_ask(numbers[0]));
    } else {
        print_answer(served_listen());
    }
}

int main(void)
{
    char line[64];

    while (fgets(line, sizeof line, stdin) != NULL) {
        call(line);
    }
    return EXIT_SUCCESS;
}

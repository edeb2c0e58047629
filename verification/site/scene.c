/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Plays a scene as robot.wasm plays it in scene.mjs, in native code, and prints the same lines.
 *
 *     closed-loop-scene ROBOT SEED CYCLES <SCENE
 *
 * Lines of a scene, in the order of their cycles: `CYCLE order WORDS`, or `CYCLE command ID SOURCE
 * PEER KIND ARGUMENT VALUE`. Printed are each answer, each reply, and once a second a hash of all
 * bytes of inputs and outputs so far, in which a difference stays.
 */
#include "site/exports.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SECOND_CYCLES 1000U
#define FNV_BASIS 2166136261U
#define FNV_PRIME 16777619U

static uint32_t add(uint32_t hash, const void *bytes, uint32_t size)
{
    uint32_t sum = hash;

    for (uint32_t at = 0U; at < size; at += (uint32_t)sizeof(uint32_t)) {
        uint32_t word = 0U;
        (void)memcpy(&word, (const uint8_t *)bytes + at, sizeof word);
        sum = (sum ^ word) * FNV_PRIME;
    }
    return sum;
}

static void give_order(const char *order)
{
    (void)snprintf(exports_text(), EXPORTS_TEXT_SIZE, "%s", order);
    (void)exports_order();
    (void)printf("%s", exports_text());
}

static void give_command(const char *numbers)
{
    command_t *const command = exports_command();

    if ((command == NULL) ||
        (sscanf(numbers, "%" SCNu32 " %" SCNu32 " %" SCNu32 " %" SCNu32 " %" SCNu32 " %" SCNd32,
                &command->id, &command->source, &command->peer, &command->kind, &command->argument,
                &command->value) != 6)) {
        (void)fprintf(stderr, "closed-loop-scene: this is no command: %s\n", numbers);
        exit(EXIT_FAILURE);
    }
}

/* The next line, without its end; its cycle is UINT32_MAX when there is none. */
static uint32_t next_line(char *line, int size, const char **what)
{
    if (fgets(line, size, stdin) == NULL) {
        return UINT32_MAX;
    }
    char *end = NULL;
    const uint32_t cycle = (uint32_t)strtoul(line, &end, 10);
    line[strcspn(line, "\n")] = '\0';
    *what = end + 1;
    return cycle;
}

static void act(const char *what)
{
    if (strncmp(what, "order ", 6U) == 0) {
        give_order(&what[6]);
    } else {
        give_command(&what[8]); /* Behind "command ". */
    }
}

static void print_answers(uint32_t cycle)
{
    const controller_outputs_t *const outputs = exports_outputs();

    for (uint32_t i = 0U; i < outputs->answer_count; i++) {
        const answer_t *const answer = &outputs->answers[i];
        (void)printf("%" PRIu32 " answer %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", cycle, answer->id,
                     answer->kind, answer->status);
    }
}

static void play(uint32_t cycles)
{
    char line[128];
    const char *what = NULL;
    uint32_t due = next_line(line, sizeof line, &what);
    uint32_t hash = FNV_BASIS;

    for (uint32_t cycle = 0U; cycle < cycles; cycle++) {
        while (due == cycle) {
            act(what);
            due = next_line(line, sizeof line, &what);
        }
        exports_step();
        hash = add(hash, exports_inputs(), exports_inputs_size());
        hash = add(hash, exports_outputs(), exports_outputs_size());
        print_answers(cycle);
        if (((cycle + 1U) % SECOND_CYCLES) == 0U) {
            (void)printf("%" PRIu32 " hash %" PRIu32 "\n", cycle + 1U, hash);
        }
    }
}

int main(int count, char **words)
{
    if (count != 4) {
        (void)fprintf(stderr, "usage: closed-loop-scene ROBOT SEED CYCLES <SCENE\n");
        return EXIT_FAILURE;
    }
    (void)snprintf(exports_text(), EXPORTS_TEXT_SIZE, "%s", words[1]);
    if (!exports_start((uint32_t)strtoul(words[2], NULL, 10))) {
        (void)fprintf(stderr, "closed-loop-scene: there is no robot %s\n", words[1]);
        return EXIT_FAILURE;
    }
    play((uint32_t)strtoul(words[3], NULL, 10));
    return EXIT_SUCCESS;
}

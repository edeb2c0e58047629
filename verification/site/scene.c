/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Plays a scene as robot.wasm plays it in scene.mjs, in native code, and prints the same lines.
 *
 *     closed-loop-scene ROBOT SEED CYCLES [OTHER] <SCENE
 *
 * Lines of a scene, in the order of their cycles: `CYCLE order WORDS`, or `CYCLE command ID SOURCE
 * PEER KIND FIRST SECOND`, the first two words of what the command says. Printed are each answer,
 * each reply, and once a second a hash of all bytes of inputs and outputs so far, in which a
 * difference stays. With OTHER, a file with another scene, only what is said of the first cycle in
 * which that differs, as scene_run.ts asks for it. Without any argument it prints where scene.mjs
 * finds the answers in the outputs, in words.
 */
#include "site/exports.h"
#include "site/watch.h"

#include <inttypes.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SECOND_CYCLES 1000U
#define FNV_BASIS 2166136261U
#define FNV_PRIME 16777619U

static bool is_compared;

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
    if (!is_compared) {
        (void)printf("%s", exports_text());
    }
}

static void give_command(const char *numbers)
{
    command_t *const command = exports_command();
    uint32_t first = 0U;
    int32_t second = 0;

    if ((command == NULL) ||
        (sscanf(numbers, "%" SCNu32 " %" SCNu32 " %" SCNu32 " %" SCNu32 " %" SCNu32 " %" SCNd32,
                &command->id, &command->source, &command->peer, &command->kind, &first,
                &second) != 6)) {
        (void)fprintf(stderr, "closed-loop-scene: this is no command: %s\n", numbers);
        exit(EXIT_FAILURE);
    }
    (void)memcpy(&command->as, &first, sizeof first);
    (void)memcpy((uint8_t *)&command->as + sizeof first, &second, sizeof second);
}

/* The next line, without its end; its cycle is UINT32_MAX when there is none. */
static uint32_t next_line(FILE *scene, char *line, int size, const char **what)
{
    if (fgets(line, size, scene) == NULL) {
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
    const controller_outputs_t *const outputs = watch_outputs();

    for (uint32_t i = 0U; i < outputs->answer_count; i++) {
        const answer_t *const answer = &outputs->answers[i];
        (void)printf("%" PRIu32 " answer %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", cycle, answer->id,
                     answer->kind, answer->status);
    }
}

static bool say_cycle(uint32_t cycle)
{
    static uint32_t hash = FNV_BASIS;

    hash = add(hash, exports_inputs(), exports_inputs_size());
    hash = add(hash, watch_outputs(), watch_outputs_size());
    print_answers(cycle);
    if (((cycle + 1U) % SECOND_CYCLES) == 0U) {
        (void)printf("%" PRIu32 " hash %" PRIu32 "\n", cycle + 1U, hash);
    }
    return true;
}

static controller_outputs_t *kept; /* By cycle. */

static bool keep_cycle(uint32_t cycle)
{
    kept[cycle] = *watch_outputs();
    return true;
}

/* False: it differs, which is said. */
static bool compare_cycle(uint32_t cycle)
{
    *watch_other() = kept[cycle];
    watch_compare();
    (void)printf("%s", watch_words());
    return watch_words()[0] == '\0';
}

/* Until `after` a cycle is false. */
static void play(FILE *scene, uint32_t cycles, bool (*after)(uint32_t cycle))
{
    char line[128];
    const char *what = NULL;
    uint32_t due = next_line(scene, line, sizeof line, &what);
    bool goes_on = true;

    for (uint32_t cycle = 0U; (cycle < cycles) && goes_on; cycle++) {
        while (due == cycle) {
            act(what);
            due = next_line(scene, line, sizeof line, &what);
        }
        exports_step();
        goes_on = after(cycle);
    }
}

static void start(const char *robot, const char *seed)
{
    (void)snprintf(exports_text(), EXPORTS_TEXT_SIZE, "%s", robot);
    if (!exports_start((uint32_t)strtoul(seed, NULL, 10))) {
        (void)fprintf(stderr, "closed-loop-scene: there is no robot %s\n", robot);
        exit(EXIT_FAILURE);
    }
}

static void compare(char **words, uint32_t cycles)
{
    FILE *const other = fopen(words[4], "r");

    kept = calloc(cycles, sizeof *kept);
    if ((other == NULL) || (kept == NULL)) {
        (void)fprintf(stderr, "closed-loop-scene: %s cannot be played\n", words[4]);
        exit(EXIT_FAILURE);
    }
    is_compared = true;
    play(stdin, cycles, keep_cycle);
    start(words[1], words[2]);
    watch_compare_begin();
    play(other, cycles, compare_cycle);
    (void)fclose(other);
    free(kept);
}

#define WORDS(bytes) ((bytes) / sizeof(uint32_t))

static void print_layout(void)
{
    (void)printf("{\"count\": %zu, \"first\": %zu, \"words\": %zu, \"id\": %zu, \"kind\": %zu, "
                 "\"status\": %zu}\n",
                 WORDS(offsetof(controller_outputs_t, answer_count)),
                 WORDS(offsetof(controller_outputs_t, answers)), WORDS(sizeof(answer_t)),
                 WORDS(offsetof(answer_t, id)), WORDS(offsetof(answer_t, kind)),
                 WORDS(offsetof(answer_t, status)));
}

int main(int count, char **words)
{
    if (count == 1) {
        print_layout();
        return EXIT_SUCCESS;
    }
    if ((count != 4) && (count != 5)) {
        (void)fprintf(stderr, "usage: closed-loop-scene ROBOT SEED CYCLES [OTHER] <SCENE\n");
        return EXIT_FAILURE;
    }
    const uint32_t cycles = (uint32_t)strtoul(words[3], NULL, 10);
    start(words[1], words[2]);
    if (count == 5) {
        compare(words, cycles);
    } else {
        play(stdin, cycles, say_cycle);
    }
    return EXIT_SUCCESS;
}

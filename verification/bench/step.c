/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * bench-step: calls controller_step() once for each sample, for a tool that counts instructions,
 * and compares its outputs with the recorded ones.
 *
 *     bench-step SAMPLES [NUMBER ...]
 *
 * Without numbers, all samples in turn; the first has number 0.
 */
#include "base/contract.h"
#include "bench/sample.h"
#include "robot/app/robots.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static samples_header_t samples;
static const robot_t *robot;
static sample_t sample;
static controller_t controller;
static controller_outputs_t outputs;
static volatile uint32_t steps;

void contract_broken(const char *module, uint32_t id)
{
    (void)fprintf(stderr, "Contract %s/%u is broken.\n", module, (unsigned)id);
    _Exit(EXIT_FAILURE);
}

/* The counter begins at the entry of controller_step() and ends at the return to here; something
 * must be left to do after it, or the compiler makes the call a jump that returns elsewhere. */
__attribute__((noinline)) static void measure(void)
{
    controller_step(&controller, robot, &sample.inputs, &outputs);
    steps++;
}

static bool read_header(FILE *file)
{
    const bool is_read = fread(&samples, sizeof(samples), 1U, file) == 1U;
    samples.robot[SAMPLES_ROBOT_SIZE - 1U] = '\0';
    robot = robots_find(samples.robot);
    const bool is_sound = is_read && (robot != NULL) && (samples.magic == SAMPLES_MAGIC) &&
                          (samples.sample_size == sizeof(sample_t)) &&
                          (samples.controller_size == CONTROLLER_CHECKPOINT_BYTES) &&
                          (samples.inputs_size == sizeof(controller_inputs_t)) &&
                          (samples.outputs_size == sizeof(controller_outputs_t)) &&
                          (samples.robot_crc == robot->crc);
    if (is_sound) {
        robot = sample_robot(robot, samples.is_sensorless != 0U);
    }
    return is_sound;
}

static bool step(FILE *file, uint32_t number)
{
    const long offset = (long)(sizeof(samples) + (number * sizeof(sample)));
    if ((number >= samples.count) || (fseek(file, offset, SEEK_SET) != 0) ||
        (fread(&sample, sizeof(sample), 1U, file) != 1U)) {
        (void)fprintf(stderr, "There is no sample %u.\n", (unsigned)number);
        return false;
    }
    (void)memcpy(&controller, sample.before, sizeof sample.before);
    measure();
    if (memcmp(&outputs, &sample.outputs, sizeof(outputs)) != 0) {
        (void)fprintf(stderr, "Sample %u does not repeat what was recorded.\n", (unsigned)number);
        return false;
    }
    return true;
}

static bool step_all(FILE *file, int count, char **numbers)
{
    const uint32_t wanted = (count > 0) ? (uint32_t)count : samples.count;
    bool is_equal = true;
    for (uint32_t i = 0U; is_equal && (i < wanted); i++) {
        is_equal = step(file, (count > 0) ? (uint32_t)strtoul(numbers[i], NULL, 10) : i);
    }
    return is_equal;
}

int main(int count, char **arguments)
{
    FILE *const file = (count > 1) ? fopen(arguments[1], "rb") : NULL;
    if (file == NULL) {
        (void)fputs("usage: bench-step SAMPLES [NUMBER ...]\n", stderr);
        return EXIT_FAILURE;
    }
    if (!read_header(file)) {
        (void)fputs("The samples are of another layout or robot; write them anew.\n", stderr);
        return EXIT_FAILURE;
    }
    const bool is_equal = step_all(file, count - 2, &arguments[2]);
    (void)fclose(file);
    return is_equal ? EXIT_SUCCESS : EXIT_FAILURE;
}

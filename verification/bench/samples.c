/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * bench-samples: executes a recording again and keeps single cycles of it.
 *
 *     bench-samples RECORDING SAMPLES
 *
 * Kept are SAMPLES_EVEN cycles at equal distances, every cycle that carried a command or an answer
 * (at most SAMPLES_SPOKEN), and every other one with an event (at most SAMPLES_EVENTFUL). Standard
 * output has one line for each, tabulated: "even" or "extra", cycle, what happened in it.
 */
#include "contract.h"
#include "names.h"
#include "recording_reader.h"
#include "replay.h"
#include "sample.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SAMPLES_EVEN 300U
#define SAMPLES_SPOKEN 100U
#define SAMPLES_EVENTFUL 100U

static recording_reader_t reader;
static replay_t replay;
static cycle_record_t record;
static sample_t sample;
static samples_header_t samples = {.magic = SAMPLES_MAGIC,
                                   .sample_size = sizeof(sample_t),
                                   .controller_size = sizeof(controller_t),
                                   .inputs_size = sizeof(controller_inputs_t),
                                   .outputs_size = sizeof(controller_outputs_t)};

void contract_broken(const char *module, uint32_t id)
{
    (void)fprintf(stderr, "Cycle %" PRIu32 " breaks contract %s/%" PRIu32 ".\n", record.cycle,
                  module, id);
    _Exit(EXIT_FAILURE);
}

/* Names what happened in the cycle, commands first. */
static void print_label(const cycle_record_t *from)
{
    const controller_inputs_t *const inputs = &from->body.cycle.inputs;
    const controller_outputs_t *const outputs = &from->body.cycle.outputs;
    for (uint32_t i = 0U; i < inputs->command_count; i++) {
        const command_t *const command = &inputs->commands[i];
        const bool names_workphase = command->kind == (uint32_t)COMMAND_WORKPHASE;
        (void)printf("%s%s%s", (i > 0U) ? ", " : "", command_kind_name((int32_t)command->kind),
                     names_workphase ? " " : "");
        (void)printf("%s", names_workphase ? workphase_name((int32_t)command->argument) : "");
    }
    if (inputs->command_count == 0U) {
        for (uint32_t i = 0U; i < outputs->event_count; i++) {
            (void)printf("%s%s", (i > 0U) ? ", " : "",
                         event_id_name((int32_t)outputs->events[i].id));
        }
    }
    (void)putchar('\n');
}

/* Says whether the cycle is to be kept, and why. */
static const char *reason_to_keep(const cycle_record_t *from, uint64_t distance)
{
    static uint32_t spoken;
    static uint32_t eventful;
    const bool has_word =
        (from->body.cycle.inputs.command_count + from->body.cycle.outputs.answer_count) > 0U;
    if (has_word && (spoken < SAMPLES_SPOKEN)) {
        spoken++;
        return "extra";
    }
    if ((replay.replayed % distance) == 0U) {
        return "even";
    }
    if (!has_word && (from->body.cycle.outputs.event_count > 0U) && (eventful < SAMPLES_EVENTFUL)) {
        eventful++;
        return "extra";
    }
    return NULL;
}

static bool keep(FILE *file, const char *reason)
{
    sample.inputs = record.body.cycle.inputs;
    sample.outputs = record.body.cycle.outputs;
    samples.count++;
    (void)printf("%s\t%" PRIu32 "\t", reason, record.cycle);
    print_label(&record);
    return fwrite(&sample, sizeof(sample), 1U, file) == 1U;
}

static bool take_all(FILE *file)
{
    const uint64_t distance = (reader.records / SAMPLES_EVEN) + 1U;
    while (recording_reader_next(&reader, &record)) {
        const char *const reason =
            (record.kind == (uint32_t)CYCLE_RECORD_CYCLE) && replay.is_running
                ? reason_to_keep(&record, distance)
                : NULL;
        const uint64_t before = replay.replayed;
        sample.before = replay.controller;
        if (!replay_take(&replay, &robot_neuro, &record)) {
            (void)fprintf(stderr, "Cycle %" PRIu32 " does not repeat what was recorded.\n",
                          record.cycle);
            return false;
        }
        if ((reason != NULL) && (replay.replayed > before) && !keep(file, reason)) {
            return false;
        }
    }
    return samples.count > 0U;
}

static bool write_samples(const char *path)
{
    FILE *const file = fopen(path, "wb");
    if (file == NULL) {
        return false;
    }
    samples.robot_crc = robot_neuro.crc;
    bool is_written = fwrite(&samples, sizeof(samples), 1U, file) == 1U;
    is_written = is_written && take_all(file) && (fseek(file, 0L, SEEK_SET) == 0);
    is_written = is_written && (fwrite(&samples, sizeof(samples), 1U, file) == 1U);
    return (fclose(file) == 0) && is_written;
}

int main(int count, char **arguments)
{
    recording_finding_t finding;
    if (count != 3) {
        (void)fputs("usage: bench-samples RECORDING SAMPLES\n", stderr);
        return EXIT_FAILURE;
    }
    const recording_verdict_t verdict = recording_reader_open(&reader, arguments[1], &finding);
    if ((verdict != RECORDING_WHOLE) && (verdict != RECORDING_CUT_SHORT)) {
        (void)fprintf(stderr, "%s\n", finding.sentence);
        return EXIT_FAILURE;
    }
    if ((reader.header.robot_crc != robot_neuro.crc) ||
        !recording_reader_fits(&reader, sizeof(controller_t))) {
        (void)fputs("The recording is of another robot or of another build; make a new one.\n",
                    stderr);
        return EXIT_FAILURE;
    }
    replay_init(&replay);
    const bool is_done = write_samples(arguments[2]);
    recording_reader_close(&reader);
    if (!is_done) {
        (void)fprintf(stderr, "No samples of %s could be written to %s.\n", arguments[1],
                      arguments[2]);
    }
    return is_done ? EXIT_SUCCESS : EXIT_FAILURE;
}

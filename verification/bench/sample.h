/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The file of samples: single cycles of a recording, each with all that controller_step() needs and
 * what it must say. Same layout on both machines of the benchmark; the reader compares the sizes
 * in the header with its own.
 */
#ifndef BORESIGHT_SAMPLE_H
#define BORESIGHT_SAMPLE_H

#include "controller/controller.h"

#include <stdbool.h>
#include <stdint.h>

#define SAMPLES_MAGIC 0x504D5342U /**< "BSMP" */
#define SAMPLES_ROBOT_SIZE 32U

typedef struct {
    uint32_t magic;
    uint32_t count;           /**< Samples that follow. */
    uint32_t sample_size;     /**< sizeof(sample_t). */
    uint32_t controller_size; /**< CONTROLLER_CHECKPOINT_BYTES. */
    uint32_t inputs_size;     /**< sizeof(controller_inputs_t). */
    uint32_t outputs_size;    /**< sizeof(controller_outputs_t). */
    uint32_t robot_crc;
    uint32_t is_sensorless; /**< Played by sample_robot() without its force sensor: 0 or 1. */
    char robot[SAMPLES_ROBOT_SIZE]; /**< Its name. */
} samples_header_t;

typedef struct {
    uint32_t cycle;
    uint8_t before[CONTROLLER_CHECKPOINT_BYTES]; /**< State when the cycle began. */
    controller_inputs_t inputs;
    controller_outputs_t outputs; /**< As recorded. */
} sample_t;

/** @return `robot` as it is, or a copy whose file names no force sensor; the cards are the same */
const robot_t *sample_robot(const robot_t *robot, bool is_sensorless);

#endif

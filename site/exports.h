/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Functions that a page may call of the module robot.wasm, which holds one robot in a closed loop
 * and, beside it, one recording that is executed again. It imports nothing. Words go in and come
 * out by one text; structures are those of the product, at their addresses: their bytes are those
 * of any other build. A contract that is broken leaves its name in the text and traps.
 */
#ifndef BORESIGHT_EXPORTS_H
#define BORESIGHT_EXPORTS_H

#include "controller/controller.h"
#include "sim/box.h"
#include "site/export.h"

#include <stdbool.h>
#include <stdint.h>

#define EXPORTS_TEXT_SIZE BOX_REPLY_SIZE

/** The text of EXPORTS_TEXT_SIZE, ended by a zero. */
EXPORT(text) char *exports_text(void);

/** INTERFACE_LAYOUT: a reader of the structures must be of the same. */
EXPORT(layout) uint64_t exports_layout(void);

/**
 * Starts the robot that the text names; false: there is none of that name, and nothing changes.
 *
 * @satisfies SWR-SITE-004
 */
EXPORT(start) bool exports_start(uint32_t seed);

/** Gives the order that the text holds to the box; the text becomes its reply. Needs a robot that
 * was started (contract 300). False: refused. */
EXPORT(order) bool exports_order(void);

/** Where one more command of the next cycle is to be written; NULL: that cycle takes no more. */
EXPORT(command) command_t *exports_command(void);

/**
 * Lets a cycle pass. Nothing but the calls before decides what it brings. Needs a robot that was
 * started (contract 301).
 *
 * @satisfies SWR-SITE-001
 */
EXPORT(step) void exports_step(void);

/** Inputs of the last cycle. */
EXPORT(inputs) const controller_inputs_t *exports_inputs(void);
EXPORT(inputsSize) uint32_t exports_inputs_size(void);

/**
 * Begins a recording of the robot that the text names.
 *
 * @return CRC of its description; 0: there is none of that name
 */
EXPORT(replay) uint32_t exports_replay(void);

/** Sizes of a recording that can be executed here; recording_header_t. */
EXPORT(checkpointSize) uint32_t exports_checkpoint_size(void);
EXPORT(frameLayout) uint32_t exports_frame_layout(void);

/** Room for the records of a block, RECORDING_RAW_MAX bytes. */
EXPORT(block) uint8_t *exports_block(void);
EXPORT(blockMost) uint32_t exports_block_most(void);

/**
 * Executes the `size` bytes of records that stand there, of which `cycle` is the first, as
 * replay_take() does. Needs a recording that was begun (contract 302), and room for the bytes
 * (303).
 *
 * @return records taken; below 0: the outputs of a cycle differ, and the text says where, or the
 * block does not hold what it says
 *
 * @satisfies SWR-SITE-002
 */
EXPORT(replayBlock) int32_t exports_replay_block(uint32_t size, uint32_t cycle);

/** Cycles so far whose outputs were equal. */
EXPORT(replayed) uint32_t exports_replayed(void);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
#include "site/exports.h"

#include "base/contract.h"
#include "interface/interface_layout.h"
#include "recording/read/recording_block.h"
#include "replay/verify/replay.h"
#include "robot/app/robots.h"
#include "site/closed_loop.h"
#include "site/watch.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

static const char contract_module[] = "site";

static char text[EXPORTS_TEXT_SIZE];
static closed_loop_t loop;

static const robot_t *replayed_robot;
static replay_t replay;
static recording_reader_t reader;
static uint8_t raw[RECORDING_RAW_MAX];
static cycle_record_t record;
static cycle_known_t known;

void contract_broken(const char *module, uint32_t id)
{
    (void)snprintf(text, sizeof text, "Contract %s/%u is broken, report this.", module,
                   (unsigned)id);
    __builtin_trap();
}

const closed_loop_t *watch_loop(void)
{
    return &loop;
}

char *exports_text(void)
{
    return text;
}

uint64_t exports_layout(void)
{
    return INTERFACE_LAYOUT;
}

/* The robot that the text names. */
static const robot_t *named_robot(void)
{
    text[sizeof text - 1U] = '\0';
    return robots_find(text);
}

bool exports_start(uint32_t seed)
{
    const robot_t *const robot = named_robot();

    if (robot != NULL) {
        closed_loop_init(&loop, robot, seed);
    }
    return robot != NULL;
}

bool exports_order(void)
{
    char order[EXPORTS_TEXT_SIZE];

    REQUIRE(300U, loop.robot != NULL);
    text[sizeof text - 1U] = '\0';
    (void)memcpy(order, text, sizeof order);
    return box_command(&loop.box, order, text, sizeof text);
}

command_t *exports_command(void)
{
    return closed_loop_command(&loop);
}

void exports_step(void)
{
    REQUIRE(301U, loop.robot != NULL);
    closed_loop_step(&loop);
}

const controller_inputs_t *exports_inputs(void)
{
    return &loop.inputs;
}

uint32_t exports_inputs_size(void)
{
    return (uint32_t)sizeof loop.inputs;
}

uint32_t exports_replay(void)
{
    replayed_robot = named_robot();
    replay_init(&replay);
    reader = (recording_reader_t){.raw = raw};
    reader.header.controller_size = CONTROLLER_CHECKPOINT_BYTES;
    return (replayed_robot != NULL) ? replayed_robot->crc : 0U;
}

uint32_t exports_checkpoint_size(void)
{
    return CONTROLLER_CHECKPOINT_BYTES;
}

uint32_t exports_frame_layout(void)
{
    return cycle_words_frame_layout();
}

uint8_t *exports_block(void)
{
    return raw;
}

uint32_t exports_block_most(void)
{
    return (uint32_t)sizeof raw;
}

int32_t exports_replay_block(uint32_t size, uint32_t cycle)
{
    int32_t taken = 0;

    REQUIRE(302U, replayed_robot != NULL);
    REQUIRE(303U, size <= sizeof raw);
    recording_block_begin(&reader, size, cycle);
    while (recording_block_take(&reader, &record, &known)) {
        if (!replay_take(&replay, replayed_robot, &record, &known)) {
            (void)replay_difference(&replay, &record, &known, text, sizeof text);
            return -1;
        }
        taken++;
    }
    if (reader.raw_next != size) {
        (void)snprintf(text, sizeof text, "The block of cycle %u is damaged.", (unsigned)cycle);
        return -1;
    }
    return taken;
}

uint32_t exports_replayed(void)
{
    return (uint32_t)replay.replayed;
}

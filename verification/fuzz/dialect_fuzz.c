/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Scenes of peers that say anything, played with both dialects and the real controller. The bytes
 * are those of tools/fuzz/scenes.rb: a beginning, then operations with their words.
 */
#include "fuzz/grammar.h"
#include "fuzz/dialect_oracle.h"
#include "fuzz/words.h"
#include "fuzz/world.h"

#include "base/contract.h"
#include "fuzz/sentence.h"
#include "unity.h"

#include <stddef.h>
#include <string.h>

#define CYCLES_MAX 700U /* Most cycles of a scene. */
#define SILENCE_CYCLES 16U
#define SILENCES_MAX 150U /* Most silences of a scene. */

/** The bytes that are left, and what was said of the next message. */
typedef struct {
    const uint8_t *bytes;
    size_t left;
    uint32_t cycles;
    uint32_t silences;
    grammar_fault_t fault;
    uint32_t cut;
    uint32_t cut_cycles;
} script_t;

static world_t world;

void setUp(void)
{
}

void tearDown(void)
{
}

void contract_broken(const char *module, uint32_t id)
{
    (void)fprintf(stderr, "contract %s/%u is broken\n", module, (unsigned)id);
    abort();
}

static uint8_t next(script_t *script)
{
    uint8_t byte = 0U;

    if (script->left > 0U) {
        byte = *script->bytes;
        script->bytes++;
        script->left--;
    }
    return byte;
}

static uint32_t next_place(script_t *script)
{
    return next(script) % WORLD_PEERS;
}

/* No more than the scene has left. */
static uint32_t next_cycles(script_t *script)
{
    const uint32_t wanted = next(script);
    const uint32_t cycles = (wanted < script->cycles) ? wanted : script->cycles;

    script->cycles -= cycles;
    return cycles;
}

static uint32_t next_silences(script_t *script)
{
    const uint32_t wanted = next(script);
    const uint32_t silences = (wanted < script->silences) ? wanted : script->silences;

    script->silences -= silences;
    return silences;
}

static void send(script_t *script, uint32_t place, grammar_message_t *message)
{
    const uint32_t first = script->cut % message->length;

    grammar_damage(message, &script->fault);
    script->fault.is_wanted = false;
    script->cut = 0U;
    world_receive(&world, place, message->bytes, first);
    world_wait(&world, script->cut_cycles);
    script->cut_cycles = 0U;
    world_receive(&world, place, &message->bytes[first], message->length - first);
}

static void say(script_t *script, uint32_t operation)
{
    const uint32_t place = next_place(script);
    const uint32_t version = world.peers[place].version;
    const uint8_t words[3] = {next(script), next(script), next(script)};
    grammar_message_t message;

    if (operation == FUZZ_OPERATION_STRING) {
        grammar_string(&message, version, words);
    } else if (operation == FUZZ_OPERATION_TRANSFORM) {
        grammar_transform(&message, version, words);
    } else {
        grammar_ask(&message, version, words);
    }
    send(script, place, &message);
}

static void connect(script_t *script)
{
    const uint32_t place = next_place(script);
    const igtl_language_t language = (igtl_language_t)(next(script) % 3U);

    world_connect(&world, place, language, 1U + (next(script) % 2U));
}

static void say_bytes(script_t *script)
{
    const uint32_t place = next_place(script);
    const size_t wanted = next(script);
    const size_t count = (wanted < script->left) ? wanted : script->left;

    world_receive(&world, place, script->bytes, (uint32_t)count);
    script->bytes += count;
    script->left -= count;
}

static void order_box(script_t *script)
{
    char reply[BOX_REPLY_SIZE];

    (void)box_command(&world.rig.box, grammar_order(next(script)), reply, sizeof reply);
}

static void play(script_t *script)
{
    const uint32_t operation = next(script) % FUZZ_OPERATIONS;

    switch (operation) {
    case FUZZ_OPERATION_WAIT:
        world_wait(&world, next_cycles(script));
        break;
    case FUZZ_OPERATION_CONNECT:
        connect(script);
        break;
    case FUZZ_OPERATION_DISCONNECT:
        world_disconnect(&world, next_place(script));
        break;
    case FUZZ_OPERATION_STRING:
    case FUZZ_OPERATION_TRANSFORM:
    case FUZZ_OPERATION_ASK:
        say(script, operation);
        break;
    case FUZZ_OPERATION_BYTES:
        say_bytes(script);
        break;
    case FUZZ_OPERATION_MUTATE:
        script->fault.is_wanted = true;
        script->fault.position = next(script);
        script->fault.value = next(script);
        script->fault.is_checksum_kept = (next(script) % 2U) != 0U;
        break;
    case FUZZ_OPERATION_CUT:
        script->cut = next(script);
        script->cut_cycles = next_cycles(script);
        break;
    case FUZZ_OPERATION_BOX:
        order_box(script);
        break;
    case FUZZ_OPERATION_HANG:
        world.peers[next_place(script)].is_hung = true;
        break;
    case FUZZ_OPERATION_READ:
        world.peers[next_place(script)].is_hung = false;
        break;
    case FUZZ_OPERATION_FULL:
        world.full_until_us = world.moment.now_us + (1000U * (uint64_t)next(script));
        break;
    case FUZZ_OPERATION_SILENT:
    default:
        world_wait_in_silence(&world, SILENCE_CYCLES * next_silences(script));
        break;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    script_t script = {.bytes = data, .left = size, .cycles = CYCLES_MAX, .silences = SILENCES_MAX};

    if (size == 0U) {
        return 0;
    }
    world_begin(&world, next(&script));
    while (script.left > 0U) {
        play(&script);
    }
    world_wait(&world, 1U);
    return 0;
}

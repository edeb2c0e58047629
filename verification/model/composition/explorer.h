/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * What composition.h, which is generated, tells explorer.c; it defines MEMBERS before, and NEVER
 * for what cannot happen.
 */
#ifndef BORESIGHT_EXPLORER_H
#define BORESIGHT_EXPLORER_H

#include "permit.h"

#include <stdbool.h>
#include <stdint.h>

/** Number of each member's own configuration. */
typedef struct {
    uint8_t of[MEMBERS];
} config_t;

typedef enum { TRIGGER_ENTERS, TRIGGER_DOES, TRIGGER_HEARS } trigger_t;

typedef struct {
    const char *name; /**< "member.event" or "member.timer". */
    uint32_t member;
    uint32_t event;
    uint32_t free; /**< Bits of the free inputs that it may come to read. */
} stimulus_t;

typedef struct {
    uint32_t member;
    trigger_t trigger;
    uint32_t what; /**< A state, a bit of the actions, or an event, by the trigger. */
    uint32_t told_member;
    uint32_t told_event;
} reaction_t;

typedef struct {
    const char *id;
    uint32_t steps; /**< 0, or how many a reachable one may take. */
} property_t;

/** What a chart's interpreter did. */
typedef struct {
    uint16_t after;
    uint16_t actions;
} answer_t;

/** One member's step from one of its configurations to another. */
typedef uint32_t step_t(uint32_t config, uint32_t event, uint32_t inputs, uint32_t *actions);

#endif

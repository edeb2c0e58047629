/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Data that composition.h, which is generated, gives to explorer.c; it defines the sizes before,
 * and NEVER for what cannot happen.
 */
#ifndef BORESIGHT_EXPLORER_H
#define BORESIGHT_EXPLORER_H

#include "found.h"
#include "safety/permit.h"

#include <stdbool.h>
#include <stdint.h>

/* In the bits of a configuration, of a mask, and of the inputs of a way. */
#if (MEMBERS > 12U) || (LARGEST > 32U) || (REACTIONS > 64U) || (PROPERTIES > 64U) ||               \
    (FREE_INPUTS > 16U)
#error "the composition does not fit"
#endif

typedef enum { TRIGGER_ENTERS, TRIGGER_DOES, TRIGGER_HEARS } trigger_t;

/** One member's step from one of its own configurations to another, or NEVER. */
typedef uint32_t step_t(uint32_t own, uint32_t event, uint32_t inputs, uint32_t *actions);

/** Step of a chart's interpreter. */
typedef struct {
    uint16_t after;
    uint16_t actions;
} answer_t;

typedef struct {
    step_t *compiled;
    step_t *interpreted;
    uint32_t configurations;
    uint32_t events; /**< Its timers included. */
    uint32_t valuations;
} member_t;

typedef struct {
    const char *name; /**< "member.event" or "member.timer". */
    uint32_t member;
    uint32_t event;
    uint32_t free; /**< Bits of the free inputs that it may come to read. */
    uint32_t twin; /**< The same stimulus when the axes change places. */
} stimulus_t;

typedef struct {
    uint32_t member;
    trigger_t trigger;
    uint32_t what; /**< A set of own configurations, a bit of the actions, or an event. */
    uint32_t reported_member;
    uint32_t reported_event;
    bool is_of_one_axis; /**< It has no twin. */
} reaction_t;

typedef struct {
    const char *id;
    uint32_t steps; /**< 0, or how many a reachable one may take. */
    uint32_t twin;
} property_t;

static inline uint32_t own(config_t config, uint32_t member)
{
    return (uint32_t)(config >> (member * OWN_BITS)) & OWN_MASK;
}

static inline config_t with_own(config_t config, uint32_t member, uint32_t number)
{
    const uint32_t place = member * OWN_BITS;
    return (config & ~((config_t)OWN_MASK << place)) | ((config_t)number << place);
}

/** Whether a member is in one of a set of its own configurations. */
static inline bool is_in(config_t config, uint32_t member, uint32_t set)
{
    return ((set >> own(config, member)) & 1U) != 0U;
}

/** Two members change places. */
static inline config_t swapped(config_t config, uint32_t one, uint32_t other)
{
    return with_own(with_own(config, one, own(config, other)), other, own(config, one));
}

static inline uint32_t swapped_bits(uint32_t bits, uint32_t one, uint32_t other)
{
    const uint32_t differ = ((bits >> one) ^ (bits >> other)) & 1U;
    return bits ^ (differ << one) ^ (differ << other);
}

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The last events of each card, each axis and each other part that can be in trouble: the words of
 * an alarm, and since when it stands. The snapshot shows whether it stands.
 */
#ifndef BORESIGHT_ALARMS_H
#define BORESIGHT_ALARMS_H

#include "card/card_frame.h"
#include "exchange/exchange.h"
#include "interface/snapshot.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** The parts that are neither a card nor an axis. */
typedef enum {
    ALARM_PART_TABLE,  /**< The robot's. */
    ALARM_PART_INPUTS, /**< The inputs of the box. */
    ALARM_PART_ESTOP,
    ALARM_PART_LOOP,
    ALARM_PART_PEDAL,
    ALARM_PART_RECORDER,
    ALARM_PART_COUNT
} alarm_part_t;

/** An event and when control published it. */
typedef struct {
    bool is_known;
    exchange_event_t said;
} alarm_word_t;

/** Where an axis was known to stand last. */
typedef struct {
    bool is_now; /**< It is known still. */
    bool is_known;
    int32_t ticks;
    uint32_t cycle;
} alarm_place_t;

/** All zero: nothing is known. */
typedef struct {
    alarm_word_t parts[ALARM_PART_COUNT];
    alarm_word_t cards[CARD_SLOT_COUNT];  /**< Lost. */
    alarm_word_t unwell[CARD_SLOT_COUNT]; /**< The last trouble of each. */
    alarm_word_t faults[ROBOT_AXIS_MAX];  /**< The fault that has stopped the axis. */
    alarm_word_t doubts[ROBOT_AXIS_MAX];  /**< Why its position is lost or in doubt. */
    alarm_place_t places[ROBOT_AXIS_MAX];
} alarms_t;

/** Takes an event; each once, in their order. */
void alarms_take(alarms_t *self, const exchange_event_t *event);

/** After the events up to `snapshot`: where the axes stand. */
void alarms_see(alarms_t *self, const snapshot_t *snapshot);

#endif

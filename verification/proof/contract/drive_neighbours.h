/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the neighbours of controller_drive() answer in a cycle, whatever they are asked, and
 * what was sent to them. */
#ifndef BORESIGHT_DRIVE_NEIGHBOURS_H
#define BORESIGHT_DRIVE_NEIGHBOURS_H

#include "controller/controller.h"

#include <stdbool.h>
#include <stdint.h>

/** Of a slot: the command that was written into its frame last, and how many were. */
typedef struct {
    card_command_t command;
    uint32_t count;
} sent_command_t;

typedef struct {
    const axis_t *axes;                  /**< Of the controller. */
    const axis_record_t *records;        /**< Of the controller. */
    uint8_t (*frames)[CARD_FRAME_BYTES]; /**< Of the outputs. */
    bool may_be_unhomed;
    uint32_t hand_reasons;
    uint32_t heeding_needle;
    bool is_waiting_for_rotation;
    uint32_t at_coupled_limit;
    bool is_needle_in_way[ROBOT_AXIS_MAX];
    bool is_too_fast[ROBOT_AXIS_MAX];
    sent_command_t sent[CARD_SLOT_COUNT];
} drive_neighbours_t;

extern drive_neighbours_t drive_neighbours;

#endif

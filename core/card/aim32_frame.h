/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The frames of the dialect aim32, which the thesis' own cards speak: 32 big-endian words, both
 * ways, with a start word and one sum. They have no slot, sequence, heartbeat, echo, guard or
 * watchdog, and say nothing of the card's type, faults and temperatures: what is missing stands in
 * docs/board-nifpga.md. A frame is the first half of its buffer; the other half is zero.
 */
#ifndef BORESIGHT_AIM32_FRAME_H
#define BORESIGHT_AIM32_FRAME_H

#include "card/card_frame.h"

#include <stdint.h>

#define AIM32_FRAME_WORDS 32U
#define AIM32_FRAME_BYTES 128U

/**
 * Writes what of `command` has a word: the drive (words 2 to 5) and the amplifier (14). A drive
 * that no card of this dialect has, one with a value out of its range among them, goes out as off.
 *
 * @satisfies SWR-NI-001
 * @satisfies SWR-NI-002
 */
void aim32_frame_encode_command(const card_command_t *command, uint8_t bytes[CARD_FRAME_BYTES]);

/**
 * Reads a report; fields of `report` without a word of their own are not touched. The card's one
 * switch is reported as CARD_LIMIT_LOWER, whichever end it is at.
 *
 * @return CARD_FRAME_OK, CARD_FRAME_BAD_START or CARD_FRAME_BAD_CRC (the sum is wrong); `report` is
 * unchanged but on the first
 *
 * @satisfies SWR-NI-003
 */
card_frame_result_t aim32_frame_decode_report(const uint8_t bytes[CARD_FRAME_BYTES],
                                              card_report_t *report);

#endif

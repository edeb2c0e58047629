/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The controller's view of one daughter card: is it alive, what did it say last, does it do as
 * told. The controller owns one per slot and steps it every cycle. Behaviour:
 * statecharts/card_link.scxml.
 */
#ifndef BORESIGHT_LINK_H
#define BORESIGHT_LINK_H

#include "card/card_frame.h"
#include "charts/card_link_chart.h"
#include "interface/link_cause.h"

#include <stdbool.h>
#include <stdint.h>

/** From `sent` on sixteen words, which cost the seal least. */
typedef struct {
    card_link_chart_t chart;
    card_report_t report;     /**< The last valid one; all zero before the first. */
    uint16_t last_error;      /**< card_frame_result_t of this cycle's frame. */
    uint16_t is_fresh;        /**< A valid frame arrived in this cycle: 0 or 1. */
    card_drive_t sent;        /**< Drive of the last command. */
    card_drive_t sent_before; /**< Of the one before: the one that a report speaks of. */
    uint32_t sent_sequence;
    uint32_t sent_sequence_before;
    uint32_t card_type; /**< What the card must be. */
    uint32_t firmware;
    uint32_t age_cycles;      /**< Since the last valid frame, saturates. */
    uint32_t frame_errors;    /**< Frames discarded, saturates. */
    uint32_t echo_mismatches; /**< In a row. */
    uint16_t has_report;      /**< 0 or 1. */
    uint16_t cause;           /**< link_cause_t of the last loss. */
} link_t;

/** Starts absent; only a card of this type and firmware will be trusted. */
void link_init(link_t *self, uint32_t card_type, uint32_t firmware);

/** Before each step: a damaged link is a lost card. True when it was damaged. */
static inline bool link_check(link_t *self)
{
    return card_link_chart_check(&self->chart) != 0U;
}

/**
 * One cycle; `elapsed_us` since the one before. `bytes` is this cycle's frame of `slot`, NULL when
 * none was received. While the card is usable, its heartbeat must be 1 to LIMIT_SEQUENCE_WINDOW
 * after the last one.
 *
 * @satisfies SWR-LINK-001
 * @satisfies SWR-LINK-002
 * @satisfies SWR-LINK-004
 * @satisfies SWR-LINK-005
 * @satisfies SWR-DRIVE-004
 * @satisfies SWR-LINK-006
 * @satisfies SWR-LINK-007
 * @satisfies SWR-LINK-008
 */
void link_step(link_t *self, uint32_t slot, const uint8_t *bytes, uint32_t elapsed_us);

/** What link_step() does for every dialect: time passes, before the report of the cycle is read. */
void link_advance(link_t *self, uint32_t elapsed_us);

/** The same, after it: the cycle had a report to count on, or had none, and none for too long. */
void link_judge(link_t *self, bool is_good);

/** Remembers what goes out in this cycle, for the comparison with the card's read-back. */
static inline void link_note_sent(link_t *self, uint32_t sequence, const card_drive_t *drive)
{
    self->sent_sequence_before = self->sent_sequence;
    self->sent_before = self->sent;
    self->sent_sequence = sequence;
    self->sent = *drive;
}

/**
 * Trusts a lost card again if it sent a valid frame without a fault in this cycle.
 *
 * @satisfies SWR-LINK-003
 */
void link_reset(link_t *self);

/** What it remembers was damaged: all but its chart, which has its own complement, starts anew as
 * link_init(); a card in use is given up. */
void link_distrust(link_t *self, uint32_t card_type, uint32_t firmware);

/** The card may be given a drive command. */
static inline bool link_is_usable(const link_t *self)
{
    return (self->chart.state == CARD_LINK_STATE_LIVE) ||
           (self->chart.state == CARD_LINK_STATE_LATE);
}

/** Nothing was known against the lost card but that frames did not come through, one way or the
 * other. */
bool link_was_only_silent(const link_t *self);

/** The last report is of the card that must be there. */
static inline bool link_is_right_card(const link_t *self)
{
    return (self->report.card_type == self->card_type) && (self->report.firmware == self->firmware);
}

/** A valid frame without a fault arrived in this cycle. */
static inline bool link_is_well(const link_t *self)
{
    return (self->is_fresh != 0U) && ((self->report.status & CARD_STATUS_FAULTS) == 0U);
}

/** The right card sent a valid frame without a fault in this cycle. */
static inline bool link_is_healthy_now(const link_t *self)
{
    return link_is_well(self) && link_is_right_card(self);
}

#endif

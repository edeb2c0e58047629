/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The controller's view of one daughter card: is it alive, what did it say last, does it do as
 * commanded. The controller owns one per slot and steps it every cycle. Behaviour:
 * statecharts/card_link.scxml.
 */
#ifndef BORESIGHT_LINK_H
#define BORESIGHT_LINK_H

#include "card/card_frame.h"
#include "charts/card_link_chart.h"
#include "interface/link_cause.h"
#include "limits/requirement_limits.h"

#include <stdbool.h>
#include <stdint.h>

/** Part that decides in a cycle to come, under seal. */
typedef struct {
    card_drive_t sent;        /**< Drive of the last command. */
    card_drive_t sent_before; /**< Drive of the command before: the one that a report shows. */
    uint32_t sent_sequence;
    uint32_t sent_sequence_before;
    uint32_t card_type; /**< Type that the card must have. */
    uint32_t firmware;
    uint32_t age_cycles;      /**< Since the last valid frame, saturates. */
    uint32_t frame_errors;    /**< Frames discarded, saturates. */
    uint32_t echo_mismatches; /**< In a row. */
    uint16_t has_report;      /**< 0 or 1. */
    uint16_t cause;           /**< link_cause_t of the last loss. */
} link_sealed_t;

/** A report, and that one came, decides only in its cycle. */
typedef struct {
    card_link_chart_t chart;
    card_report_t report;    /**< The last valid one; all zero before the first. */
    uint32_t sampled_us;     /**< When that was sampled, as the board has it. */
    uint32_t reported_us;    /**< From the sample before to that of this cycle; 0: none came. */
    uint32_t is_timed;       /**< The card's clock says so, and no cycle was missed: 0 or 1. */
    uint32_t lost_heartbeat; /**< Heartbeat of the last valid report, at the loss or since then. */
    uint32_t frames_out_of_order; /**< Frames discarded for their heartbeat; saturates. */
    uint32_t frames_missed;       /**< Cycles without a frame while it was usable; saturates. */
    uint16_t last_error;          /**< card_frame_result_t of this cycle's frame. */
    uint16_t is_fresh;            /**< A valid frame arrived in this cycle: 0 or 1. */
    link_sealed_t sealed;
} link_t;

/** Times at which the cards sampled the frames of a cycle, as the board measures them. */
typedef struct {
    uint32_t sampled_us[CARD_SLOT_COUNT]; /**< By slot, wraps; as the last one: unknown. */
    uint32_t error_us; /**< Two of one slot are apart by so much more or less at most. */
} card_samples_t;

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
 * after the last one. From one report to the next the card's own clock counts, unless it differs
 * from the board's by more than that may be wrong.
 *
 * @satisfies SWR-LINK-001
 * @satisfies SWR-LINK-002
 * @satisfies SWR-LINK-004
 * @satisfies SWR-LINK-005
 * @satisfies SWR-DRIVE-004
 * @satisfies SWR-LINK-006
 * @satisfies SWR-LINK-007
 * @satisfies SWR-LINK-008
 * @satisfies SWR-LINK-012
 * @satisfies SWR-LINK-040
 */
void link_step(link_t *self, uint32_t slot, const uint8_t *bytes, const card_samples_t *samples,
               uint32_t elapsed_us);

/** From the last valid report to one of `sampled_us`, by the board's clock; `elapsed_us` before the
 * first one, and when that is unknown. */
static inline uint32_t link_measured_us(const link_t *self, uint32_t sampled_us,
                                        uint32_t elapsed_us)
{
    const uint32_t measured_us = sampled_us - self->sampled_us;
    return ((self->sealed.has_report == 0U) || (measured_us == 0U)) ? elapsed_us : measured_us;
}

/** The card may be given a drive command. */
static inline bool link_is_usable(const link_t *self)
{
    return (self->chart.state == CARD_LINK_STATE_LIVE) ||
           (self->chart.state == CARD_LINK_STATE_LATE);
}

/** No frame came in this cycle. It counts as missed only while the card is usable. */
static inline void link_note_missed(link_t *self)
{
    if (link_is_usable(self) && (self->frames_missed < UINT32_MAX)) {
        self->frames_missed++;
    }
}

/** First part of link_step() for every dialect: time passes, before the report of the cycle is
 * read. */
void link_advance(link_t *self, uint32_t elapsed_us);

/** The same, after it: the cycle had a report to count on, or had none, and none for too long. */
void link_judge(link_t *self, bool is_good);

/**
 * Drive that the card applied up to the sample of this cycle: by its own report, for it may have
 * refused the one that was sent. A card that has tripped does not report what it did until then.
 *
 * @satisfies SWR-LINK-013
 */
static inline const card_drive_t *link_applied(const link_t *self)
{
    const bool is_reported =
        (self->is_fresh != 0U) && ((self->report.status & CARD_STATUS_FAULTS) == 0U);
    return is_reported ? &self->report.applied : &self->sealed.sent_before;
}

/** Remembers what goes out in this cycle, for the comparison with the card's read-back. */
static inline void link_note_sent(link_t *self, uint32_t sequence, const card_drive_t *drive)
{
    self->sealed.sent_sequence_before = self->sealed.sent_sequence;
    self->sealed.sent_before = self->sealed.sent;
    self->sealed.sent_sequence = sequence;
    self->sealed.sent = *drive;
}

/**
 * Trusts a lost card again if it sent a valid frame without a fault in this cycle.
 *
 * @satisfies SWR-LINK-003
 */
void link_reset(link_t *self);

/** Its memory was damaged: all but its chart, which has its own complement, starts anew as
 * link_init(); a card in use is given up. */
void link_distrust(link_t *self, uint32_t card_type, uint32_t firmware);

/** Nothing was known against the lost card but that frames did not come through, one way or the
 * other. */
bool link_was_only_silent(const link_t *self);

/**
 * Called in each cycle of a lost card but the one in which it was lost; `missed_cycles` without a
 * report came before this one. True when its report shows that its counts may not go on from the
 * last one: it has begun anew, or may have, or comes back as another card or with a fault besides
 * its watchdog's.
 *
 * @satisfies SWR-REF-016
 * @satisfies SWR-REF-030
 */
bool link_has_broken(link_t *self, uint32_t missed_cycles);

/** The card answers, and for so long always by the same report: its program stands, and its counts
 * are unknown. */
static inline bool link_is_standing(const link_t *self)
{
    return (self->last_error == (uint16_t)CARD_FRAME_REPEATED) &&
           (self->sealed.age_cycles >= LIMIT_LINK_AGE_CYCLES);
}

/** The last report is of the card that must be there. */
static inline bool link_is_right_card(const link_t *self)
{
    return (self->report.card_type == self->sealed.card_type) &&
           (self->report.firmware == self->sealed.firmware);
}

/** A valid frame without a fault arrived in this cycle. */
static inline bool link_is_well(const link_t *self)
{
    return (self->is_fresh != 0U) && ((self->report.status & CARD_STATUS_FAULTS) == 0U);
}

/**
 * The right card sent a valid frame without a fault in this cycle; a card that is not usable also
 * accepted the command that it was sent.
 *
 * @satisfies SWR-LINK-042
 */
static inline bool link_is_healthy_now(const link_t *self)
{
    return link_is_well(self) && link_is_right_card(self) &&
           (link_is_usable(self) || (self->sealed.echo_mismatches == 0U));
}

#endif

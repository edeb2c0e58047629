/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The motion permit: the one decision whether an axis may be driven in this cycle. A pure function
 * of the cycle's facts. Everything else only requests motion; permit_apply() is the only way a
 * drive reaches a frame.
 */
#ifndef BORESIGHT_PERMIT_H
#define BORESIGHT_PERMIT_H

#include "card/card_frame.h"
#include "interface/box_input.h"
#include "interface/permit_reason.h"
#include "limits/requirement_limits.h"

#include <stdbool.h>
#include <stdint.h>

/* From the first to before the end they depend on where the axis stands and goes: in one motion
 * they may come and go. */
#define PERMIT_REASON_FIRST_OF_PLACE ((uint32_t)PERMIT_REASON_LIMIT_SWITCH)
#define PERMIT_REASON_END_OF_PLACE ((uint32_t)PERMIT_REASON_MEMORY)

/** The facts of one cycle that are the same for every axis. */
typedef struct {
    bool is_estop_pulled;
    bool is_estop_latched;
    bool is_loop_stopped;
    bool is_link_lost;
    bool is_pedal_faulty;
    bool is_scanner_active;
    bool is_armed;
    bool is_pedal_unproven;
    bool is_pedal_pressed;
    bool is_every_axis_homed;
    bool is_memory_damaged; /**< The table of the robot is. */
    /** The cards' dialect lacks protections, which is not accepted. */
    bool are_cards_unprotected;
    bool may_be_unhomed;   /**< The armed order may drive an axis that is not homed. */
    uint32_t hand_reasons; /**< hand_guard_reasons() of a mode in which a hand moves the needle;
                              else 0. */
} permit_common_facts_t;

/** Decision by these facts. */
typedef struct {
    uint32_t reasons;           /**< Against every axis; bit mask of permit_reason_t. */
    uint32_t unhomed_reasons;   /**< Against an axis that is not homed. */
    uint32_t speed_cap_percent; /**< permit_cap_percent(). */
} permit_common_t;

/** The facts of one cycle about one axis. */
typedef struct {
    bool is_axis_faulty;
    bool is_axis_enabled;
    bool is_homed;
    bool is_towards_switch; /**< Requested direction is towards an active limit switch. */
    /** Homed, at or beyond a soft limit, and requested to go further. */
    bool is_beyond_soft_limit;
    bool is_coupled_limit; /**< As coupled_guard_blocks() says. */
    bool is_needle_in;     /**< needle_forbids_jog() of the jog that is armed. */
    bool is_unsteered;     /**< Requested to go deeper, and mode_waits_for_rotation(). */
} permit_facts_t;

/** The answer for one axis. */
typedef struct {
    bool is_allowed;            /**< No reason stands. */
    uint32_t reasons;           /**< Bit mask of permit_reason_t. */
    uint32_t speed_cap_percent; /**< permit_cap_percent(), 0 when not allowed. */
} permit_t;

/**
 * The one rule how fast an axis may be, in percent of its speed.
 *
 * @satisfies SWR-AXIS-006
 */
static inline uint32_t permit_cap_percent(bool is_every_axis_homed)
{
    return is_every_axis_homed ? 100U : LIMIT_UNHOMED_SPEED_PERCENT;
}

/** The bit of an input of the box. */
static inline uint32_t permit_input(box_input_t input)
{
    return (uint32_t)1U << (uint32_t)input;
}

/** The bit of a reason, if it stands. */
static inline uint32_t permit_reason(bool stands, permit_reason_t name)
{
    return stands ? ((uint32_t)1U << (uint32_t)name) : 0U;
}

/**
 * Decides the part that is the same for every axis, once a cycle. Inputs in `unread`, bits of
 * box_input_t, allow nothing if they are pedal, e-stop or scanner; that is the reason then, and not
 * the state that they are taken for.
 *
 * @satisfies SWR-COOP-008
 * @satisfies SWR-PERMIT-004
 * @satisfies SWR-NI-006
 * @satisfies SWR-PEDAL-001
 * @satisfies SWR-PERMIT-040
 */
permit_common_t permit_decide_common(const permit_common_facts_t *facts, uint32_t unread);

/**
 * Decides for one axis.
 *
 * @satisfies SWR-PERMIT-001
 * @satisfies SWR-CHART-034
 */
static inline permit_t permit_decide(const permit_common_t *common, const permit_facts_t *facts)
{
    uint32_t reasons = common->reasons;
    reasons |= facts->is_homed ? 0U : common->unhomed_reasons;
    reasons |= permit_reason(facts->is_axis_faulty, PERMIT_REASON_AXIS_FAULT);
    reasons |= permit_reason(!facts->is_axis_enabled, PERMIT_REASON_AXIS_DISABLED);
    reasons |= permit_reason(facts->is_towards_switch, PERMIT_REASON_LIMIT_SWITCH);
    reasons |= permit_reason(facts->is_beyond_soft_limit, PERMIT_REASON_SOFT_LIMIT);
    reasons |= permit_reason(facts->is_coupled_limit, PERMIT_REASON_COUPLED_LIMIT);
    reasons |= permit_reason(facts->is_needle_in, PERMIT_REASON_NEEDLE_IN);
    reasons |= permit_reason(facts->is_unsteered, PERMIT_REASON_ROTATION_LAGS);
    const permit_t permit = {.is_allowed = (reasons == 0U),
                             .reasons = reasons,
                             .speed_cap_percent = (reasons == 0U) ? common->speed_cap_percent : 0U};
    return permit;
}

/**
 * The drive that may go into the card's frame: `requested` if it is allowed and the axis is not
 * faster than its cap, otherwise off.
 *
 * @satisfies SWR-PERMIT-002
 */
static inline card_drive_t permit_apply(const permit_t *permit, bool is_too_fast,
                                        const card_drive_t *requested)
{
    const card_drive_t off = {.mode = (uint32_t)CARD_DRIVE_OFF, .direction = 0U, .duty = 0U};
    return (permit->is_allowed && !is_too_fast) ? *requested : off;
}

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/* Checks of the duration of a cycle. */
#include "check/check.h"
#include "check/check_judges.h"

#include "card/card_dialect.h"
#include "limits/requirement_limits.h"

#define BITS_OF_BYTE 8U
#define NS_PER_US 1000U
#define US_PER_S UINT64_C(1000000)

bool check_wake_up(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    return check_say((facts->cycles != 0U) && (facts->wake_worst_us <= LIMIT_WAKE_UP_US), found,
                     "Of %u wake-ups 99 %% were at most %u us late and the worst %u us; at most %u "
                     "us are allowed.",
                     (unsigned)facts->cycles, (unsigned)facts->wake_p99_us,
                     (unsigned)facts->wake_worst_us, LIMIT_WAKE_UP_US);
}

check_budget_t check_budget(const check_board_t *board, uint32_t cards)
{
    const uint64_t bytes = card_dialect_frame_bytes(board->dialect);
    const uint64_t words = (uint64_t)cards * (bytes / sizeof(uint32_t));
    const uint64_t turns = (cards + board->wires - 1U) / board->wires;
    const uint64_t bits = turns * bytes * BITS_OF_BYTE;
    const uint32_t instructions = (LIMIT_CYCLE_MEDIAN_INSTRUCTIONS / LIMIT_CYCLE_CARDS) * cards;
    return (check_budget_t){.wake_us = LIMIT_WAKE_UP_US,
                            .words_us = (uint32_t)((words * board->word_ns) / NS_PER_US),
                            .step_us = instructions / board->instructions_per_us,
                            .publish_us = board->publish_us,
                            .wire_us = (uint32_t)((bits * US_PER_S) / board->wire_hz)};
}

static uint32_t until_sent_us(const check_budget_t *budget)
{
    return budget->wake_us + budget->words_us + budget->step_us;
}

/* The frames are back before the next cycle, and between them the processor rests. */
static bool fits(const check_budget_t *budget)
{
    return ((until_sent_us(budget) + budget->publish_us) <= LIMIT_CYCLE_BUDGET_US) &&
           ((until_sent_us(budget) + budget->wire_us) <= LIMIT_CYCLE_US);
}

/*
 * The number of cards for which a cycle has time.
 *
 * @satisfies SWR-CHECK-010
 */
static uint32_t count_fitting(const check_board_t *board)
{
    uint32_t cards = CHECK_CARDS;
    check_budget_t budget = check_budget(board, cards);

    while ((cards > 0U) && !fits(&budget)) {
        cards--;
        budget = check_budget(board, cards);
    }
    return cards;
}

bool check_cycle_budget(const check_facts_t *facts, char found[CHECK_TEXT_SIZE])
{
    const check_board_t *const board = &facts->board;
    if ((board->wire_hz == 0U) || (board->wires == 0U) || (board->instructions_per_us == 0U)) {
        return check_say(facts->is_simulated, found, "The board says nothing of its wires.");
    }
    const check_budget_t budget = check_budget(board, CHECK_CARDS);
    const uint32_t sent_us = until_sent_us(&budget);
    return check_say(
        fits(&budget), found,
        "With %u cards wake-up %u + words %u + step %u + publish %u = %u us of %u; the "
        "wires take %u us, frames are back after %u us of %u. There is time for %u "
        "cards.",
        CHECK_CARDS, (unsigned)budget.wake_us, (unsigned)budget.words_us, (unsigned)budget.step_us,
        (unsigned)budget.publish_us, (unsigned)(sent_us + budget.publish_us), LIMIT_CYCLE_BUDGET_US,
        (unsigned)budget.wire_us, (unsigned)(sent_us + budget.wire_us), LIMIT_CYCLE_US,
        (unsigned)count_fitting(board));
}

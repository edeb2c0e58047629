/* SPDX-License-Identifier: Apache-2.0 */
#include "control/computer.h"

#include "check/check.h"
#include "check/realtime.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"

#include <stdio.h>
#include <string.h>

#define LINE_SIZE (3U * CHECK_TEXT_SIZE)

static uint32_t bit(computer_check_t check)
{
    return (uint32_t)1U << (uint32_t)check;
}

/* Adds what was found to the line that is said. */
static void note(char line[LINE_SIZE], computer_check_t check, const char *found)
{
    const size_t length = strlen(line);
    const int stop = (int)strlen(found) - 1; /* Its full stop. */
    (void)snprintf(&line[length], LINE_SIZE - length, "%s%s (%.*s)", (length > 0U) ? ", " : "",
                   computer_check_name((int32_t)check), stop, found);
}

void computer_begin(computer_t *self, const char *root, uint32_t rights)
{
    static check_facts_t facts;
    char line[LINE_SIZE] = "";
    (void)memset(&facts, 0, sizeof facts);
    facts.root = root;
    facts.rights = rights;
    self->lacks = 0U;
    self->looks = 0U;
    realtime_report(rights);
    for (uint32_t i = 0U; i < COMPUTER_CHECK_COUNT; i++) {
        const computer_check_t check = (computer_check_t)i;
        const bool stays = check_blocks(check) && (check != COMPUTER_CHECK_PAGE_FAULTS);
        char found[CHECK_TEXT_SIZE];
        if (stays && !check_is_good(&facts, check, found)) {
            self->lacks |= bit(check);
            note(line, check, found);
        }
    }
    if (self->lacks != 0U) {
        (void)fprintf(
            stderr,
            "control: this computer cannot drive a real robot: %s; boresight --check says "
            "what to do.\n",
            line);
    }
    realtime_count_faults(&self->minor_faults, &self->major_faults);
}

void computer_look(computer_t *self, loop_figures_t *published)
{
    uint64_t minor = 0U;
    uint64_t major = 0U;
    realtime_count_faults(&minor, &major);
    const bool has_any = (minor != self->minor_faults) || (major != self->major_faults);
    published->minor_faults += (uint32_t)(minor - self->minor_faults);
    published->major_faults += (uint32_t)(major - self->major_faults);
    self->minor_faults = minor;
    self->major_faults = major;
    self->lacks &= ~bit(COMPUTER_CHECK_PAGE_FAULTS);
    self->lacks |= has_any ? bit(COMPUTER_CHECK_PAGE_FAULTS) : 0U;
    published->computer = self->lacks;
}

void computer_report_wake_up(computer_t *self, const loop_figures_t *published)
{
    check_facts_t facts;
    char found[CHECK_TEXT_SIZE];

    self->looks += (self->looks <= LIMIT_START_LOOK_S) ? 1U : 0U;
    if ((self->looks != LIMIT_START_LOOK_S) || (published->is_elastic != 0U)) {
        return;
    }
    (void)memset(&facts, 0, sizeof facts);
    facts.cycles = (uint32_t)published->cycles;
    facts.wake_p99_us = published->wake_p99_us;
    facts.wake_worst_us = published->wake_worst_us;
    if (check_is_good(&facts, COMPUTER_CHECK_WAKE_UP, found)) {
        (void)fprintf(stderr, "control: %s This computer can be expected to keep %u us.\n", found,
                      LIMIT_CYCLE_US);
    } else {
        (void)fprintf(
            stderr,
            "control: %s This computer cannot be expected to keep %u us: motion will stop "
            "now and then, START_UP goes on; boresight --check says what to do.\n",
            found, LIMIT_CYCLE_US);
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: an event reads as a sentence that says what happened to what, and because of
 * whom.
 */
#include "common/event_text.h"

#include "interface/app/names.h"
#include "interface/card_frame_result.h"
#include "interface/card_trouble.h"
#include "interface/command.h"
#include "interface/link_cause.h"
#include "interface/mode_list.h"
#include "interface/status.h"
#include "interface/workphase_list.h"
#include "robot/robot_neuro.h"
#include "unity.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#define LAST_CAUSE ((uint32_t)EVENT_CAUSE_LOOP)
#define MOST_EVENTS 64U

static char text[EVENT_TEXT_SIZE];

void setUp(void)
{
}

void tearDown(void)
{
}

static void expect(event_t event, const char *sentence)
{
    event_text_sentence(&robot_neuro, &event, NULL, text, sizeof text);
    TEST_ASSERT_EQUAL_STRING(sentence, text);
}

void test_SWR_EVENT_007_a_sentence_ends_with_its_cause(void)
{
    expect((event_t){.id = EVENT_WORKPHASE,
                     .subject = WORKPHASE_STOP,
                     .cause = EVENT_CAUSE_CONSOLE,
                     .peer = 51234U},
           "Workphase entered STOP. By the console, page 51234.");
    expect(
        (event_t){.id = EVENT_WORKPHASE, .subject = WORKPHASE_STOP, .cause = EVENT_CAUSE_CONSOLE},
        "Workphase entered STOP. By the console.");
    expect((event_t){.id = EVENT_ORDER_DISCARDED,
                     .subject = MODE_MOVE,
                     .cause = EVENT_CAUSE_IGTL,
                     .peer = 3U},
           "MOVE was discarded. By OpenIGTLink peer 3.");
    expect((event_t){.id = EVENT_ORDER_DISCARDED, .subject = MODE_MOVE, .cause = EVENT_CAUSE_IGTL},
           "MOVE was discarded. By the loss of an OpenIGTLink peer.");
    expect((event_t){.id = EVENT_ORDER_DISCARDED, .subject = MODE_MOVE, .cause = EVENT_CAUSE_ESTOP},
           "MOVE was discarded. By the e-stop.");
    expect((event_t){.id = EVENT_ORDER_DISCARDED,
                     .subject = MODE_MOVE,
                     .cause = EVENT_CAUSE_AXIS,
                     .peer = NEURO_AXIS_HEAD},
           "MOVE was discarded. By axis head.");
    expect((event_t){.id = EVENT_ORDER_DISCARDED,
                     .subject = MODE_MOVE,
                     .cause = EVENT_CAUSE_CARD,
                     .peer = robot_neuro.axes[NEURO_AXIS_INSERTION].slot},
           "MOVE was discarded. By card 3 (insertion).");
}

void test_SWR_EVENT_007_an_event_that_says_its_cause_itself_says_it_once(void)
{
    expect((event_t){.id = EVENT_ESTOP_PULLED}, "The e-stop was pulled.");
}

void test_SWR_EVENT_007_a_refused_frame_is_reported_with_its_reason_by_name(void)
{
    const uint32_t slot = robot_neuro.axes[NEURO_AXIS_YAW].slot;
    char sentence[EVENT_TEXT_SIZE];

    (void)snprintf(sentence, sizeof sentence, "Frame of card %u (yaw) discarded, why BAD_START.",
                   (unsigned)slot);
    expect((event_t){.id = EVENT_FRAME_REFUSED, .subject = slot, .value = CARD_FRAME_BAD_START},
           sentence);
}

void test_SWR_EVENT_007_numbers_are_reported_as_what_they_are(void)
{
    const uint32_t slot = robot_neuro.axes[NEURO_AXIS_YAW].slot;
    char card[EVENT_TEXT_SIZE];

    expect((event_t){.id = EVENT_COMMAND_REFUSED, .subject = COMMAND_JOG, .value = STATUS_BUSY},
           "Command of kind JOG refused, status BUSY.");
    expect((event_t){.id = EVENT_PROBE_LENGTH, .subject = 1U, .value = 5000000},
           "The probe's robot_to_entry is now 5000000 nm.");
    expect((event_t){.id = EVENT_REFUSED_LENGTH, .subject = 9U, .value = -1},
           "Refused: the probe's ? of -1 nm.");
    expect((event_t){.id = EVENT_SENT_PLACE, .subject = PLAN_PLACE_TARGET_Y, .value = -7},
           "Sent: TARGET_Y -7 nm.");
    expect((event_t){.id = EVENT_SENT_ROTATION,
                     .subject = PLAN_ROTATION_REGISTRATION_ZX,
                     .value = 500000},
           "Sent: REGISTRATION_ZX 500000 millionths.");
    expect((event_t){.id = EVENT_SCANNER, .value = 1}, "The scanner started acquiring.");
    expect((event_t){.id = EVENT_SCANNER}, "The scanner ended acquiring.");
    expect((event_t){.id = EVENT_AXIS_MOVED_OFF, .subject = NEURO_AXIS_YAW, .value = -7},
           "Axis yaw moved -0.504 deg (-7 ticks) while its drive was off.");
    expect((event_t){.id = EVENT_AXIS_WRONG_SPEED, .subject = NEURO_AXIS_YAW, .value = 31},
           "Axis yaw counted 31 percent of what its motor should make.");
    expect((event_t){.id = EVENT_OVERRUN, .subject = 2U, .value = 1700},
           "The loop was late, interval in us 1700, stage STEP.");
    expect((event_t){.id = EVENT_CHART_REPAIRED, .subject = EVENT_CHART_ESTOP},
           "A chart's state was damaged; chart ESTOP went to its safe state.");
    (void)snprintf(card, sizeof card,
                   "A chart's state was damaged; chart CARD %u (yaw) went to its safe state.",
                   (unsigned)slot);
    expect(
        (event_t){.id = EVENT_CHART_REPAIRED, .subject = EVENT_CHART_CARD, .value = (int32_t)slot},
        card);
    expect((event_t){.id = EVENT_MEMORY_DAMAGED,
                     .subject = EVENT_MEMORY_CARD,
                     .value = NEURO_AXIS_YAW},
           "Memory was damaged and forgotten: CARD yaw.");
    expect((event_t){.id = EVENT_ROBOT_TABLE_DAMAGED, .subject = UINT32_MAX},
           "The table of the robot is damaged in geometry: restart the programs.");
}

void test_SWR_EVENT_180_ticks_of_an_axis_are_reported_in_its_unit_too(void)
{
    expect((event_t){.id = EVENT_AXIS_UNVERIFIED, .subject = NEURO_AXIS_HEAD, .value = 7874},
           "The position of axis head is in doubt, it is shown at 100.000 mm (7874 ticks).");
    expect((event_t){.id = EVENT_AXIS_HOMED, .subject = NEURO_AXIS_YAW, .value = 0},
           "Axis yaw homed, correction 0.000 deg (0 ticks).");
    expect((event_t){.id = EVENT_AXIS_STALLED, .subject = NEURO_AXIS_PITCH, .value = -139},
           "Axis pitch stalled at -10.008 deg (-139 ticks).");
    expect((event_t){.id = EVENT_AXIS_UNVERIFIED, .subject = NEURO_AXIS_INSERTION, .value = -1},
           "The position of axis insertion is in doubt, it is shown at 0.000 mm (-1 ticks).");
    /* An axis that the robot does not have. */
    expect((event_t){.id = EVENT_AXIS_STALLED, .subject = ROBOT_AXIS_MAX, .value = 5},
           "Axis ? stalled at 5 ticks.");
}

void test_SWR_EVENT_007_a_loss_is_reported_with_what_its_cause_means(void)
{
    const uint32_t slot = robot_neuro.axes[NEURO_AXIS_INSERTION].slot;

    expect((event_t){.id = EVENT_CARD_LOST, .subject = slot, .value = LINK_CAUSE_AGE},
           "Card 3 (insertion) is lost. No frame of it came for several cycles: check its cable "
           "and its supply.");
    expect((event_t){.id = EVENT_CARD_UNWELL, .subject = slot, .value = CARD_TROUBLE_SUPPLY_LOW},
           "Card 3 (insertion) is not well. Its supply is too low: look at the power supply and "
           "its wires.");
    expect((event_t){.id = EVENT_CARD_WELL, .subject = slot, .value = CARD_TROUBLE_SUPPLY_LOW},
           "Card 3 (insertion) is well again, no longer SUPPLY_LOW.");
}

/* A sentence whose values each have one of their own. */
void test_SWR_EVENT_007_the_longest_cause_of_a_loss_fits(void)
{
    for (int32_t cause = 0; cause <= (int32_t)LINK_CAUSE_LOOP_LATE; cause++) {
        event_text_sentence(&robot_neuro,
                            &(event_t){.id = EVENT_CARD_LOST, .subject = 9U, .value = cause}, NULL,
                            text, sizeof text);
        TEST_ASSERT_NOT_NULL(strstr(text, link_cause_text(cause)));
    }
}

/* Every number of an event that has a name. */
void test_SWR_EVENT_007_every_event_fits_with_every_cause(void)
{
    for (uint32_t id = 0U; id < MOST_EVENTS; id++) {
        for (uint32_t cause = 0U; cause <= LAST_CAUSE; cause++) {
            const event_t event = {.id = id,
                                   .subject = NEURO_AXIS_INSERTION,
                                   .value = INT32_MIN,
                                   .cause = cause,
                                   .peer = UINT32_MAX};
            event_text_sentence(&robot_neuro, &event, NULL, text, sizeof text);
            const bool is_known = event_id_text((int32_t)id)[0] != '\0';
            TEST_ASSERT_TRUE(!is_known || (text[strlen(text) - 1U] == '.'));
            TEST_ASSERT_LESS_THAN_size_t(EVENT_TEXT_SIZE - 1U, strlen(text));
        }
    }
}

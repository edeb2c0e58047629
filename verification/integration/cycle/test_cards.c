/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: each slot of the box has its link. A card without an axis is judged, shown and
 * reported, and no axis stops for it; one that the robot does not name is reported once.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "base/seal.h"
#include "controller/controller.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

#include <stddef.h>
#include <string.h>

#define SENSOR 8U
#define STRANGER 9U
#define SILENT_CYCLES (LIMIT_LINK_AGE_CYCLES + 2U)

static rig_t rig;
static robot_t robot; /* The NeuroRobot with a card that has no motor. */

void setUp(void)
{
    robot = robot_neuro;
    rig_put_near_switches(&robot);
    robot.sensor_slots = (uint32_t)1U << SENSOR;
    robot.seal = seal_of(SEAL_START, (const uint8_t *)&robot, offsetof(robot_t, seal));
    rig_start_robot(&rig, &robot);
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static const snapshot_card_t *shown(uint32_t slot)
{
    return &rig.outputs.snapshot.cards[slot];
}

/* Number of times that `id` was reported of the card in `slot`. */
static uint32_t reported(event_id_t id, uint32_t slot)
{
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        count += ((rig.events[i].id == (uint32_t)id) && (rig.events[i].subject == slot)) ? 1U : 0U;
    }
    return count;
}

static card_command_t sent_to(uint32_t slot)
{
    card_command_t command;
    TEST_ASSERT_EQUAL(CARD_FRAME_OK,
                      card_frame_decode_command(rig.outputs.frames[slot], slot, &command));
    return command;
}

static card_command_t sent_to_sensor(void)
{
    return sent_to(SENSOR);
}

static void begin_jog(void)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_LATERAL, .to_ticks = -2000}};
    rig_home(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    rig_cycles(&rig, 100U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_forget(&rig);
}

void test_SWR_LINK_009_a_card_without_an_axis_is_judged_and_shown(void)
{
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_CARD_LIVE, SENSOR));
    TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LIVE, shown(SENSOR)->link);
    TEST_ASSERT_EQUAL_UINT32(CARD_TYPE_SENSOR, shown(SENSOR)->card_type);
    TEST_ASSERT_EQUAL_UINT32(0U, shown(SENSOR)->age_cycles);
    rig_box(&rig, "card 8 corrupt");
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_FRAME_REFUSED, SENSOR));
    TEST_ASSERT_EQUAL_UINT32(1U, shown(SENSOR)->frame_errors);
    TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LATE, shown(SENSOR)->link);
}

void test_SWR_LINK_009_the_firmware_of_a_card_without_an_axis_is_judged(void)
{
    rig_box(&rig, "card 8 foreign");
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LOST, shown(SENSOR)->link);
    TEST_ASSERT_EQUAL_UINT32(LINK_CAUSE_WRONG_CARD, rig.controller.links[SENSOR].sealed.cause);
}

void test_SWR_LINK_010_its_drive_is_off_in_every_cycle_while_an_axis_is_driven(void)
{
    begin_jog();
    for (uint32_t i = 0U; i < 100U; i++) {
        rig_cycle(&rig);
        const card_command_t command = sent_to_sensor();
        TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, command.drive.mode);
        TEST_ASSERT_EQUAL_HEX32(0U, command.control);
        TEST_ASSERT_EQUAL_HEX32(CARD_NO_AXIS, command.axis_id);
        TEST_ASSERT_BITS_LOW(CARD_SYSTEM_PERMIT, command.system_state);
        TEST_ASSERT_EQUAL_UINT32(LIMIT_CARD_WATCHDOG_US, command.watchdog_us);
    }
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

void test_SWR_LINK_010_it_is_reported_as_lost_and_no_axis_stops_for_it(void)
{
    begin_jog();
    rig_box(&rig, "card 8 silent");
    rig_cycles(&rig, SILENT_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_LOST));
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_CARD_LOST, SENSOR));
    TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LOST, shown(SENSOR)->link);
    TEST_ASSERT_EQUAL_HEX32(CARD_CONTROL_CLEAR_FAULT, sent_to_sensor().control);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 20000U).kind);
}

void test_SWR_LINK_010_start_up_begins_without_it_and_ends_its_loss(void)
{
    rig_box(&rig, "card 8 silent");
    rig_cycles(&rig, SILENT_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LOST, shown(SENSOR)->link);
    rig_box(&rig, "card 8 normal");
    rig_cycles(&rig, 5U);
    TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LOST, shown(SENSOR)->link);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LIVE, shown(SENSOR)->link);
}

void test_SWR_LINK_010_damaged_memory_of_it_is_reported_and_no_axis_stops_for_it(void)
{
    static rig_t moving;
    begin_jog();
    moving = rig;
    for (size_t i = 0U; i < sizeof rig.controller.links[SENSOR].sealed; i += 4U) {
        rig = moving;
        ((uint8_t *)&rig.controller.links[SENSOR].sealed)[i] ^= 0x10U;
        rig_cycle(&rig);
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_LOST));
        TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_CARD_LOST, SENSOR));
        TEST_ASSERT_EQUAL_INT32(LINK_CAUSE_MEMORY, rig.events[0].value);
        TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LOST, shown(SENSOR)->link);
        TEST_ASSERT_TRUE(rig_is_driving(&rig));
    }
}

/* A valid report of a card that the robot does not name. */
static void answer(uint32_t heartbeat)
{
    const card_report_t report = {.slot = STRANGER,
                                  .heartbeat = heartbeat,
                                  .card_type = (uint32_t)CARD_TYPE_PWM,
                                  .firmware = robot.card_firmware};
    card_frame_encode_report(&report, rig.inputs.frames[STRANGER]);
}

/* The next cycle, but that the board hands over a frame from that slot as well. */
static void cycle_with_unexpected_card(void)
{
    static uint8_t frame[CARD_FRAME_BYTES];
    (void)memcpy(frame, rig.inputs.frames[STRANGER], sizeof frame);
    rig.inputs.frames_received =
        box_exchange(&rig.box, rig.outputs.frames_to_send,
                     (const uint8_t(*)[CARD_FRAME_BYTES])rig.outputs.frames, rig.inputs.frames) |
        ((uint32_t)1U << STRANGER);
    (void)memcpy(rig.inputs.frames[STRANGER], frame, sizeof frame);
    box_advance(&rig.box, 1000U);
    controller_step(&rig.controller, &rig.robot, &rig.inputs, &rig.outputs);
    for (uint32_t i = 0U; i < rig.outputs.event_count; i++) {
        rig.events[rig.event_count] = rig.outputs.events[i];
        rig.event_count++;
    }
}

void test_SWR_LINK_011_a_card_that_the_robot_does_not_name_is_reported_of_once_and_shown(void)
{
    begin_jog();
    for (uint32_t i = 1U; i <= 20U; i++) {
        answer(i);
        cycle_with_unexpected_card();
        TEST_ASSERT_EQUAL_HEX32(0U, rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].permit_reasons);
    }
    TEST_ASSERT_EQUAL_UINT32(1U, rig.event_count);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_UNEXPECTED_CARD, STRANGER));
    TEST_ASSERT_EQUAL_INT32(CARD_TYPE_PWM, rig.events[0].value);
    TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LOST, shown(STRANGER)->link);
    TEST_ASSERT_EQUAL_UINT32(CARD_TYPE_PWM, shown(STRANGER)->card_type);
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, sent_to(STRANGER).drive.mode);
    TEST_ASSERT_EQUAL_HEX32(CARD_NO_AXIS, sent_to(STRANGER).axis_id);
    TEST_ASSERT_EQUAL_UINT32(0U, shown(STRANGER)->age_cycles);
    rig_cycles(&rig, 3U);
    TEST_ASSERT_EQUAL_UINT32(3U, shown(STRANGER)->age_cycles);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.event_count);
}

void test_SWR_LINK_011_noise_from_an_empty_slot_is_no_card(void)
{
    begin_jog();
    for (uint32_t i = 1U; i <= 20U; i++) {
        answer(i);
        rig.inputs.frames[STRANGER][30] ^= 1U;
        cycle_with_unexpected_card();
    }
    TEST_ASSERT_EQUAL_UINT32(0U, rig.event_count);
    TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_ABSENT, shown(STRANGER)->link);
    TEST_ASSERT_EQUAL_UINT32(CARD_TYPE_NONE, shown(STRANGER)->card_type);
    TEST_ASSERT_EQUAL_HEX32(0U, rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].permit_reasons);
}

void test_SWR_LINK_011_start_up_does_not_make_it_one_of_the_robot(void)
{
    answer(1U);
    cycle_with_unexpected_card();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    answer(2U);
    cycle_with_unexpected_card();
    TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LOST, shown(STRANGER)->link);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_UNEXPECTED_CARD, STRANGER));
}

/* Slots without a named card that this cycle sends to. */
static uint32_t looked_at(void)
{
    return rig.outputs.frames_to_send & ~rig.controller.cards.named_slots;
}

static void plug(const char *order)
{
    rig_box(&rig, order);
    rig_forget(&rig);
}

void test_SWR_DRIVE_011_each_empty_slot_is_looked_at_in_its_turn_with_the_drive_off(void)
{
    uint32_t seen = 0U;
    for (uint32_t i = 0U; i < (LIMIT_PROBE_CYCLES * CARD_SLOT_COUNT); i++) {
        rig_cycle(&rig);
        const uint32_t now = looked_at();
        TEST_ASSERT_EQUAL_HEX32(0U, now & (now - 1U));
        TEST_ASSERT_EQUAL_HEX32(0U, now & seen);
        for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
            if (now == ((uint32_t)1U << slot)) {
                TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, sent_to(slot).drive.mode);
                TEST_ASSERT_EQUAL_UINT32(0U,
                                         (rig.controller.sealed.cycle - 1U) % LIMIT_PROBE_CYCLES);
            }
        }
        seen |= now;
    }
    TEST_ASSERT_EQUAL_HEX32(CARD_EVERY_SLOT & ~rig.controller.cards.named_slots, seen);
}

void test_SWR_DRIVE_011_a_card_that_is_plugged_in_is_found_and_stays_shown(void)
{
    plug("plug 9 analog");
    rig_cycles(&rig, (LIMIT_PROBE_CYCLES * CARD_SLOT_COUNT) + 1U);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_UNEXPECTED_CARD, STRANGER));
    TEST_ASSERT_EQUAL_UINT32(CARD_TYPE_ANALOG, shown(STRANGER)->card_type);
    begin_jog();
    for (uint32_t i = 0U; i < 100U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_EQUAL_HEX32((uint32_t)1U << STRANGER, looked_at());
        TEST_ASSERT_EQUAL_UINT32(0U, shown(STRANGER)->age_cycles);
    }
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.event_count);
}

void test_SWR_DRIVE_011_no_slot_is_looked_at_while_an_axis_is_driven(void)
{
    begin_jog();
    plug("plug 9 pwm");
    for (uint32_t i = 0U; i < (LIMIT_PROBE_CYCLES * CARD_SLOT_COUNT); i++) {
        rig_cycle(&rig);
        TEST_ASSERT_TRUE(!rig_is_driving(&rig) || (looked_at() == 0U));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, reported(EVENT_UNEXPECTED_CARD, STRANGER));
}

void test_SWR_DRIVE_012_a_card_that_is_taken_out_is_reported_and_another_found(void)
{
    plug("plug 9 analog");
    rig_cycles(&rig, (LIMIT_PROBE_CYCLES * CARD_SLOT_COUNT) + 1U);
    plug("plug 9 none");
    rig_cycles(&rig, LIMIT_LINK_AGE_CYCLES - 1U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.event_count);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_CARD_LOST, STRANGER));
    TEST_ASSERT_EQUAL_INT32(LINK_CAUSE_AGE, rig.events[0].value);
    TEST_ASSERT_EQUAL_UINT32(CARD_TYPE_NONE, shown(STRANGER)->card_type);
    plug("plug 9 high_frequency");
    rig_cycles(&rig, (LIMIT_PROBE_CYCLES * CARD_SLOT_COUNT) + 1U);
    TEST_ASSERT_EQUAL_UINT32(1U, reported(EVENT_UNEXPECTED_CARD, STRANGER));
    TEST_ASSERT_EQUAL_UINT32(CARD_TYPE_HIGH_FREQUENCY, shown(STRANGER)->card_type);
}

void test_SWR_DRIVE_013_what_the_converters_read_is_shown(void)
{
    plug("plug 9 sensor");
    rig_box(&rig, "force hand 2345");
    rig_cycles(&rig, (LIMIT_PROBE_CYCLES * CARD_SLOT_COUNT) + 1U);
    for (uint32_t slot = SENSOR; slot <= STRANGER; slot++) {
        TEST_ASSERT_EQUAL_HEX32(2345U, shown(slot)->adc_words[0]);
        TEST_ASSERT_EQUAL_HEX32(BOX_NEEDLE_AT_REST << 16U, shown(slot)->adc_words[1]);
    }
    rig_box(&rig, "force needle 17");
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_HEX32(17U << 16U, shown(SENSOR)->adc_words[1]);
    plug("plug 9 none");
    rig_cycles(&rig, LIMIT_LINK_AGE_CYCLES);
    TEST_ASSERT_EQUAL_HEX32(0U, shown(STRANGER)->adc_words[0]);
}

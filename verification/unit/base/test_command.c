/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: what a command says is read by its kind alone. */
#include "unit/support/contract_trap.h"
#include "unity.h"

#include "interface/command.h"

#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

/* The data of a command begins at the same place in every form. */
static const void *read_as(command_form_t form, const command_t *command)
{
    switch (form) {
    case COMMAND_FORM_WORKPHASE:
        return command_as_workphase(command);
    case COMMAND_FORM_REGISTRATION:
        return command_as_registration(command);
    case COMMAND_FORM_POSE:
        return command_as_pose(command);
    case COMMAND_FORM_SEEN_POSE:
        return command_as_seen_pose(command);
    case COMMAND_FORM_JOG:
        return command_as_jog(command);
    case COMMAND_FORM_WITHDRAWAL:
        return command_as_withdrawal(command);
    case COMMAND_FORM_REQUEST:
        return command_as_request(command);
    case COMMAND_FORM_POSITIONS:
        return command_as_positions(command);
    case COMMAND_FORM_NOTE:
        return command_as_note(command);
    case COMMAND_FORM_AXIS:
        return command_as_axis(command);
    case COMMAND_FORM_LIST_BEGIN:
        return command_as_list_begin(command);
    case COMMAND_FORM_ROW:
        return command_as_row(command);
    case COMMAND_FORM_LIST:
        return command_as_list(command);
    case COMMAND_FORM_VELOCITY:
        return command_as_velocity(command);
    case COMMAND_FORM_PROBE:
        return command_as_probe(command);
    case COMMAND_FORM_MEMBRANES:
        return command_as_membranes(command);
    case COMMAND_FORM_STEERING:
        return command_as_steering(command);
    case COMMAND_FORM_JOG_BY:
        return command_as_jog_by(command);
    case COMMAND_FORM_POSE_NAME:
        return command_as_pose_name(command);
    case COMMAND_FORM_STEP:
        return command_as_step(command);
    case COMMAND_FORM_SWEEP:
        return command_as_sweep(command);
    case COMMAND_FORM_NONE:
    default:
        return NULL;
    }
}

static uint32_t last_form(void)
{
    uint32_t last = 0U;
    for (uint32_t kind = 0U; kind < COMMAND_KIND_COUNT; kind++) {
        last = (command_traits[kind].form > last) ? command_traits[kind].form : last;
    }
    return last;
}

void test_SWR_CMD_008_each_kind_is_read_as_its_own_form_and_as_no_other(void)
{
    for (uint32_t kind = 0U; kind <= COMMAND_KIND_COUNT; kind++) {
        const command_t command = {.kind = kind};
        const uint32_t own = (kind < COMMAND_KIND_COUNT) ? command_traits[kind].form : 0U;
        for (uint32_t form = 1U; form <= last_form(); form++) {
            if (form == own) {
                TEST_ASSERT_EQUAL_PTR(&command.as, read_as((command_form_t)form, &command));
            } else {
                EXPECT_CONTRACT("command", form, (void)read_as((command_form_t)form, &command));
            }
        }
    }
}

void test_SWR_CMD_007_only_the_bytes_that_a_kind_uses_are_left(void)
{
    for (uint32_t kind = 0U; kind <= COMMAND_KIND_COUNT; kind++) {
        const uint32_t used = (kind < COMMAND_KIND_COUNT) ? command_traits[kind].bytes : 0U;
        const uint8_t nothing[sizeof(command_payload_t)] = {0U};
        command_t command;
        (void)memset(&command, 0x5A, sizeof command);
        command.kind = kind;
        command_clear_unused(&command);
        const uint8_t *const bytes = (const uint8_t *)&command.as;
        for (uint32_t i = 0U; i < used; i++) {
            TEST_ASSERT_EQUAL_HEX8(0x5A, bytes[i]);
        }
        TEST_ASSERT_EQUAL_INT(0, memcmp(&bytes[used], nothing, sizeof nothing - used));
        TEST_ASSERT_EQUAL_HEX32(0x5A5A5A5AU, command.peer);
    }
}

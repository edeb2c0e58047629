/* SPDX-License-Identifier: Apache-2.0 */
#include "procedure/command_kinds.h"

workphase_t command_kinds_workphase(const command_t *command)
{
    workphase_t asked = WORKPHASE_UNDEFINED;
    if ((command->kind == (uint32_t)COMMAND_WORKPHASE) &&
        (command->as.workphase.workphase < WORKPHASE_COUNT)) {
        asked = (workphase_t)command->as.workphase.workphase;
    }
    return asked;
}

bool command_kinds_is_stop(const command_t *command)
{
    const workphase_t asked = command_kinds_workphase(command);
    return (asked == WORKPHASE_STOP) || (asked == WORKPHASE_EMERGENCY);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "oracle/commanding.h"

#include "interface/authority_list.h"
#include "interface/workphase_list.h"

bool commanding_is_stop(const command_t *command)
{
    return (command->kind == (uint32_t)COMMAND_WORKPHASE) &&
           ((command->as.workphase.workphase == (uint32_t)WORKPHASE_STOP) ||
            (command->as.workphase.workphase == (uint32_t)WORKPHASE_EMERGENCY));
}

bool commanding_needs_authority(const command_t *command)
{
    switch (command->kind) {
    case (uint32_t)COMMAND_WORKPHASE:
        return !commanding_is_stop(command);
    case (uint32_t)COMMAND_WITHDRAW:
        return (command->source == (uint32_t)COMMAND_SOURCE_HTTP) ||
               (command->as.withdrawal.of == (uint32_t)COMMAND_ENTRY);
    case (uint32_t)COMMAND_REQUEST:
        return command->as.request.request == (uint32_t)AUTHORITY_REQUEST_CONFIRM;
    default:
        return (command->kind >= COMMAND_KIND_COUNT) ||
               (((COMMAND_KINDS_FREE >> command->kind) & 1U) == 0U);
    }
}

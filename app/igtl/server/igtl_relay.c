/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/server/igtl_relay.h"

#include "procedure/command_kinds.h"

/* A command that was not passed on comes back as refused. */
static void refuse_command(const command_t *command, status_t status, uint32_t workphase,
                           igtl_relay_hand_in_t hand_in)
{
    const answer_t refusal = {.id = command->id,
                              .source = command->source,
                              .command = command->kind,
                              .asked = (uint32_t)command_kinds_workphase(command),
                              .kind = (uint32_t)ANSWER_REFUSED,
                              .status = (uint32_t)status,
                              .is_final = 1U,
                              .workphase = workphase};

    (void)hand_in(&refusal);
}

void igtl_relay_requests(exchange_t *exchange, igtl_requests_t *requests, uint32_t workphase,
                         igtl_relay_hand_in_t hand_in)
{
    bool is_waiting = false;
    command_t command;

    for (uint32_t left = requests->queued; (left > 0U) && igtl_requests_take(requests, &command);
         left--) {
        const status_t status =
            is_waiting ? STATUS_BUSY : exchange_send_command(exchange, &command);

        if ((status == STATUS_BUSY) && command_kinds_is_stop(&command)) {
            igtl_requests_keep(requests, &command);
            is_waiting = true;
        } else if (status != STATUS_OK) {
            refuse_command(&command, status, workphase, hand_in);
        } else {
            /* It is on its way. */
        }
    }
}

bool igtl_relay_awaits_answer(const igtl_requests_t *requests)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        if ((requests->requests[i].id != 0U) && !requests->requests[i].is_accepted &&
            !requests->requests[i].is_overdue) {
            return true;
        }
    }
    return false;
}

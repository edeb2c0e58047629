/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl_orders.h"

#include <stddef.h>
#include <string.h>

#define FORGET_US UINT64_C(10000000) /* An order that was never answered. */

void igtl_orders_init(igtl_orders_t *self, uint32_t first_id, uint32_t most)
{
    (void)memset(self, 0, sizeof *self);
    self->most = most;
    self->next_id = first_id;
}

static igtl_order_t *entry_with(igtl_orders_t *self, uint32_t id)
{
    for (uint32_t i = 0U; i < self->most; i++) {
        if (self->orders[i].id == id) {
            return &self->orders[i];
        }
    }
    return NULL;
}

const igtl_order_t *igtl_orders_add(igtl_orders_t *self, uint32_t peer, command_t *command,
                                    uint64_t now_us)
{
    igtl_order_t *order = entry_with(self, 0U);

    if ((order == NULL) || (self->queued == self->most)) {
        return NULL;
    }
    command->id = self->next_id;
    command->source = (uint32_t)COMMAND_SOURCE_IGTL;
    self->next_id += IGTL_ORDER_ID_STEP;
    if (self->next_id < IGTL_ORDER_ID_STEP) {
        self->next_id += IGTL_ORDER_ID_STEP;
    }
    self->queue[self->queued] = *command;
    self->queued++;
    *order = (igtl_order_t){.id = command->id,
                            .peer = peer,
                            .kind = command->kind,
                            .argument = command->argument,
                            .sent_us = now_us};
    return order;
}

igtl_order_t *igtl_orders_find(igtl_orders_t *self, uint32_t id)
{
    return (id == 0U) ? NULL : entry_with(self, id);
}

void igtl_orders_end(igtl_order_t *order)
{
    order->id = 0U;
}

igtl_order_t *igtl_orders_overdue(igtl_orders_t *self, uint64_t now_us)
{
    for (uint32_t i = 0U; i < IGTL_ORDERS; i++) {
        igtl_order_t *order = &self->orders[i];
        const uint64_t age_us = now_us - order->sent_us;

        if ((order->id != 0U) && !order->is_accepted) {
            if (!order->is_overdue && (age_us >= IGTL_ANSWER_TIMEOUT_US)) {
                order->is_overdue = true;
                return order;
            }
            if (age_us >= FORGET_US) {
                igtl_orders_end(order);
            }
        }
    }
    return NULL;
}

bool igtl_orders_take(igtl_orders_t *self, command_t *command)
{
    if (self->queued == 0U) {
        return false;
    }
    *command = self->queue[0];
    self->queued--;
    (void)memmove(&self->queue[0], &self->queue[1], self->queued * sizeof self->queue[0]);
    return true;
}

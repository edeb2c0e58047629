/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/igtl_orders.h"

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
    for (uint32_t i = 0U; i < IGTL_ORDERS; i++) {
        if (self->orders[i].id == id) {
            return &self->orders[i];
        }
    }
    return NULL;
}

bool igtl_orders_is_urgent(const command_t *command)
{
    return (command->kind == (uint32_t)COMMAND_WORKPHASE) &&
           ((command->argument == (uint32_t)WORKPHASE_STOP) ||
            (command->argument == (uint32_t)WORKPHASE_EMERGENCY));
}

static bool is_urgent(const igtl_order_t *order)
{
    const command_t command = {.kind = order->kind, .argument = order->argument};

    return igtl_orders_is_urgent(&command);
}

static bool is_queued(const igtl_orders_t *self, uint32_t id)
{
    for (uint32_t i = 0U; i < self->queued; i++) {
        if (self->queue[i].id == id) {
            return true;
        }
    }
    return false;
}

static void remove_queued(igtl_orders_t *self, uint32_t id)
{
    uint32_t kept = 0U;

    for (uint32_t i = 0U; i < self->queued; i++) {
        if (self->queue[i].id != id) {
            self->queue[kept] = self->queue[i];
            kept++;
        }
    }
    self->queued = kept;
}

/* A place for a command that may be refused. */
static igtl_order_t *common_place(igtl_orders_t *self, uint32_t peer)
{
    uint32_t all = 0U;
    uint32_t own = 0U;

    for (uint32_t i = 0U; i < IGTL_ORDERS; i++) {
        const igtl_order_t *order = &self->orders[i];

        if ((order->id != 0U) && !is_urgent(order)) {
            all++;
            own += ((order->peer == peer) && !order->is_accepted) ? 1U : 0U;
        }
    }
    return ((all < self->most) && (own < IGTL_ORDERS_PER_PEER)) ? entry_with(self, 0U) : NULL;
}

/* The newest order of this peer and kind, NULL for none. */
static igtl_order_t *newest_of(igtl_orders_t *self, uint32_t peer, uint32_t argument)
{
    igtl_order_t *newest = NULL;

    for (uint32_t i = 0U; i < IGTL_ORDERS; i++) {
        igtl_order_t *order = &self->orders[i];

        if ((order->id != 0U) && is_urgent(order) && (order->argument == argument) &&
            (order->peer == peer) && ((newest == NULL) || (order->sent_us >= newest->sent_us))) {
            newest = order;
        }
    }
    return newest;
}

/* A place for STOP or EMERGENCY. When all of its kind are taken and this peer has its share not yet
 * used up, some are of peers that have gone: nobody waits for their answers. */
static igtl_order_t *urgent_place(igtl_orders_t *self, uint32_t peer, uint32_t argument)
{
    uint32_t all = 0U;
    uint32_t own = 0U;
    igtl_order_t *place;

    for (uint32_t i = 0U; i < IGTL_ORDERS; i++) {
        const igtl_order_t *order = &self->orders[i];

        if ((order->id != 0U) && is_urgent(order) && (order->argument == argument)) {
            all++;
            own += (order->peer == peer) ? 1U : 0U;
        }
    }
    if (own >= IGTL_ORDERS_PER_PEER) {
        place = newest_of(self, peer, argument);
    } else if (all >= IGTL_ORDERS_URGENT) {
        place = newest_of(self, IGTL_NOBODY, argument);
    } else {
        return entry_with(self, 0U);
    }
    if (place != NULL) {
        remove_queued(self, place->id);
    }
    return place;
}

const igtl_order_t *igtl_orders_add(igtl_orders_t *self, uint32_t peer, command_t *command,
                                    uint64_t now_us)
{
    igtl_order_t *order = igtl_orders_is_urgent(command)
                              ? urgent_place(self, peer, command->argument)
                              : common_place(self, peer);

    if (order == NULL) {
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
            if ((age_us >= FORGET_US) && !is_queued(self, order->id)) {
                igtl_orders_end(order);
            }
        }
    }
    return NULL;
}

void igtl_orders_keep(igtl_orders_t *self, const command_t *command)
{
    self->queue[self->queued] = *command;
    self->queued++;
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

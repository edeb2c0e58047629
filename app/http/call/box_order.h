/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Orders of a page to the simulated box, in the words of the box. They are those of the tables by
 * which requests are read, so no other ones come there from the network.
 */
#ifndef BORESIGHT_BOX_ORDER_H
#define BORESIGHT_BOX_ORDER_H

#include "interface/app/requests.h"

#include <stdbool.h>
#include <stdint.h>

#define BOX_ORDER_SIZE 48U

typedef enum {
    BOX_ORDER_WRITTEN = 0,
    BOX_ORDER_MISSING = 1, /**< Something must be there that is not. */
    BOX_ORDER_EXCESS = 2   /**< Something is there that must not be. */
} box_order_verdict_t;

typedef struct {
    char words[BOX_ORDER_SIZE]; /**< The order; */
    bool is_of_page;            /**< which page gives it belongs behind it. */
    bool is_safe;               /**< It opens what is held, or pulls the e-stop. */
    char place[BOX_ORDER_SIZE]; /**< JSON pointer to what is missing or in excess. */
} box_order_t;

/**
 * Writes `request`, which says one thing, as an order.
 *
 * @satisfies SWR-HTTP-038
 */
box_order_verdict_t box_order_write(const request_box_order_t *request, box_order_t *order);

/** The word of `value` of a member of the request; the first one for a value without. */
const char *box_order_word(const char *member, uint32_t value);

#endif

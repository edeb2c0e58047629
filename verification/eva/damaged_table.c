/* SPDX-License-Identifier: Apache-2.0 */
/* A small part of the core, followed in seconds, for the test that Eva finds what it should: which
 * card belongs into a slot says a table of which every byte may be damaged. */
#include "robot/robot_cards.h"

#include <__fc_builtin.h>

static robot_t robot;

uint32_t any_slot(void)
{
    Frama_C_make_unknown((char *)&robot, sizeof robot);
    return robot_cards_type(&robot, Frama_C_unsigned_int_interval(0U, CARD_SLOT_COUNT - 1U));
}

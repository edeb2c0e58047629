/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * An operator who knows nothing but the next step that is shown and what it names: he does what he
 * is shown and nothing else. He comes into a scene of any other play at any time, with anything
 * broken, armed, pressed or lost, and must get the robot homed, and to a target that is there, or
 * see what is to be mended.
 */
#ifndef BORESIGHT_OPERATOR_H
#define BORESIGHT_OPERATOR_H

#include "integration/support/rig.h"

#include <stdbool.h>
#include <stdint.h>

/** How a scene has ended for him. */
typedef enum {
    OPERATOR_ACTS = 0,     /**< He still acts. */
    OPERATOR_COMMANDS = 1, /**< The robot is homed and may be commanded. */
    OPERATOR_SERVICE = 2,  /**< The broken part was named to him. */
    OPERATOR_DEAD_END = 3, /**< Too many acts or too long, or nothing that he could do. */
    OPERATOR_REFUSED = 4,  /**< The command that was shown to him was refused. */
    OPERATOR_ARRIVES = 5   /**< As OPERATOR_COMMANDS, with the needle at the target. */
} operator_end_t;

#define OPERATOR_ENDS 6U

/** State of the operator; one scene at a time. */
typedef struct {
    uint32_t random;
    uint32_t acts;
    uint32_t wait_cycles;   /**< Until he looks again. */
    uint32_t press_cycles;  /**< He still holds the button. */
    uint32_t time_cycles;   /**< Since he came, but for waits that were shown, and found_cycles. */
    uint32_t found_cycles;  /**< Cycles of the order that was armed when he came. */
    uint32_t brought;       /**< Bit n: he has brought axis n back by hand. */
    uint32_t tries;         /**< START_UPs for what service is said to have mended. */
    uint32_t waited_cycles; /**< The step was to wait, in a row. */
    uint32_t last_step;     /**< next_step_t that he followed last. */
    uint64_t shown;         /**< Bit n: next_step_t n was shown to him. */
    uint32_t checked_step;  /**< The last one whose command was tried on a copy. */
    status_t refusal;       /**< Status of OPERATOR_REFUSED. */
    operator_end_t end;
    bool is_of_others;     /**< The order that was armed when he came is not over. */
    bool has_started_anew; /**< Since the cycle before; who looks on clears it. */
    robot_t robot;         /**< As it stands when the box is switched on anew. */
} operator_t;

/** He comes; half of the time service has mended all before. */
void operator_begin(operator_t *self, rig_t *rig, uint32_t seed);

/** Before a cycle: he follows what is shown. @return self->end */
operator_end_t operator_play(operator_t *self, rig_t *rig);

#endif

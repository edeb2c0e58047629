/* SPDX-License-Identifier: Apache-2.0 */
/** @file Membranes on the way to the target, in a cycle of a robot with a force sensor. They are
 * reported; no motion rests on them but the vibration that answers a puncture. */
#ifndef BORESIGHT_CONTROLLER_MEMBRANES_H
#define BORESIGHT_CONTROLLER_MEMBRANES_H

#include "controller/controller_events.h"

/** Nothing is expected or looked for. */
void controller_clear_membranes(controller_t *self);

/**
 * Once in each cycle, after the force was read and before a mode moves anything. While a hand
 * inserts the needle the detector gets the last reading, unfiltered, and the depth. It is blind
 * while the needle vibrates.
 *
 * @return a puncture was found in this cycle
 *
 * @satisfies SWR-PUNCT-610
 * @satisfies SWR-PUNCT-611
 * @satisfies SWR-PUNCT-612
 * @satisfies SWR-PUNCT-613
 * @satisfies SWR-PUNCT-616
 * @satisfies SWR-PUNCT-617
 * @satisfies SWR-PUNCT-752
 * @satisfies SWR-VIB-705
 * @satisfies SWR-VIB-753
 */
bool controller_feel_membranes(controller_t *self, const cycle_t *cycle);

/**
 * Takes the depths of expected membranes.
 *
 * @return STATUS_OK; or as SWR-PUNCT-615 says
 *
 * @satisfies SWR-PUNCT-614
 * @satisfies SWR-PUNCT-615
 */
status_t controller_obey_membranes(controller_t *self, const cycle_t *cycle,
                                   const command_t *command, answer_t *answer);

#endif

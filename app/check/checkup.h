/* SPDX-License-Identifier: Apache-2.0 */
/** @file The whole check of the computer, as `boresight --check` makes it. */
#ifndef BORESIGHT_CHECKUP_H
#define BORESIGHT_CHECKUP_H

#include "check/check.h"

#include <stdio.h>

/**
 * Wakes up `cycles` times as the control loop does, with the rights that it gets itself, and fills
 * in what `facts` has of that: core, cores, rights, clock and all that is measured. Nothing is
 * driven: no card receives anything of it.
 *
 * @satisfies SWR-CHECK-003
 */
void checkup_measure(check_facts_t *facts, uint32_t cycles);

/**
 * Writes what each check has found, and what to do where it is not good.
 *
 * @return 0 when all are good, 1 otherwise: the exit code
 *
 * @satisfies SWR-CHECK-001
 */
int checkup_report(const check_facts_t *facts, FILE *out);

#endif

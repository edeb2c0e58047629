/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * What every harness has. A local variable without a value is any value at all; assume() leaves
 * only those of which a sentence speaks, and PROVE() is the sentence, which begins with the
 * requirement that it is of.
 */
#ifndef BORESIGHT_PROVE_H
#define BORESIGHT_PROVE_H

#include <stdbool.h>
#include <stdint.h>

#define PROVE(holds, sentence) __CPROVER_assert((holds), sentence)

/** This happens, or the proof may have proved nothing: the prover must find a way to it. */
#define POSSIBLE(happens, sentence) __CPROVER_assert(!(happens), "possible: " sentence)

#define assume(holds) __CPROVER_assume(holds)

/** `if_this` holds only where `that` does, too. */
#define IMPLIES(if_this, that) (!(if_this) || (that))

/** Both hold or neither does; a bool without a value need not be 0 or 1. */
#define SAME(one, other) (!(one) == !(other))

#endif

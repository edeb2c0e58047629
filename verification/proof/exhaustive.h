/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The words of prove.h for a harness that is compiled and run, and looks at every value by itself.
 */
#ifndef BORESIGHT_EXHAUSTIVE_H
#define BORESIGHT_EXHAUSTIVE_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

/** A sentence that is seen to hold of all values, or not to: tools/proof/exhaustive.rb reads the
 * line.
 */
#define PROVE(holds, sentence) (void)printf("%d %d %s\n", (holds) ? 1 : 0, __LINE__, sentence)

/** Some value was seen of which it is so. */
#define POSSIBLE(happens, sentence) PROVE(!(happens), "possible: " sentence)

#endif

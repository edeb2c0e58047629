/* SPDX-License-Identifier: Apache-2.0 */
/** @file What must hold, as a sentence: where it does not, the program says so and ends, which the
 * fuzzer takes for a find. */
#ifndef BORESIGHT_FUZZ_SENTENCE_H
#define BORESIGHT_FUZZ_SENTENCE_H

#include <stdio.h>
#include <stdlib.h>

#define SENTENCE(condition, says)                                                                  \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            (void)fprintf(stderr, "does not hold: %s (%s:%d)\n", (says), __FILE__, __LINE__);      \
            abort();                                                                               \
        }                                                                                          \
    } while (0)

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Contracts: what a programmer promised. Live in release builds; a broken one ends in the safe
 * state.
 */
#ifndef BORESIGHT_CONTRACT_H
#define BORESIGHT_CONTRACT_H

#include <stdint.h>

/**
 * Called when a contract is broken; provided by the program (control: stop all motion and end;
 * tests: a trap). Does not return.
 *
 * @param module name of the module, lives for ever
 * @param id     number of the contract inside the module, never reused
 *
 * @satisfies SWR-CORE-003
 */
void contract_broken(const char *module, uint32_t id);

/** Requires `condition`, which has no side effects. The file defines `static const char
 * contract_module[]`. */
#define REQUIRE(id, condition)                                                                     \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            contract_broken(contract_module, (id));                                                \
        }                                                                                          \
    } while (false)

#endif

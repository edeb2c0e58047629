/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Included before each source of the core where its coverage is counted: a broken contract does not
 * return, so that nothing after it counts as reached because of it.
 */
#ifndef BORESIGHT_CONTRACT_ENDS_H
#define BORESIGHT_CONTRACT_ENDS_H

#include "base/contract.h"

__attribute__((noreturn)) void contract_broken(const char *module, uint32_t id);

#endif

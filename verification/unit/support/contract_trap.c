/* SPDX-License-Identifier: Apache-2.0 */
#include "unit/support/contract_trap.h"

#include "base/contract.h"

#include <stdio.h>
#include <stdlib.h>

jmp_buf contract_trap_jump;
bool contract_trap_armed;
const char *contract_trap_module;
uint32_t contract_trap_id;

/* Weak: a test of a program has the one of that program. */
__attribute__((weak)) void contract_broken(const char *module, uint32_t id)
{
    contract_trap_module = module;
    contract_trap_id = id;
    if (!contract_trap_armed) {
        (void)fprintf(stderr, "contract %s/%u broken outside EXPECT_CONTRACT\n", module,
                      (unsigned)id);
        abort();
    }
    longjmp(contract_trap_jump, 1);
}

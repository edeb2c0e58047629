/* SPDX-License-Identifier: Apache-2.0 */
/** @file Catches a broken contract in a test, so that each can be fired by its id. */
#ifndef BORESIGHT_CONTRACT_TRAP_H
#define BORESIGHT_CONTRACT_TRAP_H

#include <setjmp.h>
#include <stdbool.h>
#include <stdint.h>

extern jmp_buf contract_trap_jump;
extern bool contract_trap_armed;
extern const char *contract_trap_module;
extern uint32_t contract_trap_id;

/** Runs `call` and expects it to break contract `id` of `module`. */
#define EXPECT_CONTRACT(module, id, call)                                                          \
    do {                                                                                           \
        contract_trap_armed = true;                                                                \
        if (setjmp(contract_trap_jump) == 0) {                                                     \
            call;                                                                                  \
            contract_trap_armed = false;                                                           \
            TEST_FAIL_MESSAGE("the contract was not broken");                                      \
        }                                                                                          \
        contract_trap_armed = false;                                                               \
        TEST_ASSERT_EQUAL_STRING((module), contract_trap_module);                                  \
        TEST_ASSERT_EQUAL_UINT32((id), contract_trap_id);                                          \
    } while (false)

#endif

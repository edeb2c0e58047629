/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Functions that a page may call of the module served.wasm: a robot in a closed loop, and the
 * server of the console before it, which is app/http. It imports nothing; its time is that of its
 * cycles. A contract that is broken leaves its name in the text and traps.
 */
#ifndef BORESIGHT_SERVED_H
#define BORESIGHT_SERVED_H

#include "site/closed_loop.h"
#include "site/export.h"

#include <stdbool.h>
#include <stdint.h>

/** Where the words of the page stand, and how many bytes there is room for. */
EXPORT(text) char *served_text(void);
EXPORT(textSize) uint32_t served_text_size(void);

/** Where the answer to them stands. */
EXPORT(answer) const char *served_answer(void);

/**
 * Starts the robot that the text names, `utc_s` being the time of the world. The answer is the code
 * of the first login: the user who has opened the page stands before the robot.
 *
 * @return false: there is none of that name, and nothing changes
 */
EXPORT(start) bool served_start(uint32_t seed, uint32_t utc_s);

/** Lets so many cycles pass. Needs a robot that was started (contract 310). */
EXPORT(step) void served_step(uint32_t cycles);

/**
 * Gives the order that the text holds to the box; the text becomes its reply. Needs a robot
 * (contract 313). False: refused.
 *
 * @satisfies SWR-SITE-027
 */
EXPORT(order) bool served_order(void);

/** Where one more command of the next cycle is to be written; NULL: that cycle takes no more. Needs
 * a robot (contract 314). */
EXPORT(command) command_t *served_command(void);

/**
 * Asks the server the request whose `size` bytes the text holds, as HTTP/1.1 has it. A request that
 * waits for control lets cycles pass. Needs a robot (contract 311), and room for the bytes (312).
 *
 * @return bytes of the answer, head and body; 0: it was no request
 *
 * @satisfies SWR-SITE-006
 * @satisfies SWR-SITE-007
 * @satisfies SWR-SITE-008
 */
EXPORT(ask) uint32_t served_ask(uint32_t size);

/** Puts what the stream has brought since the last time in the answer. Returns its size. */
EXPORT(listen) uint32_t served_listen(void);

/** Time of the robot, in cycles since it was started. */
EXPORT(cycles) uint32_t served_cycles(void);

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * boresight-simctl: hands one order to a running simulated control box and prints its answer.
 * Exit code 0: carried out, 1: no box or no answer, 2: refused.
 */
#include "base/contract.h"
#include "common/command_line.h"
#include "sim/wire.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ANSWER_TIMEOUT_US 10000000U
#define NAME_SIZE 128U
#define MORE_SIZE 2048U
#define PACE "pace "

void contract_broken(const char *module, uint32_t id)
{
    (void)fprintf(stderr, "boresight-simctl: contract %s/%u is broken\n", module, (unsigned)id);
    abort();
}

enum { INSTANCE = 0, BOX, OPTIONS };

static const command_option_t options[OPTIONS] = {
    [INSTANCE] = {"instance", "NAME", .says = "the box of this instance; default boresight"},
    [BOX] = {"box", "NAME", .says = "a box by its own name; default $" WIRE_NAME_VARIABLE},
};

/* False when the words do not fit. */
static bool join(char **words, int count, char *order, size_t size)
{
    size_t length = 0U;

    order[0] = '\0';
    for (int i = 0; i < count; i++) {
        const int written =
            snprintf(order + length, size - length, "%s%s", (i > 0) ? " " : "", words[i]);
        if ((written < 0) || ((size_t)written >= size - length)) {
            return false;
        }
        length += (size_t)written;
    }
    return true;
}

/* It is of the wire, and no order to the box. */
static int set_pace(wire_t *wire, const char *number)
{
    const uint32_t fastest = wire_load(&wire->speedup);

    if (!command_line_is_number(number, 1U, fastest)) {
        (void)fprintf(stderr,
                      "\"%s\" is no pace of this box; give a number from 1 to %u, which --fast "
                      "says\n",
                      number, (unsigned)fastest);
        return 2;
    }
    (void)wire_set_pace(wire, (uint32_t)strtoul(number, NULL, 10));
    return 0;
}

static int send_order(wire_t *wire, const char *order, const char *name)
{
    if (!wire_give_order(wire, order, ANSWER_TIMEOUT_US)) {
        (void)fprintf(
            stderr,
            "boresight-simctl: the simulated control box \"%s\" does not answer; start it again\n",
            name);
        return 1;
    }
    const bool is_done = wire->order_done != 0U;
    (void)fputs(wire->answer, is_done ? stdout : stderr);
    return is_done ? 0 : 2;
}

/* Box by the option that comes first. */
static void choose_box(const char *const values[], char *name, size_t size)
{
    const char *const otherwise = getenv(WIRE_NAME_VARIABLE);

    if (values[BOX] != NULL) {
        (void)snprintf(name, size, "%s", values[BOX]);
    } else if (values[INSTANCE] != NULL) {
        (void)snprintf(name, size, "%s" WIRE_NAME_ENDING, values[INSTANCE]);
    } else {
        (void)snprintf(name, size, "%s", (otherwise != NULL) ? otherwise : WIRE_DEFAULT_NAME);
    }
}

static int give(const char *name, const char *order)
{
    char error[256];
    wire_port_t port;

    if (!wire_attach(&port, name, WIRE_END_ORDERS, error, sizeof error)) {
        (void)fprintf(stderr, "boresight-simctl: %s\n", error);
        return 1;
    }
    const bool is_pace = strncmp(order, PACE, strlen(PACE)) == 0;
    const int code =
        is_pace ? set_pace(port.wire, &order[strlen(PACE)]) : send_order(port.wire, order, name);
    wire_close(&port, WIRE_END_ORDERS);
    return code;
}

int main(int count, char **words)
{
    const char *values[OPTIONS];
    char name[NAME_SIZE];
    char order[WIRE_ORDER_SIZE];
    char more[MORE_SIZE];
    int first;

    (void)snprintf(more, sizeof more,
                   "The orders are:\n%s" PACE "NUMBER\n"
                   "\nExit code 0: carried out. 1: no box, or no answer. 2: refused.\n",
                   box_orders());
    const command_line_t command_line = {
        .program = "boresight-simctl",
        .says = "Hands one order to a running simulated control box, and prints its answer.",
        .usage = "[OPTION...] ORDER",
        .options = options,
        .count = OPTIONS,
        .fewest_words = 1,
        .most_words = COMMAND_LINE_MANY,
        .more = more};
    const int code = command_line_read(&command_line, count, words, values, &first);
    if (code != COMMAND_LINE_GO_ON) {
        return code;
    }
    if (!join(words + first, count - first, order, sizeof order)) {
        return command_line_refuse(&command_line, "The order is too long.");
    }
    choose_box(values, name, sizeof name);
    return give(name, order);
}

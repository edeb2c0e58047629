/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * boresight-simctl: hands one order to a running simulated control box and prints its answer.
 * Exit code 0: carried out, 1: no box or no answer, 2: refused.
 */
#include "sim/wire.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ANSWER_TIMEOUT_US 10000000U

static int usage(FILE *where)
{
    (void)fprintf(where, "usage: boresight-simctl [--name NAME] ORDER\nthe orders are:\n%s",
                  box_orders());
    return (where == stdout) ? 0 : 2;
}

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

static int send_order(wire_t *wire, const char *order, const char *name)
{
    const uint32_t number = wire_load(&wire->order_request) + 1U;

    (void)snprintf(wire->order, sizeof wire->order, "%s", order);
    wire_store(&wire->order_request, number);
    wire_wake_box(wire);
    if (!wire_await(&wire->order_reply, number, ANSWER_TIMEOUT_US)) {
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

int main(int count, char **words)
{
    const char *named = getenv(WIRE_NAME_VARIABLE);
    const char *name = (named != NULL) ? named : WIRE_DEFAULT_NAME;
    char order[WIRE_ORDER_SIZE];
    char error[256];
    wire_port_t port;
    int first = 1;

    if ((count > 1) && (strcmp(words[1], "--help") == 0)) {
        return usage(stdout);
    }
    if ((count > 2) && (strcmp(words[1], "--name") == 0)) {
        name = words[2];
        first = 3;
    }
    if ((first == count) || (words[first][0] == '-') ||
        !join(words + first, count - first, order, sizeof order)) {
        return usage(stderr);
    }
    if (!wire_attach(&port, name, WIRE_END_ORDERS, error, sizeof error)) {
        (void)fprintf(stderr, "boresight-simctl: %s\n", error);
        return 1;
    }
    const int code = send_order(port.wire, order, name);
    wire_close(&port, WIRE_END_ORDERS);
    return code;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "supervisor/at_rest.h"

#include "common/clock.h"
#include "common/rest.h"
#include "exchange/exchange.h"
#include "interface/app/names.h"

#include <stdio.h>
#include <unistd.h>

#define EXIT_AT_REST 0
#define EXIT_NOT_AT_REST 1
#define ERROR_SIZE 256U
#define ANSWER_CLOCK_US UINT64_C(10000000)
#define LOOK_US 20000U

static int judge(const snapshot_t *snapshot, const robot_t *robot)
{
    const uint32_t axis = rest_driven_axis(snapshot);
    const char *const workphase = workphase_name((int32_t)snapshot->workphase);

    if (axis < snapshot->axis_count) {
        (void)printf("The drive of %s is on; release the pedal.\n", robot->axes[axis].name);
        return EXIT_NOT_AT_REST;
    }
    if (rest_is_armed(snapshot)) {
        (void)printf("A motion is armed; send STOP, or stop Boresight.\n");
        return EXIT_NOT_AT_REST;
    }
    if (rest_has_procedure(snapshot)) {
        (void)printf("The workphase is %s, a client has left START_UP; end the session, and stop "
                     "Boresight.\n",
                     workphase);
        return EXIT_NOT_AT_REST;
    }
    (void)printf("Boresight runs at rest, in %s.\n", workphase);
    return EXIT_AT_REST;
}

/* Control alone knows whether it is still at rest; what it goes on with is seen in its snapshot. */
static int stop(exchange_t *exchange, const char *instance)
{
    const uint64_t end_us = clock_monotonic_us() + ANSWER_CLOCK_US;
    snapshot_t snapshot;

    exchange_request_end(exchange);
    while (exchange_is_used(instance) && (clock_monotonic_us() < end_us)) {
        if (exchange_read_snapshot(exchange, &snapshot) && !rest_is_it(&snapshot)) {
            return judge(&snapshot, exchange_robot(exchange));
        }
        (void)usleep(LOOK_US);
    }
    if (exchange_is_used(instance)) {
        (void)printf("Boresight does not stop; stop it yourself.\n");
        return EXIT_NOT_AT_REST;
    }
    (void)printf("Boresight has stopped.\n");
    return EXIT_AT_REST;
}

int at_rest_report(const char *instance, bool is_stopped)
{
    char error[ERROR_SIZE];
    snapshot_t snapshot;
    int code = EXIT_NOT_AT_REST;

    if (!exchange_is_used(instance)) {
        (void)printf("No Boresight runs with the name \"%s\".\n", instance);
        return EXIT_AT_REST;
    }
    exchange_t *const exchange = exchange_open(instance, error, sizeof error);
    if (exchange == NULL) {
        (void)printf("%s\n", error);
    } else if (!exchange_read_snapshot(exchange, &snapshot)) {
        (void)printf("Boresight is starting; wait for its console.\n");
    } else {
        code = judge(&snapshot, exchange_robot(exchange));
    }
    if ((code == EXIT_AT_REST) && is_stopped) {
        code = stop(exchange, instance);
    }
    if (exchange != NULL) {
        exchange_close(exchange);
    }
    return code;
}

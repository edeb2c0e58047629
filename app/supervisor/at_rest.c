/* SPDX-License-Identifier: Apache-2.0 */
#include "supervisor/at_rest.h"

#include "card/card_frame.h"
#include "charts/arming_chart.h"
#include "exchange/exchange.h"
#include "interface/app/names.h"
#include "interface/snapshot.h"
#include "interface/workphase_list.h"

#include <stdio.h>

#define EXIT_AT_REST 0
#define EXIT_NOT_AT_REST 1
#define ERROR_SIZE 256U

/* The count of axes when none is driven. */
static uint32_t driven_axis(const snapshot_t *snapshot)
{
    uint32_t axis = 0U;

    while ((axis < snapshot->axis_count) &&
           (snapshot->axes[axis].drive_mode == (uint32_t)CARD_DRIVE_OFF)) {
        axis++;
    }
    return axis;
}

static int judge(const snapshot_t *snapshot, const robot_t *robot)
{
    const uint32_t axis = driven_axis(snapshot);
    const char *const workphase = workphase_name((int32_t)snapshot->workphase);

    if (axis < snapshot->axis_count) {
        (void)printf("The drive of %s is on; release the pedal.\n", robot->axes[axis].name);
        return EXIT_NOT_AT_REST;
    }
    if (snapshot->order != (uint32_t)ARMING_STATE_NONE) {
        (void)printf("A motion is armed; send STOP, or stop Boresight.\n");
        return EXIT_NOT_AT_REST;
    }
    if ((snapshot->workphase != (uint32_t)WORKPHASE_UNDEFINED) &&
        (snapshot->workphase != (uint32_t)WORKPHASE_START_UP)) {
        (void)printf("The workphase is %s, a client has left START_UP; end the session, and stop "
                     "Boresight.\n",
                     workphase);
        return EXIT_NOT_AT_REST;
    }
    (void)printf("Boresight runs at rest, in %s.\n", workphase);
    return EXIT_AT_REST;
}

int at_rest_tell(const char *instance)
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
    if (exchange != NULL) {
        exchange_close(exchange);
    }
    return code;
}

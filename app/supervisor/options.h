/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the supervisor was asked for: command line first, then environment, then defaults. */
#ifndef BORESIGHT_OPTIONS_H
#define BORESIGHT_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#define OPTIONS_PATH_SIZE 512U

typedef struct {
    const char *http_port; /**< --http-port, HTTP_PORT. */
    const char *igtl_port; /**< --igtl-port, IGTL_PORT: bare transforms, joints and poses. */
    const char *brp_port;  /**< --brp-port, BRP_PORT: the workphase protocol. */
    const char *bind;      /**< --bind: IPv4 address of this machine. */
    const char *robot;     /**< --robot, ROBOT. */
    const char *instance;  /**< --instance: name of everything this instance creates. */
    const char *box;       /**< --box: a simulated box that runs already; NULL: one of its own. */
    const char *slowness;  /**< --slow: the simulated box runs so many times slower. */
    bool is_real_time;     /**< --real-time: the simulated box does not wait for control. */
    char recordings[OPTIONS_PATH_SIZE]; /**< --recordings. */
    char programs[OPTIONS_PATH_SIZE];   /**< Directory of this program and the others. */
} options_t;

/** --slow as a number, 1 .. LIMIT_BOX_SLOWEST. */
uint32_t options_slowness(const options_t *self);

/** Says what may be given. */
const char *options_usage(void);

/** Reads options. False, with a sentence in `error`, when one of them is unknown or wrong. */
bool options_read(options_t *self, int count, char **arguments, char *error, uint32_t error_size);

#endif

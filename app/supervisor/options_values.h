/* SPDX-License-Identifier: Apache-2.0 */
/** @file The values of the options, as options.h reads them. */
#ifndef BORESIGHT_OPTIONS_VALUES_H
#define BORESIGHT_OPTIONS_VALUES_H

#include "igtl/server/igtl_ports.h"
#include "supervisor/board.h"

#include <stdbool.h>

#define OPTIONS_PATH_SIZE 512U

typedef struct {
    const char *http_port;  /**< --http-port, HTTP_PORT. */
    const char *igtl_port;  /**< --igtl-port, IGTL_PORT: bare transforms, joints and poses. */
    const char *brp_port;   /**< --brp-port, BRP_PORT: the workphase protocol. */
    const char *igtl_file;  /**< --igtl-file, IGTL_FILE: of ports, NULL: none. */
    igtl_ports_t ports;     /**< The ports of that file. */
    const char *accounts;   /**< --accounts, ACCOUNTS: file of those who may log in; NULL: none. */
    const char *tls_file;   /**< --tls-file, TLS_FILE: how TLS leads here; NULL: it does not. */
    const char *trajectory; /**< --trajectory: file of one, NULL: none. */
    bool is_check;          /**< --check: nothing is started. */
    bool asks_for_rest;     /**< --at-rest: the same. */
    bool stops_at_rest;     /**< --stop-at-rest: as well, and what runs ends. */
    const char *bind;       /**< --bind: IPv4 address of this machine. */
    const char *robot;      /**< --robot, ROBOT. */
    const char *instance;   /**< --instance: name of everything this instance creates. */
    char recordings[OPTIONS_PATH_SIZE];          /**< --recordings. */
    char programs[OPTIONS_PATH_SIZE];            /**< Directory of this program and the others. */
    bool is_given[BOARD_OPTIONS];                /**< Which of the board's options are given. */
    char board[BOARD_OPTIONS][BOARD_VALUE_SIZE]; /**< Their values. */
} options_t;

#endif

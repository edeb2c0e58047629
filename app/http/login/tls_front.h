/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * How browsers reach the server over TLS: a program in front of it, stunnel, ends TLS and feeds two
 * ports on the loopback address. One file says this to both:
 *
 *     hosts = robot.example, 192.168.1.2
 *     console = 8443
 *     stop = 8444
 *     console-from = 8081
 *     stop-from = 8082
 *     certificate = /etc/boresight/certificate.pem
 *     key = /etc/boresight/key.pem
 *
 * All keys are needed. A line that begins with # is a comment.
 */
#ifndef BORESIGHT_TLS_FRONT_H
#define BORESIGHT_TLS_FRONT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#define TLS_FRONT_HOSTS 4U
#define TLS_FRONT_HOST_SIZE 64U
#define TLS_FRONT_PATH_SIZE 256U

typedef struct {
    uint32_t host_count;
    char hosts[TLS_FRONT_HOSTS][TLS_FRONT_HOST_SIZE]; /**< As browsers name this machine. */
    uint16_t console;                                 /**< Where browsers find the console. */
    uint16_t stop;                                    /**< Where they ask for a stop. */
    uint16_t console_from; /**< The port of the loopback address to which the console's leads. */
    uint16_t stop_from;    /**< The same of the stop's. */
    char certificate[TLS_FRONT_PATH_SIZE];
    char key[TLS_FRONT_PATH_SIZE];
} tls_front_t;

/**
 * Reads `length` bytes of `text`; `file` is what errors call it.
 *
 * @return false with a sentence in `error`
 *
 * @satisfies SWR-SESS-019
 */
bool tls_front_parse(tls_front_t *self, const char *file, const char *text, size_t length,
                     char *error, size_t error_size);

/** Reads the file. False with a sentence in `error`. */
bool tls_front_read(tls_front_t *self, const char *file, char *error, size_t error_size);

/** Whether `host`, as a browser writes it, is one of the hosts with `port`. */
bool tls_front_serves(const tls_front_t *self, uint32_t port, const char *host);

/** Writes the configuration of stunnel. */
void tls_front_write_stunnel(const tls_front_t *self, FILE *stream);

#endif

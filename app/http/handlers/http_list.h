/* SPDX-License-Identifier: Apache-2.0 */
/** @file A list that control holds, a trajectory or a treatment program: shown, sent item by item,
 * emptied. */
#ifndef BORESIGHT_HTTP_LIST_H
#define BORESIGHT_HTTP_LIST_H

#include "http/call/http_call.h"
#include "http/call/http_context.h"

#include <stdbool.h>
#include <stdint.h>

#define HTTP_LIST_POINTER_SIZE 24U

/** A kind of list. */
typedef struct {
    command_kind_t begin;
    command_kind_t end;
    /** Answers with what is held. @return the status that was sent */
    int (*show)(const http_call_t *call, const snapshot_t *snapshot);
    /** Number of items that are held. */
    uint32_t (*held)(const snapshot_t *snapshot);
    /** The command that hands in item `index` of `items`, and `*crc` with it. False: no command can
     * hold it. */
    bool (*item)(const robot_t *robot, const void *items, uint32_t index, command_t *command,
                 uint32_t *crc);
    /** Writes the pointer to item `index` of the body. */
    void (*point)(uint32_t index, char pointer[HTTP_LIST_POINTER_SIZE]);
} http_list_t;

/** Each answers the request. @return the status that was sent */
int http_list_show(http_server_t *server, const http_call_t *call, const http_list_t *list);

/** Sends some items together and the next ones when these were taken. A refusal is named with its
 * item, and then nothing is held. */
int http_list_send(http_server_t *server, const http_call_t *call, const http_list_t *list,
                   const void *items, uint32_t count);

int http_list_empty(http_server_t *server, const http_call_t *call, const http_list_t *list);

#endif

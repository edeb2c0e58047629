/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The acts of pages: may this page do it, and what became of it. A route that does something fills
 * a command and hands it to http_act_command(); the rest is the same for all.
 */
#ifndef BORESIGHT_HTTP_ACT_H
#define BORESIGHT_HTTP_ACT_H

#include "http/call/http_call.h"
#include "http/call/http_context.h"

#define HTTP_ACT_PAGE "X-Boresight-Page"

/**
 * Judges the page of a request, of a route of pages, and whether it has authority, where that is
 * needed; control judges authority again. `call->page` is set.
 *
 * @return 0, or the status of the refusal that was sent
 *
 * @satisfies SWR-HTTP-026
 */
int http_act_judge(http_server_t *server, http_call_t *call);

/**
 * Has `command` done for the page of `call`, and answers what became of it. `command->id` is that
 * of the act, as the body says it; source and peer are filled in.
 *
 * @return the status sent
 */
int http_act_command(http_server_t *server, const http_call_t *call, const command_t *command);

/** Refuses the body for what `pointer` leads to, which is outside its range. Returns the status
 * sent. */
int http_act_refuse_member(const http_call_t *call, const char *pointer);

/** The same, with `expected` in the sentence: "a number from ...". */
int http_act_refuse_range(const http_call_t *call, const char *pointer, const char *expected);

/** Refuses the body for the unit that `pointer` leads to, which is missing or is not that of
 * `axis`; the sentence says which it is. Returns the status sent.
 *
 * @satisfies SWR-HTTP-078
 */
int http_act_refuse_unit(const http_call_t *call, const axis_config_t *axis, const char *pointer);

/** Refuses a body that has both of two members, or neither, where it shall have one; `pointer`
 * leads to the first. Returns the status sent. */
int http_act_refuse_choice(const http_call_t *call, bool has_both, const char *pointer);

/** Refuses what control would refuse, or has refused, by `answer`. Returns the status sent. */
int http_act_refuse(http_server_t *server, const http_call_t *call, const answer_t *answer);

/** The axis that `answer` names as the reason; NULL: it names none. */
const char *http_act_axis(const robot_t *robot, const answer_t *answer);

/** Which of its limits, "lower" or "upper"; NULL: none. */
const char *http_act_limit(const answer_t *answer);

/** The result of the act `id` of `page`, from `answer`, as a message. NULL without memory; the
 * caller frees it. */
cJSON *http_act_report(const robot_t *robot, uint32_t page, uint32_t id, const answer_t *answer);

#endif

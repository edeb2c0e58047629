/* SPDX-License-Identifier: Apache-2.0 */
#include "http/stop/stop_command.h"

#include "http/gate/answer_timeout.h"
#include "interface/app/names.h"

#include <stdio.h>

stop_question_t stop_command_ask(exchange_t *exchange, workphase_t workphase)
{
    const stop_question_t question = {.number = exchange_request_stop(exchange, workphase),
                                      .looks = answer_timeout_looks(exchange)};
    return question;
}

status_t stop_command_look(const exchange_t *exchange, stop_question_t *question, answer_t *answer)
{
    if (exchange_read_stop_answer(exchange, question->number, answer)) {
        return STATUS_OK;
    }
    if (question->looks == 0U) {
        return STATUS_NO_ANSWER;
    }
    question->looks--;
    return STATUS_BUSY;
}

status_t stop_command_send_and_wait(exchange_t *exchange, workphase_t workphase, answer_t *answer)
{
    stop_question_t question = stop_command_ask(exchange, workphase);
    status_t status = stop_command_look(exchange, &question, answer);
    while (status == STATUS_BUSY) {
        answer_timeout_wait();
        status = stop_command_look(exchange, &question, answer);
    }
    return status;
}

stop_report_t stop_command_report(status_t status, const answer_t *answer,
                                  char json[STOP_COMMAND_JSON_SIZE])
{
    stop_report_t report = {.is_good = false, .problem = http_problem_of(PROBLEM_NO_ANSWER)};
    if (status != STATUS_OK) {
        return report;
    }
    if (answer->kind == (uint32_t)ANSWER_REFUSED) {
        report.problem = http_problem_of_status(answer->status);
        return report;
    }
    (void)snprintf(json, STOP_COMMAND_JSON_SIZE,
                   "{\"result\":\"%s\",\"code\":\"%s\",\"message\":\"%s\",\"workphase\":\"%s\"}",
                   answer_kind_name((int32_t)answer->kind), status_name((int32_t)answer->status),
                   status_text((int32_t)answer->status),
                   workphase_name((int32_t)answer->workphase));
    report.is_good = true;
    return report;
}

/* SPDX-License-Identifier: Apache-2.0 */
/** @file The route of notes that people write into the log. */
#ifndef BORESIGHT_HTTP_LOG_NOTE_H
#define BORESIGHT_HTTP_LOG_NOTE_H

#include "http/call/http_call.h"
#include "http/call/http_context.h"

/** Whether `text`, UTF-8, is not empty and changes nothing about how a line is shown: no control
 * characters, ends of lines or marks of direction. */
bool http_log_note_is_plain(const char *text);

#endif

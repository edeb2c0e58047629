/* SPDX-License-Identifier: Apache-2.0 */
/** @file What is wrong now, in the words of the log, and where the needle was known to stand last.
 */
#ifndef BORESIGHT_ALARM_JSON_H
#define BORESIGHT_ALARM_JSON_H

#include "http/view/telemetry.h"

#include <cjson/cJSON.h>

/**
 * All alarms that stand, the most pressing first. The caller frees the result with cJSON_Delete().
 *
 * @satisfies SWR-HTTP-064
 */
cJSON *alarm_json_list(const telemetry_view_t *view);

/**
 * Puts the sentences of `alarms` for those of the reasons against the axis of this name: which
 * part, and what is wrong with it.
 *
 * @satisfies SWR-HTTP-066
 */
void alarm_json_name_reasons(const cJSON *alarms, const char *axis, cJSON *permit);

/**
 * The needle. The same of the result.
 *
 * @satisfies SWR-HTTP-065
 */
cJSON *alarm_json_needle(const telemetry_view_t *view);

#endif

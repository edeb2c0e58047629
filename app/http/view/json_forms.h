/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The forms of values in JSON, for the generated writer (messages.h). A value that is NULL for want
 * of memory is left out.
 */
#ifndef BORESIGHT_JSON_FORMS_H
#define BORESIGHT_JSON_FORMS_H

#include "base/rigid.h"

#include <cjson/cJSON.h>
#include <stdbool.h>
#include <stdint.h>

/** Name or sentence of a value, as names.h has them. */
typedef const char *(*json_words_t)(int32_t value);

void json_add_number(cJSON *object, const char *key, double value);
void json_add_flag(cJSON *object, const char *key, bool value);
void json_add_text(cJSON *object, const char *key, const char *text);
void json_add_null(cJSON *object, const char *key);

/** Gives `item` away. */
void json_add_item(cJSON *object, const char *key, cJSON *item);

/** A value with its name and its sentence. */
void json_add_named(cJSON *object, const char *key, const char *name, const char *text);

/** The first `count` bits of `mask`, those that are set as named values. */
void json_add_set(cJSON *object, const char *key, uint32_t mask, uint32_t count, json_words_t name,
                  json_words_t text);

/** Homogeneous, by rows, translation in mm. */
cJSON *json_new_matrix(const rigid_t *pose);
void json_add_matrix(cJSON *object, const char *key, const rigid_t *pose);

/** In mm. */
void json_add_point(cJSON *object, const char *key, const point_t *point);

#endif

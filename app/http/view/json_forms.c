/* SPDX-License-Identifier: Apache-2.0 */
#include "http/view/json_forms.h"

#include "http/view/telemetry_units.h"

void json_add_number(cJSON *object, const char *key, double value)
{
    (void)cJSON_AddNumberToObject(object, key, value);
}

void json_add_flag(cJSON *object, const char *key, bool value)
{
    (void)cJSON_AddBoolToObject(object, key, value ? 1 : 0);
}

void json_add_text(cJSON *object, const char *key, const char *text)
{
    (void)cJSON_AddStringToObject(object, key, text);
}

void json_add_null(cJSON *object, const char *key)
{
    (void)cJSON_AddNullToObject(object, key);
}

void json_add_item(cJSON *object, const char *key, cJSON *item)
{
    (void)cJSON_AddItemToObject(object, key, item);
}

static cJSON *new_named(const char *name, const char *text)
{
    cJSON *named = cJSON_CreateObject();
    json_add_text(named, "name", name);
    json_add_text(named, "text", text);
    return named;
}

void json_add_named(cJSON *object, const char *key, const char *name, const char *text)
{
    json_add_item(object, key, new_named(name, text));
}

void json_add_set(cJSON *object, const char *key, uint32_t mask, uint32_t count, json_words_t name,
                  json_words_t text)
{
    cJSON *set = cJSON_AddArrayToObject(object, key);
    for (uint32_t i = 0U; i < count; i++) {
        if ((mask & (UINT32_C(1) << i)) != 0U) {
            (void)cJSON_AddItemToArray(set, new_named(name((int32_t)i), text((int32_t)i)));
        }
    }
}

cJSON *json_new_matrix(const rigid_t *pose)
{
    double matrix[16];
    telemetry_units_matrix(pose, matrix);
    return cJSON_CreateDoubleArray(matrix, 16);
}

void json_add_matrix(cJSON *object, const char *key, const rigid_t *pose)
{
    json_add_item(object, key, json_new_matrix(pose));
}

void json_add_point(cJSON *object, const char *key, const point_t *point)
{
    double coordinates[3];
    telemetry_units_point(point, coordinates);
    json_add_item(object, key, cJSON_CreateDoubleArray(coordinates, 3));
}

/* SPDX-License-Identifier: Apache-2.0 */
/** @file A message that has a field of every type. */
#ifndef BORESIGHT_EVERY_REQUEST_H
#define BORESIGHT_EVERY_REQUEST_H

#include "request/request_fields.h"

typedef struct {
    double depth_mm;
    bool hard;
    bool has_hard;
} inner_request_t;

typedef struct {
    bool flag;
    uint32_t count;
    int32_t ticks;
    double speed_mm_per_s; /**< -10 to 10. */
    char name[8];
    uint32_t workphase; /**< 3 or 6. */
    inner_request_t inner;
    double point[3];
    uint32_t point_count;
    inner_request_t rows[2];
    uint32_t rows_count;
    char note[4];
    bool has_note;
    uint8_t guard; /**< Not written. */
} every_request_t;

#define PLACE(structure, field)                                                                    \
    .offset = offsetof(structure, field), .size = sizeof(((structure *)0)->field)
#define ROW(structure, field)                                                                      \
    .offset = offsetof(structure, field), .size = sizeof(((structure *)0)->field[0])
#define GIVEN(structure, field) .is_optional = true, .given_offset = offsetof(structure, field)
#define COUNT(fields) (uint32_t)(sizeof(fields) / sizeof(fields)[0])

static const request_word_t words[] = {{"STOP", 3U}, {"MANUAL", 6U}};

static const request_field_t inner_fields[] = {{.name = "depth_mm",
                                                .kind = REQUEST_NUMBER,
                                                PLACE(inner_request_t, depth_mm),
                                                .minimum = -100.0,
                                                .maximum = 100.0},
                                               {.name = "hard",
                                                .kind = REQUEST_FLAG,
                                                PLACE(inner_request_t, hard),
                                                GIVEN(inner_request_t, has_hard)}};

static const request_message_t inner = {inner_fields, COUNT(inner_fields)};

#define SINGLE_FIELDS(is_free)                                                                     \
    {.name = "flag", .kind = REQUEST_FLAG, PLACE(every_request_t, flag)},                          \
        {.name = "count",                                                                          \
         .kind = REQUEST_UINT32,                                                                   \
         PLACE(every_request_t, count),                                                            \
         .is_optional = (is_free),                                                                 \
         .given_offset = offsetof(every_request_t, has_note),                                      \
         .maximum = 4294967295.0},                                                                 \
        {.name = "ticks",                                                                          \
         .kind = REQUEST_INT32,                                                                    \
         PLACE(every_request_t, ticks),                                                            \
         .is_optional = (is_free),                                                                 \
         .given_offset = offsetof(every_request_t, has_note),                                      \
         .minimum = -2147483648.0,                                                                 \
         .maximum = 2147483647.0,                                                                  \
         .unit = "ticks"},                                                                         \
        {.name = "speed_mm_per_s",                                                                 \
         .kind = REQUEST_NUMBER,                                                                   \
         PLACE(every_request_t, speed_mm_per_s),                                                   \
         .is_optional = (is_free),                                                                 \
         .given_offset = offsetof(every_request_t, has_note),                                      \
         .minimum = -10.0,                                                                         \
         .maximum = 10.0,                                                                          \
         .unit = "mm per s"},                                                                      \
        {.name = "name",                                                                           \
         .kind = REQUEST_TEXT,                                                                     \
         PLACE(every_request_t, name),                                                             \
         .is_optional = (is_free),                                                                 \
         .given_offset = offsetof(every_request_t, has_note)},                                     \
    {                                                                                              \
        .name = "workphase", .kind = REQUEST_WORD, PLACE(every_request_t, workphase),              \
        .is_optional = (is_free), .given_offset = offsetof(every_request_t, has_note),             \
        .word_count = 2U, .words = words                                                           \
    }

static const request_field_t fields[] = {
    SINGLE_FIELDS(false),
    {.name = "inner", .kind = REQUEST_OBJECT, PLACE(every_request_t, inner), .message = &inner},
    {.name = "point",
     .kind = REQUEST_NUMBER,
     ROW(every_request_t, point),
     GIVEN(every_request_t, point_count),
     .least = 3U,
     .most = 3U,
     .minimum = -1000.0,
     .maximum = 1000.0},
    {.name = "rows",
     .kind = REQUEST_OBJECT,
     ROW(every_request_t, rows),
     GIVEN(every_request_t, rows_count),
     .most = 2U,
     .message = &inner},
    {.name = "note",
     .kind = REQUEST_TEXT,
     PLACE(every_request_t, note),
     GIVEN(every_request_t, has_note)}};

static const request_field_t query_fields[] = {SINGLE_FIELDS(true)};

static const request_message_t endless;

static const request_field_t endless_fields[] = {
    {.name = "a", .kind = REQUEST_OBJECT, .message = &endless},
    {.name = "a_long_name_that_fills_the_room_of_names_too",
     .kind = REQUEST_OBJECT,
     .message = &endless}};

/* Needs all members but the last three. */
static const request_message_t every_request = {fields, COUNT(fields)};
/* Its single values; needs the flag. */
static const request_message_t every_query = {query_fields, COUNT(query_fields)};
static const request_message_t no_members = {NULL, 0U};
/* Holds itself, which no table of the product does. */
static const request_message_t endless = {endless_fields, COUNT(endless_fields)};

#endif

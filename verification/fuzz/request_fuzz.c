/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Any bytes as the body and as the query of a request, by tables of every kind and by those of each
 * route. A sentence that does not hold ends the
 * program: what is refused has a place, what is taken is within its bounds, and nothing else is
 * written.
 */
#include "http/view/telemetry_units.h"
#include "interface/app/routes.h"
#include "request/request_body.h"
#include "request/request_headers.h"
#include "request/request_query.h"
#include "unit/support/every_request.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define LONGEST 4096U
#define GUARD 0x5AU
#define COOKIE_SIZE 8U

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

static void hold(bool sentence)
{
    if (!sentence) {
        abort();
    }
}

static bool is_within(double value, double most)
{
    return isfinite(value) && (fabs(value) <= most);
}

static void look(const every_request_t *read)
{
    hold((read->workphase == 3U) || (read->workphase == 6U));
    hold(is_within(read->speed_mm_per_s, 10.0) && is_within(read->inner.depth_mm, 100.0));
    hold(memchr(read->name, '\0', sizeof read->name) != NULL);
    hold((read->point_count == 0U) || (read->point_count == 3U));
    hold(read->rows_count <= 2U);
    for (uint32_t i = 0U; i < read->rows_count; i++) {
        hold(is_within(read->rows[i].depth_mm, 100.0));
    }
}

static void try_body(const char *bytes, size_t size)
{
    every_request_t read = {.guard = GUARD};
    const request_result_t result = request_read_body(&every_request, bytes, size, &read);
    hold((read.guard == GUARD) && (memchr(result.place, '\0', sizeof result.place) != NULL));
    if (result.fault == REQUEST_OK) {
        look(&read);
    }
}

static void look_at_pose(const double matrix[16])
{
    rigid_t pose;
    const uint32_t wrong = telemetry_units_pose(matrix, &pose);
    hold(wrong <= 16U);
    for (uint32_t i = 0U; (i < 9U) && (wrong == 16U); i++) {
        hold(abs(pose.rotation_q30[i / 3U][i % 3U]) < (INT32_C(1) << 30) + (INT32_C(1) << 21));
    }
    hold((wrong < 16U) || (abs(pose.translation.x_nm) <= 2000000000));
}

/* Body and query of each route. */
static void try_routes(const char *bytes, size_t size)
{
    for (size_t i = 0U; i < ROUTE_COUNT; i++) {
        static request_body_t body;
        if (routes[i].body != NULL) {
            const request_result_t result = request_read_body(routes[i].body, bytes, size, &body);
            hold(memchr(result.place, '\0', sizeof result.place) != NULL);
            if ((result.fault == REQUEST_OK) && (routes[i].id == ROUTE_REGISTRATION)) {
                hold((body.registration.id > 0U) && (body.registration.matrix_count == 16U));
                look_at_pose(body.registration.matrix);
            }
        }
    }
}

static void try_texts(const char *bytes, size_t size)
{
    char text[LONGEST + 1U];
    every_request_t read = {.guard = GUARD};
    uint32_t number = 0U;
    (void)memcpy(text, bytes, size);
    text[size] = '\0';
    const request_result_t result = request_read_query(&every_query, text, &read);
    hold((read.guard == GUARD) && (memchr(result.place, '\0', sizeof result.place) != NULL));
    (void)request_headers_take_gzip(text);
    (void)request_headers_know(text, "\"tag\"");
    (void)request_headers_are_json(text);
    char id[COOKIE_SIZE];
    hold(!request_headers_cookie(text, "id", id, sizeof id) ||
         (memchr(id, '\0', sizeof id) != NULL));
    (void)request_headers_number(text, &number);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size <= LONGEST) {
        try_body((const char *)bytes, size);
        try_routes((const char *)bytes, size);
        try_texts((const char *)bytes, size);
    }
    return 0;
}

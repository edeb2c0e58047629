/* SPDX-License-Identifier: Apache-2.0 */
#include "http/server/http_server.h"

#include "common/build_id.h"
#include "http/handlers/http_positions.h"

#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <sys/random.h>

static void make_boot_id(char *text, size_t size)
{
    uint64_t number = 0U;
    if (getrandom(&number, sizeof number, 0U) != (ssize_t)sizeof number) {
        number = telemetry_now_ms();
    }
    (void)snprintf(text, size, "%016llx", (unsigned long long)number);
}

void http_server_init(http_server_t *self, const http_server_config_t *config)
{
    self->exchange = config->exchange;
    self->guard = config->guard;
    self->instance = config->instance;
    self->front = config->front;
    self->archive.directory = config->recordings;
    (void)pthread_mutex_init(&self->archive.lock, NULL);
    if (!exchange_read_log_level(config->exchange, &self->archive.level)) {
        (void)memset(&self->archive.level, 0, sizeof self->archive.level);
    }
    if (config->front != NULL) {
        const http_guard_t front = {.address = "127.0.0.1",
                                    .port = config->front->console_from,
                                    .page_port = config->front->console_from,
                                    .front = config->front,
                                    .front_port = config->front->console,
                                    .is_front_only = true};
        self->front_guard = front;
    }
    command_client_init(&self->acts, config->exchange);
    (void)pthread_mutex_init(&self->orders, NULL);
    http_notes_init(&self->notes, config->exchange, &self->acts);
    http_record_init(&self->record, &self->notes, telemetry_now_ms());
    http_peers_log_init(&self->peers_log, &self->notes);
    session_store_init(&self->sessions, config->accounts, http_notes_write, &self->notes);
    http_positions_begin(self, config->box_key);
    make_boot_id(self->identity.boot_id, sizeof self->identity.boot_id);
    self->identity.version = BUILD_VERSION;
    self->identity.build_id = BUILD_ID;
    self->identity.box = config->box;
    telemetry_init(&self->telemetry, config->exchange);
    http_stream_init(&self->stream, config->exchange);
}

bool http_server_prepare_logins(http_server_t *self, char *error, size_t error_size)
{
    static const char none[] = "There is no account, and this board drives a real robot; make one "
                               "with boresight-passwd and name its file with --accounts.";
    accounts_t accounts;
    accounts.count = 0U;
    if ((self->sessions.accounts_file != NULL) &&
        !accounts_read(&accounts, self->sessions.accounts_file, error, error_size)) {
        return false;
    }
    if ((self->identity.box == NULL) && (accounts.count == 0U)) {
        (void)snprintf(error, error_size, "%s", none);
        return false;
    }
    if (self->sessions.accounts_file == NULL) {
        if (!session_store_make_code(&self->sessions)) {
            (void)snprintf(error, error_size, "The system has no random numbers.");
            return false;
        }
        (void)fprintf(stderr, "Login:       %s (once, at the console on this machine)\n",
                      self->sessions.code);
    }
    return true;
}

/* Again: a neighbour may have damaged it. */
static void set_log_level(http_server_t *self)
{
    (void)pthread_mutex_lock(&self->archive.lock);
    exchange_set_log_level(self->exchange, &self->archive.level);
    (void)pthread_mutex_unlock(&self->archive.lock);
}

void http_server_tick(http_server_t *self)
{
    telemetry_view_t view;
    session_store_tick(&self->sessions, telemetry_now_ms());
    set_log_level(self);
    http_notes_report_replaced(&self->notes);
    http_notes_report_damage(&self->notes, telemetry_now_ms());
    http_record_tick(&self->record, telemetry_now_ms());
    http_peers_log_tick(&self->peers_log, telemetry_now_ms());
    http_notes_tick(&self->notes);
    command_client_tick(&self->acts, &self->sessions, telemetry_now_ms());
    telemetry_look(&self->telemetry, &view);
    if (!view.has_snapshot || !http_stream_is_watched(&self->stream)) {
        return;
    }
    cJSON *state = telemetry_json_state(&self->identity, &view);
    char *json = cJSON_PrintUnformatted(state);
    if (json != NULL) {
        (void)http_stream_publish(&self->stream, json);
    }
    cJSON_free(json);
    cJSON_Delete(state);
}

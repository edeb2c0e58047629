/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/export/motion_json.h"

#include "card/card_dialect.h"
#include "common/build_id.h"
#include "common/utc_text.h"
#include "replay/data/frame_fields.h"
#include "replay/export/page_text.h"
#include "replay/data/series.h"
#include "robot/robot_cards.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#define FORMAT 2U
#define NUMBER_CYCLES 25U /* Each so many cycles numbers are given. */
#define US_PER_MS 1000U
#define MS_PER_S 1000.0
#define HASH_START 2166136261U
#define HASH_FACTOR 16777619U

/* And frees it. */
static void write_value(FILE *file, cJSON *value)
{
    char *const text = cJSON_PrintUnformatted(value);

    if (text == NULL) {
        abort();
    }
    page_text_write(file, text, strlen(text));
    cJSON_free(text);
    cJSON_Delete(value);
}

/* The person who accepts cards of another dialect is in no recording, and not shown by its page. */
static const exchange_cards_t cards = {.dialect = (uint32_t)CARD_DIALECT_OWN};

/* The robot as it is before anything is known of it by others than its file. */
static void begin_view(motion_json_t *self, const robot_t *robot, const recording_header_t *header)
{
    recording_escape(header->build, self->build, sizeof self->build);
    self->identity = (telemetry_identity_t){
        .boot_id = "recording", .version = BUILD_VERSION, .build_id = self->build};
    self->view.has_snapshot = true;
    self->view.robot = robot;
    self->view.cards = &cards;
    self->started_us = header->started_us;
}

void motion_json_begin(motion_json_t *self, FILE *file, const walk_t *walk)
{
    (void)memset(self, 0, sizeof *self);
    self->file = file;
    self->robot = walk->robot;
    begin_view(self, walk->robot, &walk->reader.header);
    (void)fprintf(file, "{\"format\":%u,\"numbers_each\":%u,\"robot\":", FORMAT, NUMBER_CYCLES);
    write_value(file, telemetry_json_robot(&self->view));
    (void)fputs(",\"rows\":[", file);
}

static void take_events(motion_json_t *self, const controller_outputs_t *outputs)
{
    for (uint32_t i = 0U; (i < outputs->event_count) && (i < CONTROLLER_EVENTS); i++) {
        const exchange_event_t event = {.event = outputs->events[i], .utc_us = self->pace.utc_us};
        log_entry_t entry = {.event = event.event, .utc_us = event.utc_us};
        alarms_take(&self->view.alarms, &event);
        event_text_sentence(self->robot, &entry.event, NULL, entry.text, sizeof entry.text);
        cJSON *const reported = telemetry_json_event(self->robot, &entry);
        char *const text = cJSON_PrintUnformatted(reported);
        if (text == NULL) {
            abort();
        }
        bytes_print(&self->events, "%s\n%s", (self->events.used > 0U) ? "," : "", text);
        cJSON_free(text);
        cJSON_Delete(reported);
    }
}

static bool find_frame(const controller_outputs_t *shown, uint32_t slot, card_command_t *command)
{
    return ((shown->frames_to_send & (1U << slot)) != 0U) &&
           (card_frame_decode_command(shown->frames[slot], slot, command) == CARD_FRAME_OK);
}

static uint32_t hash(uint32_t before, uint32_t word)
{
    return (before ^ word) * HASH_FACTOR;
}

/* A number that is another one when a card is asked for something else than before. */
static uint32_t drives_of(const controller_outputs_t *shown)
{
    uint32_t drives = HASH_START;

    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        card_command_t command;
        if (find_frame(shown, slot, &command)) {
            drives = hash(drives, slot);
            drives = hash(drives, command.system_state);
            drives = hash(drives, command.control);
            drives = hash(drives, (uint32_t)command.drive.mode);
            drives = hash(drives, command.drive.direction);
            drives = hash(drives, command.drive.duty);
            drives = hash(drives, command.drive.amplitude);
        }
    }
    return drives;
}

/* Values that are given in each cycle in which they change, so that they are no numbers for the
 * page. */
static bool is_order(const char *name)
{
    return (strncmp(name, "drive_", strlen("drive_")) == 0) || (strcmp(name, "control") == 0) ||
           (strcmp(name, "system_state") == 0);
}

static void put_field(void *to, const series_t *series)
{
    cJSON *const frame = to;
    char text[32];

    if (series->kind == SERIES_WORD) {
        (void)cJSON_AddStringToObject(frame, series->name, series->word);
    } else if (is_order(series->name)) {
        (void)snprintf(text, sizeof text, "%.0f", series->number);
        (void)cJSON_AddStringToObject(frame, series->name, text);
    } else {
        (void)cJSON_AddNumberToObject(frame, series->name, series->number);
    }
}

/* One for each slot, null for one that is sent none. */
static cJSON *new_frames(const controller_outputs_t *shown)
{
    cJSON *const frames = cJSON_CreateArray();

    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        card_command_t command;
        const bool is_sent = find_frame(shown, slot, &command);
        cJSON *const frame = is_sent ? cJSON_CreateObject() : cJSON_CreateNull();
        if (is_sent) {
            series_report(fields_card_command, &command, NULL, put_field, frame);
        }
        (void)cJSON_AddItemToArray(frames, frame);
    }
    return frames;
}

/* A recording has the number of who commands, as its events, but not the name. */
static void name_peer(uint32_t peer, char name[EXCHANGE_TITLE_SIZE])
{
    name[0] = '\0';
    if (peer != 0U) {
        (void)snprintf(name, EXCHANGE_TITLE_SIZE, "peer %u (name not recorded)", (unsigned)peer);
    }
}

/* The view of a cycle on the page; its time stands for the clock's, which is that of now. */
static cJSON *new_moment(motion_json_t *self, const controller_outputs_t *shown)
{
    cJSON *const moment = cJSON_CreateObject();
    char utc[UTC_TEXT_SIZE];

    self->view.snapshot = shown->snapshot;
    alarms_see(&self->view.alarms, &self->view.snapshot);
    name_peer(shown->snapshot.holder_peer, self->view.holder);
    name_peer(shown->snapshot.requester_peer, self->view.requester);
    cJSON *const state = telemetry_json_state(&self->identity, &self->view);
    utc_text_write(self->started_us, utc);
    (void)cJSON_ReplaceItemInObject(cJSON_GetObjectItem(state, "status"), "utc",
                                    cJSON_CreateString(utc));
    const uint64_t since_ms = (self->pace.utc_us - self->started_us) / US_PER_MS;
    (void)cJSON_AddNumberToObject(moment, "time_s", (double)since_ms / MS_PER_S);
    (void)cJSON_AddItemToObject(moment, "state", state);
    (void)cJSON_AddItemToObject(moment, "frames", new_frames(shown));
    return moment;
}

/* And frees `moment`. */
static void write_row(motion_json_t *self, uint32_t cycle, bool with_numbers, cJSON *moment)
{
    bytes_clear(&self->row);
    bytes_print(&self->row, "%s\n", (self->rows == 0U) ? "" : ",");
    if (tape_take(&self->tape, cycle, with_numbers, moment, &self->row)) {
        page_text_write(self->file, (const char *)self->row.at, self->row.used);
        self->rows++;
    }
    cJSON_Delete(moment);
}

static void write_null(motion_json_t *self, uint32_t cycle)
{
    write_row(self, cycle, true, cJSON_CreateNull());
    self->is_known = false;
}

/* Ends what is known where the present cycle does not go on with it. */
static void end_known(motion_json_t *self, const controller_outputs_t *shown)
{
    const uint32_t cycle = self->pace.cycle;

    if (self->is_known && ((shown == NULL) || (cycle != self->next))) {
        write_null(self, self->next);
    } else if ((shown == NULL) && (self->rows == 0U)) {
        write_null(self, cycle);
    } else {
        /* It goes on, or nothing is known anyway. */
    }
}

void motion_json_take(walk_t *walk, void *to, const controller_outputs_t *shown)
{
    motion_json_t *const self = to;
    const controller_outputs_t *const kept = &walk->record.body.cycle.outputs;

    pace_take(&self->pace, &walk->reader.header, &walk->record);
    take_events(self, kept);
    end_known(self, shown);
    if (shown == NULL) {
        return;
    }
    const uint32_t drives = drives_of(shown);
    const bool is_turn = pace_is_turn(&self->pace, &shown->snapshot);
    const bool with_numbers =
        !self->is_known || ((self->pace.cycle % NUMBER_CYCLES) == 0U) || (kept->event_count > 0U);
    if (is_turn || with_numbers || (drives != self->drives)) {
        write_row(self, self->pace.cycle, with_numbers, new_moment(self, shown));
    }
    self->drives = drives;
    self->is_known = true;
    self->next = self->pace.cycle + 1U;
}

static cJSON *new_identity(const motion_json_t *self, const walk_t *walk, int code)
{
    cJSON *const identity = cJSON_CreateObject();
    char checksum[9];
    char utc[UTC_TEXT_SIZE];
    char run[RECORDING_RUN_SIZE];

    recording_run_name(walk->reader.header.run, run);
    (void)snprintf(checksum, sizeof checksum, "%08x", (unsigned)self->robot->crc);
    utc_text_write(self->started_us, utc);
    (void)cJSON_AddStringToObject(identity, "build", self->build);
    (void)cJSON_AddStringToObject(identity, "replayed_by", BUILD_ID);
    (void)cJSON_AddStringToObject(identity, "robot", self->robot->name);
    (void)cJSON_AddStringToObject(identity, "checksum", checksum);
    (void)cJSON_AddStringToObject(identity, "started", utc);
    (void)cJSON_AddStringToObject(identity, "run", run);
    (void)cJSON_AddNumberToObject(identity, "first", (double)walk->coverage.first);
    (void)cJSON_AddNumberToObject(identity, "cycles", (double)walk->coverage.next);
    (void)cJSON_AddBoolToObject(identity, "has_run_end", walk->has_run_end);
    (void)cJSON_AddBoolToObject(identity, "is_whole_run",
                                (code == EXIT_EQUAL) && walk_is_whole_run(walk));
    (void)cJSON_AddNumberToObject(identity, "missing", (double)walk->coverage.missing);
    (void)cJSON_AddNumberToObject(identity, "replayed", (double)walk->replay.replayed);
    (void)cJSON_AddNumberToObject(identity, "unreplayed", (double)walk->replay.unreplayed);
    (void)cJSON_AddNumberToObject(identity, "cycles_lost", (double)walk->reader.cycles_lost);
    (void)cJSON_AddBoolToObject(identity, "is_cut_short", walk->is_cut_short);
    (void)cJSON_AddBoolToObject(identity, "is_trusted", code != EXIT_REFUSED);
    (void)cJSON_AddStringToObject(identity, "difference", walk->difference);
    return identity;
}

void motion_json_end(motion_json_t *self, const walk_t *walk, int code)
{
    FILE *const file = self->file;

    if (!self->is_known && (self->tape.cycle < self->pace.cycle)) {
        write_null(self, self->pace.cycle);
    }
    (void)fputs("],\n\"events\":[", file);
    page_text_write(file, (const char *)self->events.at, self->events.used);
    (void)fputs("],\n\"recording\":", file);
    write_value(file, new_identity(self, walk, code));
    (void)fputc('}', file);
    tape_free(&self->tape);
    bytes_free(&self->row);
    bytes_free(&self->events);
}

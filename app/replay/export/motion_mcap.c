/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/export/motion_mcap.h"

#include "common/build_id.h"
#include "common/event_text.h"
#include "interface/app/names.h"
#include "replay/data/frame_fields.h"
#include "robot/robot_cards.h"

#include <inttypes.h>
#include <string.h>

#define NS_PER_US 1000U
#define US_PER_S 1000000U

/* The schema by whose name Foxglove knows a log, and what an event has beside it. */
static const char event_schema[] =
    "{\"type\":\"object\",\"title\":\"An event.\",\"properties\":{"
    "\"timestamp\":{\"type\":\"object\",\"title\":\"time\",\"properties\":{"
    "\"sec\":{\"type\":\"integer\"},\"nsec\":{\"type\":\"integer\"}}},"
    "\"level\":{\"type\":\"integer\",\"description\":\"2 information, 3 warning, 5 critical.\"},"
    "\"message\":{\"type\":\"string\"},\"name\":{\"type\":\"string\"},"
    "\"file\":{\"type\":\"string\"},\"line\":{\"type\":\"integer\"},"
    "\"severity\":{\"type\":\"string\"},\"number\":{\"type\":\"integer\"},"
    "\"cycle\":{\"type\":\"integer\"}}}";

static void put_property(void *to, const series_t *series)
{
    static const char *const types[] = {
        [SERIES_NUMBER] = "number", [SERIES_FLAG] = "boolean", [SERIES_WORD] = "string"};
    bytes_t *const schema = to;

    bytes_quote(schema, series->name);
    bytes_print(schema, ":{\"type\":\"%s\",\"description\":", types[series->kind]);
    bytes_quote(schema, series->says);
    bytes_print(schema, "},");
}

static void put_value(void *to, const series_t *series)
{
    bytes_t *const message = to;

    bytes_quote(message, series->name);
    bytes_put8(message, (uint8_t)':');
    if (series->kind == SERIES_WORD) {
        bytes_quote(message, series->word);
    } else if (series->kind == SERIES_FLAG) {
        bytes_print(message, "%s", (series->number != 0.0) ? "true" : "false");
    } else {
        bytes_print(message, "%.*f", series->decimals, series->number);
    }
    bytes_put8(message, (uint8_t)',');
}

/* The last member has no comma behind it. */
static void close_object(bytes_t *to, const char *end)
{
    to->used--;
    bytes_print(to, "%s", end);
}

static void begin_schema(motion_mcap_t *self, const char *says)
{
    bytes_clear(&self->message);
    bytes_print(&self->message, "{\"type\":\"object\",\"title\":");
    bytes_quote(&self->message, says);
    bytes_print(&self->message, ",\"properties\":{");
}

static uint16_t end_schema(motion_mcap_t *self, const char *topic)
{
    char name[64];

    (void)snprintf(name, sizeof name, "boresight%s", topic);
    close_object(&self->message, "}}");
    return mcap_add_channel(&self->file, topic, name, &self->message);
}

static uint16_t add_source(motion_mcap_t *self, const source_t *source)
{
    static const snapshot_t nothing;

    begin_schema(self, source->says);
    source_report(source, &nothing, put_property, &self->message);
    return end_schema(self, source->topic);
}

static uint16_t add_frames(motion_mcap_t *self, uint32_t slot)
{
    static const card_command_t nothing;
    char topic[32];

    (void)snprintf(topic, sizeof topic, "/frames/%u", (unsigned)slot);
    begin_schema(self, "What leaves to a card.");
    series_report(fields_card_command, &nothing, NULL, put_property, &self->message);
    return end_schema(self, topic);
}

static void add_channels(motion_mcap_t *self)
{
    for (uint32_t i = 0U; i < self->count; i++) {
        self->channels[i] = add_source(self, &self->sources[i]);
    }
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (robot_cards_type(self->robot, slot) != (uint32_t)CARD_TYPE_NONE) {
            self->frames[slot] = add_frames(self, slot);
        }
    }
    bytes_clear(&self->message);
    bytes_print(&self->message, "%s", event_schema);
    self->events = mcap_add_channel(&self->file, "/events", "foxglove.Log", &self->message);
}

bool motion_mcap_begin(motion_mcap_t *self, FILE *file, const robot_t *robot)
{
    (void)memset(self, 0, sizeof *self);
    self->robot = robot;
    self->count = source_find(robot, self->sources);
    const bool has_begun = mcap_begin(&self->file, file, "boresight-replay " BUILD_ID);
    if (has_begun) {
        add_channels(self);
    }
    return has_begun;
}

static void begin_message(motion_mcap_t *self)
{
    bytes_clear(&self->message);
    bytes_put8(&self->message, (uint8_t)'{');
}

static void end_message(motion_mcap_t *self, uint16_t channel)
{
    close_object(&self->message, "}");
    mcap_write(&self->file, channel, self->pace.utc_us * NS_PER_US, &self->message);
}

static uint32_t log_level(uint32_t severity)
{
    static const uint8_t levels[] = {[EVENT_SEVERITY_INFORMATION] = 2U,
                                     [EVENT_SEVERITY_WARNING] = 3U,
                                     [EVENT_SEVERITY_CRITICAL] = 5U};

    return (severity < sizeof levels) ? levels[severity] : 0U;
}

static void write_event(motion_mcap_t *self, const event_t *event)
{
    const uint64_t utc_us = self->pace.utc_us;
    char sentence[EVENT_TEXT_SIZE];

    event_text_sentence(self->robot, event, NULL, sentence, sizeof sentence);
    begin_message(self);
    bytes_print(&self->message,
                "\"timestamp\":{\"sec\":%" PRIu64 ",\"nsec\":%" PRIu64 "},\"level\":%" PRIu32
                ",\"message\":",
                utc_us / US_PER_S, (utc_us % US_PER_S) * NS_PER_US, log_level(event->severity));
    bytes_quote(&self->message, sentence);
    bytes_print(&self->message, ",\"name\":\"%s\",\"file\":\"\",\"line\":0,\"severity\":\"%s\",",
                event_id_name((int32_t)event->id), event_severity_name((int32_t)event->severity));
    bytes_print(&self->message, "\"number\":%" PRIu32 ",\"cycle\":%" PRIu32 ",", event->number,
                event->cycle);
    end_message(self, self->events);
}

static void write_events(motion_mcap_t *self, const controller_outputs_t *outputs)
{
    for (uint32_t i = 0U; (i < outputs->event_count) && (i < CONTROLLER_EVENTS); i++) {
        write_event(self, &outputs->events[i]);
    }
}

/* A slot that the robot does not name has no channel, and gets no frame. */
static void write_frames(motion_mcap_t *self, const controller_outputs_t *shown)
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        card_command_t command;
        if (((shown->frames_to_send & (1U << slot)) != 0U) && (self->frames[slot] != 0U) &&
            (card_frame_decode_command(shown->frames[slot], slot, &command) == CARD_FRAME_OK)) {
            begin_message(self);
            series_report(fields_card_command, &command, NULL, put_value, &self->message);
            end_message(self, self->frames[slot]);
        }
    }
}

void motion_mcap_take(motion_mcap_t *self, const recording_header_t *header,
                      const cycle_record_t *record, const controller_outputs_t *shown)
{
    pace_take(&self->pace, header, record);
    write_events(self, &record->body.cycle.outputs);
    if ((shown == NULL) || !pace_is_turn(&self->pace, &shown->snapshot)) {
        return;
    }
    for (uint32_t i = 0U; i < self->count; i++) {
        begin_message(self);
        source_report(&self->sources[i], &shown->snapshot, put_value, &self->message);
        end_message(self, self->channels[i]);
    }
    write_frames(self, shown);
}

bool motion_mcap_end(motion_mcap_t *self, const recording_header_t *header, bool is_cut_short,
                     uint32_t cycles_lost)
{
    char lost[16];
    char build[4U * sizeof header->build];
    char run[RECORDING_RUN_SIZE];
    const char *const pairs[][2] = {{"robot", self->robot->name},
                                    {"build", build},
                                    {"run", run},
                                    {"is_cut_short", is_cut_short ? "true" : "false"},
                                    {"cycles_lost", lost}};

    recording_escape(header->build, build, sizeof build);
    recording_run_name(header->run, run);
    (void)snprintf(lost, sizeof lost, "%" PRIu32, cycles_lost);
    mcap_note(&self->file, "recording", pairs, sizeof pairs / sizeof pairs[0]);
    bytes_free(&self->message);
    return mcap_end(&self->file);
}

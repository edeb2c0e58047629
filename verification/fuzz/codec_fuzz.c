/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Any bytes into the inbox, in pieces and at once. The first byte says whether each message's
 * checksum is put right, the second how the rest is cut. A sentence that does not hold ends the
 * program.
 */
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_crc64.h"
#include "igtl/wire/igtl_packet.h"
#include "igtl/wire/igtl_inbox.h"
#include "fuzz/sentence.h"

#include <stdlib.h>
#include <string.h>

#define EVENTS_MAX 512U
#define LONGEST 20000U

/** Result of an inbox for a stream. */
typedef struct {
    uint32_t count;
    uint64_t events[EVENTS_MAX];
    uint64_t consumed;
} transcript_t;

static uint8_t stream[LONGEST];
static igtl_inbox_t inbox;

static uint64_t number_at(const uint8_t *bytes)
{
    uint64_t value = 0U;

    for (uint32_t i = 0U; i < 8U; i++) {
        value = (value << 8U) | bytes[i];
    }
    return value;
}

/* The checksum of every whole message as its header cuts the stream. */
static void mend(uint32_t length)
{
    uint32_t at = 0U;

    while ((at + IGTL_HEADER_BYTES) <= length) {
        const uint64_t body_bytes = number_at(&stream[at + 42U]);

        if (body_bytes > (uint64_t)(length - at - IGTL_HEADER_BYTES)) {
            return;
        }
        const uint64_t crc = igtl_crc64(0U, &stream[at + IGTL_HEADER_BYTES], (size_t)body_bytes);
        for (uint32_t i = 0U; i < 8U; i++) {
            stream[at + 50U + i] = (uint8_t)(crc >> (56U - (8U * i)));
        }
        at += IGTL_HEADER_BYTES + (uint32_t)body_bytes;
    }
}

static bool is_printable(const char *text, uint32_t length)
{
    for (uint32_t i = 0U; i < length; i++) {
        if ((text[i] < ' ') || (text[i] > '~')) {
            return false;
        }
    }
    return true;
}

static void check_text(const igtl_message_t *message, const char *text, uint32_t length)
{
    const uint64_t place = (uint64_t)((const uint8_t *)text - message->content);

    SENTENCE((text == NULL) ? (length == 0U) : ((place + length) <= message->content_bytes),
             "a text stands inside the content");
}

static void check_inside(const igtl_message_t *message, const uint8_t *body, uint64_t body_bytes)
{
    const uint64_t offset = (uint64_t)(message->content - body);

    SENTENCE((offset <= body_bytes) && (message->content_bytes <= (body_bytes - offset)),
             "content stands inside the body");
    SENTENCE(memchr(message->name, 0, sizeof message->name) != NULL, "a name ends");
    SENTENCE(is_printable(message->name, (uint32_t)strlen(message->name)), "a name is printable");
    check_text(message, message->text, message->text_bytes);
    check_text(message, message->subject, message->subject_bytes);
    SENTENCE((message->kind != IGTL_KIND_STRING) ||
                 is_printable(message->text, message->text_bytes),
             "a text is printable");
    SENTENCE(is_printable(message->subject, message->subject_bytes), "a subject is printable");
}

static igtl_message_t read_back(const igtl_packet_t *packet)
{
    static igtl_packet_t kept; /* The bytes that the message points into. */
    igtl_header_t header;
    igtl_message_t message;

    SENTENCE(igtl_decode_header(packet->bytes, &header) == IGTL_OK, "what is written has a header");
    SENTENCE((header.body_bytes + IGTL_HEADER_BYTES) == packet->length, "its length is reported");
    kept = *packet;
    SENTENCE(igtl_decode_body(&header, &kept.bytes[IGTL_HEADER_BYTES], &message) == IGTL_OK,
             "what is written is read");
    return message;
}

/* An accepted message, written by us, is the same again. */
static void check_round(const igtl_message_t *message)
{
    igtl_packet_t packet;
    igtl_message_t again;

    if (message->kind == IGTL_KIND_TRANSFORM) {
        igtl_encode_transform(&packet, message->name, message->numbers, 0U);
        again = read_back(&packet);
        SENTENCE(memcmp(again.numbers, message->numbers, sizeof again.numbers) == 0,
                 "a matrix stays the same");
    } else if ((message->kind == IGTL_KIND_STRING) && (message->text_bytes <= IGTL_TEXT_MAX)) {
        char text[IGTL_TEXT_MAX + 1U] = "";

        (void)memcpy(text, message->text, message->text_bytes);
        igtl_encode_string(&packet, message->name, text, 0U);
        again = read_back(&packet);
        SENTENCE((again.text_bytes == message->text_bytes) &&
                     (memcmp(again.text, message->text, again.text_bytes) == 0),
                 "a text stays the same");
    } else if (message->kind == IGTL_KIND_STATUS) {
        const igtl_status_t status = {message->code, "NAME", "text"};

        igtl_encode_status(&packet, message->name, &status, 0U);
        again = read_back(&packet);
        SENTENCE(again.code == message->code, "a code stays the same");
    } else if (message->kind == IGTL_KIND_COMMAND) {
        igtl_encode_command_reply(&packet, message, true, "no", 0U);
        again = read_back(&packet);
    } else {
        return;
    }
    SENTENCE(strcmp(again.name, message->name) == 0, "a name stays the same");
}

/* Read where nothing stands beside it, as the sanitizers see. */
static igtl_result_t read_apart(const igtl_header_t *header, const uint8_t *body)
{
    const size_t length = (size_t)header->body_bytes;
    uint8_t *apart = malloc(length);
    igtl_message_t message;
    igtl_result_t result;

    if ((length > 0U) && (apart != NULL)) {
        (void)memcpy(apart, body, length);
    }
    result = igtl_decode_body(header, apart, &message);
    if (result == IGTL_OK) {
        check_inside(&message, apart, length);
        check_round(&message);
    }
    free(apart);
    return result;
}

/* The body was read and judged, not skipped. */
static bool has_body(igtl_inbox_event_t event)
{
    const bool is_refused_by_header =
        (inbox.reason == IGTL_BAD_NAME) || (inbox.reason == IGTL_TOO_LONG);

    return (event == IGTL_INBOX_MESSAGE) ||
           ((event == IGTL_INBOX_REFUSED) && (inbox.header.kind != IGTL_KIND_OTHER) &&
            !is_refused_by_header);
}

static void note(transcript_t *self, igtl_inbox_event_t event)
{
    const igtl_message_t *message = &inbox.message;
    uint64_t sum = ((uint64_t)event << 8U);

    if ((event == IGTL_INBOX_REFUSED) || (event == IGTL_INBOX_BROKEN)) {
        sum |= (uint64_t)inbox.reason;
    }
    if (has_body(event)) {
        SENTENCE(read_apart(&inbox.header, &inbox.buffer[IGTL_HEADER_BYTES]) == inbox.reason,
                 "a message is read the same elsewhere");
    }
    if (event == IGTL_INBOX_MESSAGE) {
        sum = igtl_crc64(sum, (const uint8_t *)message->name, strlen(message->name));
        sum = igtl_crc64(sum, message->content, message->content_bytes);
    }
    if (self->count < EVENTS_MAX) {
        self->events[self->count] = sum;
    }
    self->count++;
}

/* As many bytes at a time as the next of `cuts` says, at least 1; 0 for all there is room for. */
static void play(transcript_t *self, uint32_t length, uint8_t cut)
{
    uint32_t at = 0U;
    uint32_t random = cut;

    self->count = 0U;
    igtl_inbox_init(&inbox);
    while (at < length) {
        uint8_t *where;
        uint32_t room = igtl_inbox_room(&inbox, &where);
        igtl_inbox_event_t event;

        SENTENCE(room >= 1U, "an inbox has room");
        SENTENCE((where >= inbox.buffer) &&
                     ((where + room) <= (inbox.buffer + sizeof inbox.buffer)),
                 "the room is inside the inbox");
        room = (room < (length - at)) ? room : (length - at);
        if (cut > 0U) {
            random = (random * 1103515245U) + 12345U;
            const uint32_t piece = 1U + ((random >> 16U) % (1U + cut));
            room = (room < piece) ? room : piece;
        }
        (void)memcpy(where, &stream[at], room);
        at += room;
        event = igtl_inbox_advance(&inbox, room, at);
        if (event != IGTL_INBOX_WAITING) {
            note(self, event);
            self->consumed = at;
        }
        if (event == IGTL_INBOX_BROKEN) {
            return;
        }
    }
}

/* Nothing of a message is taken for the next one, and nothing of the next one skipped. */
static void check_framing(const transcript_t *transcript, uint32_t length)
{
    uint64_t at = 0U;

    for (uint32_t i = 0U; i < transcript->count; i++) {
        if ((i + 1U) == transcript->count) {
            const uint64_t end = at + IGTL_HEADER_BYTES;

            SENTENCE(transcript->consumed >= end, "nothing is decided before a header is whole");
        }
        SENTENCE((at + IGTL_HEADER_BYTES) <= length, "an event has a header");
        at += IGTL_HEADER_BYTES;
        if (transcript->events[i] >> 8U != (uint64_t)IGTL_INBOX_BROKEN) {
            at += number_at(&stream[at - 16U]);
            SENTENCE(at <= length, "an event has its body");
        }
    }
    SENTENCE((transcript->count == 0U) || (transcript->consumed == at),
             "messages end where their headers say");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static transcript_t pieces;
    static transcript_t whole;

    if ((size < 2U) || ((size - 2U) > LONGEST)) {
        return 0;
    }
    const uint32_t length = (uint32_t)(size - 2U);

    (void)memcpy(stream, &data[2], length);
    if ((data[0] & 1U) != 0U) {
        mend(length);
    }
    play(&whole, length, 0U);
    play(&pieces, length, data[1]);
    if (whole.count <= EVENTS_MAX) {
        SENTENCE(
            (whole.count == pieces.count) &&
                (memcmp(whole.events, pieces.events, whole.count * sizeof whole.events[0]) == 0),
            "it does not matter how bytes are cut");
        check_framing(&whole, length);
    }
    return 0;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "fuzz/grammar.h"

#include "fuzz/words.h"
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_crc64.h"

#include <stdio.h>
#include <string.h>

#define ENCODING_ASCII 3U
#define TRACKING_BYTES 36U
#define COMMAND_BYTES 138U
#define STATUS_BYTES 31U
#define TRAJECTORY_TYPE 96U
#define FLOAT_128 0x43000000U

static void put(grammar_message_t *self, uint64_t value, uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        self->bytes[self->length] = (uint8_t)(value >> (8U * (count - 1U - i)));
        self->length++;
    }
}

static void put_text(grammar_message_t *self, const char *text, uint32_t size)
{
    const size_t length = strlen(text);

    (void)memset(&self->bytes[self->length], 0, size);
    (void)memcpy(&self->bytes[self->length], text, (length < size) ? length : size);
    self->length += size;
}

static void write_at(grammar_message_t *self, uint32_t at, uint64_t value)
{
    const uint32_t end = self->length;

    self->length = at;
    put(self, value, 8U);
    self->length = end;
}

static void put_name(grammar_message_t *self, uint8_t name, uint8_t number)
{
    const char *pattern = fuzz_names[name % FUZZ_NAMES];
    const char *mark = strchr(pattern, '#');
    char whole[32];

    if (mark == NULL) {
        put_text(self, pattern, IGTL_NAME_SIZE - 1U);
        return;
    }
    (void)snprintf(whole, sizeof whole, "%.*s%04u", (int)(mark - pattern), pattern,
                   (unsigned)number);
    put_text(self, whole, IGTL_NAME_SIZE - 1U);
}

static void begin(grammar_message_t *self, uint32_t version, const char *type)
{
    self->length = 0U;
    put(self, version, 2U);
    put_text(self, type, IGTL_TYPE_SIZE - 1U);
}

static void end_header(grammar_message_t *self, uint32_t version)
{
    put(self, 0U, 8U);
    put(self, 0U, 8U);
    put(self, 0U, 8U);
    if (version == 2U) {
        put(self, 12U, 2U); /* Extended header. */
        put(self, 10U, 2U); /* Metadata's header. */
        put(self, 10U, 4U); /* Metadata. */
        put(self, 7U, 4U);  /* Id. */
    }
}

static void finish(grammar_message_t *self, uint32_t version)
{
    if (version == 2U) {
        put(self, 1U, 2U);
        put(self, 5U, 2U);
        put(self, ENCODING_ASCII, 2U);
        put(self, 5U, 4U);
        put_text(self, "dummydummy", 10U);
    }
    write_at(self, 42U, self->length - IGTL_HEADER_BYTES);
    write_at(self, 50U,
             igtl_crc64(0U, &self->bytes[IGTL_HEADER_BYTES], self->length - IGTL_HEADER_BYTES));
}

static void put_string(grammar_message_t *self, uint8_t text)
{
    const char *said = fuzz_texts[text % FUZZ_TEXTS];

    put(self, ENCODING_ASCII, 2U);
    put(self, strlen(said), 2U);
    put_text(self, said, (uint32_t)strlen(said));
}

void grammar_string(grammar_message_t *self, uint32_t version, const uint8_t words[3])
{
    begin(self, version, "STRING");
    put_name(self, words[0], words[1]);
    end_header(self, version);
    put_string(self, words[2]);
    finish(self, version);
}

void grammar_transform(grammar_message_t *self, uint32_t version, const uint8_t words[3])
{
    begin(self, version, "TRANSFORM");
    put_name(self, words[0], words[1]);
    end_header(self, version);
    for (uint32_t i = 0U; i < IGTL_TRANSFORM_NUMBERS; i++) {
        put(self, fuzz_matrices[words[2] % FUZZ_MATRICES][i], 4U);
    }
    finish(self, version);
}

/* Mostly one, of types 0 to 4; its points are where a matrix is. */
static void put_trajectories(grammar_message_t *self, uint32_t number)
{
    const uint32_t *matrix = fuzz_matrices[number % FUZZ_MATRICES];
    const uint32_t count = ((number % 16U) == 0U) ? (number / 16U) : 1U;

    for (uint32_t i = 0U; i < (count % 4U); i++) {
        put_text(self, "path", TRAJECTORY_TYPE);
        put(self, number % 5U, 1U);
        put_text(self, "", 5U);
        for (uint32_t k = 0U; k < 6U; k++) {
            put(self, matrix[9U + (k % 3U)], 4U);
        }
        put_text(self, "", IGTL_TRAJECTORY_BYTES - TRAJECTORY_TYPE - 30U);
    }
}

/* So many rows for the robot of seven axes, or steps, mostly well formed. */
static void put_array(grammar_message_t *self, uint32_t number)
{
    const uint32_t rows = number % 8U;
    const uint32_t columns = ((number % 32U) == 31U) ? 14U : ((number < 128U) ? 15U : 4U);

    put(self, ((number / 8U) % 16U == 1U) ? 6U : 10U, 1U);
    put(self, 2U, 1U);
    put(self, rows, 2U);
    put(self, columns, 2U);
    for (uint32_t i = 0U; i < rows; i++) {
        put(self, (i == 0U) ? 0U : (FLOAT_128 + (i << 16U)), 4U);
        put_text(self, "", 4U * (columns - 1U));
    }
}

static void put_content(grammar_message_t *self, const char *type, uint8_t number)
{
    static const uint32_t resolutions[] = {0U, 1U, 10U, 100U, 100000U, 0xFFFFFFFFU};

    if ((strncmp(type, "GET_", 4U) == 0) || (strncmp(type, "STP_", 4U) == 0)) {
        return;
    }
    if (strncmp(type, "STT_", 4U) == 0) {
        put(self, resolutions[number % (sizeof resolutions / sizeof resolutions[0])], 4U);
        put_text(self, "", TRACKING_BYTES - 4U);
    } else if (strstr(type, "COMMAND") != NULL) {
        const char *text = fuzz_texts[number % FUZZ_TEXTS];

        put(self, number, 4U);
        put_text(self, text, COMMAND_BYTES - 10U);
        put(self, ENCODING_ASCII, 2U);
        put(self, strlen(text), 4U);
        put_text(self, text, (uint32_t)strlen(text));
    } else if (strcmp(type, "STATUS") == 0) {
        put(self, number, 2U);
        put_text(self, "", STATUS_BYTES - 2U);
    } else if (strcmp(type, "POINT") == 0) {
        put_text(self, "point", IGTL_POINT_BYTES * (number % 3U));
    } else if (strcmp(type, "TRAJ") == 0) {
        put_trajectories(self, number);
    } else if (strcmp(type, "NDARRAY") == 0) {
        put_array(self, number);
    } else {
        put_text(self, type, 4U * (uint32_t)number);
    }
}

void grammar_ask(grammar_message_t *self, uint32_t version, const uint8_t words[3])
{
    const char *type = fuzz_types[words[0] % FUZZ_TYPES];

    begin(self, version, type);
    put_name(self, words[1], words[2]);
    end_header(self, version);
    put_content(self, type, words[2]);
    finish(self, version);
}

void grammar_damage(grammar_message_t *self, const grammar_fault_t *fault)
{
    if (!fault->is_wanted) {
        return;
    }
    self->bytes[fault->position % self->length] = fault->value;
    if (!fault->is_checksum_kept) {
        write_at(self, 50U,
                 igtl_crc64(0U, &self->bytes[IGTL_HEADER_BYTES], self->length - IGTL_HEADER_BYTES));
    }
}

const char *grammar_order(uint8_t number)
{
    return fuzz_orders[number % FUZZ_ORDERS];
}

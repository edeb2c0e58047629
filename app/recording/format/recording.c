/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/format/recording.h"

#include "base/crc.h"
#include "common/little_endian.h"

#include <openssl/evp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define HEADER_VERSION 8U
#define HEADER_SIZE_FIELD 12U
#define HEADER_BUILD 16U
#define HEADER_ROBOT 80U
#define HEADER_ROBOT_CRC 96U
#define HEADER_INPUTS 100U
#define HEADER_OUTPUTS 104U
#define HEADER_CONTROLLER 108U
#define HEADER_STARTED 112U
#define HEADER_LAYOUT 120U
#define HEADER_FRAME_LAYOUT 128U
#define HEADER_RUN 136U
#define HEADER_HASHED (RECORDING_HEADER_SIZE - RECORDING_HASH_SIZE)
#define FIELDS_CRC 28U

static const uint8_t magic[8] = {'B', 'S', 'R', 'E', 'C', 'O', 'R', 'D'};

/* Hashes up to three pieces; without memory for it nothing can be trusted, so the process ends. */
static void digest(const uint8_t *const pieces[3], const size_t sizes[3], uint8_t *hash)
{
    EVP_MD_CTX *context = EVP_MD_CTX_new();
    bool is_good = (context != NULL) && (EVP_DigestInit_ex(context, EVP_sha256(), NULL) == 1);

    for (uint32_t i = 0U; i < 3U; i++) {
        is_good = is_good && (EVP_DigestUpdate(context, pieces[i], sizes[i]) == 1);
    }
    is_good = is_good && (EVP_DigestFinal_ex(context, hash, NULL) == 1);
    EVP_MD_CTX_free(context);
    if (!is_good) {
        abort();
    }
}

void recording_hash(const uint8_t *before, const uint8_t *fields, const uint8_t *rest,
                    size_t rest_size, uint8_t *hash)
{
    const uint8_t *const pieces[3] = {before, fields, rest};
    const size_t sizes[3] = {RECORDING_HASH_SIZE, RECORDING_FIELDS_SIZE, rest_size};

    digest(pieces, sizes, hash);
}

static void hash_header(const uint8_t *bytes, uint8_t *hash)
{
    const uint8_t *const pieces[3] = {bytes, bytes, bytes};
    const size_t sizes[3] = {HEADER_HASHED, 0U, 0U};

    digest(pieces, sizes, hash);
}

void recording_seal_header(uint8_t *bytes)
{
    hash_header(bytes, &bytes[HEADER_HASHED]);
}

void recording_encode_header(const recording_header_t *header, uint8_t *bytes)
{
    (void)memset(bytes, 0, RECORDING_HEADER_SIZE);
    (void)memcpy(bytes, magic, sizeof magic);
    put32(&bytes[HEADER_VERSION], RECORDING_VERSION);
    put32(&bytes[HEADER_SIZE_FIELD], RECORDING_HEADER_SIZE);
    (void)memcpy(&bytes[HEADER_BUILD], header->build, sizeof header->build);
    (void)memcpy(&bytes[HEADER_ROBOT], header->robot, sizeof header->robot);
    put32(&bytes[HEADER_ROBOT_CRC], header->robot_crc);
    put32(&bytes[HEADER_INPUTS], header->inputs_size);
    put32(&bytes[HEADER_OUTPUTS], header->outputs_size);
    put32(&bytes[HEADER_CONTROLLER], header->controller_size);
    put64(&bytes[HEADER_STARTED], header->started_us);
    put64(&bytes[HEADER_LAYOUT], header->layout);
    put32(&bytes[HEADER_FRAME_LAYOUT], header->frame_layout);
    put64(&bytes[HEADER_RUN], header->run);
    recording_seal_header(bytes);
}

uint32_t recording_decode_header(const uint8_t *bytes, recording_header_t *header)
{
    uint8_t hash[RECORDING_HASH_SIZE];

    hash_header(bytes, hash);
    if ((memcmp(bytes, magic, sizeof magic) != 0) ||
        (memcmp(hash, &bytes[HEADER_HASHED], sizeof hash) != 0)) {
        return 0U;
    }
    (void)memcpy(header->build, &bytes[HEADER_BUILD], sizeof header->build);
    (void)memcpy(header->robot, &bytes[HEADER_ROBOT], sizeof header->robot);
    header->build[sizeof header->build - 1U] = '\0';
    header->robot[sizeof header->robot - 1U] = '\0';
    header->robot_crc = get32(&bytes[HEADER_ROBOT_CRC]);
    header->inputs_size = get32(&bytes[HEADER_INPUTS]);
    header->outputs_size = get32(&bytes[HEADER_OUTPUTS]);
    header->controller_size = get32(&bytes[HEADER_CONTROLLER]);
    header->started_us = get64(&bytes[HEADER_STARTED]);
    header->layout = get64(&bytes[HEADER_LAYOUT]);
    header->frame_layout = get32(&bytes[HEADER_FRAME_LAYOUT]);
    header->run = get64(&bytes[HEADER_RUN]);
    return get32(&bytes[HEADER_VERSION]);
}

void recording_run_name(uint64_t run, char name[RECORDING_RUN_SIZE])
{
    const time_t seconds = (time_t)(run / UINT64_C(1000000));
    struct tm utc = {.tm_year = 0};

    (void)gmtime_r(&seconds, &utc);
    const size_t used = strftime(name, RECORDING_RUN_SIZE, "%Y%m%dT%H%M%S", &utc);
    (void)snprintf(&name[used], RECORDING_RUN_SIZE - used, ".%06uZ",
                   (unsigned)(run % UINT64_C(1000000)));
}

void recording_escape(const char *text, char *escaped, size_t size)
{
    size_t used = 0U;

    for (size_t i = 0U; (text[i] != '\0') && ((used + sizeof "\\x00") <= size); i++) {
        const bool is_plain =
            (text[i] >= ' ') && (text[i] <= '~') && (text[i] != '\\') && (text[i] != '"');
        used += (size_t)snprintf(&escaped[used], size - used, is_plain ? "%c" : "\\x%02X",
                                 (unsigned)(unsigned char)text[i]);
    }
    escaped[used] = '\0';
}

void recording_encode_fields(const recording_fields_t *fields, uint8_t *bytes)
{
    put32(&bytes[0], fields->magic);
    put32(&bytes[4], fields->number);
    put32(&bytes[8], fields->cycle);
    put32(&bytes[12], fields->records);
    put32(&bytes[16], fields->raw_size);
    put32(&bytes[20], fields->compressed_size);
    put32(&bytes[24], fields->cycles_lost);
    put32(&bytes[FIELDS_CRC], crc32c(bytes, FIELDS_CRC));
}

bool recording_decode_fields(const uint8_t *bytes, recording_fields_t *fields)
{
    fields->magic = get32(&bytes[0]);
    fields->number = get32(&bytes[4]);
    fields->cycle = get32(&bytes[8]);
    fields->records = get32(&bytes[12]);
    fields->raw_size = get32(&bytes[16]);
    fields->compressed_size = get32(&bytes[20]);
    fields->cycles_lost = get32(&bytes[24]);
    return get32(&bytes[FIELDS_CRC]) == crc32c(bytes, FIELDS_CRC);
}

size_t recording_checksums_size(uint32_t compressed_size)
{
    return (((size_t)compressed_size + RECORDING_CHUNK - 1U) / RECORDING_CHUNK) * sizeof(uint32_t);
}

void recording_encode_checksums(const uint8_t *payload, uint32_t compressed_size, uint8_t *bytes)
{
    for (uint32_t offset = 0U; offset < compressed_size; offset += RECORDING_CHUNK) {
        const uint32_t left = compressed_size - offset;
        put32(&bytes[(offset / RECORDING_CHUNK) * sizeof(uint32_t)],
              crc32c(&payload[offset], (left < RECORDING_CHUNK) ? left : RECORDING_CHUNK));
    }
}

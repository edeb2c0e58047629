/* SPDX-License-Identifier: Apache-2.0 */
#include "site/recorded/recorded.h"

#include "base/contract.h"
#include "common/clock.h"
#include "replay/export/motion_json.h"
#include "replay/verify/walk.h"
#include "site/recorded/one_file.h"

#include <stdio.h>
#include <stdlib.h>

static const char contract_module[] = "recorded";

static char name[RECORDED_NAME_SIZE];
static walk_t walk;
static motion_json_t json;
static FILE *document;
static char *text;
static size_t text_size;

void contract_broken(const char *module, uint32_t id)
{
    (void)fprintf(stderr, "Cycle %u breaks contract %s/%u.\n", (unsigned)walk.record.cycle, module,
                  (unsigned)id);
    __builtin_trap();
}

/* A recording has its own time: none of now is shown. */
uint64_t clock_utc_us(void)
{
    return 0U;
}

char *recorded_name(void)
{
    return name;
}

uint8_t *recorded_room(uint32_t size)
{
    return one_file_make(size);
}

bool recorded_open(void)
{
    name[sizeof name - 1U] = '\0';
    walk_begin(&walk, false, stderr);
    if (!walk_open(&walk, name)) {
        return false;
    }
    document = open_memstream(&text, &text_size);
    if (document == NULL) {
        abort();
    }
    motion_json_begin(&json, document, &walk);
    return true;
}

static void end_document(int code)
{
    motion_json_end(&json, &walk, code);
    if (fclose(document) != 0) {
        abort(); /* Only memory can lack. */
    }
    document = NULL;
}

uint32_t recorded_go_on(uint32_t records)
{
    int code = WALK_GOES_ON;

    REQUIRE(330U, document != NULL);
    for (uint32_t i = 0U; (i < records) && (code == WALK_GOES_ON); i++) {
        code = walk_report_next(&walk, motion_json_take, &json);
    }
    if (code != WALK_GOES_ON) {
        end_document(code);
        return RECORDED_ALL;
    }
    return (uint32_t)(((RECORDED_ALL - 1U) * walk.reader.next) / walk.reader.end);
}

const char *recorded_document(void)
{
    return text;
}

uint32_t recorded_document_size(void)
{
    return (uint32_t)text_size;
}

const char *recorded_printed(void)
{
    return one_file_printed();
}

/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: no text of a recording ends the script that holds it, or begins another one, and
 * who reads the JSON has the text as it was.
 */
#include "unity.h"

#include "replay/export/page_text.h"

#include <cjson/cJSON.h>
#include <string.h>

static char written[512];

void setUp(void)
{
}

void tearDown(void)
{
}

static cJSON *write(const char *text)
{
    cJSON *const value = cJSON_CreateString(text);
    char *const json = cJSON_PrintUnformatted(value);
    FILE *const file = fmemopen(written, sizeof written, "w");

    page_text_write(file, json, strlen(json));
    (void)fclose(file);
    cJSON_free(json);
    cJSON_Delete(value);
    return cJSON_Parse(written);
}

void test_SWR_REPLAY_019_a_name_cannot_break_out_of_the_page(void)
{
    static const char *const names[] = {"</script><script>alert(1)</script>", "<!--<script>",
                                        "\"</SCRIPT\n>", "plain \\u003c"};

    for (size_t i = 0U; i < (sizeof names / sizeof names[0]); i++) {
        cJSON *const read = write(names[i]);
        TEST_ASSERT_NULL(strchr(written, '<'));
        TEST_ASSERT_EQUAL_STRING(names[i], cJSON_GetStringValue(read));
        cJSON_Delete(read);
    }
}

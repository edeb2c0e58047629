/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/export/page_text.h"

void page_text_write(FILE *file, const char *json, size_t size)
{
    for (size_t i = 0U; i < size; i++) {
        if (json[i] == '<') {
            (void)fputs("\\u003c", file);
        } else {
            (void)fputc(json[i], file);
        }
    }
}

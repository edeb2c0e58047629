/* SPDX-License-Identifier: Apache-2.0 */
#include "check/check_files.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#define BITS_OF_DIGIT 4U

FILE *check_open(const char *root, const char *path)
{
    char whole[PATH_MAX];
    const int length = snprintf(whole, sizeof whole, "%s%s", root, path);
    return (length < (int)sizeof whole) ? fopen(whole, "r") : NULL;
}

bool check_read(const char *root, const char *path, char text[CHECK_FILE_SIZE])
{
    FILE *const file = check_open(root, path);
    text[0] = '\0';
    if (file == NULL) {
        return false;
    }
    const bool has_line = fgets(text, (int)CHECK_FILE_SIZE, file) != NULL;
    const bool is_read = has_line || (ferror(file) == 0);
    (void)fclose(file);
    text[strcspn(text, "\n")] = '\0';
    return is_read;
}

bool check_list_has(const char *list, uint32_t core)
{
    const char *next = list;
    bool has_it = false;
    while ((*next >= '0') && (*next <= '9')) {
        char *end = NULL;
        const unsigned long first = strtoul(next, &end, 10);
        const unsigned long last = (*end == '-') ? strtoul(end + 1, &end, 10) : first;
        has_it = has_it || ((core >= first) && (core <= last));
        next = (*end == ',') ? (end + 1) : end;
    }
    return has_it;
}

/* Its digits from the last one on; commas are between groups of them. */
bool check_mask_has(const char *mask, uint32_t core)
{
    uint32_t first = 0U;
    for (size_t i = strlen(mask); i > 0U; i--) {
        const char digit[] = {mask[i - 1U], '\0'};
        if (digit[0] == ',') {
            continue;
        }
        if ((core >= first) && (core < (first + BITS_OF_DIGIT))) {
            return ((strtoul(digit, NULL, 16) >> (core - first)) & 1U) != 0U;
        }
        first += BITS_OF_DIGIT;
    }
    return false;
}

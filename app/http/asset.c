/* SPDX-License-Identifier: Apache-2.0 */
#include "asset.h"

#include <string.h>

const asset_t *asset_find(const char *path)
{
    const char *wanted = (strcmp(path, "/") == 0) ? "/index.html" : path;
    for (size_t i = 0; i < asset_count; i++) {
        if (strcmp(assets[i].path, wanted) == 0) {
            return &assets[i];
        }
    }
    return NULL;
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "mode/lists/trajectory_row.h"

#include "base/crc.h"

#include <stddef.h>

uint32_t trajectory_row_crc(const trajectory_row_t *row)
{
    return crc32c((const uint8_t *)row, offsetof(trajectory_row_t, crc));
}

bool trajectory_row_is_whole(const trajectory_row_t *row)
{
    return row->crc == trajectory_row_crc(row);
}

uint32_t trajectory_list_crc(uint32_t crc, const trajectory_row_t *row)
{
    const uint32_t words[2] = {crc, trajectory_row_crc(row)};
    return crc32c((const uint8_t *)words, sizeof words);
}

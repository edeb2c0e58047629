/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/orders/box_number.h"

#include "sim/box.h"

#include <errno.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

static const box_number_t numbers[] = {
    {"pedal", "hold", 1, UINT32_MAX, ""},
    {"pedal", "drop", 1, UINT32_MAX, ""},
    {"button", "hold", 1, UINT32_MAX, ""},
    {"button", "drop", 1, UINT32_MAX, ""},
    {"hand", "hold", 1, UINT32_MAX, ""},
    {"hand", "drop", 1, UINT32_MAX, ""},
    {"hand", "speed", -BOX_WISH_MOST_UM_PER_S, BOX_WISH_MOST_UM_PER_S, " um/s"},
    {"hand", "go", -BOX_WISH_MOST_UM, BOX_WISH_MOST_UM, " um"},
    {"hand", "stiffness", BOX_STIFFNESS_LEAST, BOX_STIFFNESS_MOST, " mN/mm"},
    {"grip", NULL, -BOX_GRIP_MOST_MN, BOX_GRIP_MOST_MN, " mN"},
    {"keep", NULL, 1, UINT32_MAX, ""},
    {"force", "hand", 0, SIM_LOAD_CELL_MOST, ""},
    {"force", "needle", 0, SIM_LOAD_CELL_MOST, ""},
    {"needle", "curvature", 0, BOX_CURVATURE_MOST, " per km"},
    {"needle", "torsion", 0, BOX_TORSION_MOST, " degrees per 100 mm"},
    {"images", "period", 0, BOX_IMAGE_MOST_MS, " ms"},
    {"images", "delay", 0, BOX_IMAGE_MOST_MS, " ms"},
    {"images", "noise", 0, BOX_IMAGE_NOISE_MOST_UM, " um"},
    {"images", "tilt", 0, BOX_IMAGE_TILT_MOST_MDEG, " mdeg"},
    {"push", NULL, -BOX_PUSH_MOST_MM, BOX_PUSH_MOST_MM, " mm"},
};

const box_number_t *box_number_find(const char *order, const char *act, uint32_t count)
{
    const box_number_t *found = NULL;

    for (size_t i = 0U; i < (sizeof numbers / sizeof numbers[0]); i++) {
        const box_number_t *number = &numbers[i];
        const bool is_act = (number->act == NULL)
                                ? (count == 2U)
                                : ((count == 3U) && (strcmp(act, number->act) == 0));
        found = (is_act && (strcmp(order, number->order) == 0)) ? number : found;
    }
    return found;
}

bool box_number_read(const box_number_t *self, const char *word, int64_t *number)
{
    const char *digits = (word[0] == '-') ? &word[1] : word;
    char *end = NULL;

    errno = 0;
    const long long value = strtoll(word, &end, 10);
    const bool is_good = (digits[0] >= '0') && (digits[0] <= '9') && (*end == '\0') &&
                         (errno == 0) && (value >= self->least) && (value <= self->most);
    *number = is_good ? value : *number;
    return is_good;
}

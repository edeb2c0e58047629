/* SPDX-License-Identifier: Apache-2.0 */
#include "fuzz/dialect_message.h"

#include "igtl/dialect/igtl_units.h"
#include "fuzz/sentence.h"

#include <math.h>
#include <string.h>

#define ONE_Q30 1073741824.0
#define NM_PER_MM 1e6
#define NM_MAX 2000000000.5
#define ENTRY_MAX_Q30 INT32_C(1074815565) /* 1 + 1e-3. */

bool message_begins(const char *name, const char *prefix)
{
    return strncmp(name, prefix, strlen(prefix)) == 0;
}

bool message_is_command(const igtl_message_t *message)
{
    return (message->kind == IGTL_KIND_STRING) && message_begins(message->name, "CMD_");
}

uint32_t message_id_prefix(const igtl_message_t *message)
{
    static const char *const prefixes[] = {"CLB_", "TGT_", "NPOS_", "ENTRY_"};

    for (uint32_t i = 0U; i < (sizeof prefixes / sizeof prefixes[0]); i++) {
        if ((message->kind == IGTL_KIND_TRANSFORM) && message_begins(message->name, prefixes[i])) {
            return (uint32_t)strlen(prefixes[i]);
        }
    }
    return 0U;
}

bool message_is_tip(const igtl_message_t *message)
{
    return (message->kind == IGTL_KIND_TRANSFORM) && message_begins(message->name, "NPOS_");
}

bool message_acknowledges(const igtl_message_t *message, const igtl_message_t *said)
{
    if (!message_begins(message->name, "ACK_") || (said == NULL) || (message->kind != said->kind)) {
        return false;
    }
    const uint32_t prefix = message_is_command(said) ? MESSAGE_PREFIX : message_id_prefix(said);

    if ((prefix == 0U) || (strcmp(&message->name[MESSAGE_PREFIX], &said->name[prefix]) != 0)) {
        return false;
    }
    if (message->kind == IGTL_KIND_TRANSFORM) {
        return memcmp(message->numbers, said->numbers, sizeof message->numbers) == 0;
    }
    const uint32_t length = (said->text_bytes < IGTL_TEXT_MAX) ? said->text_bytes : IGTL_TEXT_MAX;

    return (message->text_bytes == length) && (memcmp(message->text, said->text, length) == 0);
}

bool message_is_named(const igtl_message_t *message, const char *name)
{
    return strcmp(message->name, name) == 0;
}

bool message_says(const igtl_message_t *message, const char *text)
{
    return (message->text_bytes == strlen(text)) &&
           (memcmp(message->text, text, message->text_bytes) == 0);
}

static double number_of(uint32_t bits)
{
    float number;

    (void)memcpy(&number, &bits, sizeof number);
    return (double)number;
}

static void judge_number(uint32_t bits, double unit, double most, int32_t taken)
{
    const double meant = number_of(bits) * unit;

    SENTENCE(isfinite(meant) && (fabs(meant) <= most), "a number out of its range is refused");
    SENTENCE(fabs(meant - (double)taken) <= 1.0, "a number is taken as it was meant");
}

void message_judge_pose(const igtl_message_t *said, const rigid_t *pose)
{
    if (said->kind != IGTL_KIND_TRANSFORM) {
        return;
    }
    for (uint32_t i = 0U; i < 9U; i++) {
        judge_number(said->numbers[i], ONE_Q30, ONE_Q30 * 1.0011,
                     pose->rotation_q30[i % 3U][i / 3U]);
    }
    judge_number(said->numbers[9], NM_PER_MM, NM_MAX, pose->translation.x_nm);
    judge_number(said->numbers[10], NM_PER_MM, NM_MAX, pose->translation.y_nm);
    judge_number(said->numbers[11], NM_PER_MM, NM_MAX, pose->translation.z_nm);
}

bool message_is_in_range(const rigid_t *pose)
{
    for (uint32_t i = 0U; i < 9U; i++) {
        const int32_t entry = pose->rotation_q30[i / 3U][i % 3U];

        if ((entry > ENTRY_MAX_Q30) || (entry < -ENTRY_MAX_Q30)) {
            return false;
        }
    }
    return (pose->translation.x_nm <= IGTL_UNITS_MAX_NM) &&
           (pose->translation.x_nm >= -IGTL_UNITS_MAX_NM) &&
           (pose->translation.y_nm <= IGTL_UNITS_MAX_NM) &&
           (pose->translation.y_nm >= -IGTL_UNITS_MAX_NM) &&
           (pose->translation.z_nm <= IGTL_UNITS_MAX_NM) &&
           (pose->translation.z_nm >= -IGTL_UNITS_MAX_NM);
}

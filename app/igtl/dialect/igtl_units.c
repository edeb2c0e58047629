/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/dialect/igtl_units.h"

#include "base/fixed.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#define NM_PER_MM INT64_C(1000000)
#define EXPONENT_BIAS 127
#define FRACTION_BITS 23
#define ENTRY_MAX_Q30 (FIXED_ONE_Q30 + (FIXED_ONE_Q30 / 1000))
#define BAM_PER_RADIAN (4294967296.0 / 6.283185307179586)

/* |number| * unit, rounded half up; |number| < 2^11, unit <= 2^30. */
static int64_t scaled_magnitude(uint32_t bits, int64_t unit)
{
    const int32_t exponent = (int32_t)((bits >> FRACTION_BITS) & 0xFFU);
    const int64_t fraction = (int64_t)(bits & 0x7FFFFFU);
    const int64_t mantissa =
        (exponent == 0) ? fraction : (fraction | (INT64_C(1) << FRACTION_BITS));
    const int32_t shift = EXPONENT_BIAS + FRACTION_BITS - ((exponent == 0) ? 1 : exponent);
    const int64_t product = mantissa * unit;

    if (shift > 60) {
        return 0;
    }
    return (product + (INT64_C(1) << (shift - 1))) >> shift;
}

static status_t read_number(uint32_t bits, int64_t unit, int64_t most, int32_t *value)
{
    const uint32_t exponent = (bits >> FRACTION_BITS) & 0xFFU;
    int64_t magnitude;

    if (exponent == 0xFFU) {
        return STATUS_NOT_FINITE;
    }
    if (exponent > (uint32_t)(EXPONENT_BIAS + 10)) {
        return STATUS_OUT_OF_RANGE;
    }
    magnitude = scaled_magnitude(bits, unit);
    if (magnitude > most) {
        return STATUS_OUT_OF_RANGE;
    }
    *value = (int32_t)(((bits >> 31U) == 0U) ? magnitude : -magnitude);
    return STATUS_OK;
}

status_t igtl_units_read_mm(uint32_t bits, int32_t *length_nm)
{
    return read_number(bits, NM_PER_MM, IGTL_UNITS_MAX_NM, length_nm);
}

status_t igtl_units_read_entry(uint32_t bits, int32_t *entry_q30)
{
    const uint32_t exponent = (bits >> FRACTION_BITS) & 0xFFU;
    status_t status;

    if ((exponent > (uint32_t)EXPONENT_BIAS) && (exponent != 0xFFU)) {
        return STATUS_NOT_RIGID;
    }
    status = read_number(bits, FIXED_ONE_Q30, ENTRY_MAX_Q30, entry_q30);
    return (status == STATUS_OUT_OF_RANGE) ? STATUS_NOT_RIGID : status;
}

status_t igtl_units_read_point(const uint32_t numbers[3], point_t *point)
{
    int32_t *const coordinates[3] = {&point->x_nm, &point->y_nm, &point->z_nm};
    status_t status = STATUS_OK;

    for (uint32_t i = 0U; (i < 3U) && (status == STATUS_OK); i++) {
        status = igtl_units_read_mm(numbers[i], coordinates[i]);
    }
    return status;
}

status_t igtl_units_read_pose(const uint32_t numbers[IGTL_TRANSFORM_NUMBERS], rigid_t *pose)
{
    status_t status = STATUS_OK;

    for (uint32_t i = 0U; (i < 9U) && (status == STATUS_OK); i++) {
        status = igtl_units_read_entry(numbers[i], &pose->rotation_q30[i % 3U][i / 3U]);
    }
    return (status == STATUS_OK) ? igtl_units_read_point(&numbers[9], &pose->translation) : status;
}

/* The parts of a number of IEEE 754: mantissa * 2^-shift. */
typedef struct {
    bool is_finite;
    bool is_negative;
    uint64_t mantissa;
    int32_t shift;
} parts_t;

static parts_t parts_of(uint64_t bits, uint32_t fraction_bits, uint32_t exponent_bits)
{
    const uint64_t most = (UINT64_C(1) << exponent_bits) - 1U;
    const uint64_t exponent = (bits >> fraction_bits) & most;
    const uint64_t one = UINT64_C(1) << fraction_bits;
    const uint64_t fraction = bits & (one - 1U);

    return (parts_t){.is_finite = exponent != most,
                     .is_negative = ((bits >> (fraction_bits + exponent_bits)) & 1U) != 0U,
                     .mantissa = (exponent == 0U) ? fraction : (fraction | one),
                     .shift = (int32_t)(most >> 1U) + (int32_t)fraction_bits -
                              (int32_t)((exponent == 0U) ? 1U : exponent)};
}

/* The mantissa has at most 53 bits. */
static bool is_whole(const parts_t *parts, uint64_t *magnitude)
{
    if (parts->mantissa == 0U) {
        *magnitude = 0U;
    } else if ((parts->shift < -10) || (parts->shift > 53)) {
        return false;
    } else if (parts->shift < 0) {
        *magnitude = parts->mantissa << (uint32_t)-parts->shift;
    } else {
        *magnitude = parts->mantissa >> (uint32_t)parts->shift;
        return (*magnitude << (uint32_t)parts->shift) == parts->mantissa;
    }
    return true;
}

static parts_t parts_at(const igtl_message_t *message, uint32_t index)
{
    const uint64_t bits = igtl_array_bits(message, index);

    return (message->number_bytes == 4U) ? parts_of(bits, 23U, 8U) : parts_of(bits, 52U, 11U);
}

status_t igtl_units_read_double(const igtl_message_t *message, uint32_t index, double *value)
{
    const parts_t parts = parts_at(message, index);

    if (!parts.is_finite) {
        return STATUS_NOT_FINITE;
    }
    *value =
        ldexp(parts.is_negative ? -(double)parts.mantissa : (double)parts.mantissa, -parts.shift);
    return STATUS_OK;
}

status_t igtl_units_read_whole(const igtl_message_t *message, uint32_t index, int32_t *value)
{
    const parts_t parts = parts_at(message, index);
    uint64_t magnitude = 0U;

    if (!parts.is_finite) {
        return STATUS_NOT_FINITE;
    }
    if (!is_whole(&parts, &magnitude) || (magnitude > (uint64_t)INT32_MAX)) {
        return STATUS_OUT_OF_RANGE;
    }
    *value = parts.is_negative ? -(int32_t)magnitude : (int32_t)magnitude;
    return STATUS_OK;
}

static uint32_t float_bits(double number)
{
    const float narrow = (float)number;
    uint32_t bits;

    (void)memcpy(&bits, &narrow, sizeof bits);
    return bits;
}

double igtl_units_newtons(int32_t force_mn)
{
    return (double)force_mn / 1000.0;
}

uint64_t igtl_units_write_newtons(int32_t force_mn)
{
    const double newtons = igtl_units_newtons(force_mn);
    uint64_t bits;

    (void)memcpy(&bits, &newtons, sizeof bits);
    return bits;
}

double igtl_units_mm(int32_t length_nm)
{
    return (double)length_nm / (double)NM_PER_MM;
}

uint32_t igtl_units_write_mm(int32_t length_nm)
{
    return float_bits(igtl_units_mm(length_nm));
}

void igtl_units_write_pose(const rigid_t *pose, uint32_t numbers[IGTL_TRANSFORM_NUMBERS])
{
    for (uint32_t i = 0U; i < 9U; i++) {
        numbers[i] = float_bits((double)pose->rotation_q30[i % 3U][i / 3U] / (double)FIXED_ONE_Q30);
    }
    igtl_units_write_point(&pose->translation, &numbers[9]);
}

void igtl_units_write_point(const point_t *point, uint32_t numbers[3])
{
    numbers[0] = igtl_units_write_mm(point->x_nm);
    numbers[1] = igtl_units_write_mm(point->y_nm);
    numbers[2] = igtl_units_write_mm(point->z_nm);
}

static void write_list(const robot_t *robot, const int32_t counts[ROBOT_AXIS_MAX],
                       double counts_per_tick, char text[IGTL_LIST_SIZE])
{
    size_t used = 0U;

    text[0] = '\0';
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const uint32_t reported = robot->reported_joints[i];
        const axis_config_t *axis = &robot->axes[reported];
        const double unit =
            (axis->unit == (uint8_t)AXIS_UNIT_MM) ? (double)NM_PER_MM : BAM_PER_RADIAN;
        const double value = ((double)counts[reported] / counts_per_tick) *
                             ((double)axis->unit_per_tick_q16 / 65536.0) / unit;
        const int written = snprintf(&text[used], IGTL_LIST_SIZE - used, "%f,", value);

        if ((written < 0) || ((size_t)written >= (IGTL_LIST_SIZE - used))) {
            text[used] = '\0';
            return;
        }
        used += (size_t)written;
    }
}

void igtl_units_write_positions(const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX],
                                char text[IGTL_LIST_SIZE])
{
    write_list(robot, ticks, 1.0, text);
}

void igtl_units_write_speeds(const robot_t *robot,
                             const int32_t speeds_ticks_per_s_q8[ROBOT_AXIS_MAX],
                             char text[IGTL_LIST_SIZE])
{
    write_list(robot, speeds_ticks_per_s_q8, 256.0, text);
}

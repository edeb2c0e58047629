/* SPDX-License-Identifier: Apache-2.0 */
#include "http/view/telemetry_units.h"

#include "common/axis_terms.h"

#include <math.h>

#define NM_PER_MM 1.0e6
#define ONE_Q30 1073741824.0
#define UNIT_TOLERANCE 0.001
#define MM_MOST 2000.0
#define ENTRY_MOST 1.001

/* Rounds to a millionth, so that no digits are sent that mean nothing. */
static double rounded(double value)
{
    return round(value * 1.0e6) / 1.0e6;
}

const char *telemetry_units_name(const axis_config_t *axis)
{
    return axis_terms_unit_name(axis);
}

double telemetry_units_position(const axis_config_t *axis, int32_t ticks)
{
    return rounded((double)ticks * axis_terms_unit(axis));
}

double telemetry_units_speed(const axis_config_t *axis, int32_t speed_ticks_per_s_q8)
{
    return rounded(((double)speed_ticks_per_s_q8 / 256.0) * axis_terms_unit(axis));
}

void telemetry_units_point(const point_t *point, double coordinates[3])
{
    coordinates[0] = (double)point->x_nm / NM_PER_MM;
    coordinates[1] = (double)point->y_nm / NM_PER_MM;
    coordinates[2] = (double)point->z_nm / NM_PER_MM;
}

double telemetry_units_length(int32_t length_nm)
{
    return (double)length_nm / NM_PER_MM;
}

void telemetry_units_matrix(const rigid_t *pose, double matrix[16])
{
    double translation[3];
    telemetry_units_point(&pose->translation, translation);
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++) {
            matrix[(row * 4) + column] =
                round((double)pose->rotation_q30[row][column] / ONE_Q30 * 1.0e9) / 1.0e9;
        }
        matrix[(row * 4) + 3] = translation[row];
    }
    for (int column = 0; column < 4; column++) {
        matrix[12 + column] = (column == 3) ? 1.0 : 0.0;
    }
}

void telemetry_units_read_point(const double coordinates[3], point_t *point)
{
    point->x_nm = (int32_t)round(coordinates[0] * NM_PER_MM);
    point->y_nm = (int32_t)round(coordinates[1] * NM_PER_MM);
    point->z_nm = (int32_t)round(coordinates[2] * NM_PER_MM);
}

static bool is_of_pose(uint32_t place, double number)
{
    const bool is_last_row = place >= 12U;
    const bool is_coordinate = (place % 4U) == 3U;
    if (is_last_row) {
        return is_coordinate ? (number == 1.0) : (number == 0.0);
    }
    return fabs(number) <= (is_coordinate ? MM_MOST : ENTRY_MOST);
}

uint32_t telemetry_units_pose(const double matrix[16], rigid_t *pose)
{
    const double translation[3] = {matrix[3], matrix[7], matrix[11]};
    for (uint32_t i = 0U; i < 16U; i++) {
        if (!is_of_pose(i, matrix[i])) {
            return i;
        }
    }
    for (uint32_t i = 0U; i < 9U; i++) {
        pose->rotation_q30[i / 3U][i % 3U] =
            (int32_t)round(matrix[((i / 3U) * 4U) + (i % 3U)] * ONE_Q30);
    }
    telemetry_units_read_point(translation, &pose->translation);
    return 16U;
}

const char *telemetry_units_pose_range(uint32_t place)
{
    const char *range = "a number from -1 to 1";
    if (place >= 12U) {
        range = "0 0 0 1 as the last row";
    } else if ((place % 4U) == 3U) {
        range = "a number from -2000 to 2000";
    } else {
        /* An entry of the rotation. */
    }
    return range;
}

bool telemetry_units_quaternion(const double point[3], const double quaternion[4], rigid_t *pose)
{
    double square = 0.0;
    for (uint32_t i = 0U; i < 4U; i++) {
        square += quaternion[i] * quaternion[i];
    }
    const double length = sqrt(square);
    if (fabs(length - 1.0) > UNIT_TOLERANCE) {
        return false;
    }
    const double w = quaternion[0] / length;
    const double x = quaternion[1] / length;
    const double y = quaternion[2] / length;
    const double z = quaternion[3] / length;
    const double rotation[3][3] = {
        {1.0 - (2.0 * ((y * y) + (z * z))), 2.0 * ((x * y) - (z * w)), 2.0 * ((x * z) + (y * w))},
        {2.0 * ((x * y) + (z * w)), 1.0 - (2.0 * ((x * x) + (z * z))), 2.0 * ((y * z) - (x * w))},
        {2.0 * ((x * z) - (y * w)), 2.0 * ((y * z) + (x * w)), 1.0 - (2.0 * ((x * x) + (y * y)))}};
    for (uint32_t i = 0U; i < 9U; i++) {
        pose->rotation_q30[i / 3U][i % 3U] = (int32_t)round(rotation[i / 3U][i % 3U] * ONE_Q30);
    }
    telemetry_units_read_point(point, &pose->translation);
    return true;
}

double telemetry_units_distance(const rigid_t *a, const rigid_t *b)
{
    double x = (double)a->translation.x_nm - (double)b->translation.x_nm;
    double y = (double)a->translation.y_nm - (double)b->translation.y_nm;
    double z = (double)a->translation.z_nm - (double)b->translation.z_nm;
    return rounded(sqrt((x * x) + (y * y) + (z * z)) / NM_PER_MM);
}

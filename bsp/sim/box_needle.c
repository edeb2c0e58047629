/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/box_needle.h"

#include "robot/joints.h"
#include "robot/kinematics.h"

#include <string.h>

#define BAM_PER_RAD 683565275.57643158
#define Q16 65536.0
#define Q30 1073741824.0
#define NM_PER_MM 1e6
#define UM_PER_MM 1e3
#define PER_KM 1e6 /* Of what is per mm. */
#define US_PER_MS UINT64_C(1000)

static double units_of(const box_axis_t *axis)
{
    return axis->motor.position_ticks * (double)axis->config->unit_per_tick_q16 / Q16;
}

double box_turn_rad(const box_t *self)
{
    double turn_rad = 0.0;

    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        if (self->axes[i].config->needle_motion == (uint32_t)NEEDLE_ABOUT) {
            turn_rad += units_of(&self->axes[i]) / BAM_PER_RAD;
        }
    }
    return turn_rad;
}

/* To the nearest. */
static int32_t whole(double value)
{
    return (int32_t)((value < 0.0) ? (value - 0.5) : (value + 0.5));
}

void box_needle_line(const box_t *self, rigid_t *zframe_line)
{
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    joints_t joints;

    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        const box_axis_t *const axis = &self->axes[i];
        const bool is_across = (i != self->robot->needle_axis) &&
                               (axis->config->needle_motion != (uint32_t)NEEDLE_ABOUT);
        ticks[i] = is_across ? whole(axis->motor.position_ticks) : 0;
    }
    joints_from_ticks(self->robot, ticks, &joints);
    kinematics_forward(self->robot, &self->robot->probe, &joints, zframe_line);
}

sim_tip_t box_needle_tip(const box_t *self)
{
    return sim_bevel_at(&self->force.bevel, &self->force.phantom.tissue, box_depth_mm(self));
}

sim_vector_t box_needle_target(const box_t *self)
{
    return sim_target_place(&self->force.phantom.target,
                            box_depth_mm(self) - self->force.phantom.tissue.surface_mm);
}

sim_vector_t box_needle_direction(const rigid_t *zframe_line, sim_vector_t direction)
{
    double row[3];

    for (uint32_t i = 0U; i < 3U; i++) {
        const int32_t *const turn = zframe_line->rotation_q30[i];
        row[i] = ((double)turn[0] * direction.x + (double)turn[1] * direction.y +
                  (double)turn[2] * direction.z) /
                 Q30;
    }
    return (sim_vector_t){row[0], row[1], row[2]};
}

sim_vector_t box_needle_place(const rigid_t *zframe_line, sim_vector_t place_mm)
{
    const point_t *const from = &zframe_line->translation;
    const sim_vector_t from_mm = {(double)from->x_nm / NM_PER_MM, (double)from->y_nm / NM_PER_MM,
                                  (double)from->z_nm / NM_PER_MM};

    return sim_space_add(from_mm, 1.0, box_needle_direction(zframe_line, place_mm));
}

void box_image_tip(box_t *self)
{
    const sim_imager_config_t *const config = &self->force.phantom.images;

    if (sim_imager_step(&self->imager, config, self->time_us)) {
        const sim_tip_t tip = box_needle_tip(self);
        rigid_t line;
        box_needle_line(self, &line);
        sim_imager_take(&self->imager, config, self->time_us, box_needle_place(&line, tip.place_mm),
                        box_needle_direction(&line, tip.z));
    }
}

static bsp_bench_point_t point_of(sim_vector_t place_mm)
{
    return (bsp_bench_point_t){whole(place_mm.x * UM_PER_MM), whole(place_mm.y * UM_PER_MM),
                               whole(place_mm.z * UM_PER_MM)};
}

/* An image of the z-frame on the present line. */
static void show_image(const box_t *self, bsp_bench_needle_t *seen)
{
    const sim_image_t *const image = &self->imager.last;
    rigid_t line;
    rigid_t line_zframe;

    seen->image = image->number;
    if (image->number == 0U) {
        return;
    }
    box_needle_line(self, &line);
    rigid_invert(&line, &line_zframe);
    seen->image_age_ms = (uint32_t)((self->time_us - image->taken_us) / US_PER_MS);
    seen->image_place = point_of(box_needle_place(&line_zframe, image->place_mm));
}

void box_needle_show(const box_t *self, bsp_bench_needle_t *seen)
{
    const sim_phantom_file_t *const phantom = &self->force.phantom;
    const double depth_mm = box_depth_mm(self);

    (void)memset(seen, 0, sizeof *seen);
    if (phantom->tissue.layer_count == 0U) {
        return;
    }
    seen->is_seen = 1U;
    seen->surface_um = whole(phantom->tissue.surface_mm * UM_PER_MM);
    seen->turn_mdeg = whole(box_turn_rad(self) / SIM_RAD_PER_DEG * 1e3);
    seen->lag_mdeg = whole(self->force.bevel.lag_rad / SIM_RAD_PER_DEG * 1e3);
    seen->curvature_per_km = whole(phantom->needle.curvature_per_mm * PER_KM);
    seen->torsion_deg = whole(phantom->needle.torsion_deg_per_100_mm);
    seen->images_period_ms = (uint32_t)phantom->images.period_ms;
    seen->images_delay_ms = (uint32_t)phantom->images.delay_ms;
    seen->images_noise_um = whole(phantom->images.noise_mm * UM_PER_MM);
    for (uint32_t i = 0U; i < BSP_BENCH_WAY; i++) {
        const double at_mm = depth_mm * (double)i / (double)(BSP_BENCH_WAY - 1U);
        seen->way[i] = point_of(sim_bevel_at(&self->force.bevel, &phantom->tissue, at_mm).place_mm);
    }
    seen->has_target = sim_target_is_there(&phantom->target) ? 1U : 0U;
    seen->target = point_of(box_needle_target(self));
    show_image(self, seen);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/model/sim_tissue.h"

/* Limits of a force that builds up, and by how much it does in this step if nothing limits it. */
typedef struct {
    double least_n;
    double most_n;
    double rise_n;
} sim_drag_t;

static double clamp(double value, double least, double most)
{
    return (value < least) ? least : (value > most) ? most : value;
}

double sim_tissue_front_mm(const sim_phantom_t *phantom, uint32_t layer)
{
    double front_mm = phantom->surface_mm;

    for (uint32_t i = 0U; i < layer; i++) {
        front_mm += phantom->layers[i].thickness_mm;
    }
    return front_mm;
}

double sim_tissue_rupture_n(const sim_layer_t *layer, double speed_mm_per_s)
{
    const double half = layer->rupture_half_speed_mm_per_s;
    const double speed = (speed_mm_per_s < 0.0) ? -speed_mm_per_s : speed_mm_per_s;
    const double left = half / (half + speed);

    return layer->rupture_n *
           (layer->rupture_fast_share + (1.0 - layer->rupture_fast_share) * left);
}

/* From `layer` on, the first one with a membrane. */
static uint32_t membrane_from(const sim_phantom_t *phantom, uint32_t layer)
{
    uint32_t next = layer;

    while ((next < phantom->layer_count) && (phantom->layers[next].rupture_n <= 0.0)) {
        next++;
    }
    return next;
}

void sim_tissue_init(sim_tissue_t *self, const sim_phantom_t *phantom, double depth_mm)
{
    uint32_t layer = 0U;

    while ((layer < phantom->layer_count) && (sim_tissue_front_mm(phantom, layer) < depth_mm)) {
        layer++;
    }
    *self = (sim_tissue_t){.depth_mm = depth_mm,
                           .front_mm =
                               (depth_mm > phantom->surface_mm) ? depth_mm : phantom->surface_mm,
                           .next = membrane_from(phantom, layer)};
}

/* What is left of a relaxing force, by the implicit rule: no exponential decides about the last
 * bit. */
static double left_share(const sim_layer_t *layer, double step_s)
{
    return layer->relaxing_s / (layer->relaxing_s + step_s);
}

static void rupture(sim_tissue_t *self, const sim_phantom_t *phantom)
{
    self->popped_at_mm[self->popped] = self->depth_mm;
    self->popped++;
    self->recoil_mm = self->indentation_mm;
    self->next = membrane_from(phantom, self->next + 1U);
    self->indentation_mm = 0.0;
    self->elastic_n = 0.0;
    self->branch_n = 0.0;
    self->membrane_n = 0.0;
}

static void press_membrane(sim_tissue_t *self, const sim_phantom_t *phantom, double step_s,
                           double speed_mm_per_s)
{
    if (self->next >= phantom->layer_count) {
        return;
    }
    const sim_layer_t *const layer = &phantom->layers[self->next];
    const double beyond_mm = self->depth_mm - sim_tissue_front_mm(phantom, self->next);
    const double d = (beyond_mm > 0.0) ? beyond_mm : 0.0;
    const double elastic_n = (layer->stiffness_n_per_mm + layer->stiffening_n_per_mm2 * d) * d;
    const double gain = layer->relaxing_share / (1.0 - layer->relaxing_share);

    self->branch_n =
        (self->branch_n + gain * (elastic_n - self->elastic_n)) * left_share(layer, step_s);
    self->elastic_n = elastic_n;
    self->indentation_mm = d;
    const double force_n = elastic_n + self->branch_n;
    self->membrane_n = ((d > 0.0) && (force_n > 0.0)) ? force_n : 0.0;
    if ((speed_mm_per_s > 0.0) &&
        (self->membrane_n >= sim_tissue_rupture_n(layer, speed_mm_per_s))) {
        rupture(self, phantom);
    }
}

/* Depth of the tip in the tissue as it is at rest, where a membrane has not moved. */
static double tip_mm(const sim_tissue_t *self, const sim_phantom_t *phantom)
{
    return (self->indentation_mm > 0.0) ? sim_tissue_front_mm(phantom, self->next) : self->depth_mm;
}

/* The layer that holds the tip, the last one beyond it; NULL before the surface. */
static const sim_layer_t *layer_at(const sim_phantom_t *phantom, double tip)
{
    const sim_layer_t *found = 0;
    double front_mm = phantom->surface_mm;

    for (uint32_t i = 0U; (i < phantom->layer_count) && (tip > front_mm); i++) {
        found = &phantom->layers[i];
        front_mm += found->thickness_mm;
    }
    return found;
}

static double build_up(sim_bristle_t *self, const sim_layer_t *layer, const sim_drag_t *drag,
                       double step_s)
{
    const double share = layer->relaxing_share;
    const double rest = 1.0 - share;

    self->held_n =
        clamp(self->held_n + rest * drag->rise_n, rest * drag->least_n, rest * drag->most_n);
    self->relaxing_n = clamp(self->relaxing_n * left_share(layer, step_s) + share * drag->rise_n,
                             share * drag->least_n, share * drag->most_n);
    return self->held_n + self->relaxing_n;
}

/* All of the shaft's friction, at this speed. */
static sim_drag_t drag_of(const sim_phantom_t *phantom, double tip, double way_mm,
                          double speed_mm_per_s)
{
    const double speed = (speed_mm_per_s < 0.0) ? -speed_mm_per_s : speed_mm_per_s;
    const bool slides = speed >= phantom->stick_mm_per_s;
    sim_drag_t drag = {0.0, 0.0, 0.0};
    double front_mm = phantom->surface_mm;

    for (uint32_t i = 0U; i < phantom->layer_count; i++) {
        const sim_layer_t *const layer = &phantom->layers[i];
        const double in_mm = clamp(tip - front_mm, 0.0, layer->thickness_mm);
        const double in =
            (slides && (speed_mm_per_s > 0.0))
                ? (layer->friction_in_n_per_mm + layer->viscous_in_n_s_per_mm2 * speed)
                : layer->stick_in_n_per_mm;
        const double out =
            (slides && (speed_mm_per_s < 0.0))
                ? (layer->friction_out_n_per_mm + layer->viscous_out_n_s_per_mm2 * speed)
                : layer->stick_out_n_per_mm;
        drag.most_n += in * in_mm;
        drag.least_n -= out * in_mm;
        drag.rise_n += layer->stick_in_n_per_mm * in_mm * way_mm / phantom->presliding_mm;
        front_mm += layer->thickness_mm;
    }
    return drag;
}

/* The tip cuts nothing in its own hole, nor beyond the last layer. */
static sim_drag_t cut_of(const sim_tissue_t *self, const sim_phantom_t *phantom,
                         const sim_layer_t *layer, double tip, double way_mm)
{
    const double end_mm = sim_tissue_front_mm(phantom, phantom->layer_count);
    const bool is_free = (tip < self->front_mm) || (tip > end_mm);

    return (sim_drag_t){0.0, is_free ? 0.0 : layer->cutting_n,
                        layer->cutting_n * way_mm / phantom->presliding_mm};
}

void sim_tissue_step(sim_tissue_t *self, const sim_phantom_t *phantom, double step_s,
                     double depth_mm, double speed_mm_per_s)
{
    const double way_mm = depth_mm - self->depth_mm;

    self->depth_mm = depth_mm;
    if (phantom->layer_count == 0U) {
        self->front_mm = (depth_mm > self->front_mm) ? depth_mm : self->front_mm;
        return;
    }
    press_membrane(self, phantom, step_s, speed_mm_per_s);
    const double tip = tip_mm(self, phantom);
    const sim_layer_t *const layer = layer_at(phantom, tip);
    if (layer != 0) {
        const sim_drag_t cut = cut_of(self, phantom, layer, tip, way_mm);
        const sim_drag_t drag = drag_of(phantom, tip, way_mm, speed_mm_per_s);
        self->cutting_n = build_up(&self->cutting, layer, &cut, step_s);
        self->friction_n = build_up(&self->friction, layer, &drag, step_s);
    } else {
        self->cutting = (sim_bristle_t){0.0, 0.0};
        self->friction = (sim_bristle_t){0.0, 0.0};
        self->cutting_n = 0.0;
        self->friction_n = 0.0;
    }
    self->front_mm = (tip > self->front_mm) ? tip : self->front_mm;
    self->force_n = self->membrane_n + self->cutting_n + self->friction_n;
}

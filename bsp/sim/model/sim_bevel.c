/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/model/sim_bevel.h"

static double clamp(double value, double least, double most)
{
    return (value < least) ? least : (value > most) ? most : value;
}

/* A straight needle. */
static sim_tip_t straight_at(double depth_mm)
{
    return (sim_tip_t){
        .place_mm = {0.0, 0.0, depth_mm}, .x = {1.0, 0.0, 0.0}, .z = {0.0, 0.0, 1.0}};
}

/* Length of the needle in the tissue, from its surface to its end. */
static double inside_mm(const sim_phantom_t *phantom, double depth_mm)
{
    const double end_mm = sim_tissue_front_mm(phantom, phantom->layer_count);

    return clamp(depth_mm, phantom->surface_mm, end_mm) - phantom->surface_mm;
}

/* Coulomb friction: the tip stands while the base is within the torsion of it. */
static void turn(sim_bevel_t *self, double torsion_rad, double base_rad)
{
    self->tip_rad = clamp(self->tip_rad, base_rad - torsion_rad, base_rad + torsion_rad);
    self->lag_rad = base_rad - self->tip_rad;
}

/* Where the bevel bends a tip to: -y of it. */
static sim_vector_t bent_to(const sim_tip_t *tip, double rad)
{
    const sim_vector_t none = {0.0, 0.0, 0.0};
    const sim_vector_t y = sim_space_cross(tip->z, tip->x);

    return sim_space_add(sim_space_add(none, sim_space_sine(rad), tip->x), -sim_space_cosine(rad),
                         y);
}

/* Along an arc of a = kappa times its length. With t = tan(a / 2) its turn is one without a root;
 * the error of t and of the chord is a^5. */
static void bend(sim_tip_t *tip, double curvature_per_mm, double rad, double way_mm)
{
    const double a = curvature_per_mm * way_mm;
    const double t = 0.5 * a + a * a * a / 24.0;
    const double cosine = (1.0 - t * t) / (1.0 + t * t);
    const double sine = 2.0 * t / (1.0 + t * t);
    const sim_vector_t to = bent_to(tip, rad);
    const sim_vector_t z = sim_space_add(tip->z, cosine - 1.0, tip->z);
    const sim_vector_t bent = sim_space_unit(sim_space_add(z, sine, to));
    const sim_vector_t middle = sim_space_add(tip->z, 1.0, bent);
    /* `to` turns about the same axis as z. */
    const double part = sim_space_dot(tip->x, to);
    const sim_vector_t lifted = sim_space_add(tip->x, part * (cosine - 1.0), to);
    const sim_vector_t x = sim_space_add(lifted, -part * sine, tip->z);

    tip->place_mm = sim_space_add(tip->place_mm, 0.5 * way_mm * (1.0 + a * a / 12.0), middle);
    tip->z = bent;
    tip->x = sim_space_unit(sim_space_add(x, -sim_space_dot(x, bent), bent));
}

/* The way begins at the surface. */
static void begin(sim_bevel_t *self, double surface_mm)
{
    self->cut_mm = 0.0;
    self->end = straight_at(surface_mm);
    self->way[0] = self->end;
    self->nodes = 1U;
}

/* Cuts on until the way is `to_mm` long, node by node, with the bevel at `rad`. */
static void cut(sim_bevel_t *self, double curvature_per_mm, double rad, double to_mm)
{
    while (self->cut_mm < to_mm) {
        const double node_mm = SIM_BEVEL_NODE_MM * (double)self->nodes;
        const bool has_room = self->nodes < SIM_BEVEL_NODES;
        const bool is_node = has_room && (to_mm >= node_mm);
        const double next_mm = is_node ? node_mm : to_mm;
        bend(&self->end, has_room ? curvature_per_mm : 0.0, rad, next_mm - self->cut_mm);
        self->cut_mm = next_mm;
        if (is_node) {
            self->way[self->nodes] = self->end;
            self->nodes++;
        }
    }
}

/* In the tissue up to its end, and straight beyond. */
static void advance(sim_bevel_t *self, double curvature_per_mm, const sim_phantom_t *phantom,
                    double depth_mm, double rad)
{
    const double in_mm = depth_mm - phantom->surface_mm;

    if ((in_mm <= 0.0) || (phantom->layer_count == 0U)) {
        begin(self, phantom->surface_mm);
    } else if (in_mm > self->cut_mm) {
        cut(self, curvature_per_mm, rad, inside_mm(phantom, depth_mm));
        cut(self, 0.0, rad, in_mm);
    } else {
        /* It is in its own way. */
    }
}

void sim_bevel_init(sim_bevel_t *self, const sim_phantom_t *phantom, double depth_mm,
                    double base_rad)
{
    static const sim_bevel_config_t straight = {0.0, 0.0};

    begin(self, phantom->surface_mm);
    sim_bevel_step(self, &straight, phantom, depth_mm, base_rad);
}

void sim_bevel_step(sim_bevel_t *self, const sim_bevel_config_t *config,
                    const sim_phantom_t *phantom, double depth_mm, double base_rad)
{
    const double torsion_rad =
        config->torsion_deg_per_100_mm * SIM_RAD_PER_DEG / 100.0 * inside_mm(phantom, depth_mm);
    const double before_rad = self->tip_rad;

    turn(self, torsion_rad, base_rad);
    /* Evenly, from one angle to the other. */
    advance(self, config->curvature_per_mm, phantom, depth_mm, 0.5 * (before_rad + self->tip_rad));
    self->depth_mm = depth_mm;
}

/* Between two nodes, by Hermite's cubic: both are on it with their directions. */
static sim_tip_t between(const sim_tip_t *a, const sim_tip_t *b, double way_mm, double share)
{
    const double s = share;
    const double rest = 1.0 - s;
    const sim_vector_t none = {0.0, 0.0, 0.0};
    sim_tip_t tip = *a;

    tip.place_mm = sim_space_add(none, (1.0 + 2.0 * s) * rest * rest, a->place_mm);
    tip.place_mm = sim_space_add(tip.place_mm, s * s * (3.0 - 2.0 * s), b->place_mm);
    tip.place_mm = sim_space_add(tip.place_mm, way_mm * s * rest * rest, a->z);
    tip.place_mm = sim_space_add(tip.place_mm, -way_mm * s * s * rest, b->z);
    tip.z = sim_space_unit(sim_space_add(sim_space_add(none, rest, a->z), s, b->z));
    const sim_vector_t x = sim_space_add(sim_space_add(none, rest, a->x), s, b->x);
    tip.x = sim_space_unit(sim_space_add(x, -sim_space_dot(x, tip.z), tip.z));
    return tip;
}

/* `in_mm` above 0, and less than what was cut. */
static sim_tip_t on_way(const sim_bevel_t *self, double in_mm)
{
    const uint32_t last = self->nodes - 1U;
    const double nodes = in_mm / SIM_BEVEL_NODE_MM;
    const uint32_t node = (nodes < (double)last) ? (uint32_t)nodes : last;
    const double from_mm = SIM_BEVEL_NODE_MM * (double)node;
    const double way_mm = (node < last) ? SIM_BEVEL_NODE_MM : (self->cut_mm - from_mm);
    const sim_tip_t *const next = (node < last) ? &self->way[node + 1U] : &self->end;

    return between(&self->way[node], next, way_mm, (in_mm - from_mm) / way_mm);
}

sim_tip_t sim_bevel_at(const sim_bevel_t *self, const sim_phantom_t *phantom, double depth_mm)
{
    const double in_mm = depth_mm - phantom->surface_mm;

    if ((in_mm <= 0.0) || (phantom->layer_count == 0U)) {
        return straight_at(depth_mm);
    }
    return (in_mm >= self->cut_mm) ? self->end : on_way(self, in_mm);
}

void sim_bevel_heal(sim_bevel_t *self, const sim_phantom_t *phantom)
{
    const double in_mm = self->depth_mm - phantom->surface_mm;

    if ((in_mm > 0.0) && (in_mm < self->cut_mm)) {
        const uint32_t nodes = 1U + (uint32_t)(in_mm / SIM_BEVEL_NODE_MM);
        self->end = sim_bevel_at(self, phantom, self->depth_mm);
        self->cut_mm = in_mm;
        self->nodes = (nodes < self->nodes) ? nodes : self->nodes;
    }
}

sim_vector_t sim_bevel_towards(const sim_bevel_t *self, const sim_tip_t *tip)
{
    return bent_to(tip, self->tip_rad);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/orders/box_needle_orders.h"

#include "sim/box_needle.h"

#include <stddef.h>

#define CURVATURE_PARTS 1e6
#define PER_THOUSAND 1000.0
#define MS_PER_S 1000.0
#define US_PER_S 1e6

/* What such an order sets, and how many of its parts are one there; NULL: there is none. */
static double *set_by(sim_phantom_file_t *phantom, const box_words_t *order, double *parts)
{
    const bool is_needle = box_words_is(order, 0U, "needle");
    const struct {
        bool is_of_needle;
        const char *word;
        double *number;
        double parts;
    } numbers[] = {{true, "curvature", &phantom->needle.curvature_per_mm, CURVATURE_PARTS},
                   {true, "torsion", &phantom->needle.torsion_deg_per_100_mm, 1.0},
                   {false, "period", &phantom->images.period_ms, 1.0},
                   {false, "delay", &phantom->images.delay_ms, 1.0},
                   {false, "noise", &phantom->images.noise_mm, PER_THOUSAND},
                   {false, "tilt", &phantom->images.noise_deg, PER_THOUSAND}};

    for (size_t i = 0U; i < sizeof numbers / sizeof numbers[0]; i++) {
        if ((numbers[i].is_of_needle == is_needle) && box_words_is(order, 1U, numbers[i].word)) {
            *parts = numbers[i].parts;
            return numbers[i].number;
        }
    }
    return NULL;
}

static bool order_number(box_t *self, const box_words_t *order)
{
    double parts = 1.0;
    double *const number = set_by(&self->force.phantom, order, &parts);
    int64_t value = 0;

    if ((number == NULL) || !box_words_take_number(order, &value)) {
        return false;
    }
    *number = (double)value / parts;
    return true;
}

static bool order_target(box_t *self, const box_words_t *order)
{
    static const sim_target_t none = {.depth_mm = 0.0};
    const bool is_usual = box_words_is(order, 1U, "usual");

    if ((order->count != 2U) || (!is_usual && !box_words_is(order, 1U, "none"))) {
        return false;
    }
    self->force.phantom.target = is_usual ? sim_target_usual : none;
    return true;
}

bool box_needle_order(box_t *self, const box_words_t *order)
{
    return box_words_is(order, 0U, "target") ? order_target(self, order)
                                             : order_number(self, order);
}

static void say_place(box_reply_t *reply, const char *name, const rigid_t *line,
                      sim_vector_t place_mm)
{
    const sim_vector_t zframe_mm = box_needle_place(line, place_mm);

    box_reply_say(reply, "%s: %.4f %.4f mm off the line at %.4f mm, z-frame %.4f %.4f %.4f mm",
                  name, place_mm.x, place_mm.y, place_mm.z, zframe_mm.x, zframe_mm.y, zframe_mm.z);
}

static void say_direction(box_reply_t *reply, sim_vector_t direction)
{
    box_reply_say(reply, ", direction %.6f %.6f %.6f", direction.x, direction.y, direction.z);
}

static void say_image(box_reply_t *reply, const box_t *self)
{
    const sim_image_t *const image = &self->imager.last;

    if (image->number == 0U) {
        box_reply_say(reply, "image: none\n");
        return;
    }
    box_reply_say(reply, "image %u: taken at %.3f s, %.3f s old, z-frame %.4f %.4f %.4f mm",
                  (unsigned)image->number, (double)image->taken_us / US_PER_S,
                  (double)(self->time_us - image->taken_us) / US_PER_S, image->place_mm.x,
                  image->place_mm.y, image->place_mm.z);
    say_direction(reply, image->direction);
    box_reply_say(reply, "\n");
}

void box_needle_reply(box_reply_t *reply, const box_t *self)
{
    const sim_phantom_file_t *const phantom = &self->force.phantom;
    const sim_tip_t tip = box_needle_tip(self);
    const double turn_rad = box_turn_rad(self);
    rigid_t line;

    box_needle_line(self, &line);
    say_place(reply, "tip", &line, tip.place_mm);
    say_direction(reply, box_needle_direction(&line, tip.z));
    box_reply_say(reply, "\nbase turned by %.3f deg, %.3f deg ahead of the tip\n",
                  turn_rad / SIM_RAD_PER_DEG, self->force.bevel.lag_rad / SIM_RAD_PER_DEG);
    if (sim_target_is_there(&phantom->target)) {
        say_place(reply, "target", &line, box_needle_target(self));
        box_reply_say(reply, "\n");
    } else {
        box_reply_say(reply, "target: none\n");
    }
    say_image(reply, self);
    box_reply_say(reply,
                  "curvature %.6f per mm, torsion %.1f deg per 100 mm; images each %.3f s, %.3f s "
                  "late, noise %.3f mm, %.3f deg\n",
                  phantom->needle.curvature_per_mm, phantom->needle.torsion_deg_per_100_mm,
                  phantom->images.period_ms / MS_PER_S, phantom->images.delay_ms / MS_PER_S,
                  phantom->images.noise_mm, phantom->images.noise_deg);
}

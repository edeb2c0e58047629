/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/model/sim_target.h"

static double shifted_share(const sim_target_t *self, double in_mm)
{
    if (in_mm >= self->shift_to_mm) {
        return 1.0;
    }
    return (in_mm > self->shift_from_mm)
               ? ((in_mm - self->shift_from_mm) / (self->shift_to_mm - self->shift_from_mm))
               : 0.0;
}

sim_vector_t sim_target_place(const sim_target_t *self, double in_mm)
{
    const sim_vector_t rest = {self->x_mm, self->y_mm, self->depth_mm};
    const double share = (in_mm > 0.0) ? shifted_share(self, in_mm) : 0.0;
    const double pushed_mm = (in_mm > 0.0) ? (self->push_share * in_mm) : 0.0;
    const double push_mm = (pushed_mm > self->push_most_mm) ? self->push_most_mm : pushed_mm;
    const sim_vector_t by = {share * self->shift_x_mm, share * self->shift_y_mm, push_mm};

    return sim_space_add(rest, 1.0, by);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "sensor/membrane_list.h"

#include "base/fixed.h"

#define SAME_PLACE_UM 100 /* A drive that stands is moved on by less. */

static bool are_in_order(const int32_t depths_um[], uint32_t count)
{
    int32_t least_um = 0;
    for (uint32_t i = 0U; i < count; i++) {
        if ((depths_um[i] < least_um) || (depths_um[i] > (int32_t)LIMIT_MEMBRANE_DEEPEST_UM)) {
            return false;
        }
        least_um = depths_um[i] + 1;
    }
    return true;
}

status_t membrane_list_set(membrane_list_t *self, const int32_t depths_um[], uint32_t count)
{
    if ((count > LIMIT_MEMBRANES_MOST) || !are_in_order(depths_um, count)) {
        return STATUS_OUT_OF_RANGE;
    }
    for (uint32_t i = 0U; i < count; i++) {
        self->membranes[i].depth_um = depths_um[i];
    }
    self->count = count;
    membrane_list_renew(self);
    return STATUS_OK;
}

void membrane_list_renew(membrane_list_t *self)
{
    self->unexpected = 0U;
    self->unseen_um = 0;
    self->seen_um = 0;
    for (uint32_t i = 0U; i < self->count; i++) {
        self->membranes[i].found_um = 0;
        self->membranes[i].state = (uint32_t)MEMBRANE_AHEAD;
    }
}

static bool is_ahead(const membrane_t *membrane)
{
    return membrane->state == (uint32_t)MEMBRANE_AHEAD;
}

uint32_t membrane_list_take(membrane_list_t *self, int32_t depth_um)
{
    uint32_t nearest = MEMBRANE_NONE;
    int64_t least_um = (int64_t)LIMIT_MEMBRANE_WINDOW_UM + 1;
    for (uint32_t i = 0U; i < self->count; i++) {
        const membrane_t *const membrane = &self->membranes[i];
        const int64_t away_um = fixed_magnitude((int64_t)depth_um - (int64_t)membrane->depth_um);
        if (is_ahead(membrane) && (away_um < least_um)) {
            nearest = i;
            least_um = away_um;
        }
    }
    if (nearest == MEMBRANE_NONE) {
        self->unexpected++;
    } else {
        self->membranes[nearest].found_um = depth_um;
        self->membranes[nearest].state = (uint32_t)MEMBRANE_FOUND;
    }
    return nearest;
}

/* The first one that is ahead and less deep than `behind_um`. */
static uint32_t miss(membrane_list_t *self, int64_t behind_um)
{
    for (uint32_t i = 0U; i < self->count; i++) {
        membrane_t *const membrane = &self->membranes[i];
        if (is_ahead(membrane) && ((int64_t)membrane->depth_um < behind_um)) {
            membrane->state = (membrane->depth_um < self->unseen_um) ? (uint32_t)MEMBRANE_PASSED
                                                                     : (uint32_t)MEMBRANE_MISSED;
            return i;
        }
    }
    return MEMBRANE_NONE;
}

void membrane_list_look(membrane_list_t *self, int32_t depth_um)
{
    self->seen_um = (depth_um > self->seen_um) ? depth_um : self->seen_um;
}

void membrane_list_blind(membrane_list_t *self, int32_t depth_um)
{
    const bool is_deeper = ((int64_t)depth_um - (int64_t)SAME_PLACE_UM) > (int64_t)self->seen_um;
    if (is_deeper && (depth_um > self->unseen_um)) {
        self->unseen_um = depth_um;
    }
}

uint32_t membrane_list_pass(membrane_list_t *self, int32_t depth_um)
{
    return miss(self, (int64_t)depth_um - (int64_t)LIMIT_MEMBRANE_WINDOW_UM);
}

uint32_t membrane_list_end(membrane_list_t *self)
{
    return miss(self, INT64_MAX);
}

uint32_t membrane_list_left(const membrane_list_t *self)
{
    uint32_t left = 0U;
    for (uint32_t i = 0U; i < self->count; i++) {
        left += is_ahead(&self->membranes[i]) ? 1U : 0U;
    }
    return left;
}

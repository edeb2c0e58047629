/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/orders/box_force_orders.h"

#include "sim/orders/box_needle_orders.h"
#include "sim/orders/box_reply.h"

#include <stddef.h>

#define PER_THOUSAND 1000.0 /* Orders have mN and um, the model N and mm. */

/* As a spring, from another wish on. */
static void wish(box_t *self, const box_words_t *order, double number)
{
    const double depth_mm = box_depth_mm(self);

    self->holds[BOX_HELD_HAND].holder = 0U;
    if (box_words_is(order, 1U, "speed")) {
        sim_hand_wish(&self->force.hand, depth_mm, 0.0, number);
    } else {
        sim_hand_wish(&self->force.hand, depth_mm, number, 0.0);
    }
}

static bool order_hand(box_t *self, const box_words_t *order)
{
    const bool is_spring = box_words_is(order, 1U, "speed") || box_words_is(order, 1U, "go");
    const bool is_stiffness = box_words_is(order, 1U, "stiffness");
    int64_t number = 0;

    if ((!is_spring && !is_stiffness) || !box_words_take_number(order, &number)) {
        return false;
    }
    if (is_stiffness) {
        self->force.hand.stiffness_n_per_mm = (double)number / PER_THOUSAND;
    } else {
        wish(self, order, (double)number / PER_THOUSAND);
    }
    return true;
}

/* A hand that presses does so with the new force at once. */
static bool order_grip(box_t *self, const box_words_t *order)
{
    box_force_t *const force = &self->force;
    int64_t number = 0;

    if (!box_words_take_number(order, &number)) {
        return false;
    }
    force->grip_mn = (int32_t)number;
    if (force->hand.act == SIM_HAND_PRESS) {
        sim_hand_press(&force->hand, (double)number / PER_THOUSAND);
    }
    return true;
}

/* A fault of a load cell, or its reading. */
static bool order_force(box_t *self, const box_words_t *order)
{
    const int which = box_words_find(sim_cell_words, order->words[1]);
    const int fault = box_words_find(box_load_cell_words, order->words[2]);
    int64_t reading = 0;

    if ((which < 0) || (order->count != BOX_WORD_COUNT)) {
        return false;
    }
    sim_load_cell_t *const cell = &self->force.cells[which];
    if (fault >= 0) {
        cell->fault = (sim_load_cell_fault_t)fault;
        return true;
    }
    if (!box_words_take_number(order, &reading)) {
        return false;
    }
    sim_load_cell_set(cell, (uint32_t)reading);
    box_read_cells(self);
    return true;
}

static bool order_tissue(box_t *self, const box_words_t *order)
{
    static const sim_phantom_file_t none = {.tissue = {.layer_count = 0U}};

    if (order->count != 2U) {
        return false;
    }
    if (box_words_is(order, 1U, "whole")) {
        box_force_heal(&self->force);
        return true;
    }
    const bool is_none = box_words_is(order, 1U, "none");
    if (is_none || box_words_is(order, 1U, "usual")) {
        box_force_lay(&self->force, is_none ? &none : &sim_phantom_usual);
        box_read_cells(self);
        return true;
    }
    return false;
}

/* First words of orders, and what carries them out. */
static const struct {
    const char *word;
    bool (*order)(box_t *self, const box_words_t *order);
} acts[] = {{"hand", order_hand},        {"grip", order_grip},         {"force", order_force},
            {"tissue", order_tissue},    {"needle", box_needle_order}, {"images", box_needle_order},
            {"target", box_needle_order}};

#define ACTS (sizeof acts / sizeof acts[0])

static size_t act_of(const box_words_t *order)
{
    size_t act = 0U;

    while ((act < ACTS) && !box_words_is(order, 0U, acts[act].word)) {
        act++;
    }
    return act;
}

bool box_force_order_is(const box_words_t *order)
{
    return act_of(order) < ACTS;
}

bool box_force_order(box_t *self, const box_words_t *order)
{
    return acts[act_of(order)].order(self, order);
}

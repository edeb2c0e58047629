/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/scenario/watcher.h"

#include "supervise/scenario/prng.h"

#define WAIT_CYCLES 700U
#define BURST_PARTS 4U /* One of so many proposals comes right after the one before. */
#define LINE_MM 100U   /* Before and behind the target. */
#define ONE_MM_NM 1000000

static int32_t some_nm(watcher_t *self)
{
    return ((int32_t)prng_below(&self->random, 2U * LINE_MM) - (int32_t)LINE_MM) * ONE_MM_NM;
}

/* A place on the needle's line through the target, or anywhere. */
static point_t some_point(watcher_t *self, const snapshot_t *shown)
{
    point_t point = {some_nm(self), some_nm(self), some_nm(self)};
    if ((shown->has_target != 0U) && (prng_below(&self->random, 4U) != 0U)) {
        const point_t along = {0, 0, some_nm(self)};
        point = rigid_apply(&shown->scanner_target, &along);
    }
    return point;
}

static command_kind_t some_kind(watcher_t *self)
{
    static const command_kind_t kinds[] = {COMMAND_PROPOSE_ENTRY, COMMAND_PROPOSE_ENTRY,
                                           COMMAND_PROPOSE_TARGET, COMMAND_PROPOSE_REGISTRATION};
    return kinds[prng_below(&self->random, (uint32_t)(sizeof kinds / sizeof kinds[0]))];
}

void watcher_begin(watcher_t *self, uint32_t seed)
{
    *self = (watcher_t){.random = (seed * 2246822519U) | 1U};
    self->wait_cycles = prng_below(&self->random, WAIT_CYCLES);
}

bool watcher_play(watcher_t *self, const rig_t *rig, command_t *command)
{
    if (self->wait_cycles > 0U) {
        self->wait_cycles--;
        return false;
    }
    const bool is_burst = prng_below(&self->random, BURST_PARTS) == 0U;
    self->wait_cycles = is_burst ? 0U : (1U + prng_below(&self->random, WAIT_CYCLES));
    const command_kind_t kind = some_kind(self);
    *command =
        (command_t){.kind = (uint32_t)kind, .as.seen_pose = {.is_one_of_many = is_burst ? 1U : 0U}};
    rigid_set_identity(&command->as.seen_pose.pose);
    command->as.seen_pose.pose.translation = some_point(self, &rig->outputs.snapshot);
    if (prng_below(&self->random, 8U) == 0U) {
        *command = (command_t){.kind = (uint32_t)COMMAND_WITHDRAW,
                               .as.withdrawal = {.of = (uint32_t)kind}};
    }
    return true;
}

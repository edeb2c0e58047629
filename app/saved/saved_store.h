/* SPDX-License-Identifier: Apache-2.0 */
/** @file Saved positions that were shown to a client, and may be restored for a while. Any number
 * of threads may be here. */
#ifndef BORESIGHT_SAVED_STORE_H
#define BORESIGHT_SAVED_STORE_H

#include "saved/saved_plan.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

/** A shown plan. */
typedef struct {
    uint32_t token; /**< Not 0. */
    uint64_t shown_ms;
    saved_t saved;
    saved_plan_t plan;
} saved_view_t;

typedef struct {
    pthread_mutex_t lock;
    saved_view_t view; /**< The last one. */
} saved_store_t;

/** Starts with nothing shown. */
void saved_store_init(saved_store_t *self);

/** Keeps `view` in place of what was shown before, and gives it a token of its own. */
void saved_store_show(saved_store_t *self, saved_view_t *view);

/** Copies the view of `token`. False: something else was shown since, or nothing yet. */
bool saved_store_find(saved_store_t *self, uint32_t token, saved_view_t *view);

/** `view` was shown no longer than LIMIT_PREVIEW_S ago.
 *
 * @satisfies SWR-STORE-030
 */
bool saved_view_is_fresh(const saved_view_t *view, uint64_t now_ms);

#endif

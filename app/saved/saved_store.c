/* SPDX-License-Identifier: Apache-2.0 */
#include "saved/saved_store.h"

#include "limits/requirement_limits.h"

#include <string.h>
#include <sys/random.h>

#define MS_PER_S UINT64_C(1000)

void saved_store_init(saved_store_t *self)
{
    (void)memset(self, 0, sizeof *self);
    (void)pthread_mutex_init(&self->lock, NULL);
    /* Those of an earlier server shall mean nothing. */
    (void)!getrandom(&self->view.token, sizeof self->view.token, 0U);
}

void saved_store_show(saved_store_t *self, saved_view_t *view)
{
    (void)pthread_mutex_lock(&self->lock);
    const uint32_t next = self->view.token + 1U;
    view->token = (next != 0U) ? next : 1U;
    self->view = *view;
    (void)pthread_mutex_unlock(&self->lock);
}

bool saved_store_find(saved_store_t *self, uint32_t token, saved_view_t *view)
{
    (void)pthread_mutex_lock(&self->lock);
    *view = self->view;
    (void)pthread_mutex_unlock(&self->lock);
    return (view->token == token) && (view->plan.axis_count > 0U);
}

bool saved_view_is_fresh(const saved_view_t *view, uint64_t now_ms)
{
    return (now_ms - view->shown_ms) <= ((uint64_t)LIMIT_PREVIEW_S * MS_PER_S);
}

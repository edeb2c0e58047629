/* SPDX-License-Identifier: Apache-2.0 */
#include "http/pages/page_table.h"

#include <stdio.h>
#include <string.h>

page_t *page_table_find(page_table_t *self, uint32_t number)
{
    for (uint32_t i = 0U; i < PAGE_TABLE_PAGES; i++) {
        if (self->pages[i].number == number) {
            return &self->pages[i];
        }
    }
    return NULL;
}

static bool is_of(const page_t *page, const session_t *session)
{
    return strcmp(page->session, session->id) == 0;
}

/* The session's own oldest one when it has enough, or else a free place. */
page_t *page_table_place(page_table_t *self, const session_t *session, uint32_t kept)
{
    uint32_t count = 0U;
    page_t *oldest = NULL;
    for (uint32_t i = 0U; i < PAGE_TABLE_PAGES; i++) {
        page_t *page = &self->pages[i];
        const bool is_own = (page->number != 0U) && is_of(page, session);
        count += is_own ? 1U : 0U;
        if (is_own && (page->number != kept) &&
            ((oldest == NULL) || ((self->turn - page->turn) > (self->turn - oldest->turn)))) {
            oldest = page;
        }
    }
    return (count >= LIMIT_SESSION_PAGES) ? oldest : page_table_find(self, 0U);
}

page_t *page_table_greet(page_table_t *self, uint32_t number, const session_t *session,
                         uint32_t kept)
{
    page_t *page = page_table_find(self, number);
    if (page == NULL) {
        page = page_table_place(self, session, kept);
        if (page == NULL) {
            return NULL;
        }
        (void)memset(page, 0, sizeof *page);
        page->number = number;
        (void)snprintf(page->session, sizeof page->session, "%s", session->id);
        (void)snprintf(page->name, sizeof page->name, "%s", session->account.name);
    }
    self->turn++;
    page->turn = is_of(page, session) ? self->turn : page->turn;
    return is_of(page, session) ? page : NULL;
}

page_act_t *page_table_act(page_t *page, uint32_t id)
{
    for (uint32_t i = 0U; i < LIMIT_PAGE_ACTS; i++) {
        if (page->acts[i].id == id) {
            return &page->acts[i];
        }
    }
    return NULL;
}

static bool has_ended(const page_act_t *act)
{
    return (act->id == 0U) || (act->is_answered && (act->answer.is_final != 0U));
}

/* Ids grow. */
static bool is_dearer(const page_act_t *act, const page_act_t *other)
{
    return (has_ended(act) != has_ended(other)) ? has_ended(other) : (act->id > other->id);
}

page_act_t *page_table_add(page_t *page)
{
    page_act_t *place = &page->acts[0];
    for (uint32_t i = 1U; i < LIMIT_PAGE_ACTS; i++) {
        place = is_dearer(place, &page->acts[i]) ? &page->acts[i] : place;
    }
    (void)memset(place, 0, sizeof *place);
    return place;
}

page_act_t *page_table_find_sent(page_table_t *self, uint32_t command, const page_t **page)
{
    for (uint32_t i = 0U; i < PAGE_TABLE_PAGES; i++) {
        *page = &self->pages[i];
        for (uint32_t j = 0U; j < LIMIT_PAGE_ACTS; j++) {
            page_act_t *act = &self->pages[i].acts[j];
            if ((act->id != 0U) && (act->command.id == command)) {
                return act;
            }
        }
    }
    return NULL;
}

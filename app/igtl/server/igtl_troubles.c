/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/server/igtl_troubles.h"

#include <inttypes.h>
#include <stdio.h>

#define LOG_INTERVAL_US UINT64_C(1000000)

void igtl_troubles_note(igtl_troubles_t *self, uint16_t port, igtl_trouble_t kind,
                        const char *reason, uint64_t now_us)
{
    static const char *const texts[IGTL_TROUBLES] = {
        [IGTL_TROUBLE_FULL] = "has no place for a connection: all are taken",
        [IGTL_TROUBLE_BROKEN] = "dropped a connection",
        [IGTL_TROUBLE_LATE] = "dropped a connection",
        [IGTL_TROUBLE_SLOW] = "dropped a connection: it does not read",
        [IGTL_TROUBLE_MESSAGE] = "refused a message",
        [IGTL_TROUBLE_SILENT] = "dropped a connection: it was silent and its place is wanted",
        [IGTL_TROUBLE_STRANGER] = "refused a connection: its address is not allowed",
        [IGTL_TROUBLE_HUNG] = "dropped a connection: its order ran and it did not read",
        [IGTL_TROUBLE_CALL] = "called in vain"};
    igtl_trouble_count_t *trouble = &self->counts[kind];

    trouble->count++;
    self->count++;
    (void)snprintf(self->last, sizeof self->last, "%s%s%s", texts[kind],
                   (reason[0] == '\0') ? "" : ": ", reason);
    if (now_us < trouble->next_log_us) {
        return;
    }
    (void)fprintf(stderr, "boresight-igtl: port %u %s (%" PRIu64 " more, %" PRIu64 " in all)\n",
                  (unsigned)port, self->last, trouble->count - trouble->said - 1U, trouble->count);
    trouble->said = trouble->count;
    trouble->next_log_us = now_us + LOG_INTERVAL_US;
}

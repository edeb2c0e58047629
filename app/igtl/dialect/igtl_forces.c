/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/dialect/igtl_forces.h"

#include "igtl/dialect/igtl_units.h"
#include "interface/app/names.h"
#include "interface/force_doubt.h"

#include <stdio.h>
#include <string.h>

static const struct {
    const char *sensor;
    const char *attribute;
} names[ROBOT_FORCE_CHANNELS] = {[FORCE_CHANNEL_HAND] = {"FORCE_HAND", "ForceHand"},
                                 [FORCE_CHANNEL_NEEDLE] = {"FORCE_NEEDLE", "ForceNeedle"}};

/* First doubt of a force that has one. */
static int32_t first_doubt(const snapshot_force_t *force)
{
    int32_t doubt = 0;

    while (((force->doubts >> (uint32_t)doubt) & 1U) == 0U) {
        doubt++;
    }
    return doubt;
}

/* "FIRST, SECOND: " and the sentence of the first, cut to what a STATUS holds. */
static void refuse_doubtful(igtl_outbox_t *outbox, const char *name, const snapshot_force_t *force,
                            const igtl_moment_t *moment)
{
    const int32_t first = first_doubt(force);
    char text[IGTL_REASON_SIZE];
    const igtl_status_t refusal = {igtl_reason_code(STATUS_FORCE_DOUBTFUL),
                                   status_name((int32_t)STATUS_FORCE_DOUBTFUL), text};
    size_t used = (size_t)snprintf(text, sizeof text, "%s", force_doubt_name(first));

    for (int32_t i = first + 1; i < (int32_t)FORCE_DOUBT_COUNT; i++) {
        if (((force->doubts >> (uint32_t)i) & 1U) != 0U) {
            used += (size_t)snprintf(&text[used], sizeof text - used, ", %s", force_doubt_name(i));
        }
    }
    (void)snprintf(&text[used], sizeof text - used, ": %s", force_doubt_text(first));
    igtl_send_refused(outbox, name, &refusal, moment);
}

static void report(igtl_outbox_t *outbox, const robot_t *robot, uint32_t channel,
                   const igtl_moment_t *moment)
{
    const char *name = names[channel].sensor;

    if (robot->force.is_there == 0U) {
        igtl_send_refusal(outbox, name, STATUS_NO_FORCE_SENSOR, moment);
    } else if (moment->snapshot == NULL) {
        igtl_send_refusal(outbox, name, STATUS_NO_ANSWER, moment);
    } else if (moment->snapshot->forces[channel].doubts != 0U) {
        refuse_doubtful(outbox, name, &moment->snapshot->forces[channel], moment);
    } else {
        igtl_packet_t packet;

        igtl_encode_force(&packet, name,
                          igtl_units_write_newtons(moment->snapshot->forces[channel].force_mn),
                          moment->timestamp);
        igtl_outbox_add(outbox, &packet);
    }
}

void igtl_forces_report(igtl_outbox_t *outbox, const robot_t *robot, const char *name,
                        const igtl_moment_t *moment)
{
    bool is_known = false;

    for (uint32_t i = 0U; i < ROBOT_FORCE_CHANNELS; i++) {
        if ((name[0] == '\0') || (strcmp(name, names[i].sensor) == 0)) {
            report(outbox, robot, i, moment);
            is_known = true;
        }
    }
    if (!is_known) {
        igtl_send_not_found(outbox, name, moment);
    }
}

size_t igtl_forces_write(const robot_t *robot, const snapshot_t *snapshot, char *text, size_t size)
{
    size_t used = 0U;

    for (uint32_t i = 0U; (robot->force.is_there != 0U) && (i < ROBOT_FORCE_CHANNELS); i++) {
        const snapshot_force_t *force = &snapshot->forces[i];

        used += (size_t)((force->doubts == 0U)
                             ? snprintf(&text[used], size - used, " %s=\"%.3f\"",
                                        names[i].attribute, igtl_units_newtons(force->force_mn))
                             : snprintf(&text[used], size - used, " %s=\"%s\"", names[i].attribute,
                                        force_doubt_name(first_doubt(force))));
    }
    if (robot->force.is_there != 0U) {
        used += (size_t)snprintf(&text[used], size - used, " Sight=\"%s\"",
                                 membrane_sight_name((int32_t)snapshot->membranes.sight));
    }
    return used;
}

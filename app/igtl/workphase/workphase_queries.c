/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/workphase/workphase_queries.h"

#include "base/fixed.h"
#include "base/rigid.h"
#include "charts/arming_chart.h"
#include "igtl/workphase/workphase_peer.h"
#include "igtl/workphase/workphase_progress.h"
#include "limits/requirement_limits.h"

#include <stddef.h>
#include <string.h>

typedef enum {
    QUESTION_NONE = 0,
    QUESTION_POSITION = 1,
    QUESTION_STATUS = 2,
    QUESTION_ALIGNED = 3,
    QUESTION_REACHED = 4,
    QUESTION_PROGRAM = 5
} question_t;

static const char *const question_names[] = {"",
                                             "CURRENT_POSITION",
                                             "CURRENT_STATUS",
                                             "IS_IN_TARGETING_POS",
                                             "HAS_REACHED_TARGET",
                                             WORKPHASE_PROGRESS};

static question_t question_of(const char *text, size_t length)
{
    for (uint32_t i = (uint32_t)QUESTION_POSITION; i <= (uint32_t)QUESTION_PROGRAM; i++) {
        if ((strlen(question_names[i]) == length) &&
            (memcmp(question_names[i], text, length) == 0)) {
            return (question_t)i;
        }
    }
    return QUESTION_NONE;
}

static bool is_near(const rigid_t *now, const rigid_t *goal)
{
    int32_t distance_nm;
    int32_t angle_bam;

    rigid_difference(now, goal, &distance_nm, &angle_bam);
    return (distance_nm <= (int32_t)LIMIT_REACHED_WAY_NM) &&
           (angle_bam <= (int32_t)LIMIT_REACHED_TURN_BAM);
}

/* The needle lies along the line of the target; its depth may differ. */
static bool is_aligned(const snapshot_t *snapshot)
{
    const rigid_t *now = &snapshot->scanner_treatment;
    rigid_t goal = snapshot->scanner_target;
    int32_t axis_q30[3];
    int32_t away[3];
    int64_t along;

    for (uint32_t i = 0U; i < 3U; i++) {
        axis_q30[i] = goal.rotation_q30[i][2];
    }
    away[0] = fixed_saturate((int64_t)now->translation.x_nm - goal.translation.x_nm);
    away[1] = fixed_saturate((int64_t)now->translation.y_nm - goal.translation.y_nm);
    away[2] = fixed_saturate((int64_t)now->translation.z_nm - goal.translation.z_nm);
    along = fixed_dot_q30(away, axis_q30);
    goal.translation.x_nm += fixed_multiply_q30(fixed_saturate(along), axis_q30[0]);
    goal.translation.y_nm += fixed_multiply_q30(fixed_saturate(along), axis_q30[1]);
    goal.translation.z_nm += fixed_multiply_q30(fixed_saturate(along), axis_q30[2]);
    return is_near(now, &goal);
}

/* The measured speed fades a little after the motion has ended; the order shows it immediately. */
static bool is_reached(const snapshot_t *snapshot)
{
    return (snapshot->order != (uint32_t)ARMING_STATE_MOVING) &&
           is_near(&snapshot->scanner_treatment, &snapshot->scanner_target);
}

/* A target is not judged by a needle of unknown position. */
static bool is_target_judged(const igtl_moment_t *moment)
{
    return (igtl_pose_status(moment) == STATUS_OK) && (moment->snapshot->has_target != 0U);
}

static void send_aligned(workphase_peer_t *peer, const igtl_moment_t *moment)
{
    const snapshot_t *snapshot = moment->snapshot;

    workphase_peer_send_flag(peer, question_names[QUESTION_ALIGNED],
                             is_target_judged(moment) && is_aligned(snapshot), moment);
}

static void send_reached(workphase_peer_t *peer, const igtl_moment_t *moment)
{
    const snapshot_t *snapshot = moment->snapshot;

    workphase_peer_send_flag(peer, question_names[QUESTION_REACHED],
                             is_target_judged(moment) && is_reached(snapshot), moment);
}

static void send_phase(workphase_peer_t *peer, const igtl_moment_t *moment)
{
    if (moment->snapshot == NULL) {
        workphase_peer_send_phase(peer, IGTL_STATUS_CONFIG_ERROR, (uint32_t)WORKPHASE_UNDEFINED,
                                  "The workphase is not known: control is silent.", moment);
        return;
    }
    workphase_peer_send_phase(peer, IGTL_STATUS_OK, moment->snapshot->workphase, "", moment);
}

bool workphase_queries_string(workphase_peer_t *peer, const igtl_message_t *message,
                              const igtl_moment_t *moment)
{
    question_t question = question_of(message->text, message->text_bytes);

    if (question == QUESTION_NONE) {
        question = question_of(message->name, strlen(message->name));
    }
    switch (question) {
    case QUESTION_POSITION:
        workphase_peer_send_position(peer, moment);
        send_aligned(peer, moment);
        send_reached(peer, moment);
        return true;
    case QUESTION_STATUS:
        send_phase(peer, moment);
        return true;
    case QUESTION_ALIGNED:
        send_aligned(peer, moment);
        return true;
    case QUESTION_REACHED:
        send_reached(peer, moment);
        return true;
    case QUESTION_PROGRAM:
        workphase_progress_send(peer, moment);
        return true;
    case QUESTION_NONE:
    default:
        return false;
    }
}

void workphase_queries_transform(workphase_peer_t *peer, const igtl_message_t *message,
                                 const igtl_moment_t *moment)
{
    if ((message->name[0] == '\0') || (strcmp(message->name, "CURRENT_POSITION") == 0)) {
        workphase_peer_send_position(peer, moment);
    } else if ((strcmp(message->name, "TARGET") == 0) && (moment->snapshot != NULL) &&
               (moment->snapshot->has_target != 0U)) {
        igtl_send_pose(peer->outbox, "TARGET", &moment->snapshot->scanner_target, moment);
    } else {
        igtl_send_not_found(peer->outbox, message->name, moment);
    }
}

void workphase_queries_status(workphase_peer_t *peer, const igtl_message_t *message,
                              const igtl_moment_t *moment)
{
    static const igtl_status_t alive = {IGTL_STATUS_OK, "", ""};

    if ((message->name[0] == '\0') || (strcmp(message->name, "CURRENT_STATUS") == 0)) {
        send_phase(peer, moment);
    } else {
        igtl_send_status(peer->outbox, message->name, &alive, moment);
    }
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/scenario/play.h"

#include <stdint.h>
#include <string.h>

int play_find(const char *name)
{
    const size_t length = strlen(name);
    int play = 0;
    for (const char *at = PLAY_NAMES; at[0] != '\0'; play++) {
        const size_t word = strcspn(at, "|");
        if ((word == length) && (strncmp(at, name, length) == 0)) {
            return play;
        }
        at += word + ((at[word] == '|') ? 1U : 0U);
    }
    return -1;
}

static bool has_card(const robot_t *robot, card_type_t type)
{
    bool has_it = false;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        has_it = has_it || (robot->axes[i].card_type == (uint8_t)type);
    }
    return has_it;
}

const char *play_refusal(const robot_t *robot, play_t play)
{
    const char *refusal = NULL;
    if ((play == PLAY_MAGNITUDE) && !has_card(robot, CARD_TYPE_NON_PWM)) {
        refusal = "no axis of it takes run and stop";
    } else if ((play == PLAY_SWEEPS) && !has_card(robot, CARD_TYPE_HIGH_FREQUENCY)) {
        refusal = "no axis of it takes waves";
    } else if ((play == PLAY_HANDS) && (robot->hand.gain_q8 == 0U)) {
        refusal = "no hand moves its needle";
    } else {
        /* It can. */
    }
    return refusal;
}

command_kind_t play_theme(play_t play)
{
    command_kind_t theme = COMMAND_NONE;
    if (play == PLAY_PROGRAMS) {
        theme = COMMAND_PROGRAM_BEGIN;
    } else if (play == PLAY_SWEEPS) {
        theme = COMMAND_SWEEP;
    } else {
        /* Any orders. */
    }
    return theme;
}

bool play_is_of_orders(play_t play)
{
    return (play == PLAY_MODES) || (play == PLAY_LATE) || (play_theme(play) != COMMAND_NONE);
}

bool play_is_of_scenes(play_t play)
{
    return (play == PLAY_RANDOM) || (play == PLAY_JOGS) || (play == PLAY_TAPS) ||
           (play == PLAY_RIVALS) || (play == PLAY_HANDS) || play_is_of_orders(play);
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/verify/build_fit.h"

#include "common/build_id.h"
#include "interface/interface_layout.h"
#include "recording/format/cycle_words.h"
#include "robot/app/robot_names.h"
#include "robot/app/robots.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

/* Names in a file's header; four letters for each that is not plain. */
typedef struct {
    char robot[4U * sizeof((recording_header_t *)0)->robot];
    char build[4U * sizeof((recording_header_t *)0)->build];
} names_t;

/* Finds the robot; NULL after saying why it is not the recorded one. */
static const robot_t *find_robot(const recording_header_t *header, const names_t *names)
{
    const robot_t *const robot = robots_find(header->robot);

    if (robot == NULL) {
        (void)fprintf(stderr,
                      "Recorded with robot %s, this build has %s; replay it with the build that "
                      "recorded it, \"%s\".\n",
                      names->robot, robot_names_list(), names->build);
        return NULL;
    }
    if (header->robot_crc != robot->crc) {
        (void)fprintf(stderr,
                      "Recorded with robot %s of CRC %08" PRIX32
                      ", this build has %s of CRC %08" PRIX32
                      "; replay it with the build that recorded it, \"%s\".\n",
                      names->robot, header->robot_crc, robot->name, robot->crc, names->build);
        return NULL;
    }
    return robot;
}

/* Says why the bytes of the recording are not what this build takes them for. */
static bool check_layout(const recording_reader_t *reader, const names_t *names)
{
    const recording_header_t *const header = &reader->header;

    if (recording_reader_fits(reader, INTERFACE_LAYOUT, CONTROLLER_CHECKPOINT_BYTES)) {
        return true;
    }
    (void)fprintf(stderr,
                  "Recorded with layout %016" PRIX64 ", inputs of %" PRIu32 ", outputs of %" PRIu32
                  " and a state of %" PRIu32 " bytes, this build has %016" PRIX64
                  ", %zu, %zu and %zu; replay it with the build that recorded it, \"%s\".\n",
                  header->layout, header->inputs_size, header->outputs_size,
                  header->controller_size, INTERFACE_LAYOUT, sizeof(controller_inputs_t),
                  sizeof(controller_outputs_t), CONTROLLER_CHECKPOINT_BYTES, names->build);
    return false;
}

/* Frames are kept as their fields: another codec makes other bytes of them, alike on both sides. */
static bool check_frames(const recording_header_t *header, const names_t *names)
{
    const uint32_t own = cycle_words_frame_layout();

    if (header->frame_layout == own) {
        return true;
    }
    (void)fprintf(stderr,
                  "Recorded with frames of another layout, %08" PRIX32 ", this build has %08" PRIX32
                  "; replay it with the build that recorded it, \"%s\".\n",
                  header->frame_layout, own, names->build);
    return false;
}

const robot_t *build_fit(const recording_reader_t *reader)
{
    const recording_header_t *const header = &reader->header;
    names_t names;

    recording_escape(header->robot, names.robot, sizeof names.robot);
    recording_escape(header->build, names.build, sizeof names.build);
    const robot_t *const robot = find_robot(header, &names);
    if (robot == NULL) {
        return NULL;
    }
    return (check_layout(reader, &names) && check_frames(header, &names)) ? robot : NULL;
}

void build_fit_mention(const recording_reader_t *reader)
{
    char build[4U * sizeof reader->header.build];

    recording_escape(reader->header.build, build, sizeof build);
    if (strcmp(reader->header.build, BUILD_ID) != 0) {
        (void)fprintf(stderr,
                      "Recorded by build \"%s\", replayed by build \"%s\": a difference may come "
                      "from that.\n",
                      build, BUILD_ID);
    }
}

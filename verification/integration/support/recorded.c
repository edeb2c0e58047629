/* SPDX-License-Identifier: Apache-2.0 */
#include "integration/support/recorded.h"

#include "interface/interface_layout.h"
#include "limits/requirement_limits.h"
#include "robot/app/robot_names.h"
#include "robot/app/robots.h"
#include "unit/support/scenes.h"

#include "unity.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define LATE_US 16U /* Fewer than that, either way. */
#define REST_CYCLES 5000U
#define LONGEST_CYCLES 150000U
#define WORDS_SIZE 256U
#define CYCLES_PER_H (3600.0 * 1e6 / LIMIT_CYCLE_US)

bool recorded_begin(recorded_t *self, rig_t *rig, const char *path)
{
    recording_header_t header = {.robot_crc = rig->robot.crc,
                                 .inputs_size = sizeof(controller_inputs_t),
                                 .outputs_size = sizeof(controller_outputs_t),
                                 .controller_size = CONTROLLER_CHECKPOINT_BYTES,
                                 .layout = INTERFACE_LAYOUT};

    (void)memset(self, 0, sizeof *self);
    self->rig = rig;
    self->noise = 1U;
    (void)snprintf(header.build, sizeof header.build, "test");
    (void)snprintf(header.robot, sizeof header.robot, "%s", rig->robot.name);
    (void)unlink(path);
    self->record.kind = (uint32_t)CYCLE_RECORD_CHECKPOINT;
    self->record.cycle = rig->controller.sealed.cycle;
    (void)memcpy(self->record.body.checkpoint, &rig->controller, CONTROLLER_CHECKPOINT_BYTES);
    return recording_writer_open(&self->writer, path, &header) &&
           recording_writer_append(&self->writer, &self->record);
}

bool recorded_cycles(recorded_t *self, uint32_t count)
{
    bool is_written = true;

    for (uint32_t i = 0U; is_written && (i < count); i++) {
        self->noise = (self->noise * 1664525U) + 1013904223U;
        self->rig->elapsed_us =
            (LIMIT_CYCLE_US - (LATE_US / 2U)) + ((self->noise >> 16U) % LATE_US);
        self->record.kind = (uint32_t)CYCLE_RECORD_CYCLE;
        self->record.cycle = self->rig->controller.sealed.cycle;
        rig_cycle(self->rig);
        self->record.body.cycle.inputs = self->rig->inputs;
        self->record.body.cycle.outputs = self->rig->outputs;
        is_written = recording_writer_append(&self->writer, &self->record);
        self->cycles++;
    }
    return is_written;
}

bool recorded_finish(recorded_t *self, uint32_t most)
{
    const uint32_t before = self->rig->answer_count;

    for (uint32_t i = 0U; (i < most) && (self->rig->answer_count == before); i++) {
        if (!recorded_cycles(self, 1U)) {
            return false;
        }
    }
    return self->rig->answer_count != before;
}

void recorded_workphase(recorded_t *self, workphase_t workphase)
{
    self->rig->commands[0] = (command_t){.id = 1U,
                                         .source = (uint32_t)COMMAND_SOURCE_IGTL,
                                         .kind = (uint32_t)COMMAND_WORKPHASE,
                                         .as.workphase = {.workphase = (uint32_t)workphase}};
    self->rig->command_count = 1U;
}

bool recorded_count(recorded_t *self)
{
    const bool is_written = recording_writer_flush(&self->writer);

    self->begun_bytes = self->writer.size;
    self->begun_cycles = self->cycles;
    return is_written;
}

double recorded_bytes_per_cycle(recorded_t *self)
{
    (void)recording_writer_flush(&self->writer);
    return (double)(self->writer.size - self->begun_bytes) /
           (double)(self->cycles - self->begun_cycles);
}

double recorded_mb_per_h(recorded_t *self)
{
    return recorded_bytes_per_cycle(self) * CYCLES_PER_H / 1e6;
}

bool recorded_end(recorded_t *self)
{
    return recording_writer_close(&self->writer);
}

uint32_t recorded_each_robot(void (*work)(const robot_t *robot))
{
    char names[WORDS_SIZE];
    uint32_t robots = 0U;

    (void)snprintf(names, sizeof names, "%s", robot_names_list());
    for (const char *name = strtok(names, ", "); name != NULL; name = strtok(NULL, ", ")) {
        const robot_t *const robot = robots_find(name);
        if (robot != NULL) { /* A word between two names is none. */
            work(robot);
            robots++;
        }
    }
    return robots;
}

void recorded_rest(recorded_t *self, rig_t *rig, const robot_t *robot, const char *path)
{
    rig_start_robot(rig, robot);
    TEST_ASSERT_TRUE(recorded_begin(self, rig, path));
    TEST_ASSERT_TRUE(recorded_cycles(self, 100U));
    TEST_ASSERT_TRUE(recorded_count(self));
    TEST_ASSERT_TRUE(recorded_cycles(self, SCENES(REST_CYCLES)));
}

void recorded_homing(recorded_t *self, rig_t *rig, const robot_t *robot, const char *path)
{
    rig_start_robot(rig, robot);
    TEST_ASSERT_TRUE(recorded_begin(self, rig, path));
    recorded_workphase(self, WORKPHASE_START_UP);
    TEST_ASSERT_TRUE(recorded_cycles(self, 1U));
    rig_box(rig, "pedal press");
    while (!rig_is_driving(rig)) {
        TEST_ASSERT_LESS_THAN_UINT64(1000U, self->cycles);
        TEST_ASSERT_TRUE(recorded_cycles(self, 1U));
    }
    TEST_ASSERT_TRUE(recorded_count(self));
    const bool is_done = recorded_finish(self, SCENES(LONGEST_CYCLES));
    TEST_ASSERT_EQUAL_UINT32(is_done ? 1U : 0U, rig->outputs.snapshot.is_homed);
    TEST_ASSERT_TRUE(is_done || !ARE_SCENES_WHOLE);
}

void recorded_move(recorded_t *self, rig_t *rig, const char *path)
{
    rig_start_moving(rig);
    TEST_ASSERT_TRUE(recorded_begin(self, rig, path));
    TEST_ASSERT_TRUE(recorded_count(self));
    TEST_ASSERT_TRUE(recorded_finish(self, LONGEST_CYCLES));
}

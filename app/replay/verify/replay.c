/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/verify/replay.h"

#include "interface/app/event_words.h"
#include "interface/app/fields.h"
#include "replay/verify/field_name.h"

#include <stdio.h>
#include <string.h>

#define PLACE_SIZE 128U
#define WORDS_NAMED 5U /**< Words of a state. */
#define WORDS_SIZE (WORDS_NAMED * sizeof ", 4294967295")

/* The equal elements of a part of the outputs; NULL: bytes without names. */
typedef struct {
    const char *name;
    size_t offset;
    size_t element_size;
    const field_t *fields;
} area_t;

static const area_t areas[] = {
    {"counts, word", 0U, sizeof(uint32_t), NULL},
    {"answers, answer", offsetof(controller_outputs_t, answers), sizeof(answer_t), fields_answer},
    {"events, event", offsetof(controller_outputs_t, events), sizeof(event_t), fields_event},
    {"snapshot", offsetof(controller_outputs_t, snapshot), sizeof(snapshot_t), fields_snapshot},
    {"frames, slot", offsetof(controller_outputs_t, frames), CARD_FRAME_BYTES, NULL},
};
#define AREAS (sizeof areas / sizeof areas[0])

void replay_init(replay_t *self)
{
    (void)memset(self, 0, sizeof *self);
}

static void restore(replay_t *self, const cycle_record_t *record, const cycle_known_t *known)
{
    (void)memcpy(&self->controller, record->body.checkpoint, CONTROLLER_CHECKPOINT_BYTES);
    if (record->rows > 0U) {
        (void)memcpy(self->controller.rows, known->rows,
                     record->rows * sizeof self->controller.rows[0]);
    }
    self->next_cycle = record->cycle;
    self->is_running = true;
    self->checkpoints++;
}

/* Words of the checkpoint, and then of its rows. */
static uint32_t checkpoint_words(const cycle_record_t *record)
{
    return (uint32_t)((CONTROLLER_CHECKPOINT_BYTES + (record->rows * sizeof(trajectory_row_t))) /
                      sizeof(uint32_t));
}

static void read_word(const replay_t *self, const cycle_record_t *record,
                      const cycle_known_t *known, uint32_t word, uint32_t *computed,
                      uint32_t *recorded)
{
    const size_t offset = word * sizeof(uint32_t);
    const uint8_t *const from = (offset < CONTROLLER_CHECKPOINT_BYTES)
                                    ? &record->body.checkpoint[offset]
                                    : &known->rows[offset - CONTROLLER_CHECKPOINT_BYTES];

    (void)memcpy(computed, (const uint8_t *)&self->controller + offset, sizeof *computed);
    (void)memcpy(recorded, from, sizeof *recorded);
}

/* The first word from `word` on in which the recorded state is another. */
static uint32_t next_difference(const replay_t *self, const cycle_record_t *record,
                                const cycle_known_t *known, uint32_t word)
{
    uint32_t computed = 0U;
    uint32_t recorded = 0U;

    while (word < checkpoint_words(record)) {
        read_word(self, record, known, word, &computed, &recorded);
        if (computed != recorded) {
            return word;
        }
        word++;
    }
    return word;
}

/* Adopts it where no state leads to it, otherwise compares it with the one that was computed. */
static bool take_checkpoint(replay_t *self, const cycle_record_t *record,
                            const cycle_known_t *known)
{
    if (self->is_running && (record->cycle == self->next_cycle)) {
        return next_difference(self, record, known, 0U) == checkpoint_words(record);
    }
    restore(self, record, known);
    return true;
}

static void execute(replay_t *self, const robot_t *robot, const controller_inputs_t *inputs)
{
    uint32_t words[CYCLE_WORDS_CHECKED];

    controller_step(&self->controller, robot, inputs, &self->outputs);
    cycle_words_of_checked(&self->outputs, words);
    prover_take(&self->prover, inputs->elapsed_us, words, &self->proof);
}

/* Bytes at the beginning of the outputs that were kept as they were. */
static size_t kept_size(const cycle_known_t *known)
{
    return known->is_whole ? sizeof(controller_outputs_t)
                           : offsetof(controller_outputs_t, snapshot);
}

static bool is_equal(const replay_t *self, const cycle_record_t *record, const cycle_known_t *known)
{
    return (memcmp(&self->outputs, &record->body.cycle.outputs, kept_size(known)) == 0) &&
           (known->is_whole || (proof_difference(&self->proof, &known->proof) == PROOF_PARTS));
}

bool replay_take(replay_t *self, const robot_t *robot, const cycle_record_t *record,
                 const cycle_known_t *known)
{
    if (record->kind == (uint32_t)CYCLE_RECORD_CHECKPOINT) {
        return take_checkpoint(self, record, known);
    }
    if (self->is_running && (record->cycle != self->next_cycle)) {
        self->is_running = false;
        self->gaps++;
    }
    if (!self->is_running) {
        self->unreplayed++;
        return true;
    }
    if (known->is_whole) {
        prover_begin(&self->prover);
    }
    execute(self, robot, &record->body.cycle.inputs);
    self->next_cycle = record->cycle + 1U;
    if (!is_equal(self, record, known)) {
        return false;
    }
    self->replayed++;
    return true;
}

static uint32_t word_at(const void *from, size_t offset)
{
    uint32_t word = 0U;

    (void)memcpy(&word, (const uint8_t *)from + offset, sizeof word);
    return word;
}

static const area_t *find_area(size_t offset)
{
    size_t area = 0U;

    while (((area + 1U) < AREAS) && (offset >= areas[area + 1U].offset)) {
        area++;
    }
    return &areas[area];
}

/* Where the byte is in the data of an answer, whose form `outputs` say. */
static void name_data(size_t offset, const uint8_t *outputs, char *text, size_t size)
{
    const size_t inside = offset - offsetof(controller_outputs_t, answers);
    const size_t at = inside % sizeof(answer_t);
    answer_t answer;
    const field_t *fields = NULL;

    (void)memcpy(&answer, &outputs[offset - at], sizeof answer);
    fields = fields_of_answer((uint32_t)answer_form(&answer));
    if (at < offsetof(answer_t, as)) {
        field_name(fields_answer, at, text, size);
    } else if (fields != NULL) {
        field_name(fields, at - offsetof(answer_t, as), text, size);
    } else {
        (void)snprintf(text, size, "data, byte %zu", at - offsetof(answer_t, as));
    }
}

/* The value of an event has the name that its row gives it. */
static void name_of_event(size_t offset, const uint8_t *outputs, char *text, size_t size)
{
    const size_t at = (offset - offsetof(controller_outputs_t, events)) % sizeof(event_t);
    event_t event;
    const char *title = NULL;

    (void)memcpy(&event, &outputs[offset - at], sizeof event);
    title = event_value_title(event.id);
    field_name(fields_event, at, text, size);
    if ((at - (at % sizeof(uint32_t)) == offsetof(event_t, value)) && (title != NULL)) {
        (void)snprintf(&text[strlen(text)], size - strlen(text), " (%s)", title);
    }
}

/* Where the byte is among `outputs`. */
static void name_place(size_t offset, const uint8_t *outputs, char *text, size_t size)
{
    const area_t *const area = find_area(offset);
    const size_t inside = offset - area->offset;
    const size_t at = inside % area->element_size;
    char field[PLACE_SIZE] = "";

    if (area->fields == fields_answer) {
        name_data(offset, outputs, field, sizeof field);
    } else if (area->fields == fields_event) {
        name_of_event(offset, outputs, field, sizeof field);
    } else if (area->fields != NULL) {
        field_name(area->fields, at, field, sizeof field);
    } else {
        (void)snprintf(field, sizeof field, "byte %zu", at);
    }
    if (area->fields == fields_snapshot) {
        (void)snprintf(text, size, "%s, %s", area->name, field);
    } else {
        (void)snprintf(text, size, "%s %zu, %s", area->name, inside / area->element_size, field);
    }
}

static void say_values(const char *where, uint32_t cycle, uint32_t replayed, uint32_t recorded,
                       char *text, size_t size)
{
    (void)snprintf(text, size,
                   "Cycle %u differs first in its %s: it is %u (0x%X), recorded %u (0x%X).",
                   (unsigned)cycle, where, (unsigned)replayed, (unsigned)replayed,
                   (unsigned)recorded, (unsigned)recorded);
}

/* The kept part of it: the word of a field, otherwise the byte. */
static void say_kept(size_t offset, uint32_t cycle, const uint8_t *replayed,
                     const uint8_t *recorded, char *text, size_t size)
{
    const size_t word = offset - (offset % sizeof(uint32_t));
    char place[PLACE_SIZE + 32U];

    name_place(offset, recorded, place, sizeof place);
    if (find_area(offset)->fields != NULL) {
        say_values(place, cycle, word_at(replayed, word), word_at(recorded, word), text, size);
    } else {
        say_values(place, cycle, replayed[offset], recorded[offset], text, size);
    }
}

/* A part that went on as expected when it was recorded: what it was is known. */
static bool say_surprise(const replay_t *self, const cycle_record_t *record, char *text,
                         size_t size)
{
    const proof_surprise_t *const surprise = &self->prover.surprises[PROOF_SNAPSHOT];
    const size_t inside = surprise->word * sizeof(uint32_t);
    char place[PLACE_SIZE + 32U];

    name_place(offsetof(controller_outputs_t, snapshot) + inside, (const uint8_t *)&self->outputs,
               place, sizeof place);
    say_values(place, record->cycle, word_at(&self->outputs.snapshot, inside), surprise->expected,
               text, size);
    return true;
}

static bool say_proof(const replay_t *self, const cycle_record_t *record,
                      const cycle_known_t *known, char *text, size_t size)
{
    const uint32_t part = proof_difference(&self->proof, &known->proof);
    const bool was_expected = ((known->proof.surprises >> part) & 1U) == 0U;

    if ((part == PROOF_SNAPSHOT) && was_expected) {
        return say_surprise(self, record, text, size);
    }
    if (part == PROOF_SNAPSHOT) {
        (void)snprintf(text, size,
                       "Cycle %u differs first in its snapshot, of which a hash was kept.",
                       (unsigned)record->cycle);
    } else {
        (void)snprintf(text, size, "Cycle %u differs first in its frames, slot %u, %s.",
                       (unsigned)record->cycle, (unsigned)(part - PROOF_FRAMES),
                       was_expected ? "which went on as expected" : "of which a hash was kept");
    }
    return false;
}

/* The words of the state that differ, the first of them with their numbers. */
static void say_state(const replay_t *self, const cycle_record_t *record,
                      const cycle_known_t *known, char *text, size_t size)
{
    const uint32_t first = next_difference(self, record, known, 0U);
    uint32_t computed = 0U;
    uint32_t recorded = 0U;
    uint32_t count = 0U;
    char words[WORDS_SIZE] = "";
    size_t used = 0U;

    read_word(self, record, known, first, &computed, &recorded);
    for (uint32_t word = first; word < checkpoint_words(record);
         word = next_difference(self, record, known, word + 1U)) {
        if (count < WORDS_NAMED) {
            used += (size_t)snprintf(&words[used], sizeof words - used, "%s%u",
                                     (count > 0U) ? ", " : "", (unsigned)word);
        }
        count++;
    }
    (void)snprintf(text, size,
                   "The checkpoint before cycle %u is another state than was computed, in %u of %u "
                   "words: %s%s; word %u is %u (0x%X), recorded %u (0x%X).",
                   (unsigned)record->cycle, (unsigned)count, (unsigned)checkpoint_words(record),
                   words, (count > WORDS_NAMED) ? " ..." : "", (unsigned)first, (unsigned)computed,
                   (unsigned)computed, (unsigned)recorded, (unsigned)recorded);
}

bool replay_difference(const replay_t *self, const cycle_record_t *record,
                       const cycle_known_t *known, char *text, size_t size)
{
    const uint8_t *const recorded = (const uint8_t *)&record->body.cycle.outputs;
    const uint8_t *const replayed = (const uint8_t *)&self->outputs;
    const size_t kept = kept_size(known);
    size_t offset = 0U;

    if (record->kind == (uint32_t)CYCLE_RECORD_CHECKPOINT) {
        say_state(self, record, known, text, size);
        return true;
    }
    while ((offset < kept) && (recorded[offset] == replayed[offset])) {
        offset++;
    }
    if (offset == kept) {
        return say_proof(self, record, known, text, size);
    }
    say_kept(offset, record->cycle, replayed, recorded, text, size);
    return true;
}

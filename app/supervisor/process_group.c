/* SPDX-License-Identifier: Apache-2.0 */
#include "supervisor/process_group.h"

#include "common/clock.h"
#include "common/rest.h"
#include "limits/requirement_limits.h"
#include "supervisor/board_text.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define SILENT_US UINT64_C(2000000)
#define LOOK_US 200000U
#define STOP_STEP_US 2000U

/* Together less than LIMIT_STOP_TIME_US, in the time of the board; the recorder has its own time.
 */
#define STOP_CLIENTS_US UINT64_C(300000)
#define STOP_CONTROL_US 900000U /* Of cycles, or of looks in a row without one. */
#define STOP_COMPANIONS_US UINT64_C(200000)

/* Looks in a row without a sign of life. A pause of the machine, in which no program can run, is
 * one look; control may just be waiting for the box. */
#define STOP_CONTROL_LOOKS (STOP_CONTROL_US / STOP_STEP_US)
#define STOP_RECORDER_LOOKS ((uint32_t)LIMIT_HANG_US / STOP_STEP_US)

/* Signs of life until it has to have ended: one each cycle. */
#define STOP_CONTROL_BEATS (STOP_CONTROL_US / LIMIT_CYCLE_US)
#define STOP_RECORDER_BEATS UINT32_MAX

static bool init_member(process_group_t *self, member_t member, const char *name,
                        const options_t *options, char *error, uint32_t error_size)
{
    child_t *child = &self->members[member];

    child->name = name;
    child->may_restart = member > MEMBER_CONTROL;
    (void)snprintf(child->path, sizeof child->path, "%s/boresight-%s", options->programs, name);
    if (access(child->path, X_OK) != 0) {
        (void)snprintf(error, error_size, "The program %s is missing (%s); build it with make.",
                       child->path, strerror(errno));
        return false;
    }
    return true;
}

static void set_arguments(child_t *child, const char *const arguments[CHILD_ARGUMENTS])
{
    (void)memcpy(child->arguments, arguments, sizeof child->arguments);
}

/* An empty argument is left out, such as an option that was not given. */
static bool write_arguments(process_group_t *self, uint32_t place, const options_t *options)
{
    const board_companion_t *const companion = &board.companions[place];
    child_t *const child = &self->members[place];
    uint32_t count = 0U;

    for (uint32_t i = 0U; (i < BOARD_ARGUMENTS) && (companion->arguments[i] != NULL); i++) {
        char *const word = self->words[place][i];
        if (!board_text_write(word, FAMILY_TEXT_SIZE, companion->arguments[i], options)) {
            return false;
        }
        child->arguments[count] = word;
        count += (word[0] != '\0') ? 1U : 0U;
    }
    if (count < CHILD_ARGUMENTS) {
        child->arguments[count] = NULL;
    }
    return true;
}

static bool init_companions(process_group_t *self, const options_t *options, char *error,
                            uint32_t error_size)
{
    for (uint32_t i = 0U; i < BOARD_COMPANIONS; i++) {
        const board_companion_t *const companion = &board.companions[i];
        if (companion->program == NULL) {
            continue;
        }
        self->runs_already[i] = options_has(options, companion->unless);
        if (!init_member(self, (member_t)i, companion->program, options, error, error_size)) {
            return false;
        }
        if (!write_arguments(self, i, options)) {
            (void)snprintf(error, error_size, "What %s is given is too long; use shorter names.",
                           companion->program);
            return false;
        }
    }
    return true;
}

/* The kept positions belong to the axes of that box, whichever robot used it last. */
static bool name_box(process_group_t *self, const options_t *options, char *error,
                     uint32_t error_size)
{
    char name[FAMILY_NAME_SIZE];

    if (!board_text_write(self->box, sizeof self->box, board.box, options) ||
        !board_text_write(name, sizeof name, board.name, options)) {
        (void)snprintf(error, error_size, "The name of the box is too long; use shorter names.");
        return false;
    }
    (void)snprintf(self->positions, sizeof self->positions, "%s/positions-%s", options->recordings,
                   name);
    (void)snprintf(self->box_key, sizeof self->box_key, "%s.key", self->positions);
    return true;
}

static void set_http(process_group_t *self, const options_t *options)
{
    const char *http[CHILD_ARGUMENTS] = {
        "--instance", options->instance, "--port",       options->http_port,
        "--bind",     options->bind,     "--recordings", options->recordings,
        "--box-key",  self->box_key};
    uint32_t count = 10U;

    if (options->accounts != NULL) {
        http[count] = "--accounts";
        http[count + 1U] = options->accounts;
        count += 2U;
    }
    if (options->tls_file != NULL) {
        http[count] = "--tls-file";
        http[count + 1U] = options->tls_file;
        count += 2U;
    }
    if (board.is_simulated) {
        http[count] = "--box";
        http[count + 1U] = self->box;
    }
    set_arguments(&self->members[MEMBER_HTTP], http);
}

bool process_group_init(process_group_t *self, const options_t *options, int output, int errors,
                        char *error, uint32_t error_size)
{
    static const char *const names[] = {"control", "recorder", "igtl", "http"};

    (void)memset(self, 0, sizeof *self);
    self->slowness = options_slowness(options);
    self->output = output;
    self->errors = errors;
    if (!name_box(self, options, error, error_size) ||
        !init_companions(self, options, error, error_size)) {
        return false;
    }
    for (uint32_t i = 0U; i < (sizeof names / sizeof names[0]); i++) {
        const member_t member = (member_t)((uint32_t)MEMBER_CONTROL + i);
        if (!init_member(self, member, names[i], options, error, error_size)) {
            return false;
        }
    }
    const char *const trajectory = (options->trajectory != NULL) ? "--trajectory" : NULL;
    const char *const control[CHILD_ARGUMENTS] = {
        "--robot", options->robot, "--instance",    options->instance, "--box",
        self->box, "--positions",  self->positions, trajectory,        options->trajectory};
    const char *const recorder[CHILD_ARGUMENTS] = {"--instance",  options->instance,
                                                   "--directory", options->recordings,
                                                   "--positions", self->positions};
    const char *const igtl[CHILD_ARGUMENTS] = {
        "--instance",  options->instance,  "--brp-port", options->brp_port,
        "--igtl-port", options->igtl_port, "--bind",     options->bind};
    const char *const igtl_by_file[CHILD_ARGUMENTS] = {"--instance", options->instance,
                                                       "--igtl-file", options->igtl_file};
    set_arguments(&self->members[MEMBER_CONTROL], control);
    set_arguments(&self->members[MEMBER_RECORDER], recorder);
    set_arguments(&self->members[MEMBER_IGTL], (options->igtl_file == NULL) ? igtl : igtl_by_file);
    set_http(self, options);
    return true;
}

bool process_group_start(process_group_t *self, member_t member, char *error, uint32_t error_size)
{
    child_t *child = &self->members[member];
    const bool is_started = child_start(child, self->output, self->errors, clock_monotonic_us());

    if (!is_started) {
        (void)snprintf(error, error_size, "%s cannot be started (%s); end other programs.",
                       child->name, strerror(errno));
    }
    return is_started;
}

int process_group_reap(process_group_t *self)
{
    for (uint32_t i = 0U; i < FAMILY_SIZE; i++) {
        child_t *child = &self->members[i];
        int status = 0;
        if ((child->pid != 0) && (waitpid(child->pid, &status, WNOHANG) == child->pid)) {
            child_ended(child, status, clock_monotonic_us());
            return (int)i;
        }
    }
    return -1;
}

void process_group_restart(process_group_t *self)
{
    const uint64_t now_us = clock_monotonic_us();

    for (uint32_t i = 0U; i < FAMILY_SIZE; i++) {
        child_t *child = &self->members[i];
        const bool is_due =
            (child->pid == 0) && (child->restart_us != 0U) && (now_us >= child->restart_us);
        if (is_due && !child_start(child, self->output, self->errors, now_us)) {
            child->restart_us = now_us + CHILD_BACKOFF_MOST_US;
        }
    }
}

static const exchange_process_t processes[FAMILY_SIZE] = {
    [MEMBER_CONTROL] = EXCHANGE_CONTROL,
    [MEMBER_RECORDER] = EXCHANGE_RECORDER,
    [MEMBER_IGTL] = EXCHANGE_IGTL,
    [MEMBER_HTTP] = EXCHANGE_HTTP,
};

bool process_group_is_silent(process_group_t *self, const exchange_t *exchange, member_t member)
{
    child_t *child = &self->members[member];

    if (member < MEMBER_CONTROL) {
        return false; /* Does not live in the exchange. */
    }
    const uint32_t beats = exchange_beats(exchange, processes[member]);
    if (beats != child->beats) {
        child->beats = beats;
        child->beaten_us = clock_monotonic_us();
    }
    return (clock_monotonic_us() - child->beaten_us) >= SILENT_US;
}

bool process_group_end_hanging(process_group_t *self, exchange_t *exchange, member_t member)
{
    child_t *child = &self->members[member];
    const uint64_t now_us = clock_monotonic_us();
    const uint32_t beats = exchange_beats(exchange, processes[member]);

    if ((child->pid == 0) || (beats != child->heard)) {
        child->heard = beats;
        child->looks = 0U;
        child->looked_us = now_us;
    } else if ((now_us - child->looked_us) >= LOOK_US) {
        child->looks++;
        child->looked_us = now_us;
    } else {
        /* It is too soon to look. */
    }
    const bool is_hanging = child->looks >= (LIMIT_HANG_US / LOOK_US);
    if (is_hanging) {
        child->looks = 0U;
        exchange_note_replaced(exchange, processes[member]);
        (void)kill(child->pid, SIGKILL);
    }
    return is_hanging;
}

static bool is_running(process_group_t *self, const member_t *members, uint32_t count)
{
    bool is_one_running = false;

    while (process_group_reap(self) >= 0) {
    }
    for (uint32_t i = 0U; i < count; i++) {
        is_one_running = is_one_running || (self->members[members[i]].pid != 0);
    }
    return is_one_running;
}

static void send(const process_group_t *self, const member_t *members, uint32_t count,
                 int signal_number)
{
    for (uint32_t i = 0U; i < count; i++) {
        if (self->members[members[i]].pid != 0) {
            (void)kill(self->members[members[i]].pid, signal_number);
        }
    }
}

static void ask_to_stop(const process_group_t *self, const member_t *members, uint32_t count)
{
    send(self, members, count, SIGTERM);
    send(self, members, count, SIGCONT); /* A stopped one would not hear. */
}

static void rest(void)
{
    const struct timespec step = {.tv_sec = 0, .tv_nsec = (long)STOP_STEP_US * 1000L};

    (void)nanosleep(&step, NULL);
}

static void make_end(process_group_t *self, const member_t *members, uint32_t count)
{
    send(self, members, count, SIGKILL);
    while (is_running(self, members, count)) {
        rest();
    }
}

static void stop(process_group_t *self, const member_t *members, uint32_t count,
                 uint64_t timeout_us)
{
    const uint64_t end_us = clock_monotonic_us() + timeout_us;

    ask_to_stop(self, members, count);
    while (is_running(self, members, count) && (clock_monotonic_us() < end_us)) {
        rest();
    }
    make_end(self, members, count);
}

/* One that gives a sign of life with each cycle: control ends after the cycle under way, the
 * recorder after those that wait for it. */
static void stop_living(process_group_t *self, const exchange_t *exchange, member_t member,
                        uint32_t most_looks, uint32_t most_beats)
{
    const uint64_t end_us = clock_monotonic_us() + LIMIT_RECORDER_END_US;
    const uint32_t first = exchange_beats(exchange, processes[member]);
    uint32_t heard = first;
    uint32_t looks = 0U;

    ask_to_stop(self, &member, 1U);
    while (is_running(self, &member, 1U) && (looks < most_looks) &&
           ((heard - first) < most_beats) && (clock_monotonic_us() < end_us)) {
        rest();
        const uint32_t beats = exchange_beats(exchange, processes[member]);
        looks = (beats != heard) ? 0U : (looks + 1U);
        heard = beats;
    }
    make_end(self, &member, 1U);
}

/* After a crash its last cycle may be in no recording. */
static bool has_ended_in_order(const child_t *control)
{
    return WIFEXITED(control->status) && ((WEXITSTATUS(control->status) == EXIT_SUCCESS) ||
                                          (WEXITSTATUS(control->status) == REST_EXIT));
}

void process_group_stop(process_group_t *self, exchange_t *exchange)
{
    static const member_t clients[] = {MEMBER_IGTL, MEMBER_HTTP};
    member_t companions[BOARD_COMPANIONS];

    for (uint32_t i = 0U; i < BOARD_COMPANIONS; i++) {
        companions[i] = (member_t)i;
    }
    stop(self, clients, 2U, STOP_CLIENTS_US);
    stop_living(self, exchange, MEMBER_CONTROL, STOP_CONTROL_LOOKS * self->slowness,
                STOP_CONTROL_BEATS);
    if (has_ended_in_order(&self->members[MEMBER_CONTROL])) {
        exchange_note_control_ended(exchange);
    }
    stop_living(self, exchange, MEMBER_RECORDER, STOP_RECORDER_LOOKS, STOP_RECORDER_BEATS);
    stop(self, companions, BOARD_COMPANIONS, STOP_COMPANIONS_US * self->slowness);
}

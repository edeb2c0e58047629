/* SPDX-License-Identifier: Apache-2.0 */
#include "supervisor/options.h"

#include "common/command_line.h"
#include "common/config_file.h"
#include "robot/app/robot_names.h"
#include "supervisor/board_text.h"

#include <arpa/inet.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define NAME_MAX_LENGTH 32U
#define PORT_MAX 65535U
#define OPTIONS_ERROR_SIZE 1024U
#define MORE                                                                                       \
    "ROBOT, HTTP_PORT, BRP_PORT, IGTL_PORT, IGTL_FILE, ACCOUNTS and TLS_FILE in the\n"             \
    "environment do the same as the options of these names, which win.\n\n"                        \
    "Exit code 0: stopped as asked, nothing is lacking, or at rest. 1: the check\n"                \
    "found something, or not at rest. 2: wrong option. 3: could not start. 4: control\n"           \
    "or a program of the board ended by itself.\n"

/* With every board; those of the board follow. */
enum {
    ROBOT = 0,
    INSTANCE,
    HTTP_PORT,
    BRP_PORT,
    IGTL_PORT,
    IGTL_FILE,
    BIND,
    ACCOUNTS,
    TLS_FILE,
    TRAJECTORY,
    RECORDINGS,
    CONFIG,
    CHECK,
    AT_REST,
    STOP_AT_REST,
    COMMON
};

static const command_option_t common[COMMON] = {
    [ROBOT] = {"robot", "NAME", .says = "the robot; default " ROBOT_NAMES_DEFAULT},
    [INSTANCE] = {"instance", "NAME", .says = "name of this one of several; default boresight"},
    [HTTP_PORT] = {"http-port", "PORT", .says = "of the console; default 8080", .least = 1U,
                   .most = PORT_MAX},
    [BRP_PORT] = {"brp-port", "PORT", .says = "of OpenIGTLink workphases; default 18936",
                  .least = 1U, .most = PORT_MAX},
    [IGTL_PORT] = {"igtl-port", "PORT", .says = "of OpenIGTLink transforms; default 18944",
                   .least = 1U, .most = PORT_MAX},
    [IGTL_FILE] = {"igtl-file", "FILE", .says = "all OpenIGTLink ports, in place of the two"},
    [BIND] = {"bind", "ADDRESS", .says = "IPv4 address to listen on; default 127.0.0.1"},
    [ACCOUNTS] = {"accounts", "FILE", .says = "who may log in; boresight-passwd makes it"},
    [TLS_FILE] = {"tls-file", "FILE", .says = "how TLS leads here from other machines"},
    [TRAJECTORY] = {"trajectory", "FILE", .says = "trajectory that is held from the start"},
    [RECORDINGS] = {"recordings", "FOLDER",
                    .says = "where recordings go; default build/recordings"},
    [CONFIG] = {"config", "FILE", .says = "further options, one in each line; no default",
                .is_by_hand = true},
    [CHECK] = {"check", .says = "say what the computer lacks for real time, and end",
               .is_by_hand = true},
    [AT_REST] = {"at-rest", .says = "say whether this instance may be replaced now, and end",
                 .is_by_hand = true},
    [STOP_AT_REST] = {"stop-at-rest", .says = "the same, and stop it if it may, in one step",
                      .is_by_hand = true},
};

/* Its texts live as long as the options. */
static config_file_t config;

uint32_t options_slowness(const options_t *self)
{
    char text[BOARD_VALUE_SIZE];

    (void)board_text_write(text, sizeof text, board.slowness, self);
    const unsigned long slowness = strtoul(text, NULL, 10);
    return (slowness > 1U) ? (uint32_t)slowness : 1U;
}

bool options_has(const options_t *self, const char *name)
{
    bool has_it = false;

    for (size_t i = 0U; (name != NULL) && (i < BOARD_OPTIONS); i++) {
        const bool is_it =
            (board.options[i].name != NULL) && (strcmp(board.options[i].name, name) == 0);
        has_it = has_it || (is_it && self->is_given[i]);
    }
    return has_it;
}

static const char *from_environment(const char *name, const char *otherwise)
{
    const char *value = getenv(name);

    return ((value != NULL) && (value[0] != '\0')) ? value : otherwise;
}

static bool find_programs(options_t *self)
{
    const ssize_t length = readlink("/proc/self/exe", self->programs, sizeof self->programs - 1U);

    if (length <= 0) {
        return false;
    }
    self->programs[length] = '\0';
    char *slash = strrchr(self->programs, '/');
    *slash = '\0';
    return true;
}

static void set_defaults(options_t *self)
{
    self->http_port = from_environment("HTTP_PORT", "8080");
    self->igtl_port = from_environment("IGTL_PORT", "18944");
    self->brp_port = from_environment("BRP_PORT", "18936");
    self->igtl_file = from_environment("IGTL_FILE", NULL);
    self->accounts = from_environment("ACCOUNTS", NULL);
    self->tls_file = from_environment("TLS_FILE", NULL);
    self->robot = from_environment("ROBOT", ROBOT_NAMES_DEFAULT);
    self->bind = "127.0.0.1";
    self->instance = "boresight";
    /* build/bin/boresight records into build/recordings, wherever it is started. */
    const char *slash = strrchr(self->programs, '/');
    (void)snprintf(self->recordings, sizeof self->recordings, "%.*s/recordings",
                   (slash != NULL) ? (int)(slash - self->programs) : 0, self->programs);
}

static bool is_name(const char *text)
{
    const size_t length = strlen(text);

    return (length > 0U) && (length <= NAME_MAX_LENGTH) &&
           (strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_") ==
            length);
}

static bool check_of_the_board(const options_t *self, size_t place, char *error,
                               uint32_t error_size)
{
    const board_option_t *const option = &board.options[place];
    const char *const value = self->board[place];

    if ((option->takes == BOARD_TAKES_NAME) && !is_name(value)) {
        (void)snprintf(error, error_size,
                       "\"%s\" is no name for --%s; use up to %u letters, digits, - and _.", value,
                       option->name, NAME_MAX_LENGTH);
        return false;
    }
    if (options_has(self, option->useless_with)) {
        (void)snprintf(error, error_size,
                       "--%s is of no use with --%s; give it to what runs already.", option->name,
                       option->useless_with);
        return false;
    }
    return true;
}

/* A given option must be right; each other has the board's value. */
static bool complete(options_t *self, char *error, uint32_t error_size)
{
    for (size_t i = 0U; i < BOARD_OPTIONS; i++) {
        const char *const otherwise = board.options[i].otherwise;
        if (self->is_given[i] && !check_of_the_board(self, i, error, error_size)) {
            return false;
        }
        if (!self->is_given[i] && (otherwise != NULL)) {
            (void)board_text_write(self->board[i], sizeof self->board[i], otherwise, self);
        }
    }
    return true;
}

static bool check_ports(const options_t *self, char *error, uint32_t error_size)
{
    const char *const ports[] = {self->http_port, self->igtl_port, self->brp_port};

    for (size_t i = 0U; i < 3U; i++) {
        if (!command_line_is_number(ports[i], 1U, PORT_MAX)) {
            (void)snprintf(error, error_size, "\"%s\" is no port; give a number from 1 to 65535.",
                           ports[i]);
            return false;
        }
        for (size_t k = 0U; k < i; k++) {
            if (strtoul(ports[i], NULL, 10) == strtoul(ports[k], NULL, 10)) {
                (void)snprintf(error, error_size,
                               "Port %s is given twice; give each service its own.", ports[i]);
                return false;
            }
        }
    }
    return true;
}

static bool check(const options_t *self, char *error, uint32_t error_size)
{
    struct in_addr address;

    if (inet_pton(AF_INET, self->bind, &address) != 1) {
        (void)snprintf(error, error_size,
                       "\"%s\" is no IPv4 address; give --bind one of this machine.", self->bind);
        return false;
    }
    if (!robot_names_has(self->robot)) {
        (void)snprintf(error, error_size,
                       "There is no robot \"%s\"; choose %s with --robot or ROBOT.", self->robot,
                       robot_names_list());
        return false;
    }
    if (!is_name(self->instance)) {
        (void)snprintf(error, error_size,
                       "\"%s\" names no instance; use up to %u letters, digits, - and _.",
                       self->instance, NAME_MAX_LENGTH);
        return false;
    }
    return check_ports(self, error, error_size);
}

static const char *either(const char *value, const char *otherwise)
{
    return (value != NULL) ? value : otherwise;
}

static bool copy(char *text, size_t size, const char *value)
{
    return (value == NULL) || ((size_t)snprintf(text, size, "%s", value) < size);
}

/* A given value wins. False when a value is too long. */
static bool take(options_t *self, const char *const values[])
{
    bool has_room = copy(self->recordings, sizeof self->recordings, values[RECORDINGS]);

    self->robot = either(values[ROBOT], self->robot);
    self->instance = either(values[INSTANCE], self->instance);
    self->http_port = either(values[HTTP_PORT], self->http_port);
    self->brp_port = either(values[BRP_PORT], self->brp_port);
    self->igtl_port = either(values[IGTL_PORT], self->igtl_port);
    self->igtl_file = either(values[IGTL_FILE], self->igtl_file);
    self->bind = either(values[BIND], self->bind);
    self->accounts = either(values[ACCOUNTS], self->accounts);
    self->tls_file = either(values[TLS_FILE], self->tls_file);
    self->is_check = values[CHECK] != NULL;
    self->stops_at_rest = values[STOP_AT_REST] != NULL;
    self->asks_for_rest = self->stops_at_rest || (values[AT_REST] != NULL);
    self->trajectory = either(values[TRAJECTORY], self->trajectory);
    for (size_t i = 0U; i < BOARD_OPTIONS; i++) {
        self->is_given[i] = values[COMMON + i] != NULL;
        has_room = copy(self->board[i], sizeof self->board[i], values[COMMON + i]) && has_room;
    }
    return has_room;
}

static uint32_t list_known(command_option_t known[COMMON + BOARD_OPTIONS])
{
    static const char *const values[] = {[BOARD_TAKES_NOTHING] = NULL,
                                         [BOARD_TAKES_NAME] = "NAME",
                                         [BOARD_TAKES_NUMBER] = "NUMBER",
                                         [BOARD_TAKES_TEXT] = "TEXT"};
    uint32_t count = COMMON;

    (void)memcpy(known, common, sizeof common);
    for (size_t i = 0U; (i < BOARD_OPTIONS) && (board.options[i].name != NULL); i++) {
        const board_option_t *const option = &board.options[i];
        known[count] = (command_option_t){option->name, values[option->takes], .says = option->says,
                                          .least = option->least, .most = option->most};
        count++;
    }
    return count;
}

int options_read(options_t *self, int count, char *const arguments[])
{
    command_option_t known[COMMON + BOARD_OPTIONS];
    const char *values[COMMON + BOARD_OPTIONS] = {NULL};
    const command_line_t command_line = {
        .program = "boresight",
        .says = "Starts all programs of Boresight, watches them, and stops them in order.",
        .usage = "[OPTION...]",
        .options = known,
        .count = list_known(known),
        .more = MORE};
    int code = command_line_read(&command_line, count, arguments, values, NULL);
    char error[OPTIONS_ERROR_SIZE] = "Something is too long; use shorter names.";

    if ((code == COMMAND_LINE_GO_ON) && (values[CONFIG] != NULL)) {
        code = config_file_read(&config, values[CONFIG], &command_line, values);
    }
    if (code != COMMAND_LINE_GO_ON) {
        return code;
    }
    (void)memset(self, 0, sizeof *self);
    if (!find_programs(self)) {
        return command_line_refuse(&command_line,
                                   "The program does not find its own place; mount /proc.");
    }
    set_defaults(self);
    if (!take(self, values) || !check(self, error, sizeof error) ||
        !complete(self, error, sizeof error)) {
        return command_line_refuse(&command_line, "%s", error);
    }
    if ((self->igtl_file != NULL) &&
        !igtl_ports_read(&self->ports, self->igtl_file, error, sizeof error)) {
        (void)fprintf(stderr, "boresight: %s\n", error);
        return COMMAND_LINE_WRONG;
    }
    return COMMAND_LINE_GO_ON;
}

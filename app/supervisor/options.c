/* SPDX-License-Identifier: Apache-2.0 */
#include "supervisor/options.h"

#include "robot/app/robot_names.h"
#include "supervisor/board_text.h"

#include <arpa/inet.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define NAME_MAX_LENGTH 32U
#define PORT_MAX 65535U
#define COMMON_OPTIONS 11U
#define OF_THE_BOARD 256 /* Its options are numbered from here on. */

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

void options_print_usage(void)
{
    static const char *const words[] = {
        [BOARD_TAKES_NOTHING] = "",
        [BOARD_TAKES_NAME] = " NAME",
        [BOARD_TAKES_NUMBER] = " NUMBER",
        [BOARD_TAKES_TEXT] = " TEXT",
    };

    (void)fputs(
        "usage: boresight [--http-port 8080] [--igtl-port 18944] [--brp-port 18936] [--bind "
        "127.0.0.1]\n"
        "                 [--igtl-file FILE] [--accounts FILE] [--tls-file FILE]\n"
        "                 [--trajectory FILE]\n"
        "                 [--robot " ROBOT_NAMES_DEFAULT
        "] [--instance NAME] [--recordings DIRECTORY]\n"
        "                ",
        stdout);
    for (size_t i = 0U; (i < BOARD_OPTIONS) && (board.options[i].name != NULL); i++) {
        (void)printf(" [--%s%s]", board.options[i].name, words[board.options[i].takes]);
    }
    (void)fputs("\nThe environment variables HTTP_PORT, IGTL_PORT, BRP_PORT, IGTL_FILE, ACCOUNTS, "
                "TLS_FILE and ROBOT do the "
                "same.\n",
                stdout);
}

static void list_known(struct option known[COMMON_OPTIONS + BOARD_OPTIONS + 1U])
{
    static const struct option common[COMMON_OPTIONS] = {
        {"http-port", required_argument, NULL, 'h'},  {"igtl-port", required_argument, NULL, 'i'},
        {"brp-port", required_argument, NULL, 'w'},   {"bind", required_argument, NULL, 'b'},
        {"robot", required_argument, NULL, 'r'},      {"instance", required_argument, NULL, 'n'},
        {"recordings", required_argument, NULL, 'd'}, {"igtl-file", required_argument, NULL, 'f'},
        {"accounts", required_argument, NULL, 'a'},   {"tls-file", required_argument, NULL, 't'},
        {"trajectory", required_argument, NULL, 'l'},
    };

    (void)memset(known, 0, (COMMON_OPTIONS + BOARD_OPTIONS + 1U) * sizeof known[0]);
    (void)memcpy(known, common, sizeof common);
    for (size_t i = 0U; i < BOARD_OPTIONS; i++) {
        const board_option_t *const option = &board.options[i];
        known[COMMON_OPTIONS + i].name = option->name;
        known[COMMON_OPTIONS + i].has_arg =
            (option->takes == BOARD_TAKES_NOTHING) ? no_argument : required_argument;
        known[COMMON_OPTIONS + i].val = OF_THE_BOARD + (int)i;
    }
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

/* An option that takes nothing stands for itself. */
static bool take_of_the_board(options_t *self, size_t place, const char *value)
{
    const board_option_t *const option = &board.options[place];
    const bool is_flag = option->takes == BOARD_TAKES_NOTHING;

    self->is_given[place] = true;
    return (size_t)snprintf(self->board[place], sizeof self->board[place], "%s%s",
                            is_flag ? "--" : "",
                            is_flag ? option->name : value) < sizeof self->board[place];
}

static bool take(options_t *self, int option, const char *value)
{
    if (option >= OF_THE_BOARD) {
        return take_of_the_board(self, (size_t)(option - OF_THE_BOARD), value);
    }
    switch (option) {
    case 'h':
        self->http_port = value;
        return true;
    case 'i':
        self->igtl_port = value;
        return true;
    case 'w':
        self->brp_port = value;
        return true;
    case 'b':
        self->bind = value;
        return true;
    case 't':
        self->tls_file = value;
        return true;
    case 'a':
        self->accounts = value;
        return true;
    case 'f':
        self->igtl_file = value;
        return true;
    case 'l':
        self->trajectory = value;
        return true;
    case 'r':
        self->robot = value;
        return true;
    case 'n':
        self->instance = value;
        return true;
    case 'd':
        return (size_t)snprintf(self->recordings, sizeof self->recordings, "%s", value) <
               sizeof self->recordings;
    default:
        return false;
    }
}

static bool is_number(const char *text, unsigned long minimum, unsigned long maximum)
{
    char *end = NULL;
    const unsigned long number = strtoul(text, &end, 10);

    return (text[0] >= '0') && (text[0] <= '9') && (*end == '\0') && (number >= minimum) &&
           (number <= maximum);
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
    if ((option->takes == BOARD_TAKES_NUMBER) && !is_number(value, option->least, option->most)) {
        (void)snprintf(error, error_size, "\"%s\" is no number for --%s; give one from %u to %u.",
                       value, option->name, (unsigned)option->least, (unsigned)option->most);
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

/* What was given must be right; what was not is as the board says. */
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
        if (!is_number(ports[i], 1U, PORT_MAX)) {
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

bool options_read(options_t *self, int count, char **arguments, char *error, uint32_t error_size)
{
    struct option known[COMMON_OPTIONS + BOARD_OPTIONS + 1U];

    (void)memset(self, 0, sizeof *self);
    if (!find_programs(self)) {
        (void)snprintf(error, error_size, "The program does not find its own place; mount /proc.");
        return false;
    }
    set_defaults(self);
    list_known(known);
    opterr = 0;
    int option = getopt_long(count, arguments, "", known, NULL);
    while (option != -1) {
        if (!take(self, option, optarg)) {
            (void)snprintf(error, error_size,
                           "\"%s\" is no option or lacks its value; see boresight --help.",
                           arguments[optind - 1]);
            return false;
        }
        option = getopt_long(count, arguments, "", known, NULL);
    }
    if (optind != count) {
        (void)snprintf(error, error_size, "\"%s\" is no option; see boresight --help.",
                       arguments[optind]);
        return false;
    }
    return check(self, error, error_size) && complete(self, error, error_size) &&
           ((self->igtl_file == NULL) ||
            igtl_ports_read(&self->ports, self->igtl_file, error, error_size));
}

/* SPDX-License-Identifier: Apache-2.0 */
#include "supervisor/options.h"

#include "limits/requirement_limits.h"
#include "robot/app/robot_names.h"

#include <arpa/inet.h>
#include <getopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define NAME_MAX_LENGTH 32U
#define PORT_MAX 65535U

static const struct option known[] = {{"http-port", required_argument, NULL, 'h'},
                                      {"igtl-port", required_argument, NULL, 'i'},
                                      {"brp-port", required_argument, NULL, 'w'},
                                      {"bind", required_argument, NULL, 'b'},
                                      {"robot", required_argument, NULL, 'r'},
                                      {"instance", required_argument, NULL, 'n'},
                                      {"recordings", required_argument, NULL, 'd'},
                                      {"slow", required_argument, NULL, 's'},
                                      {"real-time", no_argument, NULL, 't'},
                                      {"box", required_argument, NULL, 'x'},
                                      {NULL, 0, NULL, 0}};

uint32_t options_slowness(const options_t *self)
{
    return (uint32_t)strtoul(self->slowness, NULL, 10);
}

const char *options_usage(void)
{
    return "usage: boresight [--http-port 8080] [--igtl-port 18944] [--brp-port 18936] [--bind "
           "127.0.0.1]\n"
           "                 [--robot " ROBOT_NAMES_DEFAULT
           "] [--instance NAME] [--recordings DIRECTORY]\n"
           "                 [--slow TIMES] [--real-time] | [--box NAME]\n"
           "The environment variables HTTP_PORT, IGTL_PORT, BRP_PORT and ROBOT do the same.\n";
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
    self->robot = from_environment("ROBOT", ROBOT_NAMES_DEFAULT);
    self->bind = "127.0.0.1";
    self->instance = "boresight";
    self->slowness = "1";
    /* build/bin/boresight records into build/recordings, wherever it is started. */
    const char *slash = strrchr(self->programs, '/');
    (void)snprintf(self->recordings, sizeof self->recordings, "%.*s/recordings",
                   (slash != NULL) ? (int)(slash - self->programs) : 0, self->programs);
}

static bool take(options_t *self, int option, const char *value)
{
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
    case 'r':
        self->robot = value;
        return true;
    case 'n':
        self->instance = value;
        return true;
    case 's':
        self->slowness = value;
        return true;
    case 'x':
        self->box = value;
        return true;
    case 't':
        self->is_real_time = true;
        return true;
    case 'd':
        return (size_t)snprintf(self->recordings, sizeof self->recordings, "%s", value) <
               sizeof self->recordings;
    default:
        return false;
    }
}

static bool is_number(const char *text, unsigned long maximum)
{
    char *end = NULL;
    const unsigned long number = strtoul(text, &end, 10);

    return (text[0] >= '0') && (text[0] <= '9') && (*end == '\0') && (number >= 1U) &&
           (number <= maximum);
}

static bool is_name(const char *text)
{
    const size_t length = strlen(text);

    return (length > 0U) && (length <= NAME_MAX_LENGTH) &&
           (strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_") ==
            length);
}

/* The box that runs already has its time. */
static bool check_box(const options_t *self, char *error, uint32_t error_size)
{
    if (self->box == NULL) {
        return true;
    }
    if (!is_name(self->box)) {
        (void)snprintf(error, error_size,
                       "\"%s\" names no box; use up to %u letters, digits, - and _.", self->box,
                       NAME_MAX_LENGTH);
        return false;
    }
    if (self->is_real_time || (options_slowness(self) != 1U)) {
        (void)snprintf(error, error_size,
                       "--slow and --real-time are of no use with --box; give them to the box.");
        return false;
    }
    return true;
}

static bool check_ports(const options_t *self, char *error, uint32_t error_size)
{
    const char *const ports[] = {self->http_port, self->igtl_port, self->brp_port};

    for (size_t i = 0U; i < 3U; i++) {
        if (!is_number(ports[i], PORT_MAX)) {
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
    if (!is_number(self->slowness, LIMIT_BOX_SLOWEST)) {
        (void)snprintf(error, error_size, "\"%s\" is no slowness; give --slow 1 to %u.",
                       self->slowness, LIMIT_BOX_SLOWEST);
        return false;
    }
    return check_box(self, error, error_size) && check_ports(self, error, error_size);
}

bool options_read(options_t *self, int count, char **arguments, char *error, uint32_t error_size)
{
    (void)memset(self, 0, sizeof *self);
    if (!find_programs(self)) {
        (void)snprintf(error, error_size, "The program does not find its own place; mount /proc.");
        return false;
    }
    set_defaults(self);
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
    return check(self, error, error_size);
}

/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A crowd at the HTTP server, served by one thread: everyone does one thing, and begins again when
 * it is done or refused.
 *
 *     bench-crowd PORT CONSOLES LAZY COMERS HALVES GUESSERS STOPPERS
 *
 * How many there are of each: consoles read the stream of events and look for gaps in it, and come
 * before all others; the lazy ask for it and read nothing; comers ask for the state without a
 * pause; halves send half a request, every second one for STOP; guessers try passwords; stoppers
 * ask for STOP, in turn with the body at once, apart, or held back until the server asks for them.
 * "begun" is printed when each has come, and at the end of the standard input one line of JSON: of
 * each kind how many were answered, refused and dropped, and of the consoles the events heard and
 * missed.
 */
#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <poll.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#define CROWD_MOST 1024U
#define HEAD_SIZE 2560U
#define LINE_SIZE 16U
#define PAUSE_MS 50U /* Before a client that was refused or dropped comes again. */
#define LAZY_BYTES 4096

typedef enum {
    KIND_CONSOLE = 0,
    KIND_LAZY = 1,
    KIND_COMER = 2,
    KIND_HALF = 3,
    KIND_GUESSER = 4,
    KIND_STOPPER = 5
} kind_t;

#define KINDS 6U

static const char *const kind_names[KINDS] = {"consoles", "lazy",     "comers",
                                              "halves",   "guessers", "stoppers"};
static const char stop_body[] = "{}";
static const char go_on[] = "HTTP/1.1 100 Continue\r\n\r\n";

typedef struct {
    kind_t kind;
    int socket; /* -1: it waits to come again. */
    uint64_t again_ms;
    bool has_come; /* At least once. */
    bool has_asked;
    bool owes_body;   /* Stop whose head alone has been sent. */
    bool holds_body;  /* It waits for the server to ask for the body. */
    bool is_answered; /* The head has come; it states `status` and, of the body, `left`. */
    unsigned status;
    size_t left;
    size_t head_size;
    char head[HEAD_SIZE];
    size_t line_size; /* Beginning of the present line of a stream. */
    char line[LINE_SIZE];
    bool has_event;
    unsigned event; /* The last one heard. */
} client_t;

static client_t clients[CROWD_MOST];
static size_t count;
static size_t consoles;
static size_t have_come;
static struct sockaddr_in server = {.sin_family = AF_INET};
static struct {
    unsigned answered[KINDS];
    unsigned refused[KINDS];
    unsigned dropped[KINDS];
    unsigned events;
    unsigned missed;
    unsigned guesses;
} seen;

static uint64_t now_ms(void)
{
    struct timespec now;

    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return ((uint64_t)now.tv_sec * 1000U) + ((uint64_t)now.tv_nsec / 1000000U);
}

/* At once, and without a trace in the kernel, or the numbers of ports would run out. */
static void leave(client_t *self, uint64_t pause_ms)
{
    const struct linger at_once = {.l_onoff = 1, .l_linger = 0};

    (void)setsockopt(self->socket, SOL_SOCKET, SO_LINGER, &at_once, (socklen_t)sizeof at_once);
    (void)close(self->socket);
    self->socket = -1;
    self->again_ms = now_ms() + pause_ms;
}

static void come(client_t *self)
{
    const int bytes = LAZY_BYTES;

    self->socket = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
    self->has_asked = false;
    if (self->kind == KIND_LAZY) {
        (void)setsockopt(self->socket, SOL_SOCKET, SO_RCVBUF, &bytes, (socklen_t)sizeof bytes);
    }
    if ((connect(self->socket, (const struct sockaddr *)&server, (socklen_t)sizeof server) != 0) &&
        (errno != EINPROGRESS)) {
        leave(self, PAUSE_MS);
    }
}

static int write_guess(char *text, size_t size, const char *host)
{
    char body[96];
    const int length = snprintf(body, sizeof body, "{\"name\":\"guest%u\",\"password\":\"%u\"}",
                                seen.guesses % 100U, seen.guesses);

    seen.guesses++;
    return snprintf(text, size,
                    "POST /api/v1/session HTTP/1.1\r\n%sContent-Type: application/json\r\n"
                    "Content-Length: %d\r\nConnection: close\r\n\r\n%s",
                    host, length, body);
}

static int write_request(const client_t *self, char *text, size_t size)
{
    char host[64];
    char last[64] = "";
    int length = 0;

    (void)snprintf(host, sizeof host, "Host: 127.0.0.1:%u\r\n", (unsigned)ntohs(server.sin_port));
    if (self->has_event) {
        (void)snprintf(last, sizeof last, "Last-Event-ID: %u\r\n", self->event);
    }
    switch (self->kind) {
    case KIND_CONSOLE:
    case KIND_LAZY:
        length = snprintf(text, size, "GET /api/v1/events HTTP/1.1\r\n%s%s\r\n", host, last);
        break;
    case KIND_COMER:
        length = snprintf(text, size, "GET /api/v1/status HTTP/1.1\r\n%s\r\n", host);
        break;
    case KIND_HALF:
        length = snprintf(text, size, "%s HTTP/1.1\r\nHost: ",
                          ((self - clients) % 2) != 0 ? "GET /api/v1/status" : "POST /api/v1/stop");
        break;
    case KIND_STOPPER:
        length =
            snprintf(text, size, "POST /api/v1/stop HTTP/1.1\r\n%sContent-Length: 2\r\n%s\r\n%s",
                     host, self->holds_body ? "Expect: 100-continue\r\n" : "",
                     (self->owes_body || self->holds_body) ? "" : stop_body);
        break;
    case KIND_GUESSER:
    default:
        length = write_guess(text, size, host);
        break;
    }
    return length;
}

static void ask(client_t *self)
{
    char text[512];
    const unsigned turn = (self->kind == KIND_STOPPER) ? (seen.answered[KIND_STOPPER] % 3U) : 0U;
    self->owes_body = turn == 1U;
    self->holds_body = turn == 2U;
    const int length = write_request(self, text, sizeof text);

    self->has_asked = true;
    self->is_answered = false;
    self->head_size = 0U;
    self->line_size = 0U;
    if (send(self->socket, text, (size_t)length, MSG_NOSIGNAL) != (ssize_t)length) {
        seen.dropped[self->kind]++;
        leave(self, PAUSE_MS);
    }
}

static void hear_line(client_t *self)
{
    unsigned number = 0U;

    self->line[(self->line_size < LINE_SIZE) ? self->line_size : (LINE_SIZE - 1U)] = '\0';
    self->line_size = 0U;
    if (sscanf(self->line, "id: %u", &number) != 1) {
        return;
    }
    if (self->has_event && (number != (self->event + 1U))) {
        seen.missed++;
    }
    seen.events++;
    self->has_event = true;
    self->event = number;
}

static void hear_stream(client_t *self, const char *bytes, size_t size)
{
    for (size_t i = 0U; i < size; i++) {
        if (bytes[i] == '\n') {
            hear_line(self);
        } else if (self->line_size < LINE_SIZE) {
            self->line[self->line_size] = bytes[i];
            self->line_size++;
        } else {
            /* The rest of a line is not needed. */
        }
    }
}

/* The whole answer has come. */
static void finish(client_t *self)
{
    const bool is_good = self->status == 200U;

    seen.answered[self->kind] += is_good ? 1U : 0U;
    seen.refused[self->kind] += is_good ? 0U : 1U;
    leave(self, (self->kind == KIND_CONSOLE) ? PAUSE_MS : 0U);
}

static void hear_body(client_t *self, const char *bytes, size_t size)
{
    if ((self->kind == KIND_CONSOLE) && (self->status == 200U)) {
        hear_stream(self, bytes, size);
        return;
    }
    self->left -= (size < self->left) ? size : self->left;
    if (self->left == 0U) {
        finish(self);
    }
}

static void hear_head(client_t *self, const char *bytes, size_t size)
{
    const size_t room = (HEAD_SIZE - 1U) - self->head_size;
    const size_t taken = (size < room) ? size : room;

    (void)memcpy(&self->head[self->head_size], bytes, taken);
    self->head_size += taken;
    self->head[self->head_size] = '\0';
    const char *end = strstr(self->head, "\r\n\r\n");
    if (end == NULL) {
        return;
    }
    if (self->holds_body) { /* The first answer is all that has come. */
        self->holds_body = false;
        self->owes_body = strcmp(self->head, go_on) == 0;
        self->head_size = self->owes_body ? 0U : self->head_size;
    }
    if (self->owes_body) {
        return;
    }
    const char *length = strcasestr(self->head, "\r\nContent-Length: ");
    const size_t before = self->head_size - taken;
    const size_t of_head = (size_t)(end + 4 - self->head) - before;

    self->is_answered = true;
    self->status = (unsigned)strtoul(&self->head[9], NULL, 10);
    self->left = (length != NULL) ? (size_t)strtoul(&length[18], NULL, 10) : 0U;
    if ((self->kind == KIND_CONSOLE) && (self->status == 200U)) {
        seen.answered[KIND_CONSOLE]++;
    }
    hear_body(self, &bytes[of_head], size - of_head);
}

static void hear(client_t *self)
{
    static char bytes[65536];
    const ssize_t size = recv(self->socket, bytes, sizeof bytes, MSG_DONTWAIT);

    if (size > 0) {
        if (self->is_answered) {
            hear_body(self, bytes, (size_t)size);
        } else {
            hear_head(self, bytes, (size_t)size);
        }
    } else if ((size == 0) || (errno != EAGAIN)) {
        seen.dropped[self->kind]++;
        leave(self, (self->kind == KIND_HALF) ? 0U : PAUSE_MS);
    } else {
        /* Nothing has come. */
    }
}

static void send_body(client_t *self)
{
    self->owes_body = false;
    (void)send(self->socket, stop_body, sizeof stop_body - 1U, MSG_NOSIGNAL);
}

static void attend(client_t *self, short events)
{
    if (!self->has_asked) {
        ask(self);
    } else if (self->owes_body) {
        send_body(self);
    } else if ((self->kind == KIND_LAZY) && (events != 0)) {
        seen.dropped[KIND_LAZY]++;
        leave(self, PAUSE_MS);
    } else {
        hear(self);
    }
}

/* Lazy clients notice only that the server closes. */
static short awaited(const client_t *self)
{
    if (!self->has_asked || self->owes_body) {
        return POLLOUT;
    }
    return (self->kind == KIND_LAZY) ? POLLRDHUP : POLLIN;
}

static bool take_turn(void)
{
    static struct pollfd events[CROWD_MOST + 1U];
    const uint64_t turn_ms = now_ms();
    const size_t present = (seen.answered[KIND_CONSOLE] < consoles) ? consoles : count;

    for (size_t i = 0U; i < count; i++) {
        if ((i < present) && (clients[i].socket < 0) && (turn_ms >= clients[i].again_ms)) {
            come(&clients[i]);
            have_come += clients[i].has_come ? 0U : 1U;
            clients[i].has_come = true;
        }
        events[i] = (struct pollfd){.fd = clients[i].socket, .events = awaited(&clients[i])};
    }
    events[count] = (struct pollfd){.fd = STDIN_FILENO, .events = POLLIN};
    (void)poll(events, count + 1U, 10);
    for (size_t i = 0U; i < count; i++) {
        if ((clients[i].socket >= 0) && (events[i].revents != 0)) {
            attend(&clients[i], events[i].revents);
        }
    }
    return events[count].revents == 0;
}

static void report(void)
{
    for (size_t i = 0U; i < KINDS; i++) {
        (void)printf("%s\"%s\": {\"answered\": %u, \"refused\": %u, \"dropped\": %u}",
                     (i == 0U) ? "{" : ", ", kind_names[i], seen.answered[i], seen.refused[i],
                     seen.dropped[i]);
    }
    (void)printf(", \"events\": %u, \"missed\": %u}\n", seen.events, seen.missed);
}

int main(int argument_count, char **arguments)
{
    if (argument_count != (int)(KINDS + 2U)) {
        (void)fputs("usage: bench-crowd PORT CONSOLES LAZY COMERS HALVES GUESSERS "
                    "STOPPERS\n",
                    stderr);
        return 1;
    }
    server.sin_port = htons((uint16_t)strtoul(arguments[1], NULL, 10));
    server.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    for (size_t kind = 0U; kind < KINDS; kind++) {
        const size_t wanted = strtoul(arguments[kind + 2U], NULL, 10);
        for (size_t i = 0U; (i < wanted) && (count < CROWD_MOST); i++) {
            clients[count].kind = (kind_t)kind;
            clients[count].socket = -1;
            count++;
        }
    }
    consoles = strtoul(arguments[2], NULL, 10);
    bool goes_on = true;
    while (goes_on && (have_come < count)) {
        goes_on = take_turn();
    }
    (void)puts("begun");
    (void)fflush(stdout);
    while (goes_on) {
        goes_on = take_turn();
    }
    report();
    return 0;
}

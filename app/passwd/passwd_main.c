/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * boresight-passwd: makes, changes and removes accounts.
 *
 * @satisfies SWR-SESS-004
 * @satisfies SWR-SESS-024
 */
#include "common/command_line.h"
#include "limits/requirement_limits.h"
#include "http/login/account.h"
#include "http/login/password.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <termios.h>
#include <unistd.h>

#define PATH_SIZE 512U

static const command_line_t command_line = {
    .program = "boresight-passwd",
    .says = "Makes, changes and removes the accounts of those who may log in to the console.",
    .usage = "FILE set NAME ROLE\nFILE remove NAME\nFILE list",
    .fewest_words = 2,
    .most_words = 4,
    .more = "ROLE is observer, operator, engineer or service. A new password is asked for, or\n"
            "read from the standard input.\n\n"
            "Exit code 0: done. 1: refused, and nothing has changed. 2: wrong command line.\n"};

static char error[PATH_SIZE + 64U];
static struct termios shown; /* As the terminal was. */

static int complain(const char *sentence)
{
    (void)fprintf(stderr, "boresight-passwd: %s\n", sentence);
    return EXIT_FAILURE;
}

/* Gives the terminal back and ends as without us: the action is the default one again. */
static void show_typing_and_end(int number)
{
    (void)tcsetattr(STDIN_FILENO, TCSANOW, &shown);
    (void)raise(number);
}

static void hide_typing(void)
{
    static const int ends[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
    const struct sigaction action = {.sa_handler = show_typing_and_end,
                                     .sa_flags = (int)SA_RESETHAND};
    struct termios hidden;

    if (tcgetattr(STDIN_FILENO, &shown) == 0) {
        for (size_t i = 0U; i < (sizeof ends / sizeof ends[0]); i++) {
            (void)sigaction(ends[i], &action, NULL);
        }
        hidden = shown;
        hidden.c_lflag &= ~(tcflag_t)ECHO;
        (void)tcsetattr(STDIN_FILENO, TCSAFLUSH, &hidden);
    }
}

/* One line, without its end. False with a sentence in `error`. */
static bool read_line(const char *question, char password[PASSWORD_SIZE])
{
    char line[PASSWORD_SIZE + 1U];
    const bool is_asked = isatty(STDIN_FILENO) == 1;

    if (is_asked) {
        (void)fputs(question, stderr);
        hide_typing();
    }
    const bool is_read = fgets(line, (int)sizeof line, stdin) != NULL;
    if (is_asked) {
        (void)tcsetattr(STDIN_FILENO, TCSANOW, &shown);
        (void)fputs("\n", stderr);
    }
    const size_t length = is_read ? strcspn(line, "\n") : 0U;
    if (length >= PASSWORD_SIZE) {
        (void)snprintf(error, sizeof error, "The password is longer than %u bytes.",
                       (unsigned)(PASSWORD_SIZE - 1U));
        return false;
    }
    if (length < LIMIT_PASSWORD_LEAST) {
        (void)snprintf(error, sizeof error, "The password is shorter than %u bytes.",
                       (unsigned)LIMIT_PASSWORD_LEAST);
        return false;
    }
    line[length] = '\0';
    (void)memcpy(password, line, length + 1U);
    explicit_bzero(line, sizeof line);
    return true;
}

static bool ask_password(char password[PASSWORD_SIZE])
{
    char again[PASSWORD_SIZE];

    if (!read_line("New password: ", password)) {
        return false;
    }
    if (isatty(STDIN_FILENO) != 1) {
        return true;
    }
    const bool is_same = read_line("Once more: ", again) && password_is_equal(password, again);
    explicit_bzero(again, sizeof again);
    if (!is_same) {
        (void)snprintf(error, sizeof error, "The two passwords differ.");
    }
    return is_same;
}

static bool set(accounts_t *accounts, const char *name, const char *role)
{
    char password[PASSWORD_SIZE];
    account_t account;

    if (!account_is_name(name) || !account_read_role(role, &account.role)) {
        (void)snprintf(error, sizeof error,
                       "A name is 1 to 31 of a-z, 0-9, - and _; a role is observer, operator, "
                       "engineer or service.");
        return false;
    }
    if (!ask_password(password)) {
        return false;
    }
    (void)snprintf(account.name, sizeof account.name, "%s", name);
    const bool is_made = password_hash(password, account.hash, sizeof account.hash);
    explicit_bzero(password, sizeof password);
    if (!is_made || !accounts_put(accounts, &account)) {
        (void)snprintf(error, sizeof error, "%s",
                       is_made ? "There are too many accounts." : "The system makes no hash.");
        return false;
    }
    return true;
}

static bool remove_account(accounts_t *accounts, const char *name)
{
    (void)snprintf(error, sizeof error, "There is no account of this name.");
    return accounts_remove(accounts, name);
}

static void list(const accounts_t *accounts)
{
    for (uint32_t i = 0U; i < accounts->count; i++) {
        (void)printf("%s %s\n", accounts->accounts[i].name,
                     account_role_word(accounts->accounts[i].role));
    }
}

/* Two at once would lose what one of them does. */
static bool lock(const char *file)
{
    char name[PATH_SIZE];

    (void)snprintf(name, sizeof name, "%s.lock", file);
    const int descriptor = open(name, O_RDWR | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR);
    if ((descriptor < 0) || (flock(descriptor, LOCK_EX) != 0)) {
        (void)snprintf(error, sizeof error, "%s cannot be locked (%s).", name, strerror(errno));
        return false;
    }
    return true; /* Until the program ends. */
}

/* A file that is not there yet has no accounts. */
static bool read_accounts(accounts_t *accounts, const char *file)
{
    accounts->count = 0U;
    return ((access(file, F_OK) != 0) && (errno == ENOENT)) ||
           accounts_read(accounts, file, error, sizeof error);
}

static int obey(const char *file, char **words, bool is_set)
{
    static accounts_t accounts;

    if (!lock(file) || !read_accounts(&accounts, file)) {
        return complain(error);
    }
    const bool is_done =
        is_set ? set(&accounts, words[1], words[2]) : remove_account(&accounts, words[1]);
    if (!is_done || !accounts_write(&accounts, file, error, sizeof error)) {
        return complain(error);
    }
    return EXIT_SUCCESS;
}

static int show(const char *file)
{
    static accounts_t accounts;

    if (!accounts_read(&accounts, file, error, sizeof error)) {
        return complain(error);
    }
    list(&accounts);
    return EXIT_SUCCESS;
}

int main(int count, char **arguments)
{
    int first;
    const int code = command_line_read(&command_line, count, arguments, NULL, &first);

    if (code != COMMAND_LINE_GO_ON) {
        return code;
    }
    const char *const file = arguments[first];
    char **const words = &arguments[first + 1];
    const int more = count - first - 2; /* After the order. */
    const bool is_set = (more == 2) && (strcmp(words[0], "set") == 0);
    const bool is_remove = (more == 1) && (strcmp(words[0], "remove") == 0);

    if ((more == 0) && (strcmp(words[0], "list") == 0)) {
        return show(file);
    }
    return (is_set || is_remove)
               ? obey(file, words, is_set)
               : command_line_refuse(&command_line, "\"%s\" is no order, or lacks something.",
                                     words[0]);
}

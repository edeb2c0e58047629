/* SPDX-License-Identifier: Apache-2.0 */
#include "supervisor/child.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#define EXIT_NOT_EXECUTED 127

/* In the child. A group of its own keeps the terminal's Ctrl-C away: the supervisor stops them in
 * order. */
static void become(const child_t *self, pid_t supervisor, int output, int errors)
{
    const char *words[CHILD_ARGUMENTS + 2U] = {self->path};
    const int nothing = open("/dev/null", O_RDONLY);
    sigset_t none;

    for (size_t i = 0U; i < CHILD_ARGUMENTS; i++) {
        words[i + 1U] = self->arguments[i];
    }
    (void)setpgid(0, 0);
    (void)prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != supervisor) {
        _exit(EXIT_NOT_EXECUTED);
    }
    (void)sigemptyset(&none);
    (void)sigprocmask(SIG_SETMASK, &none, NULL);
    (void)dup2(nothing, STDIN_FILENO);
    (void)dup2(output, STDOUT_FILENO);
    (void)dup2(errors, STDERR_FILENO);
    (void)execv(self->path, (char *const *)(uintptr_t)words);
    _exit(EXIT_NOT_EXECUTED);
}

bool child_start(child_t *self, int output, int errors, uint64_t now_us)
{
    const pid_t supervisor = getpid();
    const pid_t pid = fork();

    if (pid == 0) {
        become(self, supervisor, output, errors);
    }
    if (pid < 0) {
        return false;
    }
    self->pid = pid;
    self->started_us = now_us;
    self->beaten_us = now_us;
    self->looks = 0U;
    self->looked_us = now_us;
    self->restart_us = 0U;
    return true;
}

void child_ended(child_t *self, int status, uint64_t now_us)
{
    self->pid = 0;
    self->status = status;
    if (self->may_restart) {
        const bool was_steady = (now_us - self->started_us) >= CHILD_STEADY_US;
        if ((self->backoff_us == 0U) || was_steady) {
            self->backoff_us = CHILD_BACKOFF_FIRST_US;
        } else {
            self->backoff_us *= 2U;
        }
        if (self->backoff_us > CHILD_BACKOFF_MOST_US) {
            self->backoff_us = CHILD_BACKOFF_MOST_US;
        }
        self->restart_us = now_us + self->backoff_us;
    }
}

void child_describe_end(const child_t *self, char *text, uint32_t size)
{
    if (WIFSIGNALED(self->status)) {
        (void)snprintf(text, size, "signal %d (%s)", WTERMSIG(self->status),
                       strsignal(WTERMSIG(self->status)));
    } else {
        (void)snprintf(text, size, "exit code %d", WEXITSTATUS(self->status));
    }
}

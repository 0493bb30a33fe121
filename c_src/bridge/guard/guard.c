/* c_bridge_guard LOG PROGRAM ARGS...: keeps PROGRAM and all it starts from outliving the virtual
 * machine.
 *
 * PROGRAM gets fds 3 and 4 as they are, /dev/null as fd 0, and LOG ("-": the guard's own) as fds 1
 * and 2. It leads a process group of its own. When PROGRAM ends, or the guard is told to end
 * (SIGTERM, SIGINT, SIGHUP) or loses its parent, the whole group is killed. Exit status: PROGRAM's,
 * or 128 + its signal; 2 wrong usage. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

enum { EXIT_USAGE = 2, EXIT_NOT_STARTED = 127 };

static void redirect(int fd, const char *file, int flags) {
    const int opened = open(file, flags | O_CLOEXEC, 0666);
    if (opened < 0 || dup2(opened, fd) < 0) {
        fprintf(stderr, "c_bridge_guard: cannot open %s: %s\n", file, strerror(errno));
        _exit(EXIT_USAGE);
    }
    close(opened);
}

static void run_program(const char *log, char **command, pid_t guard, const sigset_t *signals) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != guard) {
        _exit(EXIT_NOT_STARTED);
    }
    redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
    if (strcmp(log, "-") != 0) {
        redirect(STDOUT_FILENO, log, O_WRONLY | O_CREAT | O_APPEND);
        dup2(STDOUT_FILENO, STDERR_FILENO);
    }
    sigprocmask(SIG_UNBLOCK, signals, NULL);
    execvp(command[0], command);
    fprintf(stderr, "c_bridge_guard: cannot start %s: %s\n", command[0], strerror(errno));
    _exit(EXIT_NOT_STARTED);
}

/* Waits for the end of the program, which it ends itself if it is told to. */
static int await_end(pid_t program, const sigset_t *signals) {
    int status = 0;
    for (;;) {
        siginfo_t info;
        const int number = sigwaitinfo(signals, &info);
        if (number > 0 && number != SIGCHLD) {
            kill(-program, SIGKILL);
        }
        if (waitpid(program, &status, WNOHANG) == program) {
            kill(-program, SIGKILL); /* what it left behind */
            return status;
        }
    }
}

int main(int argc, char **argv) {
    if (argc < 3) {
        fprintf(stderr,
                "usage: c_bridge_guard LOG PROGRAM ARGS... (LOG `-`: output is left alone)\n");
        return EXIT_USAGE;
    }
    signal(SIGCHLD, SIG_DFL); /* it may have been inherited as ignored */
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGCHLD);
    sigaddset(&signals, SIGTERM);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGHUP);
    sigprocmask(SIG_BLOCK, &signals, NULL);
    const pid_t parent = getppid();
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) {
        return EXIT_NOT_STARTED;
    }
    const pid_t guard = getpid();
    const pid_t program = fork();
    if (program < 0) {
        fprintf(stderr, "c_bridge_guard: cannot fork: %s\n", strerror(errno));
        return EXIT_USAGE;
    }
    if (program == 0) {
        run_program(argv[1], argv + 2, guard, &signals);
    }
    setpgid(program, program); /* whichever of the two comes first */
    close(3); /* or the other side would not see the program's end of the channel close */
    close(4);
    const int status = await_end(program, &signals);
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

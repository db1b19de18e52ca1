// interrupted.c HOW - what ^C and its kind do to a program that computes, reads, sleeps, or has no
// handler
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/wait.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

static volatile sig_atomic_t caught;
static volatile float scale = 0.5f;

// It uses the registers that the program computes with.
static void handler(int number) {
    float sum = 0;
    for (int i = 0; i < 100; ++i) sum += scale * (float)i;
    caught = sum == 2475.0f ? number : -1;
}

static void handle(int number, int flags) {
    struct sigaction action = {.sa_handler = handler, .sa_flags = flags};
    sigaction(number, &action, NULL);
}

int main(int argc, char** argv) {
    const char* how = argc > 1 ? argv[1] : "";
    char line[80];
    handle(SIGINT, strcmp(how, "reads-on") == 0 ? SA_RESTART : 0);
    puts("running");
    if (strcmp(how, "computes") == 0) {
        double a = 1, b = 3, c = 5;
        unsigned long rounds = 0;
        while (!caught) {
            a += b, b += 0.5, c += 2;
            ++rounds;
        }
        const double n = (double)rounds;
        printf("caught %d, %s\n", caught,
               b == 3 + n / 2 && c == 5 + 2 * n && a == 1 + 3 * n + n * (n - 1) / 4 ? "right"
                                                                                    : "wrong");
    } else if (strcmp(how, "reads") == 0 || strcmp(how, "reads-on") == 0) {
        const long count = read(0, line, sizeof line);
        printf("caught %d, read %ld: %s\n", caught, count, count < 0 ? strerror(errno) : "a line");
    } else if (strcmp(how, "sleeps") == 0) {
        struct timespec span = {1, 0}, left = {9, 9};
        const int result = nanosleep(&span, &left);
        printf("caught %d, %d: %s, %ld ms left\n", caught, result, strerror(errno),
               left.tv_nsec / 1000000);
    } else if (strcmp(how, "waits") == 0) {
        sigset_t blocked, before;
        sigemptyset(&blocked);
        sigaddset(&blocked, SIGINT);
        sigprocmask(SIG_BLOCK, &blocked, &before);
        const struct timespec span = {0, 50000000};
        nanosleep(&span, NULL);  // it comes meanwhile
        printf("caught %d before, ", caught);
        const int result = sigsuspend(&before);
        sigprocmask(SIG_SETMASK, NULL, &before);
        printf("%d then, %d: %s, %s\n", caught, result, strerror(errno),
               sigismember(&before, SIGINT) ? "blocked again" : "open");
    } else if (strcmp(how, "has-a-child") == 0) {
        int status;
        if (fork() == 0)
            for (;;) pause();
        wait(&status);
        printf("caught %d, the child's end: %d\n", caught, WTERMSIG(status));
    } else if (strcmp(how, "is-told") == 0) {
        sigset_t set;
        siginfo_t info;
        sigemptyset(&set);
        sigaddset(&set, SIGUSR1);
        sigprocmask(SIG_BLOCK, &set, NULL);
        sigwaitinfo(&set, &info);
        printf("caught %d, code %d, from %d\n", info.si_signo, info.si_code, (int)info.si_pid);
    } else if (strcmp(how, "takes") == 0) {
        struct termios settings;
        tcgetattr(0, &settings);
        settings.c_lflag &= ~(tcflag_t)ISIG;
        tcsetattr(0, TCSANOW, &settings);
        const long count = read(0, line, sizeof line);
        printf("read %ld, the first is %d\n", count, line[0]);
    } else {
        signal(SIGINT, SIG_DFL);
        for (;;) pause();
    }
    return 0;
}

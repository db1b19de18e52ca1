// signalfd.c - what signalfd tells of signals: one, several at once, a child's, another thread's
#include <errno.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/signalfd.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

static int file;

static void say(const char* name, long result) {
    printf("%s: %s\n", name, result < 0 ? strerror(errno) : "done");
}

// Reads up to `most` at once and prints them.
static void take(const char* name, int most) {
    struct signalfd_siginfo all[8];
    const ssize_t bytes = read(file, all, most * sizeof all[0]);
    printf("%s:", name);
    if (bytes < 0) printf(" %s", strerror(errno));
    for (int i = 0; i < (int)(bytes / (ssize_t)sizeof all[0]); ++i)
        printf(" %u code %d value %d pointer %llx %s", all[i].ssi_signo, all[i].ssi_code,
               all[i].ssi_int, (unsigned long long)all[i].ssi_ptr,
               all[i].ssi_pid == (uint32_t)getpid() ? "own;" : "other;");
    printf("\n");
}

static void look(const char* name) {
    struct pollfd entry = {file, POLLIN | POLLOUT, 0};
    const int found = poll(&entry, 1, 0);
    printf("%s: %d, %x\n", name, found, entry.revents);
}

static void* other_thread(void* main_has_looked) {
    pthread_barrier_wait(main_has_looked);
    take("the thread", 1);
    return NULL;
}

static void handle(int number) { (void)number; }

// What qemu-arm does not do as Linux: a long is 64 bits there, and it takes any size of a mask.
static int apart(void) {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGRTMIN);
    sigprocmask(SIG_BLOCK, &set, NULL);
    say("too short a mask", syscall(SYS_signalfd4, -1, &set, 4, 0));
    file = signalfd(-1, &set, 0);
    sigqueue(getpid(), SIGRTMIN, (union sigval){.sival_int = -1});
    take("below 0", 1);
    return 0;
}

int main(int count, char** words) {
    (void)words;
    if (count > 1) return apart();
    sigset_t set, one;
    setvbuf(stdout, NULL, _IOLBF, 0);
    sigemptyset(&set);
    sigaddset(&set, SIGUSR1);
    sigaddset(&set, SIGUSR2);
    sigaddset(&set, SIGCHLD);
    sigaddset(&set, SIGRTMIN + 1);
    sigaddset(&set, SIGKILL);
    sigprocmask(SIG_BLOCK, &set, NULL);

    const uint64_t no_signals = 0;
    say("no mask", syscall(SYS_signalfd4, -1, 16, 8, 0));
    say("other flags", syscall(SYS_signalfd4, -1, &no_signals, 8, 1));
    say("no file", syscall(SYS_signalfd4, 99, &no_signals, 8, 0));
    say("another file", syscall(SYS_signalfd4, 1, &no_signals, 8, 0));
    say("below -1", syscall(SYS_signalfd4, -2, &no_signals, 8, 0));
    file = signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
    say("open", file);
    char part[64];
    say("too short a read", read(file, part, sizeof part));
    say("write", write(file, part, sizeof part));
    take("none", 1);
    look("no event");

    raise(SIGUSR2);
    kill(getpid(), SIGUSR1);
    kill(getpid(), SIGUSR1);
    look("event");
    take("the own first", 8);
    look("taken");
    for (int i = 1; i <= 3; ++i) sigqueue(getpid(), SIGRTMIN + 1, (union sigval){.sival_int = i});
    take("the first two", 2);
    take("the third", 2);

    // Without SIGUSR1; one that was pending stays so.
    raise(SIGUSR1);
    sigemptyset(&one);
    sigaddset(&one, SIGUSR2);
    printf("the same: %d\n", signalfd(file, &one, 0) == file);
    take("another mask", 1);
    sigset_t pending;
    sigpending(&pending);
    printf("pending: %d\n", sigismember(&pending, SIGUSR1));
    signalfd(file, &set, 0);
    take("the first mask", 1);

    pthread_t thread;
    pthread_barrier_t main_has_looked;
    pthread_barrier_init(&main_has_looked, NULL, 2);
    pthread_create(&thread, NULL, other_thread, &main_has_looked);
    pthread_kill(thread, SIGUSR2);
    take("the first thread", 1);
    pthread_barrier_wait(&main_has_looked);
    pthread_join(thread, NULL);

    const int epoll = epoll_create1(0);
    struct epoll_event event = {.events = EPOLLIN | EPOLLET};
    epoll_ctl(epoll, EPOLL_CTL_ADD, file, &event);
    printf("by edge: %d", epoll_wait(epoll, &event, 1, 0));
    raise(SIGUSR1);
    printf(", %d", epoll_wait(epoll, &event, 1, 0));
    printf(", %d", epoll_wait(epoll, &event, 1, 0));
    raise(SIGUSR2);
    printf(", %d\n", epoll_wait(epoll, &event, 1, 0));
    take("both", 8);
    close(file);

    file = signalfd(-1, &set, 0);
    const pid_t child = fork();
    if (child == 0) {
        usleep(20000);
        _exit(3);
    }
    struct signalfd_siginfo info;
    const ssize_t bytes = read(file, &info, sizeof info);
    printf("child: %d bytes, %u code %d status %d, its number: %d\n", (int)bytes, info.ssi_signo,
           info.ssi_code, info.ssi_status, info.ssi_pid == (uint32_t)child);
    waitpid(child, NULL, 0);

    const struct itimerval soon = {{0, 0}, {0, 5000}};
    struct sigaction action = {.sa_handler = handle};
    sigaction(SIGALRM, &action, NULL);
    setitimer(ITIMER_REAL, &soon, NULL);
    take("interrupted", 1);
    return 0;
}

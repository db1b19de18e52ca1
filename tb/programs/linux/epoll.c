// epoll.c - what epoll tells of pipes, a counter and a timer: by level, by edge, once
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/timerfd.h>
#include <unistd.h>

static int epoll;

static void control(const char* name, int operation, int fd, uint32_t events) {
    struct epoll_event event = {.events = events, .data.u64 = 0x100000000ull + fd};
    const int result = epoll_ctl(epoll, operation, fd, &event);
    printf("%s: %s\n", name, result < 0 ? strerror(errno) : "done");
}

// Prints the events of each file, as the number that it has among `fds`.
static void look(const char* name, const int* fds, int count, int timeout) {
    struct epoll_event events[8];
    const int found = epoll_wait(epoll, events, 8, timeout);
    printf("%s: %d", name, found);
    for (int i = 0; i < count; ++i)
        for (int n = 0; n < found; ++n)
            if (events[n].data.u64 == 0x100000000ull + fds[i])
                printf(", %c %x", 'a' + i, events[n].events);
    printf("\n");
}

int main(void) {
    int a[2], b[2];
    char byte = 'x';
    epoll = epoll_create1(EPOLL_CLOEXEC);
    if (epoll < 0 || pipe(a) != 0 || pipe(b) != 0) return 1;
    const int counter = eventfd(0, EFD_NONBLOCK), timer = timerfd_create(CLOCK_MONOTONIC, 0);
    const int fds[] = {a[0], b[0], counter, timer, b[1]};

    look("empty", fds, 5, 0);
    control("add a", EPOLL_CTL_ADD, a[0], EPOLLIN);
    control("add a again", EPOLL_CTL_ADD, a[0], EPOLLIN);
    control("change b", EPOLL_CTL_MOD, b[0], EPOLLIN);
    control("delete b", EPOLL_CTL_DEL, b[0], 0);
    control("add itself", EPOLL_CTL_ADD, epoll, EPOLLIN);
    control("add none", EPOLL_CTL_ADD, 99, EPOLLIN);
    look("nothing to read", fds, 5, 3);
    if (write(a[1], &byte, 1) != 1) return 2;
    look("by level", fds, 5, -1);
    look("by level", fds, 5, -1);
    if (read(a[0], &byte, 1) != 1) return 3;
    look("read", fds, 5, 0);

    control("add b by edge", EPOLL_CTL_ADD, b[0], EPOLLIN | EPOLLET);
    control("add b to write", EPOLL_CTL_ADD, b[1], EPOLLOUT | EPOLLONESHOT);
    if (write(b[1], &byte, 1) != 1) return 4;
    look("both", fds, 5, -1);
    look("an edge, and once", fds, 5, 0);
    control("once more", EPOLL_CTL_MOD, b[1], EPOLLOUT | EPOLLONESHOT);
    look("once more", fds, 5, 0);
    if (read(b[0], &byte, 1) != 1 || write(b[1], &byte, 1) != 1) return 5;
    look("the next edge", fds, 5, 0);

    const struct itimerspec soon = {{0, 0}, {0, 5000000}};
    uint64_t value = 1;
    control("add counter", EPOLL_CTL_ADD, counter, EPOLLIN);
    control("add timer", EPOLL_CTL_ADD, timer, EPOLLIN);
    if (timerfd_settime(timer, 0, &soon, NULL) != 0) return 6;
    look("timer", fds, 5, 1000);
    if (read(timer, &value, sizeof value) != sizeof value) return 7;
    if (write(counter, &value, sizeof value) != sizeof value) return 8;
    look("counter", fds, 5, 1000);
    if (read(counter, &value, sizeof value) != sizeof value) return 9;

    const int inner = epoll;
    epoll = epoll_create(1);
    control("add inner", EPOLL_CTL_ADD, inner, EPOLLIN);
    const int inners[] = {inner};
    look("inner rests", inners, 1, 0);
    const int outer = epoll;
    epoll = inner;
    control("add outer to inner", EPOLL_CTL_ADD, outer, EPOLLIN);
    epoll = outer;
    close(a[1]);
    look("inner has one", inners, 1, 0);
    close(epoll);
    epoll = inner;
    look("hung up", fds, 5, 0);
    close(a[0]);
    look("closed", fds, 5, 0);

    int pair[2];
    if (pipe(pair) != 0) return 10;
    control("add pipe", EPOLL_CTL_ADD, pair[0], EPOLLIN);
    if (dup(pair[0]) < 0 || dup2(epoll, pair[0]) < 0) return 11;
    look("a watched number is its own", fds, 5, 10);
    return 0;
}

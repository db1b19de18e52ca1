// timers.c - ticks of setitimer, alarm and timerfd, as sound and games on the board have them.
#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/time.h>
#include <sys/timerfd.h>
#include <time.h>
#include <unistd.h>

static volatile int ticks;

static void tick(int signal) {
    (void)signal;
    ++ticks;
}

static int now_ms(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int)(now.tv_sec * 1000 + now.tv_nsec / 1000000);
}

int main(int count, char** words) {
    if (count > 1 && !strcmp(words[1], "dies")) {
        ualarm(2000, 0);
        for (;;) pause();
    }
    struct sigaction action = {.sa_handler = tick};
    sigaction(SIGALRM, &action, NULL);
    const int begin = now_ms();
    struct itimerval every = {{0, 10000}, {0, 10000}}, left;
    setitimer(ITIMER_REAL, &every, NULL);
    while (ticks < 20) pause();
    printf("%d ticks in %d ms\n", ticks, now_ms() - begin);

    struct itimerval once = {{0, 0}, {1, 500000}};
    setitimer(ITIMER_REAL, &once, NULL);
    getitimer(ITIMER_REAL, &left);
    printf("left %ld.%ld s", (long)left.it_value.tv_sec, (long)left.it_value.tv_usec / 100000);
    printf(", by alarm %u s\n", alarm(0));
    ticks = 0;
    usleep(20000);
    printf("%d ticks without\n", ticks);

    const int fd = timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK);
    struct itimerspec spec = {{0, 5000000}, {0, 5000000}};
    timerfd_settime(fd, 0, &spec, NULL);
    uint64_t expired = 0, sum = 0;
    const int early = (int)read(fd, &expired, sizeof expired);
    printf("early %d: %s\n", early, strerror(errno));
    struct pollfd wait = {fd, POLLIN, 0};
    for (int i = 0; i < 3; ++i) {
        poll(&wait, 1, 100);
        if (read(fd, &expired, sizeof expired) == sizeof expired) sum += expired;
    }
    printf("polled %d", (int)sum);
    usleep(31000);
    if (read(fd, &expired, sizeof expired) == sizeof expired)
        printf(", slept over %d\n", (int)expired);
    return 0;
}

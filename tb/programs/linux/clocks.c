// clocks.c - sleeping takes the time it should, by every clock, and so do system calls
#include <stdio.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

static long long now_us(clockid_t clock) {
    struct timespec now;
    clock_gettime(clock, &now);
    return now.tv_sec * 1000000LL + now.tv_nsec / 1000;
}

static void say(const char* what, long long us) {
    printf("%s %s\n", what, us >= 20000 && us < 20200 ? "took 20 ms" : "took another time");
}

int main(void) {
    const struct timespec span = {0, 20000000};
    long long begin = now_us(CLOCK_MONOTONIC);
    nanosleep(&span, NULL);
    say("nanosleep", now_us(CLOCK_MONOTONIC) - begin);

    begin = now_us(CLOCK_REALTIME);
    usleep(20000);
    say("usleep", now_us(CLOCK_REALTIME) - begin);

    struct timeval before, after;
    gettimeofday(&before, NULL);
    clock_nanosleep(CLOCK_MONOTONIC, 0, &span, NULL);
    gettimeofday(&after, NULL);
    say("clock_nanosleep",
        (after.tv_sec - before.tv_sec) * 1000000LL + after.tv_usec - before.tv_usec);

    struct timespec end;
    clock_gettime(CLOCK_MONOTONIC, &end);
    begin = now_us(CLOCK_MONOTONIC);
    end.tv_nsec += 20000000;
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &end, NULL);
    say("until", now_us(CLOCK_MONOTONIC) - begin);

    begin = now_us(CLOCK_MONOTONIC);
    for (int i = 0; i < 1000; ++i) getppid();
    const long long calls = now_us(CLOCK_MONOTONIC) - begin;
    printf("calls %s\n", calls >= 1000 && calls < 1100 ? "took 1 us each" : "took another time");
    return 0;
}

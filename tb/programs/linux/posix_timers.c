// posix_timers.c - timers of timer_create: their errors, signals, threads, clocks and overruns
#include <errno.h>
#include <pthread.h>
#include <semaphore.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define MS 1000000
#define SIG SIGRTMIN

static sigset_t set;

static void say(const char* name, long result) {
    printf("%s: %s\n", name, result < 0 ? strerror(errno) : "done");
}

static void set_timer(timer_t timer, int flags, long first_ms, long interval_ms) {
    const struct itimerspec spec = {{interval_ms / 1000, interval_ms % 1000 * MS},
                                    {first_ms / 1000, first_ms % 1000 * MS}};
    if (timer_settime(timer, flags, &spec, NULL) != 0) perror("timer_settime");
}

static timer_t create(clockid_t clock, int notify, int value) {
    struct sigevent event = {.sigev_notify = notify, .sigev_signo = SIG};
    timer_t timer = 0;
    event.sigev_value.sival_int = value;
    if (timer_create(clock, &event, &timer) != 0) perror("timer_create");
    return timer;
}

// Takes a signal that comes within `ms`, and prints it.
static int take(const char* name, int ms) {
    siginfo_t info;
    const struct timespec longest = {ms / 1000, ms % 1000 * MS};
    if (sigtimedwait(&set, &info, &longest) < 0) {
        printf("%s: %s\n", name, strerror(errno));
        return -1;
    }
    printf("%s: %d code %d value %d\n", name, info.si_signo, info.si_code, info.si_value.sival_int);
    return info.si_overrun;
}

static int ms_of(clockid_t clock) {
    struct timespec now;
    clock_gettime(clock, &now);
    return (int)(now.tv_sec * 1000 + now.tv_nsec / MS);
}

static void errors(void) {
    struct {
        int value, signo, notify, thread, rest[12];
    } event = {0, SIG, SIGEV_SIGNAL, 0, {0}};
    int timer;
    const struct {
        long interval_s, interval_ns, s, ns;
    } good = {0, 0, 1, 0}, bad = {0, 0, 1, 1000 * MS}, below = {0, 0, -1, 0};
    say("clock 10", syscall(SYS_timer_create, 10, &event, &timer));
    say("clock 12", syscall(SYS_timer_create, 12, &event, &timer));
    say("a raw clock", syscall(SYS_timer_create, CLOCK_MONOTONIC_RAW, &event, &timer));
    say("a coarse clock", syscall(SYS_timer_create, CLOCK_REALTIME_COARSE, &event, &timer));
    say("no memory", syscall(SYS_timer_create, CLOCK_MONOTONIC, 16, &timer));
    event.signo = 65;
    say("signal 65", syscall(SYS_timer_create, CLOCK_MONOTONIC, &event, &timer));
    event.signo = SIG, event.notify = 3;
    say("notify 3", syscall(SYS_timer_create, CLOCK_MONOTONIC, &event, &timer));
    event.notify = SIGEV_THREAD_ID, event.thread = 99999;
    say("another's thread", syscall(SYS_timer_create, CLOCK_MONOTONIC, &event, &timer));
    event.notify = SIGEV_NONE, event.signo = 0;
    say("none", syscall(SYS_timer_create, CLOCK_MONOTONIC, &event, &timer));
    say("set", syscall(SYS_timer_settime, timer, 0, &good, NULL));
    say("10^9 ns", syscall(SYS_timer_settime, timer, 0, &bad, NULL));
    say("below 0", syscall(SYS_timer_settime, timer, 0, &below, NULL));
    say("no time", syscall(SYS_timer_settime, timer, 0, NULL, NULL));
    say("no such timer", syscall(SYS_timer_settime, 77, 0, &good, NULL));
    say("get none", syscall(SYS_timer_gettime, 77, &bad));
    say("overrun of none", syscall(SYS_timer_getoverrun, 77));
    say("delete none", syscall(SYS_timer_delete, 77));
    say("delete", syscall(SYS_timer_delete, timer));
    say("delete again", syscall(SYS_timer_delete, timer));
}

static void signals(void) {
    struct itimerspec left;
    const timer_t timer = create(CLOCK_MONOTONIC, SIGEV_SIGNAL, 7);
    timer_gettime(timer, &left);
    printf("not set: %ld %ld\n", (long)left.it_value.tv_sec, left.it_value.tv_nsec);
    set_timer(timer, 0, 200, 0);
    take("too early", 1);
    printf("once: overrun %d\n", take("once", 2000));
    take("not again", 30);
    timer_gettime(timer, &left);
    printf("over: %ld %ld\n", (long)left.it_value.tv_sec, left.it_value.tv_nsec);

    set_timer(timer, TIMER_ABSTIME, 1, 0);
    take("it was before", 2000);
    set_timer(timer, TIMER_ABSTIME, ms_of(CLOCK_MONOTONIC) + 20, 0);
    take("by the clock", 2000);

    const struct itimerspec later = {{3, 0}, {50, 0}}, never = {{0, 0}, {0, 0}};
    set_timer(timer, 0, 100000, 0);
    timer_settime(timer, 0, &later, &left);
    printf("before: %d, %ld\n", left.it_value.tv_sec > 90 && left.it_value.tv_sec <= 100,
           (long)left.it_interval.tv_sec);
    timer_settime(timer, 0, &never, &left);
    printf("before: %d, %ld\n", left.it_value.tv_sec > 40 && left.it_value.tv_sec <= 50,
           (long)left.it_interval.tv_sec);
    timer_gettime(timer, &left);
    printf("never: %ld, %ld\n", (long)left.it_value.tv_sec, (long)left.it_interval.tv_sec);

    set_timer(timer, 0, 5, 5);
    usleep(42000);
    const int overrun = take("every 5 ms", 2000);
    printf("overrun: %d, %d\n", overrun >= 7, overrun == timer_getoverrun(timer));
    take("every 5 ms", 2000);
    timer_delete(timer);

    const timer_t none = create(CLOCK_REALTIME, SIGEV_NONE, 0);
    set_timer(none, 0, 900000, 0);
    timer_gettime(none, &left);
    printf("asked: %d\n", left.it_value.tv_sec > 890);
    set_timer(none, 0, 5, 0);
    usleep(10000);
    timer_gettime(none, &left);
    printf("asked: %ld %ld\n", (long)left.it_value.tv_sec, left.it_value.tv_nsec);
    set_timer(none, 0, 5, 4000);
    usleep(10000);
    timer_gettime(none, &left);
    printf("asked: %d\n", left.it_value.tv_sec >= 3);
    timer_delete(none);
}

static void two(void) {
    const timer_t first = create(CLOCK_MONOTONIC, SIGEV_SIGNAL, 1);
    const timer_t second = create(CLOCK_REALTIME, SIGEV_SIGNAL, 2);
    set_timer(first, 0, 100, 0);
    set_timer(second, 0, 5, 0);
    usleep(150000);
    take("the earlier", 0);
    take("the later", 0);
    timer_delete(first);
    timer_delete(second);
}

static volatile int caught;
static void handle(int number, siginfo_t* info, void* context) {
    (void)number, (void)context;
    caught = info->si_value.sival_int;
}

// One that is ignored for a while, and then has a handler.
static void ignored(void) {
    struct sigaction ignore = {.sa_handler = SIG_IGN};
    struct sigaction action = {.sa_sigaction = handle, .sa_flags = SA_SIGINFO};
    sigaction(SIG, &ignore, NULL);
    sigprocmask(SIG_UNBLOCK, &set, NULL);
    const timer_t timer = create(CLOCK_MONOTONIC, SIGEV_SIGNAL, 9);
    set_timer(timer, 0, 1, 15);
    usleep(20000);
    sigaction(SIG, &action, NULL);
    while (!caught) pause();
    timer_delete(timer);
    sigprocmask(SIG_BLOCK, &set, NULL);
    printf("caught %d\n", caught);
}

static timer_t its_timer;
static sem_t ready;
static void* thread(void* unused) {
    struct sigevent event = {.sigev_notify = SIGEV_THREAD_ID, .sigev_signo = SIG};
    event._sigev_un._tid = (int)syscall(SYS_gettid);
    event.sigev_value.sival_int = 3;
    timer_create(CLOCK_MONOTONIC, &event, &its_timer);
    set_timer(its_timer, 0, 10, 0);
    sem_post(&ready);
    usleep(50000);
    take("the thread", 2000);
    return unused;
}

static void in_thread(union sigval value) {
    printf("a function: %d, in another thread: %d\n", value.sival_int,
           syscall(SYS_gettid) != getpid());
    sem_post(&ready);
}

static void threads(void) {
    pthread_t other;
    sem_init(&ready, 0, 0);
    pthread_create(&other, NULL, thread, NULL);
    sem_wait(&ready);
    take("the first", 30);
    pthread_join(other, NULL);
    timer_delete(its_timer);

    struct sigevent event = {.sigev_notify = SIGEV_THREAD, .sigev_value.sival_int = 4};
    event.sigev_notify_function = in_thread;
    timer_t timer;
    say("a thread each", timer_create(CLOCK_MONOTONIC, &event, &timer));
    for (int i = 0; i < 2; ++i) {
        set_timer(timer, 0, 10, 0);
        sem_wait(&ready);
    }
    timer_delete(timer);
}

// Until the signal comes, at most so long; a busy machine sends that of processor time late.
static int longest_ms = 60;
static void* compute(void* signal_comes) {
    const int begin = ms_of(CLOCK_THREAD_CPUTIME_ID);
    while (ms_of(CLOCK_THREAD_CPUTIME_ID) < begin + longest_ms) {
        sigset_t pending;
        sigpending(&pending);
        if (sigismember(&pending, SIG)) return *(int*)signal_comes = 1, NULL;
    }
    return *(int*)signal_comes = 0, NULL;
}

static void clocks(void) {
    int comes;
    pthread_t other;
    const timer_t timer = create(CLOCK_PROCESS_CPUTIME_ID, SIGEV_SIGNAL, 5);
    set_timer(timer, 0, 30, 0);
    take("while it waits", 60);
    longest_ms = 3000;
    compute(&comes);
    printf("while it computes: %d\n", comes);
    take("by processor time", 0);
    set_timer(timer, 0, 30, 0);
    pthread_create(&other, NULL, compute, &comes);
    pthread_join(other, NULL);
    printf("while a thread computes: %d\n", comes);
    take("by processor time", 0);
    timer_delete(timer);

    const timer_t own = create(CLOCK_THREAD_CPUTIME_ID, SIGEV_SIGNAL, 6);
    set_timer(own, 0, 30, 0);
    longest_ms = 60;
    pthread_create(&other, NULL, compute, &comes);
    pthread_join(other, NULL);
    printf("while another computes: %d\n", comes);
    longest_ms = 3000;
    compute(&comes);
    printf("while this one computes: %d\n", comes);
    take("by its own time", 0);
    timer_delete(own);
}

static void processes(void) {
    int status;
    struct itimerspec left;
    const timer_t timer = create(CLOCK_MONOTONIC, SIGEV_SIGNAL, 8);
    set_timer(timer, 0, 40, 0);
    fflush(stdout);
    if (fork() == 0) _exit(timer_gettime(timer, &left) < 0 && errno == EINVAL);
    wait(&status);
    printf("in a child: %d\n", WEXITSTATUS(status));
    take("here", 2000);
    timer_delete(timer);
}

static void becomes_another(void) {
    int status;
    const timer_t timer = create(CLOCK_MONOTONIC, SIGEV_SIGNAL, 8);
    set_timer(timer, 0, 1, 0);
    usleep(5000);
    if (fork() == 0) {
        set_timer(create(CLOCK_MONOTONIC, SIGEV_SIGNAL, 8), 0, 1, 0);
        usleep(5000);
        execl("/proc/self/exe", "posix_timers", "another", NULL);
        _exit(9);
    }
    wait(&status);
    printf("in another program: %d\n", WEXITSTATUS(status));
    timer_delete(timer);
    take("deleted since", 0);
    take("deleted", 0);
}

// What qemu-arm does otherwise, or at any time: it numbers timers in its own way, and cannot start
// itself.  Since 6.13 Linux does not send the signal of a timer that has been deleted.
static int apart(void) {
    siginfo_t info;
    int timer[2];
    const struct {
        long long interval_s, interval_ns, s, ns;
    } every = {0, 2 * MS, 0, 2 * MS};
    long long left[4];
    sigaddset(&set, SIGALRM);
    sigprocmask(SIG_BLOCK, &set, NULL);
    syscall(SYS_timer_create, CLOCK_MONOTONIC, NULL, &timer[0]);
    syscall(SYS_timer_create, CLOCK_MONOTONIC, NULL, &timer[1]);
    syscall(SYS_timer_settime64, timer[1], 0, &every, NULL);
    usleep(21000);
    syscall(SYS_timer_gettime64, timer[1], left);
    sigwaitinfo(&set, &info);
    printf("timers %d and %d: signal %d of %d, value %d, overrun %d\n", timer[0], timer[1],
           info.si_signo, info.si_timerid, info.si_value.sival_int, info.si_overrun);
    printf("%lld.%01lld ms left, every %lld ms\n", left[3] / MS, left[3] / (MS / 10) % 10,
           left[1] / MS);
    usleep(4500);
    sigwaitinfo(&set, &info);
    printf("overrun %d\n", info.si_overrun);
    usleep(2500);
    syscall(SYS_timer_settime64, timer[1], 0, &every, NULL);
    usleep(2500);
    sigwaitinfo(&set, &info);
    printf("set while it was pending: overrun %d, then %d\n", info.si_overrun,
           (int)syscall(SYS_timer_getoverrun, timer[1]));
    syscall(SYS_timer_delete, timer[0]);
    syscall(SYS_timer_create, CLOCK_MONOTONIC, NULL, &timer[0]);
    printf("the next one: %d\n", timer[0]);
    syscall(SYS_timer_delete, timer[1]);
    becomes_another();
    return 0;
}

int main(int count, char** words) {
    setvbuf(stdout, NULL, _IOLBF, 0);
    sigemptyset(&set);
    sigaddset(&set, SIG);
    sigprocmask(SIG_BLOCK, &set, NULL);
    if (count > 1 && !strcmp(words[1], "apart")) return apart();
    if (count > 1) {  // after exec
        sigset_t pending;
        struct itimerspec left;
        sigpending(&pending);
        const int there = timer_gettime(0, &left) == 0 || sigismember(&pending, SIG);
        return there ? 1 : 0;
    }
    errors();
    signals();
    two();
    ignored();
    threads();
    clocks();
    processes();
    return 0;
}

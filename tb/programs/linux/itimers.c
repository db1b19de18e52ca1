// itimers.c - setitimer's timers of processor time: what they count, their signals, what is left
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static volatile int count_of[65];
static volatile int code_is_the_kernels;

static void count(int number, siginfo_t* info, void* context) {
    (void)context;
    ++count_of[number];
    code_is_the_kernels = info->si_code == SI_KERNEL;
}

static int used_ms(void) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (int)(now.tv_sec * 1000 + now.tv_nsec / 1000000);
}

static void compute(int ms) {
    const int begin = used_ms();
    while (used_ms() < begin + ms)
        for (volatile int i = 0; i < 1000; ++i) continue;
}

// Until it has come so often; a busy machine is late with it.
static void compute_until(int number, int times) {
    const int begin = used_ms();
    while (count_of[number] < times && used_ms() < begin + 3000) continue;
}

static void say(const char* name, long result) {
    printf("%s: %s\n", name, result < 0 ? strerror(errno) : "done");
}

static void leave(int number) { _exit(number); }

int main(int words, char** word) {
    const struct itimerval every = {{0, 20000}, {0, 20000}}, never = {{0, 0}, {0, 0}},
                           once = {{0, 0}, {0, 40000}}, bad = {{0, 0}, {0, 1000000}};
    struct itimerval left;
    const int which[] = {ITIMER_VIRTUAL, ITIMER_PROF}, number[] = {SIGVTALRM, SIGPROF};
    const char* const name[] = {"virtual", "prof"};
    struct sigaction action = {.sa_sigaction = count, .sa_flags = SA_SIGINFO | SA_RESTART};
    setvbuf(stdout, NULL, _IOLBF, 0);
    if (words > 1 && !strcmp(word[1], "dies")) {
        setitimer(ITIMER_PROF, &once, NULL);
        for (;;) continue;
    }
    if (words > 1 && !strcmp(word[1], "spins")) {
        signal(SIGALRM, leave);
        alarm(1);
        for (;;) continue;
    }
    say("microseconds", setitimer(ITIMER_PROF, &bad, NULL));
    say("no such timer", setitimer((__itimer_which_t)3, &once, NULL));
    say("get no such timer", getitimer((__itimer_which_t)3, &left));
    for (int i = 0; i < 2; ++i) {
        sigaction(number[i], &action, NULL);
        setitimer(which[i], &every, NULL);
        usleep(60000);
        printf("%s: %d while it sleeps\n", name[i], count_of[number[i]]);
        getitimer(which[i], &left);
        printf("left: %d, every %ld\n", left.it_value.tv_usec > 10000,
               (long)left.it_interval.tv_usec);
        if (words > 1)
            compute(210);
        else
            compute_until(number[i], 3);
        const int times = count_of[number[i]];
        if (words > 1)
            printf("%d while it computes\n", times);
        else
            printf("comes: %d, from the kernel: %d\n", times > 2, code_is_the_kernels);
        if (fork() == 0) _exit(getitimer(which[i], &left) != 0 || left.it_interval.tv_usec != 0);
        int status;
        wait(&status);
        printf("in a child: %d\n", WEXITSTATUS(status));
        setitimer(which[i], &never, &left);
        printf("before: every %ld\n", (long)left.it_interval.tv_usec);
        count_of[number[i]] = 0;
        compute(100);
        setitimer(which[i], &once, NULL);
        printf("never: %d\n", count_of[number[i]]);
        compute_until(number[i], 1);
        compute(100);
        getitimer(which[i], &left);
        printf("once: %d, left %ld %ld\n", count_of[number[i]], (long)left.it_value.tv_sec,
               (long)left.it_value.tv_usec);
    }
    return 0;
}

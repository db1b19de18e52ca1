// threads.c WHAT - POSIX threads: what they share, how they wait for each other, how they end
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <semaphore.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER, other_lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t there = PTHREAD_COND_INITIALIZER, room = PTHREAD_COND_INITIALIZER;
static pthread_barrier_t barrier;
static pthread_rwlock_t shared = PTHREAD_RWLOCK_INITIALIZER;
static sem_t semaphore;
static volatile int flag;
static volatile unsigned* leds;

static double now_ms(clockid_t clock) {
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec / 1e6;
}

static pthread_t start(void* (*run)(void*), void* argument) {
    pthread_t thread;
    const int error = pthread_create(&thread, NULL, run, argument);
    if (error) printf("pthread_create: %s\n", strerror(error)), exit(2);
    return thread;
}

// ---- Ten threads count on the LEDs under a mutex ----

static int counted;

static void* count(void* unused) {
    for (int i = 0; i < 10; ++i) {
        pthread_mutex_lock(&lock);
        *leds = (unsigned)++counted;
        pthread_mutex_unlock(&lock);
        usleep(200);
    }
    return unused;
}

static void counts(void) {
    const int fd = open("/dev/mem", O_RDWR | O_SYNC);
    leds = mmap(NULL, 0x1000, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0xFF200000);
    pthread_t all[10];
    for (unsigned i = 0; i < COUNT(all); ++i) all[i] = start(count, NULL);
    for (unsigned i = 0; i < COUNT(all); ++i) pthread_join(all[i], NULL);
    printf("counted to %d, LEDs %u\n", counted, *leds);
}

// ---- Producers and consumers, by condition variables and by a semaphore ----

static int queue[4], queued, sum, taken;

static void* produce(void* from) {
    for (int i = 0; i < 100; ++i) {
        pthread_mutex_lock(&lock);
        while (queued == (int)COUNT(queue)) pthread_cond_wait(&room, &lock);
        queue[queued++] = (int)(intptr_t)from + i;
        pthread_cond_signal(&there);
        pthread_mutex_unlock(&lock);
    }
    return NULL;
}

static void* consume(void* unused) {
    for (;;) {
        pthread_mutex_lock(&lock);
        while (queued == 0 && taken < 300) pthread_cond_wait(&there, &lock);
        if (queued == 0) break;
        sum += queue[--queued];
        if (++taken == 300) pthread_cond_broadcast(&there);
        pthread_cond_signal(&room);
        pthread_mutex_unlock(&lock);
    }
    pthread_mutex_unlock(&lock);
    return unused;
}

static void produces(void) {
    pthread_t all[5];
    for (intptr_t i = 0; i < 3; ++i) all[i] = start(produce, (void*)(1000 * i));
    for (unsigned i = 3; i < 5; ++i) all[i] = start(consume, NULL);
    for (unsigned i = 0; i < COUNT(all); ++i) pthread_join(all[i], NULL);
    printf("took %d, sum %d\n", taken, sum);
}

static void* post(void* unused) {
    for (int i = 0; i < 50; ++i) sem_post(&semaphore);
    return unused;
}

static void posts(void) {
    sem_init(&semaphore, 0, 0);
    const pthread_t a = start(post, NULL), b = start(post, NULL);
    for (int i = 0; i < 100; ++i) sem_wait(&semaphore);
    pthread_join(a, NULL);
    pthread_join(b, NULL);
    struct timespec end;
    clock_gettime(CLOCK_REALTIME, &end);
    const double begin = now_ms(CLOCK_MONOTONIC);
    end.tv_nsec += 5000000;
    const int result = sem_timedwait(&semaphore, &end);
    printf("%d: %s after %.0f ms\n", result, strerror(errno), now_ms(CLOCK_MONOTONIC) - begin);
}

// ---- Barriers and locks for readers ----

static int rounds[4], late, readers, most_readers;

static void* meet(void* own) {
    const int me = (int)(intptr_t)own;
    for (int i = 1; i <= 20; ++i) {
        rounds[me] = i;
        pthread_barrier_wait(&barrier);
        for (int j = 0; j < 4; ++j) late += rounds[j] < i;
        pthread_barrier_wait(&barrier);
    }
    return NULL;
}

static void meets(void) {
    pthread_t all[4];
    pthread_barrier_init(&barrier, NULL, 4);
    for (intptr_t i = 0; i < 4; ++i) all[i] = start(meet, (void*)i);
    for (unsigned i = 0; i < COUNT(all); ++i) pthread_join(all[i], NULL);
    printf("%d rounds, %d late\n", rounds[3], late);
}

static void* reads(void* unused) {
    for (int i = 0; i < 20; ++i) {
        pthread_rwlock_rdlock(&shared);
        const int now = __atomic_add_fetch(&readers, 1, __ATOMIC_SEQ_CST);
        if (now > most_readers) most_readers = now;
        usleep(100);
        __atomic_sub_fetch(&readers, 1, __ATOMIC_SEQ_CST);
        pthread_rwlock_unlock(&shared);
    }
    return unused;
}

static void* writes(void* unused) {
    for (int i = 0; i < 20; ++i) {
        pthread_rwlock_wrlock(&shared);
        if (readers) ++late;
        ++sum;
        pthread_rwlock_unlock(&shared);
        usleep(150);
    }
    return unused;
}

static void shares(void) {
    pthread_t all[] = {start(reads, NULL), start(reads, NULL), start(reads, NULL),
                       start(writes, NULL)};
    for (unsigned i = 0; i < COUNT(all); ++i) pthread_join(all[i], NULL);
    printf("%d writes, %d amid readers, %s\n", sum, late,
           most_readers > 1 ? "readers together" : "readers alone");
}

// ---- What is a thread's own ----

static __thread int own = 1;
static pthread_key_t key;
static int destroyed;

static void destroy(void* value) { destroyed += (int)(intptr_t)value; }

// Registers of the floating-point unit, errno and the stack are kept while others run.
static void* compute(void* argument) {
    const int me = (int)(intptr_t)argument;
    double value = me;
    pthread_setspecific(key, argument);
    own += me;
    for (int i = 0; i < 200000; ++i) value = value * 0.5 + me;
    errno = me;
    sched_yield();
    return (void*)(intptr_t)(errno == me && own == 1 + me && value == 2.0 * me);
}

static void keeps(void) {
    pthread_t all[3];
    int right = 0;
    pthread_key_create(&key, destroy);
    for (intptr_t i = 1; i <= 3; ++i) all[i - 1] = start(compute, (void*)i);
    for (unsigned i = 0; i < COUNT(all); ++i) {
        void* result;
        pthread_join(all[i], &result);
        right += (int)(intptr_t)result;
    }
    printf("%d right, own %d, destroyed %d\n", right, own, destroyed);
}

// ---- One that spins must not keep the others out ----

static void* raise_flag(void* unused) {
    usleep(3000);
    flag = 1;
    return unused;
}

static void spins(void) {
    const pthread_t other = start(raise_flag, NULL);
    usleep(1000);
    const double begin = now_ms(CLOCK_MONOTONIC);
    unsigned long spun = 0;
    while (!flag) ++spun;
    const double took = now_ms(CLOCK_MONOTONIC) - begin;
    pthread_join(other, NULL);
    printf("%s, %s\n", took > 1.9 && took < 2.1 ? "at once" : "late",
           spun > 100000 ? "spun" : "rested");
}

static double shared_ms[2];

static void* spin(void* which) {
    const double begin = now_ms(CLOCK_THREAD_CPUTIME_ID);
    while (now_ms(CLOCK_MONOTONIC) < 50) {}
    shared_ms[(int)(intptr_t)which] = now_ms(CLOCK_THREAD_CPUTIME_ID) - begin;
    return NULL;
}

static void takes_turns(void) {
    const pthread_t a = start(spin, (void*)0), b = start(spin, (void*)1);
    pthread_join(a, NULL);
    pthread_join(b, NULL);
    const double ratio = shared_ms[0] / shared_ms[1];
    printf("%s\n", ratio > 0.9 && ratio < 1.1 ? "halves" : "unequal parts");
}

// ---- How they end ----

static void cleanup(void* unused) {
    (void)unused;
    puts("cleaned up");
}

static void* forever(void* unused) {
    pthread_cleanup_push(cleanup, NULL);
    for (;;) pause();
    pthread_cleanup_pop(0);
    return unused;
}

static void* busy(void* unused) {
    pthread_setcanceltype(PTHREAD_CANCEL_ASYNCHRONOUS, NULL);
    for (;;) ++flag;
    return unused;
}

static void cancels(void) {
    void* result;
    pthread_t thread = start(forever, NULL);
    usleep(1000);
    pthread_cancel(thread);
    pthread_join(thread, &result);
    printf("%s, ", result == PTHREAD_CANCELED ? "cancelled" : "ended");
    thread = start(busy, NULL);
    usleep(1000);
    pthread_cancel(thread);
    pthread_join(thread, &result);
    printf("%s\n", result == PTHREAD_CANCELED ? "cancelled" : "ended");
}

static void* late_end(void* unused) {
    usleep(2000);
    puts("the last");
    return unused;
}

static void outlives(void) {
    pthread_detach(start(late_end, NULL));
    puts("the first");
    pthread_exit(NULL);
}

static void waits_in_time(void) {
    struct timespec end;
    pthread_mutex_lock(&lock);
    clock_gettime(CLOCK_REALTIME, &end);
    end.tv_nsec += 7000000;
    const double begin = now_ms(CLOCK_MONOTONIC);
    const int error = pthread_cond_timedwait(&there, &lock, &end);
    printf("%s after %.0f ms\n", strerror(error), now_ms(CLOCK_MONOTONIC) - begin);
}

static void* dies(void* mutex) {
    pthread_mutex_lock(mutex);
    return NULL;
}

static void inherits(void) {
    pthread_mutexattr_t robust;
    pthread_mutex_t mutex;
    pthread_mutexattr_init(&robust);
    pthread_mutexattr_setrobust(&robust, PTHREAD_MUTEX_ROBUST);
    pthread_mutex_init(&mutex, &robust);
    pthread_join(start(dies, &mutex), NULL);
    printf("%s\n", strerror(pthread_mutex_lock(&mutex)));
}

// ---- Signals are for one of them ----

static volatile pthread_t handled_by;
static void on_signal(int number) {
    (void)number;
    handled_by = pthread_self();
}

static void* sits(void* unused) {
    usleep(20000);
    return unused;
}

static void* takes_signals(void* set) {
    int number = 0;
    sigwait(set, &number);
    printf("took %d, ", number);
    return NULL;
}

static void signals(void) {
    sigset_t set;
    signal(SIGUSR1, on_signal);
    const pthread_t thread = start(sits, NULL);
    usleep(1000);
    pthread_kill(thread, SIGUSR1);
    usleep(1000);
    printf("%s, ", handled_by == thread ? "by the thread" : "by another");
    sigemptyset(&set);
    sigaddset(&set, SIGUSR2);
    pthread_sigmask(SIG_BLOCK, &set, NULL);
    const pthread_t taker = start(takes_signals, &set);
    usleep(1000);
    kill(getpid(), SIGUSR2);
    pthread_join(taker, NULL);
    handled_by = 0;
    kill(getpid(), SIGUSR1);
    printf("%s\n", handled_by == pthread_self() ? "by the first" : "by another");
}

// ---- Who waits for whom ----

static void* locks(void* unused) {
    pthread_mutex_lock(&other_lock);
    usleep(1000);
    pthread_mutex_lock(&lock);
    return unused;
}

static void deadlocks(void) {
    const pthread_t thread = start(locks, NULL);
    pthread_mutex_lock(&lock);
    usleep(1000);
    pthread_mutex_lock(&other_lock);
    pthread_join(thread, NULL);
}

static void* hello(void* unused) { return unused; }

static void storms(void) {
    for (int i = 0; i < 2000; ++i) pthread_join(start(hello, NULL), NULL);
    pthread_attr_t small;
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, 16384);
    int made = 0;
    pthread_t thread;
    while (pthread_create(&thread, &small, sits, NULL) == 0) ++made;
    printf("%s\n", made > 500 && made < 2000 ? "no more threads" : "another number");
}

static void* pauses(void* unused) {
    pause();
    return unused;
}

static void crowd(void) {
    for (int i = 0; i < 50; ++i) start(pauses, NULL);
    sleep(10);
}

static void schedules(void) {
    struct sched_param parameter = {.sched_priority = 10};
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(1, &set);
    const int fixed = sched_setaffinity(0, sizeof set, &set);
    sched_getaffinity(0, sizeof set, &set);
    const int policy = sched_setscheduler(0, SCHED_FIFO, &parameter);
    printf("%d %d, %d %d, %d to %d, processor %d\n", fixed, CPU_COUNT(&set), policy,
           sched_getscheduler(0), sched_get_priority_min(SCHED_RR),
           sched_get_priority_max(SCHED_RR), sched_getcpu());
}

int main(int argc, char** argv) {
    static const struct {
        const char* name;
        void (*run)(void);
    } all[] = {{"counts", counts},       {"produces", produces},   {"posts", posts},
               {"meets", meets},         {"shares", shares},       {"keeps", keeps},
               {"spins", spins},         {"turns", takes_turns},   {"cancels", cancels},
               {"outlives", outlives},   {"waits", waits_in_time}, {"inherits", inherits},
               {"signals", signals},     {"deadlocks", deadlocks}, {"storms", storms},
               {"schedules", schedules}, {"crowd", crowd}};
    setvbuf(stdout, NULL, _IOLBF, 0);
    for (unsigned i = 0; i < COUNT(all); ++i)
        if (argc > 1 && strcmp(argv[1], all[i].name) == 0) {
            all[i].run();
            return 0;
        }
    return 2;
}

// switches.c WHAT N - what threads cost: "compute" N rounds in as many threads as a third argument
// says, divided among them; "signal" N times from one of two threads to the other by a condition
// variable; "yield" N times in each of two
#include <pthread.h>
#include <sched.h>
#include <stdlib.h>
#include <string.h>

static unsigned rounds;

static void* compute(void* unused) {
    unsigned a = 1, b = 2, c = 3;
    for (unsigned left = rounds; left > 0; --left) {
        a = a * 5 + b;
        b ^= a >> 7;
        c += b;
        __asm__ volatile("" : "+r"(a), "+r"(b), "+r"(c));
    }
    return unused;
}

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t changed = PTHREAD_COND_INITIALIZER;
static int waker, wakers[2] = {0, 1};

static void* wake(void* own) {
    for (unsigned left = rounds; left > 0; --left) {
        pthread_mutex_lock(&lock);
        while (waker != *(int*)own) pthread_cond_wait(&changed, &lock);
        waker = !waker;
        pthread_cond_signal(&changed);
        pthread_mutex_unlock(&lock);
    }
    return NULL;
}

static void* yield(void* unused) {
    for (unsigned left = rounds; left > 0; --left) sched_yield();
    return unused;
}

int main(int count, char** arguments) {
    if (count < 3) return 2;
    const int computes = strcmp(arguments[1], "compute") == 0;
    const int signals = strcmp(arguments[1], "signal") == 0;
    const unsigned threads = computes && count > 3 ? strtoul(arguments[3], NULL, 0) : 2;
    rounds = strtoul(arguments[2], NULL, 0) / (computes ? threads : 1);
    pthread_t all[16];
    if (threads < 1 || threads > 16) return 2;
    for (unsigned i = 0; i < threads; ++i)
        pthread_create(&all[i], NULL, computes ? compute : signals ? wake : yield, &wakers[i & 1]);
    for (unsigned i = 0; i < threads; ++i) pthread_join(all[i], NULL);
    return 0;
}

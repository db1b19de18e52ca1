// kmod_library.c - what kernel modules call that needs no device: memory, texts, locks, time
#define _GNU_SOURCE
#include <errno.h>
#include <sched.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <time.h>

#define KMOD_RUNTIME
#include "kmod.h"

// ---- Memory ----

unsigned long copy_from_user(void* to, const void* from, unsigned long n) {
    if (!from) return n;
    memcpy(to, from, n);
    return 0;
}
unsigned long copy_to_user(void* to, const void* from, unsigned long n) {
    if (!to) return n;
    memcpy(to, from, n);
    return 0;
}
unsigned long clear_user(void* to, unsigned long n) {
    memset(to, 0, n);
    return 0;
}
void* memdup_user(const void* from, size_t n) {
    void* copy = malloc(n);
    return copy ? memcpy(copy, from, n) : ERR_PTR(-ENOMEM);
}
void* kmalloc(size_t n, gfp_t flags) { return flags & __GFP_ZERO ? calloc(1, n) : malloc(n); }
void* kzalloc(size_t n, gfp_t flags) {
    (void)flags;
    return calloc(1, n);
}
void* kcalloc(size_t count, size_t n, gfp_t flags) {
    (void)flags;
    return calloc(count, n);
}
void kfree(const void* p) { free((void*)(uintptr_t)p); }

int scnprintf(char* to, size_t n, const char* format, ...) {
    va_list list;
    va_start(list, format);
    const int length = vsnprintf(to, n, format, list);
    va_end(list);
    return n == 0 ? 0 : length < (int)n ? length : (int)n - 1;
}

ssize_t strscpy(char* to, const char* from, size_t n) {
    const size_t length = strnlen(from, n);
    if (n == 0) return -E2BIG;
    memcpy(to, from, length < n ? length : n - 1);
    to[length < n ? length : n - 1] = '\0';
    return length < n ? (ssize_t)length : -E2BIG;
}
// Where libc has a function of this name, it does the same.
size_t __attribute__((weak)) strlcpy(char* to, const char* from, size_t n) {
    strscpy(to, from, n);
    return strlen(from);
}

static int parsed(const char* text, unsigned base, long long least, long long most, long long* to) {
    char* end;
    errno = 0;
    *to = strtoll(text, &end, (int)base);
    if (*end == '\n') ++end;
    if (end == text || *end) return -EINVAL;
    return errno || *to < least || *to > most ? -ERANGE : 0;
}
int kstrtoint(const char* text, unsigned base, int* to) {
    long long value;
    const int error = parsed(text, base, INT32_MIN, INT32_MAX, &value);
    if (!error) *to = (int)value;
    return error;
}
int kstrtouint(const char* text, unsigned base, unsigned* to) {
    long long value;
    const int error = parsed(text, base, 0, UINT32_MAX, &value);
    if (!error) *to = (unsigned)value;
    return error;
}
int kstrtou8(const char* text, unsigned base, u8* to) {
    long long value;
    const int error = parsed(text, base, 0, UINT8_MAX, &value);
    if (!error) *to = (u8)value;
    return error;
}

// ---- Locks ----

bool kmod_try(int* taken) { return !__atomic_exchange_n(taken, 1, __ATOMIC_ACQUIRE); }
void kmod_lock(int* taken) {
    while (!kmod_try(taken)) sched_yield();
}
void kmod_unlock(int* taken) { __atomic_store_n(taken, 0, __ATOMIC_RELEASE); }

void sema_init(struct semaphore* s, int count) { s->count = count; }
int down_trylock(struct semaphore* s) {
    int count = __atomic_load_n(&s->count, __ATOMIC_RELAXED);
    while (count > 0)
        if (__atomic_compare_exchange_n(&s->count, &count, count - 1, false, __ATOMIC_ACQUIRE,
                                        __ATOMIC_RELAXED))
            return 0;
    return 1;
}
void down(struct semaphore* s) {
    while (down_trylock(s)) sched_yield();
}
void up(struct semaphore* s) { __atomic_add_fetch(&s->count, 1, __ATOMIC_RELEASE); }

// ---- Time ----

ktime_t ktime_get(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (ktime_t)now.tv_sec * 1000000000 + now.tv_nsec;
}
unsigned long kmod_jiffies(void) { return (unsigned long)(ktime_get() / (1000000000 / HZ)); }

static void sleep_ns(uint64_t ns) {
    struct timespec rest = {(time_t)(ns / 1000000000), (long)(ns % 1000000000)};
    while (nanosleep(&rest, &rest) && errno == EINTR) {
    }
}
void ndelay(unsigned long ns) {
    const ktime_t begin = ktime_get();
    while (ktime_get() - begin < (ktime_t)ns) {
    }
}
void udelay(unsigned long us) { ndelay(1000 * us); }
void mdelay(unsigned long ms) { ndelay(1000000 * ms); }
void msleep(unsigned ms) { sleep_ns(1000000ull * ms); }
void usleep_range(unsigned long least, unsigned long most) {
    (void)most;
    sleep_ns(1000ull * least);
}
void cond_resched(void) { sched_yield(); }

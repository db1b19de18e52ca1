// kmod_library.c - what kernel modules call that needs no device: memory, texts, time
#define _GNU_SOURCE
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <time.h>

#include "runtime.h"

// ---- Memory ----

unsigned long copy_from_user(void* to, const void* from, unsigned long n) {
    const unsigned long left =
        (unsigned long)kmod_call(KMOD_COPY, (uintptr_t)to, (uintptr_t)from, n, false, 0);
    memset((char*)to + (n - left), 0, left);
    return left;
}
unsigned long copy_to_user(void* to, const void* from, unsigned long n) {
    return (unsigned long)kmod_call(KMOD_COPY, (uintptr_t)to, (uintptr_t)from, n, true, 0);
}
unsigned long clear_user(void* to, unsigned long n) {
    static const char zeros[256];
    while (n > 0) {
        const unsigned long part = n < sizeof zeros ? n : sizeof zeros;
        if (copy_to_user(to, zeros, part)) return n;
        to = (char*)to + part;
        n -= part;
    }
    return 0;
}
long strncpy_from_user(char* to, const char* from, long n) {
    for (long i = 0; i < n; ++i) {
        if (copy_from_user(to + i, from + i, 1)) return -EFAULT;
        if (!to[i]) return i;
    }
    return n;
}
void* memdup_user(const void* from, size_t n) {
    void* copy = malloc(n);
    if (!copy) return ERR_PTR(-ENOMEM);
    if (!copy_from_user(copy, from, n)) return copy;
    free(copy);
    return ERR_PTR(-EFAULT);
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
void* krealloc(const void* p, size_t n, gfp_t flags) {
    (void)flags;
    return realloc((void*)(uintptr_t)p, n);
}
char* kstrdup(const char* text, gfp_t flags) {
    (void)flags;
    return text ? strdup(text) : NULL;
}
char* kasprintf(gfp_t flags, const char* format, ...) {
    (void)flags;
    va_list list;
    va_start(list, format);
    const size_t room = (size_t)kmod_vsnprintf(NULL, 0, format, list) + 1;
    char* const text = malloc(room);
    if (text) kmod_vsnprintf(text, room, format, list);
    va_end(list);
    return text;
}
void kfree(const void* p) { free((void*)(uintptr_t)p); }

int scnprintf(char* to, size_t n, const char* format, ...) {
    va_list list;
    va_start(list, format);
    const int length = kmod_vsnprintf(to, n, format, list);
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

int kstrtol(const char* text, unsigned base, long* to) {
    int value;
    const int error = kstrtoint(text, base, &value);
    if (!error) *to = value;
    return error;
}
int kstrtoul(const char* text, unsigned base, unsigned long* to) {
    unsigned value;
    const int error = kstrtouint(text, base, &value);
    if (!error) *to = value;
    return error;
}
int kstrtobool(const char* text, bool* to) {
    const char c = text[0], next = c ? text[1] : '\0';
    const bool yes = c == 'y' || c == 'Y' || c == '1' || c == 't' || c == 'T',
               no = c == 'n' || c == 'N' || c == '0' || c == 'f' || c == 'F';
    if (!yes && !no && !((c == 'o' || c == 'O') && (next == 'n' || next == 'N' || next == 'f' ||
                                                    next == 'F')))
        return -EINVAL;
    *to = yes || next == 'n' || next == 'N';
    return 0;
}

static int text_from_user(char* to, size_t room, const char* from, size_t n) {
    if (n >= room) return -EINVAL;
    if (copy_from_user(to, from, n)) return -EFAULT;
    to[n] = '\0';
    return 0;
}
int kstrtoint_from_user(const char* text, size_t n, unsigned base, int* to) {
    char own[32];
    const int error = text_from_user(own, sizeof own, text, n);
    return error ? error : kstrtoint(own, base, to);
}
int kstrtouint_from_user(const char* text, size_t n, unsigned base, unsigned* to) {
    char own[32];
    const int error = text_from_user(own, sizeof own, text, n);
    return error ? error : kstrtouint(own, base, to);
}
unsigned long simple_strtoul(const char* text, char** end, unsigned base) {
    return strtoul(text, end, (int)base);
}
long simple_strtol(const char* text, char** end, unsigned base) {
    return strtol(text, end, (int)base);
}
bool sysfs_streq(const char* a, const char* b) {
    while (*a && *a == *b) ++a, ++b;
    return (!*a || (*a == '\n' && !a[1])) && (!*b || (*b == '\n' && !b[1]));
}

// ---- Time ----

ktime_t ktime_get(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (ktime_t)now.tv_sec * 1000000000 + now.tv_nsec;
}
unsigned long kmod_jiffies(void) { return (unsigned long)(ktime_get() / (1000000000 / HZ)); }

static bool sleep_ns(s64 ns, bool interruptible, const void* caller) {
    static const int nobody;
    kmod_might_sleep("msleep", caller);
    return kmod_sleep(&nobody, 0, ns, interruptible) != -EINTR;
}
void ndelay(unsigned long ns) {
    const ktime_t begin = ktime_get();
    while (ktime_get() - begin < (ktime_t)ns) {
    }
}
void udelay(unsigned long us) { ndelay(1000 * us); }
void mdelay(unsigned long ms) { ndelay(1000000 * ms); }
void msleep(unsigned ms) { sleep_ns(1000000ll * ms, false, __builtin_return_address(0)); }
void ssleep(unsigned seconds) {
    sleep_ns(1000000000ll * seconds, false, __builtin_return_address(0));
}
unsigned long msleep_interruptible(unsigned ms) {
    const ktime_t end = ktime_get() + 1000000ll * ms;
    if (sleep_ns(1000000ll * ms, true, __builtin_return_address(0))) return 0;
    const s64 left = end - ktime_get();
    return left > 0 ? (unsigned long)((left + 999999) / 1000000) : 0;
}
void usleep_range(unsigned long least, unsigned long most) {
    (void)most;
    sleep_ns(1000ll * least, false, __builtin_return_address(0));
}

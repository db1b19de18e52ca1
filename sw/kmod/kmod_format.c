// kmod_format.c - the kernel's printf: the C library's, and what follows a %p
//
//   %pa %pap %pad   the address that the pointer leads to, of physical memory or of the bus
//   %pR %pr         struct resource: [mem 0xff200000-0xff20000f]
//   %pOF            struct device_node: its name
//   %pe             an error as a pointer: -EINVAL
//   %pM %pI4        bytes: 00:01:02:03:04:05, 10.0.0.1
//   %*ph            as many bytes: 00 01 02, with C, D or N after it other separators
//   %pV             struct va_format
//
// Others print the pointer, with eight digits.  Source: Linux, Documentation/core-api/printk-formats.
#define _GNU_SOURCE
#include <ctype.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/types.h>

#include "runtime.h"
#include "nodes.h"

// The text so far; what does not fit is only counted.
struct text {
    char* to;
    size_t room, length;
};

static void __attribute__((format(printf, 2, 3))) add(struct text* t, const char* format, ...) {
    const size_t at = t->length < t->room ? t->length : t->room;
    va_list list;
    va_start(list, format);
    t->length += (size_t)vsnprintf(t->to + at, t->room - at, format, list);
    va_end(list);
}

static void add_bytes(struct text* t, const u8* bytes, int count, const char* between, bool in_hex) {
    for (int n = 0; n < count; ++n) {
        add(t, "%s", n ? between : "");
        add(t, in_hex ? "%02x" : "%u", bytes[n]);
    }
}

static const char* separator(char letter) {
    return letter == 'C' ? ":" : letter == 'D' ? "-" : letter == 'N' ? "" : " ";
}

// Returns how many letters after the p belong to it.
static size_t add_pointer(struct text* t, const char* kind, const void* p, int width) {
    static const char* const known[] = {"pap", "pad", "pa", "pR", "pr", "pOF", "pe", "pM", "pI4",
                                        "phC", "phD", "phN", "ph", "pV"};
    size_t n = 0;
    while (n < ARRAY_SIZE(known) && strncmp(kind - 1, known[n], strlen(known[n])) != 0) ++n;
    const char letter = n < ARRAY_SIZE(known) && p ? kind[0] : 0;
    switch (letter) {
        case 'a': add(t, "0x%08x", *(const phys_addr_t*)p); break;
        case 'R':
        case 'r': {
            const struct resource* const r = p;
            add(t, "[mem 0x%08x-0x%08x]", r->start, r->end);
            break;
        }
        case 'O': add(t, "%s", ((const struct device_node*)p)->name); break;
        case 'e': {
            const char* const name = IS_ERR(p) ? strerrorname_np(-(int)PTR_ERR(p)) : NULL;
            add(t, name ? "-%s" : "%s", name ? name : "");
            if (!name) add(t, "%08lx", (unsigned long)(uintptr_t)p);
            break;
        }
        case 'M': add_bytes(t, p, 6, ":", true); break;
        case 'I': add_bytes(t, p, 4, ".", false); break;
        case 'h': add_bytes(t, p, width, separator(kind[1]), true); break;
        case 'V': {
            const struct va_format* const v = p;
            va_list list;
            va_copy(list, *v->va);
            const size_t at = t->length < t->room ? t->length : t->room;
            t->length += (size_t)kmod_vsnprintf(t->to + at, t->room - at, v->fmt, list);
            va_end(list);
            break;
        }
        default:
            if (p)
                add(t, "%08lx", (unsigned long)(uintptr_t)p);
            else
                add(t, "(null)");
    }
    if (n < ARRAY_SIZE(known)) return strlen(known[n]) - 1;
    size_t rest = 0;
    while (isalnum((unsigned char)kind[rest])) ++rest;
    return rest;
}

int kmod_vsnprintf(char* to, size_t room, const char* format, va_list given) {
    struct text t = {to, room, 0};
    va_list list;
    va_copy(list, given);
    if (room) to[0] = '\0';
    while (*format) {
        const size_t plain = strcspn(format, "%");
        add(&t, "%.*s", (int)plain, format);
        format += plain;
        if (!*format) break;
        // A conversion: flags, width, precision, length; a width that is an argument is put in.
        char one[64];
        size_t n = 0;
        int width = 1, longs = 0;
        one[n++] = *format++;
        for (; *format && strchr("-+ #0123456789.*hlLqzjt", *format) && n < sizeof one - 16;
             ++format) {
            if (*format == '*') {
                width = va_arg(list, int);
                n += (size_t)sprintf(one + n, "%d", width);
                continue;
            }
            longs += *format == 'l' ? 1 : *format == 'L' || *format == 'q' || *format == 'j' ? 2 : 0;
            one[n++] = *format;
        }
        if (!*format) break;
        const char kind = one[n++] = *format++;
        one[n] = '\0';
        if (kind == 'p') {
            format += add_pointer(&t, format, va_arg(list, const void*), width);
        } else if (kind == 's') {
            const char* const s = va_arg(list, const char*);
            one[n - 1] = 's';
            add(&t, (const char*)one, s ? s : "(null)");
        } else if (strchr("diouxXc", kind)) {
            if (longs >= 2)
                add(&t, (const char*)one, va_arg(list, long long));
            else
                add(&t, (const char*)one, va_arg(list, int));
        } else {
            add(&t, "%s", kind == '%' ? "%" : one);
        }
    }
    va_end(list);
    return (int)t.length;
}

int kmod_snprintf(char* to, size_t room, const char* format, ...) {
    va_list list;
    va_start(list, format);
    const int length = kmod_vsnprintf(to, room, format, list);
    va_end(list);
    return length;
}

int kmod_sprintf(char* to, const char* format, ...) {
    va_list list;
    va_start(list, format);
    const int length = kmod_vsnprintf(to, 1u << 16, format, list);
    va_end(list);
    return length;
}

// kmod.h - what a Linux kernel module for this board includes, where de1sim runs it
//
// `de1sim link` compiles a module against this file in place of the kernel's headers.  Names,
// arguments and results are the kernel's (4.19; where a later kernel has other arguments, both).
// The C files here are its runtime: the emulated kernel (sim/linux) calls them by requests, see
// kmod_calls.h.
//
// A module has the addresses from 0xBF000000 on.  Each call of a program runs in a thread of the
// module, an interrupt's handler in one that comes before all others (kmod_later.h).  Registers are
// mapped from /dev/mem, so ioread32() loads.  A device is found by its `compatible`, in the table
// that `de1sim link` makes of the Platform Designer system.
//
// A function that may sleep, called where that is forbidden, a spinlock that is not given back or
// taken twice, and a wrong address end the run, with the message of a kernel that looks for them.
//
// Not handled: seq_file beyond single_open(), kfifo, networks, ALSA, block devices, input devices,
// regmap, clk, gpio, DMA engines, virt_to_phys(); kobjects beside attributes; properties of the
// device tree; a program that reads the modules' memory is not refused.
#ifndef DE1SIM_KMOD_H
#define DE1SIM_KMOD_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// ---- Types ----

typedef uint8_t u8, __u8;
typedef uint16_t u16, __u16, __le16, __be16;
typedef uint32_t u32, __u32, __le32, __be32;
typedef uint64_t u64, __u64;
typedef int8_t s8, __s8;
typedef int16_t s16, __s16;
typedef int32_t s32, __s32;
typedef int64_t s64, __s64;
typedef uint32_t phys_addr_t, resource_size_t, dma_addr_t;
typedef int64_t ktime_t;
typedef unsigned gfp_t, fmode_t, kmod_dev_t, __poll_t;  // libc's dev_t has 64 bits
#ifndef KMOD_RUNTIME                                    // which has those of libc
typedef unsigned char uchar, u_char;
typedef unsigned short ushort, u_short, umode_t, mode_t;
typedef unsigned int uint, u_int;
typedef unsigned dev_t;
typedef unsigned long ulong, u_long, off_t;
typedef long ssize_t;
typedef int64_t loff_t;
#else
typedef unsigned short umode_t;
#endif

#define __iomem
#define __user
#define __kernel
#define __force
#define __init
#define __exit
#define __initdata
#define __exitdata
#define __devinit
#define __devexit
#define __devexit_p(f) (f)
#define __exit_p(f) (f)
#define __maybe_unused __attribute__((unused))
#define __always_unused __attribute__((unused))
#ifndef KMOD_RUNTIME
#define __packed __attribute__((packed))
#endif
#define __aligned(n) __attribute__((aligned(n)))
#define likely(x) __builtin_expect(!!(x), 1)
#define unlikely(x) __builtin_expect(!!(x), 0)
#define fallthrough __attribute__((fallthrough))

#define CONFIG_OF 1
#define CONFIG_ARM 1
#define HZ 100
#define PAGE_SHIFT 12
#define PAGE_SIZE (1UL << PAGE_SHIFT)
#define PAGE_MASK (~(PAGE_SIZE - 1))
#define PAGE_ALIGN(a) (((a) + PAGE_SIZE - 1) & PAGE_MASK)
#define KERNEL_VERSION(a, b, c) (((a) << 16) + ((b) << 8) + (c))
#define LINUX_VERSION_CODE KERNEL_VERSION(4, 19, 0)
#define BIT(n) (1UL << (n))
#define GENMASK(high, low) ((~0UL << (low)) & (~0UL >> (31 - (high))))
#define ARRAY_SIZE(a) (sizeof(a) / sizeof((a)[0]))
#define DIV_ROUND_UP(n, d) (((n) + (d)-1) / (d))
#define ALIGN(x, a) (((x) + (a)-1) & ~((__typeof__(x))(a)-1))
#define container_of(pointer, type, member) \
    ((type*)((char*)(pointer) - __builtin_offsetof(type, member)))
#define min(a, b)               \
    ({                          \
        __typeof__(a) a_ = (a); \
        __typeof__(b) b_ = (b); \
        a_ < b_ ? a_ : b_;      \
    })
#define max(a, b)               \
    ({                          \
        __typeof__(a) a_ = (a); \
        __typeof__(b) b_ = (b); \
        a_ > b_ ? a_ : b_;      \
    })
#define min3(a, b, c) min(min(a, b), c)
#define max3(a, b, c) max(max(a, b), c)
#define abs(n)                  \
    ({                          \
        __typeof__(n) n_ = (n); \
        n_ < 0 ? -n_ : n_;      \
    })
#define roundup(n, to) (((n) + (to)-1) / (to) * (to))
#define rounddown(n, to) ((n) / (to) * (to))
#define IS_ENABLED(option) 0
#define __stringify_(...) #__VA_ARGS__
#define __stringify(...) __stringify_(__VA_ARGS__)
#define min_t(type, a, b) min((type)(a), (type)(b))
#define max_t(type, a, b) max((type)(a), (type)(b))
#define clamp(x, low, high) min(max(x, low), high)
#define swap(a, b)              \
    do {                        \
        __typeof__(a) a_ = (a); \
        (a) = (b);              \
        (b) = a_;               \
    } while (0)
#define upper_32_bits(n) ((u32)((u64)(n) >> 32))
#define lower_32_bits(n) ((u32)(n))
#define BUILD_BUG_ON(condition) _Static_assert(!(condition), #condition)
#define WARN_ON(condition)                             \
    ({                                                 \
        bool met_ = !!(condition);                     \
        if (met_) printk("WARNING: " #condition "\n"); \
        met_;                                          \
    })

#define WARN(condition, ...)                         \
    ({                                               \
        const bool is_so_ = !!(condition);           \
        if (is_so_) printk("WARNING: " __VA_ARGS__); \
        is_so_;                                      \
    })
#define WARN_ON_ONCE WARN_ON
#define WARN_ONCE WARN
void kmod_bug(const void* place, const char* format, ...)
    __attribute__((noreturn, format(printf, 2, 3)));
#define _THIS_IP_               \
    ({                          \
        __label__ here_;        \
    here_:                      \
        (unsigned long)&&here_; \
    })
#define BUG() kmod_bug((void*)_THIS_IP_, "kernel BUG at %s:%d!", __FILE__, __LINE__)
#define BUG_ON(condition)     \
    do {                      \
        if (condition) BUG(); \
    } while (0)
#define panic(...) kmod_bug((void*)_THIS_IP_, "Kernel panic: " __VA_ARGS__)

// ---- Errors ----

#ifndef KMOD_RUNTIME
enum {
    EPERM = 1,
    ENOENT = 2,
    EINTR = 4,
    EIO = 5,
    ENXIO = 6,
    E2BIG = 7,
    EBADF = 9,
    EAGAIN = 11,
    EWOULDBLOCK = 11,
    ENOMEM = 12,
    EACCES = 13,
    EFAULT = 14,
    EBUSY = 16,
    EEXIST = 17,
    ENODEV = 19,
    EINVAL = 22,
    ENFILE = 23,
    EMFILE = 24,
    ENOTTY = 25,
    EFBIG = 27,
    ENOSPC = 28,
    ESPIPE = 29,
    EROFS = 30,
    EPIPE = 32,
    EDOM = 33,
    ERANGE = 34,
    ENOSYS = 38,
    ENODATA = 61,
    ETIME = 62,
    EPROTO = 71,
    EOVERFLOW = 75,
    ENOBUFS = 105,
    ERESTART = 85,
    EOPNOTSUPP = 95,
    ETIMEDOUT = 110,
    EALREADY = 114,
    EINPROGRESS = 115
};
#endif
enum {
    ERESTARTSYS = 512,
    ERESTARTNOINTR = 513,
    ENOIOCTLCMD = 515,
    EPROBE_DEFER = 517,
    ENOTSUPP = 524
};

#define MAX_ERRNO 4095
#define IS_ERR_VALUE(x) ((unsigned long)(x) >= (unsigned long)-MAX_ERRNO)
#define IS_ERR(p) IS_ERR_VALUE(p)
#define IS_ERR_OR_NULL(p) (!(p) || IS_ERR(p))
#define PTR_ERR(p) ((long)(p))
#define ERR_PTR(e) ((void*)(long)(e))

// ---- Messages: on the console, as the kernel's ----

#define KERN_SOH "\001"
#define KERN_EMERG KERN_SOH "0"
#define KERN_ALERT KERN_SOH "1"
#define KERN_CRIT KERN_SOH "2"
#define KERN_ERR KERN_SOH "3"
#define KERN_WARNING KERN_SOH "4"
#define KERN_NOTICE KERN_SOH "5"
#define KERN_INFO KERN_SOH "6"
#define KERN_DEBUG KERN_SOH "7"
#define KERN_CONT KERN_SOH "c"
#define KERN_DEFAULT ""

int printk(const char* format, ...) __attribute__((format(printf, 1, 2)));
#ifndef pr_fmt
#define pr_fmt(format) format
#endif
#define pr_emerg(format, ...) printk(KERN_EMERG pr_fmt(format), ##__VA_ARGS__)
#define pr_alert(format, ...) printk(KERN_ALERT pr_fmt(format), ##__VA_ARGS__)
#define pr_crit(format, ...) printk(KERN_CRIT pr_fmt(format), ##__VA_ARGS__)
#define pr_err(format, ...) printk(KERN_ERR pr_fmt(format), ##__VA_ARGS__)
#define pr_warn(format, ...) printk(KERN_WARNING pr_fmt(format), ##__VA_ARGS__)
#define pr_warning pr_warn
#define pr_notice(format, ...) printk(KERN_NOTICE pr_fmt(format), ##__VA_ARGS__)
#define pr_info(format, ...) printk(KERN_INFO pr_fmt(format), ##__VA_ARGS__)
#define pr_cont(format, ...) printk(KERN_CONT format, ##__VA_ARGS__)
#define pr_debug(format, ...)                 \
    do {                                      \
        if (0) printk(format, ##__VA_ARGS__); \
    } while (0)
#define dev_printk_(dev, format, ...) \
    printk("%s: " format, dev_name((const struct device*)(dev)), ##__VA_ARGS__)
#define dev_err(dev, format, ...) dev_printk_(dev, format, ##__VA_ARGS__)
#define dev_warn(dev, format, ...) dev_printk_(dev, format, ##__VA_ARGS__)
#define dev_notice(dev, format, ...) dev_printk_(dev, format, ##__VA_ARGS__)
#define dev_info(dev, format, ...) dev_printk_(dev, format, ##__VA_ARGS__)
#define dev_dbg(dev, format, ...)                       \
    do {                                                \
        if (0) dev_printk_(dev, format, ##__VA_ARGS__); \
    } while (0)

// ---- Modules ----

struct module;
#define THIS_MODULE ((struct module*)0)
#define KMOD_JOIN_(a, b) a##b
#define KMOD_JOIN(a, b) KMOD_JOIN_(a, b)
void kmod_add_init(const char* name, int (*init)(void));
void kmod_add_exit(const char* name, void (*exit)(void));
#define module_init(f)                                                               \
    static void __attribute__((constructor)) KMOD_JOIN(kmod_init_, __LINE__)(void) { \
        kmod_add_init(KBUILD_MODNAME, f);                                            \
    }
#define module_exit(f)                                                               \
    static void __attribute__((constructor)) KMOD_JOIN(kmod_exit_, __LINE__)(void) { \
        kmod_add_exit(KBUILD_MODNAME, f);                                            \
    }
#define late_initcall(f) module_init(f)
#define device_initcall(f) module_init(f)
#define KMOD_TEXT_(...) _Static_assert(1, "")
#define MODULE_LICENSE(...) KMOD_TEXT_()
#define MODULE_AUTHOR(...) KMOD_TEXT_()
#define MODULE_DESCRIPTION(...) KMOD_TEXT_()
#define MODULE_VERSION(...) KMOD_TEXT_()
#define MODULE_ALIAS(...) KMOD_TEXT_()
#define MODULE_INFO(...) KMOD_TEXT_()
#define MODULE_DEVICE_TABLE(...) KMOD_TEXT_()
#define MODULE_PARM_DESC(...) KMOD_TEXT_()
#define EXPORT_SYMBOL(...) KMOD_TEXT_()
#define EXPORT_SYMBOL_GPL(...) KMOD_TEXT_()
static inline bool try_module_get(struct module* m) { return (void)m, true; }
static inline void module_put(struct module* m) { (void)m; }

// `insmod dial.ko period=5`, and /sys/module/dial/parameters/period.
enum kmod_kind {
    kmod_kind_int,
    kmod_kind_uint,
    kmod_kind_short,
    kmod_kind_ushort,
    kmod_kind_long,
    kmod_kind_ulong,
    kmod_kind_byte,
    kmod_kind_bool,
    kmod_kind__Bool = kmod_kind_bool,  // where bool is <stdbool.h>'s
    kmod_kind_charp
};
struct kmod_parameter {
    const char *module, *name;
    enum kmod_kind kind;
    unsigned short mode;
    void* value;
    unsigned most;  // of an array
    int* count;     // of an array, where the module wants to know it; or NULL
    struct kmod_parameter* next;
};
void kmod_add_parameter(struct kmod_parameter* parameter);
#define KMOD_PARAMETER_(name, value, type, most, count, mode)                                     \
    static void __attribute__((constructor)) KMOD_JOIN(kmod_parameter_, name)(void) {             \
        static struct kmod_parameter parameter = {KBUILD_MODNAME, #name, kmod_kind_##type, mode,  \
                                                  value,          most,  (int*)(count),    NULL}; \
        kmod_add_parameter(&parameter);                                                           \
    }
#define module_param_named(name, value, type, mode) \
    KMOD_PARAMETER_(name, &(value), type, 1, NULL, mode)
#define module_param(name, type, mode) module_param_named(name, name, type, mode)
#define module_param_array(name, type, count, mode) \
    KMOD_PARAMETER_(name, name, type, ARRAY_SIZE(name), count, mode)

#include "kmod_devices.h"

// ---- Memory ----

enum { GFP_KERNEL = 1, GFP_ATOMIC = 2, __GFP_ZERO = 4, GFP_DMA = 8 };
enum { VERIFY_READ, VERIFY_WRITE };
#define access_ok(...) 1
unsigned long copy_from_user(void* to, const void* from, unsigned long n);
unsigned long copy_to_user(void* to, const void* from, unsigned long n);
#define __copy_from_user copy_from_user
#define __copy_to_user copy_to_user
#define get_user(to, from)                                               \
    ({                                                                   \
        __typeof__(*(from)) value_ = 0;                                  \
        const bool lost_ = copy_from_user(&value_, from, sizeof value_); \
        (to) = value_;                                                   \
        lost_ ? -EFAULT : 0;                                             \
    })
#define put_user(from, to)                                      \
    ({                                                          \
        const __typeof__(*(to)) value_ = (from);                \
        copy_to_user(to, &value_, sizeof value_) ? -EFAULT : 0; \
    })
#define __get_user get_user
#define __put_user put_user
long strncpy_from_user(char* to, const char* from, long n);
unsigned long clear_user(void* to, unsigned long n);
void* memdup_user(const void* from, size_t n);
void* kmalloc(size_t n, gfp_t flags);
void* kzalloc(size_t n, gfp_t flags);
void* kcalloc(size_t count, size_t n, gfp_t flags);
void* krealloc(const void* p, size_t n, gfp_t flags);
char* kstrdup(const char* text, gfp_t flags);
char* kasprintf(gfp_t flags, const char* format, ...);
void kfree(const void* p);
#define kmalloc_array(count, n, flags) kcalloc(count, n, flags)
#define devm_kzalloc(dev, n, flags) ((void)(dev), kzalloc(n, flags))
#define devm_kmalloc devm_kzalloc
#define vmalloc(n) kmalloc(n, GFP_KERNEL)
#define vzalloc(n) kzalloc(n, GFP_KERNEL)
#define vfree kfree
#define kvfree kfree

#ifndef KMOD_RUNTIME
void* memcpy(void* to, const void* from, size_t n);
void* memmove(void* to, const void* from, size_t n);
void* memset(void* to, int value, size_t n);
int memcmp(const void* a, const void* b, size_t n);
size_t strlen(const char* s);
size_t strnlen(const char* s, size_t n);
char* strcpy(char* to, const char* from);
char* strncpy(char* to, const char* from, size_t n);
char* strcat(char* to, const char* from);
char* strchr(const char* s, int c);
char* strstr(const char* s, const char* part);
int strcmp(const char* a, const char* b);
int strncmp(const char* a, const char* b, size_t n);
int snprintf(char* to, size_t n, const char* format, ...) __asm__("kmod_snprintf");
int vsnprintf(char* to, size_t n, const char* format, va_list list) __asm__("kmod_vsnprintf");
int sprintf(char* to, const char* format, ...) __asm__("kmod_sprintf");
int sscanf(const char* text, const char* format, ...);
#endif
struct va_format {  // of %pV
    const char* fmt;
    va_list* va;
};
int scnprintf(char* to, size_t n, const char* format, ...);
size_t strlcpy(char* to, const char* from, size_t n);
ssize_t strscpy(char* to, const char* from, size_t n);
int kstrtoint(const char* text, unsigned base, int* to);
int kstrtouint(const char* text, unsigned base, unsigned* to);
int kstrtou8(const char* text, unsigned base, u8* to);
int kstrtol(const char* text, unsigned base, long* to);
int kstrtoul(const char* text, unsigned base, unsigned long* to);
int kstrtobool(const char* text, bool* to);
int kstrtoint_from_user(const char* text, size_t n, unsigned base, int* to);
int kstrtouint_from_user(const char* text, size_t n, unsigned base, unsigned* to);
unsigned long simple_strtoul(const char* text, char** end, unsigned base);
long simple_strtol(const char* text, char** end, unsigned base);
bool sysfs_streq(const char* a, const char* b);
#define sysfs_emit(to, ...) scnprintf(to, PAGE_SIZE, __VA_ARGS__)
static inline u64 div64_u64(u64 a, u64 b) { return a / b; }
static inline u64 div_u64(u64 a, u32 b) { return a / b; }
#define do_div(n, base)                  \
    ({                                   \
        u32 rest_ = (u32)((n) % (base)); \
        (n) /= (base);                   \
        rest_;                           \
    })

// ---- Time ----

void udelay(unsigned long us);
void ndelay(unsigned long ns);
void mdelay(unsigned long ms);
void msleep(unsigned ms);
void usleep_range(unsigned long least, unsigned long most);
unsigned long msleep_interruptible(unsigned ms);
void ssleep(unsigned seconds);
#define cpu_relax() barrier()
unsigned long kmod_jiffies(void);
#define jiffies kmod_jiffies()
#define msecs_to_jiffies(ms) ((unsigned long)(((ms)*HZ + 999) / 1000))
#define usecs_to_jiffies(us) msecs_to_jiffies(((us) + 999) / 1000)
#define jiffies_to_msecs(j) ((unsigned)((j)*1000 / HZ))
#define time_after(a, b) ((long)((b) - (a)) < 0)
#define time_before(a, b) time_after(b, a)
#define time_after_eq(a, b) ((long)((a) - (b)) >= 0)
#define time_before_eq(a, b) time_after_eq(b, a)
ktime_t ktime_get(void);
#define ktime_get_ns() ((u64)ktime_get())
#define ktime_to_ns(t) (t)
#define ktime_to_us(t) ((t) / 1000)
#define ktime_to_ms(t) ((t) / 1000000)
#define ktime_sub(a, b) ((a) - (b))
#define ktime_add(a, b) ((a) + (b))
#define ktime_add_ns(a, ns) ((a) + (s64)(ns))
#define ktime_add_us(a, us) ((a) + (s64)(us)*1000)
#define ktime_add_ms(a, ms) ((a) + (s64)(ms)*1000000)
#define ktime_set(seconds, ns) ((ktime_t)(seconds)*1000000000 + (ktime_t)(ns))
#define ns_to_ktime(ns) ((ktime_t)(ns))
#define us_to_ktime(us) ((ktime_t)(us)*1000)
#define ms_to_ktime(ms) ((ktime_t)(ms)*1000000)
#define ktime_us_delta(a, b) (((a) - (b)) / 1000)
#define ktime_ms_delta(a, b) (((a) - (b)) / 1000000)
#define ktime_get_real ktime_get
#define ktime_get_boottime ktime_get
#define NSEC_PER_SEC 1000000000L
#define NSEC_PER_MSEC 1000000L
#define NSEC_PER_USEC 1000L
#define USEC_PER_SEC 1000000L
#define MSEC_PER_SEC 1000L

#include "kmod_list.h"

#include "kmod_sleep.h"

#include "kmod_later.h"

#endif

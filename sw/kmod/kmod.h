// kmod.h - what a Linux kernel module for this board includes, where it runs in its program
//
// `de1sim link` compiles a module against this file in place of the kernel's headers, and links it
// with the program that uses it and with kmod.c.  Names, arguments and results are the kernel's.
// The program's open("/dev/NAME"), ioctl, read, write, lseek, mmap and close go to the module.
//
// The processor's memory and the program's are the same here, so copy_from_user() copies; registers
// are mapped from /dev/mem, so ioread32() loads.  A device is found by its `compatible`, in the
// table that `de1sim link` makes of the Platform Designer system.
//
// Not handled: interrupts, wait queues, kernel threads, timers and work queues, sysfs and procfs,
// DMA, clocks: a module that calls such a function does not compile.  Parameters of a module keep
// their default values.  fopen() and C++ streams of /dev/NAME do not reach the module.
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
typedef unsigned gfp_t, fmode_t, kmod_dev_t;  // libc's dev_t has 64 bits
#ifndef KMOD_RUNTIME  // which has those of libc
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
#define DIV_ROUND_UP(n, d) (((n) + (d) - 1) / (d))
#define ALIGN(x, a) (((x) + (a) - 1) & ~((__typeof__(x))(a) - 1))
#define container_of(pointer, type, member) \
    ((type*)((char*)(pointer) - __builtin_offsetof(type, member)))
#define min(a, b) \
    ({ __typeof__(a) a_ = (a); __typeof__(b) b_ = (b); a_ < b_ ? a_ : b_; })
#define max(a, b) \
    ({ __typeof__(a) a_ = (a); __typeof__(b) b_ = (b); a_ > b_ ? a_ : b_; })
#define min_t(type, a, b) min((type)(a), (type)(b))
#define max_t(type, a, b) max((type)(a), (type)(b))
#define clamp(x, low, high) min(max(x, low), high)
#define swap(a, b) \
    do { __typeof__(a) a_ = (a); (a) = (b); (b) = a_; } while (0)
#define upper_32_bits(n) ((u32)((u64)(n) >> 32))
#define lower_32_bits(n) ((u32)(n))
#define BUILD_BUG_ON(condition) _Static_assert(!(condition), #condition)
#define WARN_ON(condition) \
    ({ bool met_ = !!(condition); if (met_) printk("WARNING: " #condition "\n"); met_; })

// ---- Errors ----

#ifndef KMOD_RUNTIME
enum {
    EPERM = 1, ENOENT = 2, EINTR = 4, EIO = 5, ENXIO = 6, E2BIG = 7, EBADF = 9, EAGAIN = 11,
    EWOULDBLOCK = 11, ENOMEM = 12, EACCES = 13, EFAULT = 14, EBUSY = 16, EEXIST = 17, ENODEV = 19,
    EINVAL = 22, ENFILE = 23, EMFILE = 24, ENOTTY = 25, EFBIG = 27, ENOSPC = 28, ESPIPE = 29,
    EROFS = 30, EPIPE = 32, EDOM = 33, ERANGE = 34, ENOSYS = 38, ENODATA = 61, ETIME = 62,
    EPROTO = 71, EOVERFLOW = 75, ENOBUFS = 105, ETIMEDOUT = 110, EALREADY = 114, EINPROGRESS = 115
};
#endif
enum { ERESTARTSYS = 512, ENOIOCTLCMD = 515, EPROBE_DEFER = 517, ENOTSUPP = 524 };

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
#define pr_debug(format, ...) \
    do { if (0) printk(format, ##__VA_ARGS__); } while (0)
#define dev_printk_(dev, format, ...) \
    printk("%s: " format, dev_name((const struct device*)(dev)), ##__VA_ARGS__)
#define dev_err(dev, format, ...) dev_printk_(dev, format, ##__VA_ARGS__)
#define dev_warn(dev, format, ...) dev_printk_(dev, format, ##__VA_ARGS__)
#define dev_notice(dev, format, ...) dev_printk_(dev, format, ##__VA_ARGS__)
#define dev_info(dev, format, ...) dev_printk_(dev, format, ##__VA_ARGS__)
#define dev_dbg(dev, format, ...) \
    do { if (0) dev_printk_(dev, format, ##__VA_ARGS__); } while (0)

// ---- Modules ----

struct module;
#define THIS_MODULE ((struct module*)0)
#define KMOD_JOIN_(a, b) a##b
#define KMOD_JOIN(a, b) KMOD_JOIN_(a, b)
void kmod_add_module(const char* name, int (*init)(void), void (*exit)(void));
void kmod_add_exit(const char* name, void (*exit)(void));
#define module_init(f)                                                            \
    static void __attribute__((constructor)) KMOD_JOIN(kmod_init_, __LINE__)(void) { \
        kmod_add_module(KBUILD_MODNAME, f, 0);                                    \
    }
#define module_exit(f)                                                            \
    static void __attribute__((constructor)) KMOD_JOIN(kmod_exit_, __LINE__)(void) { \
        kmod_add_exit(KBUILD_MODNAME, f);                                         \
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
#define module_param(...) KMOD_TEXT_()
#define module_param_named(...) KMOD_TEXT_()
#define module_param_array(...) KMOD_TEXT_()
#define EXPORT_SYMBOL(...) KMOD_TEXT_()
#define EXPORT_SYMBOL_GPL(...) KMOD_TEXT_()
static inline bool try_module_get(struct module* m) { return (void)m, true; }
static inline void module_put(struct module* m) { (void)m; }

// ---- Devices, and how they are found ----

struct device_node;
struct of_device_id {
    char name[32], type[32], compatible[128];
    const void* data;
};
struct device_driver {
    const char* name;
    struct module* owner;
    const struct of_device_id* of_match_table;
    void* bus;
};
struct device {
    struct device* parent;
    struct device_node* of_node;
    void *driver_data, *platform_data;
    struct device_driver* driver;
    const char* init_name;
    kmod_dev_t devt;
};
const char* dev_name(const struct device* dev);
static inline void* dev_get_drvdata(const struct device* dev) { return dev->driver_data; }
static inline void dev_set_drvdata(struct device* dev, void* data) { dev->driver_data = data; }

enum { IORESOURCE_IO = 0x100, IORESOURCE_MEM = 0x200, IORESOURCE_IRQ = 0x400 };
struct resource {
    resource_size_t start, end;
    const char* name;
    unsigned long flags;
    struct resource* parent;
};
static inline resource_size_t resource_size(const struct resource* r) {
    return r->end - r->start + 1;
}

struct platform_device {
    const char* name;
    int id;
    struct device dev;
    unsigned num_resources;
    struct resource* resource;
};
struct platform_device_id {
    char name[20];
    unsigned long driver_data;
};
struct platform_driver {
    int (*probe)(struct platform_device*);
    int (*remove)(struct platform_device*);
    void (*shutdown)(struct platform_device*);
    int (*suspend)(struct platform_device*, int);
    int (*resume)(struct platform_device*);
    struct device_driver driver;
    const struct platform_device_id* id_table;
};
#define to_platform_device(x) container_of((x), struct platform_device, dev)
static inline void* platform_get_drvdata(const struct platform_device* d) {
    return d->dev.driver_data;
}
static inline void platform_set_drvdata(struct platform_device* d, void* data) {
    d->dev.driver_data = data;
}
int platform_driver_register(struct platform_driver* driver);
int platform_driver_probe(struct platform_driver* driver, int (*probe)(struct platform_device*));
void platform_driver_unregister(struct platform_driver* driver);
struct resource* platform_get_resource(struct platform_device* d, unsigned type, unsigned n);
#define module_platform_driver(driver)                                       \
    static int kmod_register(void) { return platform_driver_register(&(driver)); } \
    static void kmod_unregister(void) { platform_driver_unregister(&(driver)); }   \
    module_init(kmod_register) module_exit(kmod_unregister)

#define of_match_ptr(p) (p)
const struct of_device_id* of_match_device(const struct of_device_id* table,
                                           const struct device* dev);
const struct of_device_id* of_match_node(const struct of_device_id* table,
                                         const struct device_node* node);
struct device_node* of_find_compatible_node(struct device_node* from, const char* type,
                                            const char* compatible);
struct device_node* of_find_node_by_name(struct device_node* from, const char* name);
static inline void of_node_put(struct device_node* node) { (void)node; }
int of_address_to_resource(struct device_node* node, int index, struct resource* r);
void* of_iomap(struct device_node* node, int index);

// ---- Registers ----

struct resource* request_mem_region(resource_size_t start, resource_size_t n, const char* name);
void release_mem_region(resource_size_t start, resource_size_t n);
void* ioremap(resource_size_t start, size_t size);
#define ioremap_nocache ioremap
#define ioremap_wc ioremap
void iounmap(volatile void* address);
static inline void* devm_ioremap(struct device* dev, resource_size_t start, size_t size) {
    return (void)dev, ioremap(start, size);
}
#define devm_ioremap_nocache devm_ioremap
void* devm_ioremap_resource(struct device* dev, const struct resource* r);
void* devm_platform_ioremap_resource(struct platform_device* d, unsigned n);
#define devm_request_mem_region(dev, start, n, name) request_mem_region(start, n, name)

#define mb() __asm__ volatile("dmb" : : : "memory")
#define rmb() mb()
#define wmb() mb()
#define smp_mb() mb()
#define barrier() __asm__ volatile("" : : : "memory")
#define KMOD_ACCESS(bits)                                                                      \
    static inline u##bits ioread##bits(const volatile void* a) {                               \
        return *(const volatile u##bits*)a;                                                    \
    }                                                                                          \
    static inline void iowrite##bits(u##bits value, volatile void* a) {                        \
        *(volatile u##bits*)a = value;                                                         \
    }                                                                                          \
    static inline void ioread##bits##_rep(const volatile void* a, void* to, unsigned long n) { \
        for (u##bits* p = (u##bits*)to; n; --n) *p++ = ioread##bits(a);                        \
    }                                                                                          \
    static inline void iowrite##bits##_rep(volatile void* a, const void* from, unsigned long n) { \
        for (const u##bits* p = (const u##bits*)from; n; --n) iowrite##bits(*p++, a);          \
    }
KMOD_ACCESS(8)
KMOD_ACCESS(16)
KMOD_ACCESS(32)
#define readb ioread8
#define readw ioread16
#define readl ioread32
#define writeb iowrite8
#define writew iowrite16
#define writel iowrite32
#define readl_relaxed ioread32
#define writel_relaxed iowrite32
#define __raw_readb ioread8
#define __raw_readl ioread32
#define __raw_writeb iowrite8
#define __raw_writel iowrite32
void memcpy_fromio(void* to, const volatile void* from, size_t n);
void memcpy_toio(volatile void* to, const void* from, size_t n);
void memset_io(volatile void* to, int value, size_t n);

// ---- Files ----

struct file_operations;
struct cdev {
    struct module* owner;
    const struct file_operations* ops;
    kmod_dev_t dev;
    unsigned count;
};
struct inode {
    kmod_dev_t i_rdev;
    struct cdev* i_cdev;
    void* i_private;
};
struct file {
    const struct file_operations* f_op;
    void* private_data;
    unsigned f_flags;
    fmode_t f_mode;
    loff_t f_pos;
    struct inode* f_inode;
};
static inline struct inode* file_inode(const struct file* f) { return f->f_inode; }
static inline unsigned iminor(const struct inode* inode) { return inode->i_rdev & 0xFFFFF; }
static inline unsigned imajor(const struct inode* inode) { return inode->i_rdev >> 20; }

typedef unsigned long pgprot_t;
#define pgprot_noncached(p) (p)
#define pgprot_writecombine(p) (p)
#define VM_IO 0x4000
#define VM_DONTEXPAND 0x40000
#define VM_RESERVED 0
struct vm_area_struct {
    unsigned long vm_start, vm_end, vm_pgoff, vm_flags;
    pgprot_t vm_page_prot;
    void* vm_private_data;
};
int remap_pfn_range(struct vm_area_struct* area, unsigned long at, unsigned long page,
                    unsigned long size, pgprot_t protection);
#define io_remap_pfn_range remap_pfn_range

struct file_operations {
    struct module* owner;
    loff_t (*llseek)(struct file*, loff_t, int);
    ssize_t (*read)(struct file*, char*, size_t, loff_t*);
    ssize_t (*write)(struct file*, const char*, size_t, loff_t*);
    long (*unlocked_ioctl)(struct file*, unsigned, unsigned long);
    long (*compat_ioctl)(struct file*, unsigned, unsigned long);
    int (*mmap)(struct file*, struct vm_area_struct*);
    int (*open)(struct inode*, struct file*);
    int (*flush)(struct file*, void*);
    int (*release)(struct inode*, struct file*);
};
loff_t noop_llseek(struct file* f, loff_t offset, int whence);
loff_t no_llseek(struct file* f, loff_t offset, int whence);
loff_t default_llseek(struct file* f, loff_t offset, int whence);

#define MISC_DYNAMIC_MINOR 255
struct miscdevice {
    int minor;
    const char* name;
    const struct file_operations* fops;
    struct device *parent, *this_device;
    const char* nodename;
    umode_t mode;
};
int misc_register(struct miscdevice* device);
int misc_deregister(struct miscdevice* device);

#define MKDEV(major, minor) ((kmod_dev_t)((major) << 20 | (minor)))
#define MAJOR(dev) ((unsigned)((dev) >> 20))
#define MINOR(dev) ((unsigned)((dev)&0xFFFFF))
struct class {
    const char* name;
};
int register_chrdev(unsigned major, const char* name, const struct file_operations* ops);
void unregister_chrdev(unsigned major, const char* name);
int alloc_chrdev_region(kmod_dev_t* dev, unsigned first, unsigned count, const char* name);
int register_chrdev_region(kmod_dev_t dev, unsigned count, const char* name);
void unregister_chrdev_region(kmod_dev_t dev, unsigned count);
void cdev_init(struct cdev* cdev, const struct file_operations* ops);
struct cdev* cdev_alloc(void);
int cdev_add(struct cdev* cdev, kmod_dev_t dev, unsigned count);
void cdev_del(struct cdev* cdev);
struct class* kmod_class(const char* name);
#define KMOD_CLASS_1(name) kmod_class(name)
#define KMOD_CLASS_2(module, name) kmod_class(name)  // before Linux 6.4
#define KMOD_PICK_(a, b, which, ...) which
#define class_create(...) \
    KMOD_PICK_(__VA_ARGS__, KMOD_CLASS_2, KMOD_CLASS_1, )(__VA_ARGS__)
void class_destroy(struct class* c);
struct device* device_create(struct class* c, struct device* parent, kmod_dev_t dev, void* data,
                             const char* format, ...);
void device_destroy(struct class* c, kmod_dev_t dev);

#ifndef KMOD_RUNTIME
enum {
    O_RDONLY = 0, O_WRONLY = 1, O_RDWR = 2, O_ACCMODE = 3, O_NONBLOCK = 0x800, SEEK_SET = 0,
    SEEK_CUR = 1, SEEK_END = 2, S_IRUSR = 0400, S_IWUSR = 0200, S_IRUGO = 0444, S_IWUGO = 0222
};
#define _IOC(direction, type, number, size) \
    ((direction) << 30 | (size) << 16 | (unsigned)(type) << 8 | (unsigned)(number))
#define _IOC_NONE 0U
#define _IOC_WRITE 1U
#define _IOC_READ 2U
#define _IO(type, number) _IOC(_IOC_NONE, type, number, 0U)
#define _IOR(type, number, of) _IOC(_IOC_READ, type, number, (unsigned)sizeof(of))
#define _IOW(type, number, of) _IOC(_IOC_WRITE, type, number, (unsigned)sizeof(of))
#define _IOWR(type, number, of) _IOC(_IOC_READ | _IOC_WRITE, type, number, (unsigned)sizeof(of))
#define _IOC_DIR(n) ((n) >> 30 & 3U)
#define _IOC_TYPE(n) ((n) >> 8 & 0xFFU)
#define _IOC_NR(n) ((n)&0xFFU)
#define _IOC_SIZE(n) ((n) >> 16 & 0x3FFFU)
#endif

// ---- Memory ----

enum { GFP_KERNEL = 1, GFP_ATOMIC = 2, __GFP_ZERO = 4 };
enum { VERIFY_READ, VERIFY_WRITE };
#define access_ok(...) 1
unsigned long copy_from_user(void* to, const void* from, unsigned long n);
unsigned long copy_to_user(void* to, const void* from, unsigned long n);
#define __copy_from_user copy_from_user
#define __copy_to_user copy_to_user
#define get_user(to, from) ((to) = *(from), 0)
#define put_user(from, to) (*(to) = (from), 0)
unsigned long clear_user(void* to, unsigned long n);
void* memdup_user(const void* from, size_t n);
void* kmalloc(size_t n, gfp_t flags);
void* kzalloc(size_t n, gfp_t flags);
void* kcalloc(size_t count, size_t n, gfp_t flags);
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
int snprintf(char* to, size_t n, const char* format, ...);
int sprintf(char* to, const char* format, ...);
int sscanf(const char* text, const char* format, ...);
#endif
int scnprintf(char* to, size_t n, const char* format, ...);
size_t strlcpy(char* to, const char* from, size_t n);
ssize_t strscpy(char* to, const char* from, size_t n);
int kstrtoint(const char* text, unsigned base, int* to);
int kstrtouint(const char* text, unsigned base, unsigned* to);
int kstrtou8(const char* text, unsigned base, u8* to);
static inline u64 div64_u64(u64 a, u64 b) { return a / b; }
static inline u64 div_u64(u64 a, u32 b) { return a / b; }
#define do_div(n, base) \
    ({ u32 rest_ = (u32)((n) % (base)); (n) /= (base); rest_; })

// ---- Locks: among the program's threads ----

typedef struct {
    int taken;
} spinlock_t, raw_spinlock_t;
struct mutex {
    int taken;
};
struct semaphore {
    int count;
};
typedef struct {
    int counter;
} atomic_t;
#define DEFINE_MUTEX(name) struct mutex name = {0}
#define DEFINE_SPINLOCK(name) spinlock_t name = {0}
#define DEFINE_SEMAPHORE(name) struct semaphore name = {1}
#define __SPIN_LOCK_UNLOCKED(name) {0}
void kmod_lock(int* taken);
bool kmod_try(int* taken);
void kmod_unlock(int* taken);
#define mutex_init(m) ((void)((m)->taken = 0))
#define mutex_destroy(m) ((void)(m))
#define mutex_lock(m) kmod_lock(&(m)->taken)
#define mutex_lock_interruptible(m) (kmod_lock(&(m)->taken), 0)
#define mutex_lock_killable mutex_lock_interruptible
#define mutex_trylock(m) kmod_try(&(m)->taken)
#define mutex_unlock(m) kmod_unlock(&(m)->taken)
#define mutex_is_locked(m) ((m)->taken != 0)
#define spin_lock_init(s) ((void)((s)->taken = 0))
#define spin_lock(s) kmod_lock(&(s)->taken)
#define spin_unlock(s) kmod_unlock(&(s)->taken)
#define spin_lock_irq spin_lock
#define spin_unlock_irq spin_unlock
#define spin_lock_bh spin_lock
#define spin_unlock_bh spin_unlock
#define spin_lock_irqsave(s, flags) ((void)((flags) = 0), kmod_lock(&(s)->taken))
#define spin_unlock_irqrestore(s, flags) ((void)(flags), kmod_unlock(&(s)->taken))
void sema_init(struct semaphore* s, int count);
void down(struct semaphore* s);
#define down_interruptible(s) (down(s), 0)
int down_trylock(struct semaphore* s);
void up(struct semaphore* s);
#define ATOMIC_INIT(n) {n}
#define atomic_read(a) __atomic_load_n(&(a)->counter, __ATOMIC_SEQ_CST)
#define atomic_set(a, n) __atomic_store_n(&(a)->counter, n, __ATOMIC_SEQ_CST)
#define atomic_inc(a) ((void)__atomic_add_fetch(&(a)->counter, 1, __ATOMIC_SEQ_CST))
#define atomic_dec(a) ((void)__atomic_sub_fetch(&(a)->counter, 1, __ATOMIC_SEQ_CST))
#define atomic_inc_return(a) __atomic_add_fetch(&(a)->counter, 1, __ATOMIC_SEQ_CST)
#define atomic_dec_and_test(a) (__atomic_sub_fetch(&(a)->counter, 1, __ATOMIC_SEQ_CST) == 0)
#define atomic_cmpxchg(a, old, new)                                                      \
    ({ int old_ = (old);                                                                 \
       __atomic_compare_exchange_n(&(a)->counter, &old_, new, 0, __ATOMIC_SEQ_CST,       \
                                   __ATOMIC_SEQ_CST);                                    \
       old_; })

// ---- Time ----

void udelay(unsigned long us);
void ndelay(unsigned long ns);
void mdelay(unsigned long ms);
void msleep(unsigned ms);
void usleep_range(unsigned long least, unsigned long most);
void cond_resched(void);
#define cpu_relax() barrier()
unsigned long kmod_jiffies(void);
#define jiffies kmod_jiffies()
#define msecs_to_jiffies(ms) ((unsigned long)(((ms) * HZ + 999) / 1000))
#define usecs_to_jiffies(us) msecs_to_jiffies(((us) + 999) / 1000)
#define jiffies_to_msecs(j) ((unsigned)((j) * 1000 / HZ))
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
#define ktime_us_delta(a, b) (((a) - (b)) / 1000)

#endif

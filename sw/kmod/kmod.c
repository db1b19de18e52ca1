// kmod.c - the part of the kernel that kernel modules call, and the files that they offer, within
// the program that uses them (kmod.h)
//
// The linker sends the program's open(), ioctl() and their like here (--wrap); what is no module's
// goes on to libc.  Modules are initialised before main(), in the order of the command line, and
// left after it in the reverse order.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <sched.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/mman.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>

#define KMOD_RUNTIME
#include "kmod.h"
#include "nodes.h"

int __real_open(const char* path, int flags, ...);
int __real_close(int descriptor);

enum { MODULES = 32, DEVICES = 64, DRIVERS = 32, FILES = 64, NAME = 128 };

int printk(const char* format, ...) {
    char text[1024];
    va_list list;
    va_start(list, format);
    const int level = format[0] == KERN_SOH[0] && format[1] ? 2 : 0;
    vsnprintf(text, sizeof text, format + level, list);
    va_end(list);
    fflush(stdout);
    return fputs(text, stderr);
}

static void* error_pointer(int error) { return (void*)(intptr_t)-error; }

// ---- Modules ----

static struct {
    const char* name;
    int (*init)(void);
    void (*exit)(void);
} modules[MODULES];
static unsigned module_count;

static unsigned module_of(const char* name) {
    unsigned n = 0;
    while (n < module_count && strcmp(modules[n].name, name) != 0) ++n;
    if (n == MODULES) abort();
    if (n == module_count) modules[module_count++].name = name;
    return n;
}

void kmod_add_init(const char* name, int (*init)(void)) { modules[module_of(name)].init = init; }

void kmod_add_exit(const char* name, void (*exit)(void)) { modules[module_of(name)].exit = exit; }

static unsigned initialised;

static void leave_modules(void) {
    while (initialised > 0)
        if (modules[--initialised].exit) modules[initialised].exit();
}

int __real_main(int argc, char** argv, char** environment);
int __wrap_main(int argc, char** argv, char** environment) {
    atexit(leave_modules);
    for (; initialised < module_count; ++initialised) {
        const int result = modules[initialised].init ? modules[initialised].init() : 0;
        if (result == 0) continue;
        printk("kmod: the init function of %s returned %d: %s\n", modules[initialised].name, result,
               strerror(-result));
        exit(1);
    }
    return __real_main(argc, argv, environment);
}

// ---- Devices of the system ----

const char* dev_name(const struct device* dev) {
    return dev->of_node ? dev->of_node->name : dev->init_name ? dev->init_name : "device";
}

static bool is_compatible(const struct device_node* node, const char* wanted) {
    for (const char* const* name = node->compatible; *name; ++name)
        if (strcasecmp(*name, wanted) == 0) return true;
    return false;
}

const struct of_device_id* of_match_node(const struct of_device_id* table,
                                         const struct device_node* node) {
    for (; table && node && table->compatible[0]; ++table)
        if (is_compatible(node, table->compatible)) return table;
    return NULL;
}

const struct of_device_id* of_match_device(const struct of_device_id* table,
                                           const struct device* dev) {
    return of_match_node(table, dev->of_node);
}

struct device_node* of_find_compatible_node(struct device_node* from, const char* type,
                                            const char* compatible) {
    (void)type;
    for (struct device_node* node = from ? from + 1 : kmod_nodes; node->name; ++node)
        if (is_compatible(node, compatible)) return node;
    return NULL;
}

struct device_node* of_find_node_by_name(struct device_node* from, const char* name) {
    for (struct device_node* node = from ? from + 1 : kmod_nodes; node->name; ++node)
        if (strcmp(node->name, name) == 0) return node;
    return NULL;
}

int of_address_to_resource(struct device_node* node, int index, struct resource* r) {
    if (!node || index < 0 || (unsigned)index >= node->regions) return -EINVAL;
    *r = (struct resource){node->first[index], node->first[index] + node->bytes[index] - 1,
                           node->name, IORESOURCE_MEM, NULL};
    return 0;
}

void* of_iomap(struct device_node* node, int index) {
    struct resource r;
    return of_address_to_resource(node, index, &r) ? NULL : ioremap(r.start, resource_size(&r));
}

static struct {
    struct platform_driver* driver;
    struct platform_device device;
    struct resource resources[KMOD_REGIONS];
} bound[DRIVERS];

static int probe_all(struct platform_driver* driver, int (*probe)(struct platform_device*)) {
    const struct of_device_id* table = driver->driver.of_match_table;
    unsigned matches = 0, probed = 0;
    int error = -ENODEV;
    for (struct device_node* node = kmod_nodes; node->name; ++node) {
        if (!of_match_node(table, node)) continue;
        ++matches;
        unsigned n = 0;
        while (n < DRIVERS && bound[n].driver) ++n;
        if (n == DRIVERS) return -ENOMEM;
        memset(&bound[n], 0, sizeof bound[n]);
        struct platform_device* device = &bound[n].device;
        device->name = node->name;
        device->dev.of_node = node;
        device->dev.driver = &driver->driver;
        device->resource = bound[n].resources;
        for (; device->num_resources < node->regions; ++device->num_resources)
            of_address_to_resource(node, (int)device->num_resources,
                                   &bound[n].resources[device->num_resources]);
        bound[n].driver = driver;
        const int result = probe ? probe(device) : 0;
        if (result == 0) {
            ++probed;
        } else {
            bound[n].driver = NULL;
            error = result;
        }
    }
    if (matches == 0) {
        printk("kmod: no module of the system is compatible with %s%s; there are:\n",
               table && table->compatible[0] ? table->compatible : "the driver",
               table && table->compatible[0] && table[1].compatible[0] ? ", ..." : "");
        for (const struct device_node* node = kmod_nodes; node->name; ++node) {
            printk("kmod:   %s:", node->name);
            for (const char* const* name = node->compatible; *name; ++name) printk(" %s", *name);
            printk("\n");
        }
    }
    return probed ? 0 : error;
}

int platform_driver_register(struct platform_driver* driver) {
    const int result = probe_all(driver, driver->probe);
    return result == -ENODEV ? 0 : result;  // a device might still come
}

int platform_driver_probe(struct platform_driver* driver, int (*probe)(struct platform_device*)) {
    return probe_all(driver, probe);
}

void platform_driver_unregister(struct platform_driver* driver) {
    for (unsigned n = 0; n < DRIVERS; ++n) {
        if (bound[n].driver != driver) continue;
        if (driver->remove) driver->remove(&bound[n].device);
        bound[n].driver = NULL;
    }
}

struct resource* platform_get_resource(struct platform_device* d, unsigned type, unsigned n) {
    return type == IORESOURCE_MEM && n < d->num_resources ? &d->resource[n] : NULL;
}

// ---- Registers ----

struct resource* request_mem_region(resource_size_t start, resource_size_t n, const char* name) {
    static struct resource granted;
    granted = (struct resource){start, start + n - 1, name, IORESOURCE_MEM, NULL};
    return &granted;
}

void release_mem_region(resource_size_t start, resource_size_t n) { (void)start, (void)n; }

void* ioremap(resource_size_t start, size_t size) {
    static int memory = -1;
    if (memory < 0) memory = __real_open("/dev/mem", O_RDWR | O_SYNC);
    if (memory < 0) {
        printk("kmod: /dev/mem: %s\n", strerror(errno));
        return NULL;
    }
    const size_t before = start & ~PAGE_MASK;
    char* at = mmap(NULL, PAGE_ALIGN(before + size), PROT_READ | PROT_WRITE, MAP_SHARED, memory,
                    (off_t)(start & PAGE_MASK));
    if (at != MAP_FAILED) return at + before;
    printk("kmod: 0x%x of /dev/mem: %s\n", start, strerror(errno));
    return NULL;
}

void iounmap(volatile void* address) { (void)address; }  // the program's end does

void* devm_ioremap_resource(struct device* dev, const struct resource* r) {
    (void)dev;
    if (!r) return error_pointer(EINVAL);
    void* at = ioremap(r->start, resource_size(r));
    return at ? at : error_pointer(ENOMEM);
}

void* devm_platform_ioremap_resource(struct platform_device* d, unsigned n) {
    return devm_ioremap_resource(&d->dev, platform_get_resource(d, IORESOURCE_MEM, n));
}

// Of words where both sides are aligned, as the kernel makes them, else of bytes: memcpy() of libc
// makes accesses of any size.
static bool are_words(const volatile void* a, const volatile void* b, size_t n) {
    return (((uintptr_t)a | (uintptr_t)b | n) & 3) == 0;
}
void memcpy_fromio(void* to, const volatile void* from, size_t n) {
    if (are_words(to, from, n))
        for (size_t i = 0; i < n / 4; ++i) ((u32*)to)[i] = ioread32((const volatile u32*)from + i);
    else
        for (size_t i = 0; i < n; ++i) ((u8*)to)[i] = ioread8((const volatile u8*)from + i);
}
void memcpy_toio(volatile void* to, const void* from, size_t n) {
    if (are_words(to, from, n))
        for (size_t i = 0; i < n / 4; ++i) iowrite32(((const u32*)from)[i], (volatile u32*)to + i);
    else
        for (size_t i = 0; i < n; ++i) iowrite8(((const u8*)from)[i], (volatile u8*)to + i);
}
void memset_io(volatile void* to, int value, size_t n) {
    for (size_t i = 0; i < n; ++i) iowrite8((u8)value, (volatile u8*)to + i);
}

// ---- Files in /dev and /sys ----

static struct {
    char name[NAME];  // behind /dev/, or a path in /sys; empty: none
    const struct file_operations* ops;
    struct inode inode;
    struct device device;
} devices[DEVICES];

static struct {
    const struct file_operations* ops;
    kmod_dev_t first;
    unsigned count;
    struct cdev* cdev;
} numbers[DEVICES];

static struct {
    int number;  // of the descriptor; 0: none, since 0 is the program's input
    struct file file;
} files[FILES];

// Without operations: those of its number, when it is opened.
static int add_device(const char* name, const struct file_operations* ops, kmod_dev_t dev) {
    if (strncmp(name, "/dev/", 5) == 0) name += 5;
    for (unsigned n = 0; n < DEVICES; ++n)
        if (strcmp(devices[n].name, name) == 0) return -EEXIST;
    for (unsigned n = 0; n < DEVICES; ++n) {
        if (devices[n].name[0]) continue;
        snprintf(devices[n].name, NAME, "%s", name);
        devices[n].ops = ops;
        devices[n].inode = (struct inode){dev, NULL, NULL};
        devices[n].device = (struct device){.init_name = devices[n].name, .devt = dev};
        return (int)n;
    }
    return -ENOMEM;
}

static void remove_device(kmod_dev_t dev, const struct file_operations* ops) {
    for (unsigned n = 0; n < DEVICES; ++n)
        if (devices[n].name[0] && devices[n].inode.i_rdev == dev && (!ops || devices[n].ops == ops))
            devices[n].name[0] = '\0';
}

int misc_register(struct miscdevice* device) {
    const int n = add_device(device->nodename ? device->nodename : device->name, device->fops,
                             MKDEV(10, device->minor));
    if (n < 0) return n;
    static struct class misc = {"misc"};
    device->this_device = &devices[n].device;
    devices[n].device.class = &misc;
    devices[n].inode.i_private = device;
    return 0;
}

int misc_deregister(struct miscdevice* device) {
    remove_device(MKDEV(10, device->minor), device->fops);
    return 0;
}

static unsigned next_major = 240;

static int add_numbers(kmod_dev_t first, unsigned count, const struct file_operations* ops,
                       struct cdev* cdev) {
    for (unsigned n = 0; n < DEVICES; ++n)
        if (numbers[n].count == 0) {
            numbers[n].ops = ops;
            numbers[n].first = first;
            numbers[n].count = count ? count : 1;
            numbers[n].cdev = cdev;
            return 0;
        }
    return -ENOMEM;
}

int register_chrdev(unsigned major, const char* name, const struct file_operations* ops) {
    const unsigned number = major ? major : next_major++;
    const int error = add_numbers(MKDEV(number, 0), 256, ops, NULL);
    if (error) return error;
    const int n = add_device(name, NULL, MKDEV(number, 0));  // what people make by mknod
    return n < 0 ? n : major ? 0 : (int)number;
}

void unregister_chrdev(unsigned major, const char* name) {
    (void)name;
    remove_device(MKDEV(major, 0), NULL);
}

int alloc_chrdev_region(kmod_dev_t* dev, unsigned first, unsigned count, const char* name) {
    (void)count, (void)name;
    *dev = MKDEV(next_major++, first);
    return 0;
}

int register_chrdev_region(kmod_dev_t dev, unsigned count, const char* name) {
    (void)dev, (void)count, (void)name;
    return 0;
}

void unregister_chrdev_region(kmod_dev_t dev, unsigned count) { (void)dev, (void)count; }

void cdev_init(struct cdev* cdev, const struct file_operations* ops) {
    memset(cdev, 0, sizeof *cdev);
    cdev->ops = ops;
}

struct cdev* cdev_alloc(void) {
    return calloc(1, sizeof(struct cdev));
}

int cdev_add(struct cdev* cdev, kmod_dev_t dev, unsigned count) {
    cdev->dev = dev;
    cdev->count = count;
    return add_numbers(dev, count, cdev->ops, cdev);
}

void cdev_del(struct cdev* cdev) {
    for (unsigned n = 0; n < DEVICES; ++n)
        if (numbers[n].cdev == cdev) numbers[n].count = 0;
}

struct class* kmod_class(const char* name) {
    struct class* c = calloc(1, sizeof *c);
    if (c) c->name = name;
    return c ? c : error_pointer(ENOMEM);
}

void class_destroy(struct class* c) { free(c); }

struct device* device_create(struct class* c, struct device* parent, kmod_dev_t dev, void* data,
                             const char* format, ...) {
    (void)parent;
    char name[NAME];
    va_list list;
    va_start(list, format);
    vsnprintf(name, sizeof name, format, list);
    va_end(list);
    for (unsigned n = 0; n < DEVICES; ++n)  // that register_chrdev() has made
        if (devices[n].inode.i_rdev == dev && strcmp(devices[n].name, name) == 0)
            devices[n].name[0] = '\0';
    const int n = add_device(name, NULL, dev);
    if (n < 0) return error_pointer(-n);
    devices[n].device.class = c;
    devices[n].device.driver_data = data;
    return &devices[n].device;
}

void device_destroy(struct class* c, kmod_dev_t dev) {
    (void)c;
    remove_device(dev, NULL);
}

loff_t no_llseek(struct file* f, loff_t offset, int whence) {
    (void)f, (void)offset, (void)whence;
    return -ESPIPE;
}
loff_t noop_llseek(struct file* f, loff_t offset, int whence) {
    (void)offset, (void)whence;
    return f->f_pos;
}
loff_t default_llseek(struct file* f, loff_t offset, int whence) {
    if (whence == SEEK_END) return -EINVAL;
    f->f_pos = whence == SEEK_CUR ? f->f_pos + offset : offset;
    return f->f_pos;
}

ssize_t simple_read_from_buffer(void* to, size_t n, loff_t* at, const void* from,
                                size_t available) {
    if (*at < 0) return -EINVAL;
    if ((size_t)*at >= available) return 0;
    if (n > available - (size_t)*at) n = available - (size_t)*at;
    memcpy(to, (const char*)from + *at, n);
    *at += (loff_t)n;
    return (ssize_t)n;
}
ssize_t simple_write_to_buffer(void* to, size_t available, loff_t* at, const void* from, size_t n) {
    if (*at < 0) return -EINVAL;
    if ((size_t)*at >= available) return 0;
    if (n > available - (size_t)*at) n = available - (size_t)*at;
    memcpy((char*)to + *at, from, n);
    *at += (loff_t)n;
    return (ssize_t)n;
}

// ---- Attributes ----

struct bus_type platform_bus_type = {"platform"};

static struct entry {
    struct device_driver* driver;  // one of the two
    struct device* device;
    const struct attribute* attribute;
    const struct driver_attribute* of_driver;
    const struct device_attribute* of_device;
} entries[DEVICES];

// What Linux lets nobody do: read an attribute that cannot show itself, or write one that keeps
// nothing.
static int open_attribute(struct inode* inode, struct file* f) {
    const struct entry* e = inode->i_private;
    const bool shows = e->driver ? e->of_driver->show != NULL : e->of_device->show != NULL;
    const bool stores = e->driver ? e->of_driver->store != NULL : e->of_device->store != NULL;
    const unsigned way = f->f_flags & O_ACCMODE;
    if (way != O_WRONLY && !(shows && e->attribute->mode & 0444)) return -EACCES;
    if (way != O_RDONLY && !(stores && e->attribute->mode & 0222)) return -EACCES;
    return 0;
}

static ssize_t read_attribute(struct file* f, char* to, size_t n, loff_t* at) {
    const struct entry* e = f->private_data;
    char page[4096] = {0};
    const ssize_t length =
        e->driver ? e->of_driver->show(e->driver, page)
                  : e->of_device->show(e->device, (struct device_attribute*)e->of_device, page);
    return length < 0 ? length : simple_read_from_buffer(to, n, at, page, (size_t)length);
}

static ssize_t write_attribute(struct file* f, const char* from, size_t n, loff_t* at) {
    (void)at;
    const struct entry* e = f->private_data;
    char page[4096];
    if (n >= sizeof page) n = sizeof page - 1;
    memcpy(page, from, n);
    page[n] = '\0';
    return e->driver
               ? e->of_driver->store(e->driver, page, n)
               : e->of_device->store(e->device, (struct device_attribute*)e->of_device, page, n);
}

static const struct file_operations attribute_ops = {
    .open = open_attribute, .read = read_attribute, .write = write_attribute};

static int add_attribute(const char* folder, struct entry entry) {
    char path[NAME];
    snprintf(path, sizeof path, "%s/%s", folder, entry.attribute->name);
    struct entry* e = entries;
    while (e < entries + DEVICES && e->attribute) ++e;
    if (e == entries + DEVICES) return -ENOMEM;
    const int n = add_device(path, &attribute_ops, 0);
    if (n < 0) return n;
    *e = entry;
    devices[n].inode.i_private = e;
    return 0;
}

static void remove_attribute(const void* of, const struct attribute* attribute) {
    for (unsigned n = 0; n < DEVICES; ++n) {
        struct entry* e = devices[n].inode.i_private;
        if (!devices[n].name[0] || devices[n].ops != &attribute_ops || e->attribute != attribute ||
            (of != e->driver && of != e->device))
            continue;
        devices[n].name[0] = '\0';
        e->attribute = NULL;
    }
}

int driver_register(struct device_driver* driver) { return driver->name ? 0 : -EINVAL; }
void driver_unregister(struct device_driver* driver) { (void)driver; }

int driver_create_file(struct device_driver* driver, const struct driver_attribute* attribute) {
    char folder[NAME];
    snprintf(folder, sizeof folder, "/sys/bus/%s/drivers/%s",
             driver->bus ? driver->bus->name : platform_bus_type.name, driver->name);
    return add_attribute(
        folder,
        (struct entry){.driver = driver, .attribute = &attribute->attr, .of_driver = attribute});
}
void driver_remove_file(struct device_driver* driver, const struct driver_attribute* attribute) {
    remove_attribute(driver, &attribute->attr);
}

int device_create_file(struct device* device, const struct device_attribute* attribute) {
    char folder[NAME];
    struct resource r = {0};
    of_address_to_resource(device->of_node, 0, &r);
    if (device->class)
        snprintf(folder, sizeof folder, "/sys/class/%s/%s", device->class->name, dev_name(device));
    else
        snprintf(folder, sizeof folder, "/sys/bus/platform/devices/%x.%s", r.start,
                 dev_name(device));
    return add_attribute(
        folder,
        (struct entry){.device = device, .attribute = &attribute->attr, .of_device = attribute});
}
void device_remove_file(struct device* device, const struct device_attribute* attribute) {
    remove_attribute(device, &attribute->attr);
}

// ---- What the program calls ----

// What a system call returns.
static long answer(long result) {
    if (result >= 0 || result < -MAX_ERRNO) return result;
    errno = result == -ERESTARTSYS ? EINTR : result == -ENOIOCTLCMD ? ENOTTY : (int)-result;
    return -1;
}

static struct file* file_of(int descriptor) {
    for (unsigned n = 0; descriptor > 0 && n < FILES; ++n)
        if (files[n].number == descriptor) return &files[n].file;
    return NULL;
}

static int open_device(unsigned device, int flags) {
    struct inode* inode = &devices[device].inode;
    const struct file_operations* ops = devices[device].ops;
    for (unsigned n = 0; !ops && n < DEVICES; ++n) {
        if (numbers[n].count == 0 || inode->i_rdev - numbers[n].first >= numbers[n].count) continue;
        ops = numbers[n].ops;
        inode->i_cdev = numbers[n].cdev;
    }
    if (!ops) {
        errno = ENXIO;
        return -1;
    }
    unsigned n = 0;
    while (n < FILES && files[n].number) ++n;
    const int descriptor = n == FILES ? -1 : dup(STDERR_FILENO);  // a number that nobody else has
    if (descriptor < 0) {
        errno = EMFILE;
        return -1;
    }
    files[n].file = (struct file){.f_op = ops,
                                  .f_flags = (unsigned)flags,
                                  .f_mode = (fmode_t)((flags + 1) & 3),
                                  .f_inode = inode,
                                  // where a misc device's open() finds itself
                                  .private_data = inode->i_private};
    const int result = ops->open ? ops->open(inode, &files[n].file) : 0;
    if (result != 0) {
        __real_close(descriptor);
        return (int)answer(result);
    }
    files[n].number = descriptor;
    return descriptor;
}

// The device of that path; DEVICES: none.
static unsigned device_at(const char* path) {
    if (strncmp(path, "/dev/", 5) == 0)
        path += 5;
    else if (strncmp(path, "/sys/", 5) != 0)
        return DEVICES;
    unsigned n = 0;
    while (n < DEVICES && !(devices[n].name[0] && strcmp(devices[n].name, path) == 0)) ++n;
    return n;
}

#define OPEN(function)                                                                \
    int __real_##function(const char* path, int flags, ...);                          \
    int __wrap_##function(const char* path, int flags, ...) {                         \
        const unsigned device = device_at(path);                                      \
        if (device < DEVICES) return open_device(device, flags);                      \
        va_list list;                                                                 \
        va_start(list, flags);                                                        \
        const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(list, mode_t) : 0; \
        va_end(list);                                                                 \
        return __real_##function(path, flags, mode);                                  \
    }
OPEN(open)
OPEN(open64)

int __wrap_close(int descriptor) {
    for (unsigned n = 0; descriptor > 0 && n < FILES; ++n) {
        if (files[n].number != descriptor) continue;
        const struct file_operations* ops = files[n].file.f_op;
        files[n].number = 0;
        const int result = ops->release ? ops->release(files[n].file.f_inode, &files[n].file) : 0;
        __real_close(descriptor);
        return (int)answer(result);
    }
    return __real_close(descriptor);
}

ssize_t __real_read(int descriptor, void* to, size_t n);
ssize_t __wrap_read(int descriptor, void* to, size_t n) {
    struct file* f = file_of(descriptor);
    if (!f) return __real_read(descriptor, to, n);
    return answer(f->f_op->read ? f->f_op->read(f, to, n, &f->f_pos) : -EINVAL);
}

ssize_t __real_write(int descriptor, const void* from, size_t n);
ssize_t __wrap_write(int descriptor, const void* from, size_t n) {
    struct file* f = file_of(descriptor);
    if (!f) return __real_write(descriptor, from, n);
    return answer(f->f_op->write ? f->f_op->write(f, from, n, &f->f_pos) : -EINVAL);
}

#define LSEEK(name, type)                                                            \
    type __real_##name(int descriptor, type offset, int whence);                     \
    type __wrap_##name(int descriptor, type offset, int whence) {                    \
        struct file* f = file_of(descriptor);                                        \
        if (!f) return __real_##name(descriptor, offset, whence);                    \
        return (type)answer(                                                         \
            (long)(f->f_op->llseek ? f->f_op->llseek(f, offset, whence) : -ESPIPE)); \
    }
LSEEK(lseek, long)
LSEEK(lseek64, int64_t)

// As a stream, whose reads and writes are those of the file.
static ssize_t read_stream(void* cookie, char* to, size_t n) {
    return __wrap_read((int)(intptr_t)cookie, to, n);
}
static ssize_t write_stream(void* cookie, const char* from, size_t n) {
    const ssize_t written = __wrap_write((int)(intptr_t)cookie, from, n);
    return written < 0 ? 0 : written;
}
static int seek_stream(void* cookie, int64_t* offset, int whence) {
    const int64_t at = __wrap_lseek64((int)(intptr_t)cookie, *offset, whence);
    if (at < 0) return -1;
    *offset = at;
    return 0;
}
static int close_stream(void* cookie) { return __wrap_close((int)(intptr_t)cookie); }

#define FOPEN(name)                                                                         \
    FILE* __real_##name(const char* path, const char* mode);                                \
    FILE* __wrap_##name(const char* path, const char* mode) {                               \
        const unsigned device = device_at(path);                                            \
        if (device == DEVICES) return __real_##name(path, mode);                            \
        const int descriptor = open_device(device, strchr(mode, '+') ? O_RDWR               \
                                                   : mode[0] == 'r'  ? O_RDONLY             \
                                                                     : O_WRONLY);            \
        if (descriptor < 0) return NULL;                                                    \
        return fopencookie(                                                                 \
            (void*)(intptr_t)descriptor, mode,                                              \
            (cookie_io_functions_t){read_stream, write_stream, seek_stream, close_stream}); \
    }
FOPEN(fopen)
FOPEN(fopen64)

#define IOCTL(name)                                                                      \
    int __real_##name(int descriptor, unsigned long request, ...);                       \
    int __wrap_##name(int descriptor, unsigned long request, ...) {                      \
        va_list list;                                                                    \
        va_start(list, request);                                                         \
        const unsigned long argument = va_arg(list, unsigned long);                      \
        va_end(list);                                                                    \
        struct file* f = file_of(descriptor);                                            \
        if (!f) return __real_##name(descriptor, request, argument);                     \
        return (int)answer(f->f_op->unlocked_ioctl                                       \
                               ? f->f_op->unlocked_ioctl(f, (unsigned)request, argument) \
                               : -ENOTTY);                                               \
    }
IOCTL(ioctl)
IOCTL(__ioctl_time64)

// ---- A device's memory in the program ----

static void* mapped;

int remap_pfn_range(struct vm_area_struct* area, unsigned long at, unsigned long page,
                    unsigned long size, pgprot_t protection) {
    (void)area, (void)at, (void)protection;
    mapped = ioremap(page << PAGE_SHIFT, size);
    return mapped ? 0 : -EAGAIN;
}

static void* map_device(struct file* f, size_t size, int64_t offset) {
    struct vm_area_struct area = {.vm_end = PAGE_ALIGN(size),
                                  .vm_pgoff = (unsigned long)(offset >> PAGE_SHIFT)};
    mapped = NULL;
    const int result = f->f_op->mmap ? f->f_op->mmap(f, &area) : -ENODEV;
    if (result == 0 && mapped) return mapped;
    errno = result ? -result : ENOMEM;
    return MAP_FAILED;
}

#define MMAP(name, type)                                                                  \
    void* __real_##name(void* at, size_t size, int protection, int flags, int descriptor, \
                        type offset);                                                     \
    void* __wrap_##name(void* at, size_t size, int protection, int flags, int descriptor, \
                        type offset) {                                                    \
        struct file* f = file_of(descriptor);                                             \
        return f ? map_device(f, size, offset)                                            \
                 : __real_##name(at, size, protection, flags, descriptor, offset);        \
    }
MMAP(mmap, long)
MMAP(mmap64, int64_t)

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
    return copy ? memcpy(copy, from, n) : error_pointer(ENOMEM);
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

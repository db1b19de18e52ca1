// kmod_files.c - the files in /dev and /sys that kernel modules offer, and the program's calls
//
// The linker sends the program's open(), ioctl() and their like here (--wrap); what is no module's
// goes on to libc.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/types.h>
#include <unistd.h>

#define KMOD_RUNTIME
#include "kmod.h"

int __real_close(int descriptor);

enum { DEVICES = 64, FILES = 64, NAME = 128 };

// ---- Files in /dev and /sys ----

static struct {
    char name[NAME];  // after /dev/, or a path in /sys; empty: none
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
    return c ? c : ERR_PTR(-ENOMEM);
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
    if (n < 0) return ERR_PTR(n);
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

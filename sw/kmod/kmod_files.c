// kmod_files.c - a module's files, and the requests of programs that have them open
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

#include "runtime.h"

enum { FILES = 256, NUMBERS = 64, MISC_MAJOR = 10, WAY = 3 };

// ---- Files that are offered ----

static struct {
    char path[KMOD_NAME];  // empty: none
    const struct file_operations* ops;  // NULL: those of its number, when it is opened
    struct inode inode;
    struct device device, *of;
} files[FILES];

static struct numbers {
    const struct file_operations* ops;
    kmod_dev_t first;
    unsigned count;
    struct cdev* cdev;
} numbers[NUMBERS];

int kmod_offer(const char* path, unsigned mode, const struct file_operations* ops, kmod_dev_t dev,
               void* data, struct device* device) {
    int n = 0;
    while (n < FILES && files[n].path[0]) ++n;
    if (n == FILES) return -ENOMEM;
    const long error = kmod_call(KMOD_OFFER, (uintptr_t)path, mode, dev, (uintptr_t)n, 0);
    if (error) return (int)error;
    snprintf(files[n].path, KMOD_NAME, "%s", path);
    files[n].ops = ops;
    files[n].inode = (struct inode){dev, NULL, data};
    files[n].of = device;
    return n;
}

void kmod_withdraw(int id) {
    kmod_call(KMOD_WITHDRAW, (uintptr_t)id, 0, 0, 0, 0);
    files[id].path[0] = '\0';
}

void kmod_withdraw_path(const char* path) {
    const size_t length = strlen(path);
    for (int n = 0; n < FILES; ++n)
        if (strncmp(files[n].path, path, length) == 0 &&
            (files[n].path[length] == '\0' || files[n].path[length] == '/'))
            kmod_withdraw(n);
}

// The one with this number and, unless NULL, these operations; FILES: none.
static int file_with(kmod_dev_t dev, const struct file_operations* ops) {
    int n = 0;
    while (n < FILES && !(files[n].path[0] && files[n].inode.i_rdev == dev &&
                          (!ops || files[n].ops == ops)))
        ++n;
    return n;
}

static struct class misc = {"misc"};

static int add_device(const char* name, const struct file_operations* ops, kmod_dev_t dev,
                      struct class* class, void* data) {
    char path[KMOD_NAME];
    if (strncmp(name, "/dev/", 5) == 0) name += 5;
    snprintf(path, sizeof path, "/dev/%s", name);
    for (char* c = path; *c; ++c)
        if (*c == '!') *c = '/';
    const int n = kmod_offer(path, KMOD_CHARACTER | 0600, ops, dev, data, NULL);
    if (n < 0) return n;
    struct device* const device = &files[n].device;
    *device = (struct device){.init_name = files[n].path + 5, .devt = dev, .class = class};
    files[n].of = device;
    snprintf(device->kobj.path, sizeof device->kobj.path, "/sys/class/%s/%s",
             class ? class->name : misc.name, name);
    return n;
}

static void remove_device(kmod_dev_t dev, const struct file_operations* ops) {
    const int n = file_with(dev, ops);
    if (n < FILES) kmod_withdraw(n);
}

int misc_register(struct miscdevice* device) {
    static int next_minor = 63;
    if (device->minor == MISC_DYNAMIC_MINOR) device->minor = next_minor--;
    const int n = add_device(device->nodename ? device->nodename : device->name, device->fops,
                             MKDEV(MISC_MAJOR, device->minor), &misc, device);
    if (n < 0) return n;
    device->this_device = &files[n].device;
    device->this_device->parent = device->parent;
    return 0;
}

int misc_deregister(struct miscdevice* device) {
    remove_device(MKDEV(MISC_MAJOR, device->minor), device->fops);
    return 0;
}

// ---- Numbers of character devices ----

static unsigned next_major = 240;

static int add_numbers(kmod_dev_t first, unsigned count, const struct file_operations* ops,
                       struct cdev* cdev) {
    for (struct numbers* n = numbers; n < numbers + NUMBERS; ++n) {
        if (n->count) continue;
        *n = (struct numbers){ops, first, count ? count : 1, cdev};
        return (int)kmod_call(KMOD_OFFER, (uintptr_t) "", KMOD_CHARACTER | 0600, first,
                              FILES + (uintptr_t)(n - numbers), 0);
    }
    return -ENOMEM;
}

static void remove_numbers(struct numbers* n) {
    kmod_call(KMOD_WITHDRAW, FILES + (uintptr_t)(n - numbers), 0, 0, 0, 0);
    n->count = 0;
}

static struct numbers* numbers_with(kmod_dev_t dev) {
    for (struct numbers* n = numbers; n < numbers + NUMBERS; ++n)
        if (n->count && dev - n->first < n->count) return n;
    return NULL;
}

int register_chrdev(unsigned major, const char* name, const struct file_operations* ops) {
    const unsigned number = major ? major : next_major++;
    const int error = add_numbers(MKDEV(number, 0), 256, ops, NULL);
    if (error) return error;
    // What people make by mknod; device_create() may give it another name.
    const int n = add_device(name, NULL, MKDEV(number, 0), NULL, NULL);
    return n < 0 ? n : major ? 0 : (int)number;
}

void unregister_chrdev(unsigned major, const char* name) {
    (void)name;
    remove_device(MKDEV(major, 0), NULL);
    struct numbers* const n = numbers_with(MKDEV(major, 0));
    if (n) remove_numbers(n);
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

struct cdev* cdev_alloc(void) { return calloc(1, sizeof(struct cdev)); }

int cdev_add(struct cdev* cdev, kmod_dev_t dev, unsigned count) {
    cdev->dev = dev;
    cdev->count = count;
    return add_numbers(dev, count, cdev->ops, cdev);
}

void cdev_del(struct cdev* cdev) {
    for (struct numbers* n = numbers; n < numbers + NUMBERS; ++n)
        if (n->count && n->cdev == cdev) remove_numbers(n);
}

struct class* kmod_class(const char* name) {
    struct class* c = calloc(1, sizeof *c);
    if (c) c->name = name;
    return c ? c : ERR_PTR(-ENOMEM);
}

void class_destroy(struct class* c) { free(c); }

struct device* device_create(struct class* c, struct device* parent, kmod_dev_t dev, void* data,
                             const char* format, ...) {
    char name[KMOD_NAME];
    va_list list;
    va_start(list, format);
    kmod_vsnprintf(name, sizeof name, format, list);
    va_end(list);
    const int old = file_with(dev, NULL);
    if (old < FILES && !files[old].device.class) kmod_withdraw(old);
    const int n = add_device(name, NULL, dev, c, NULL);
    if (n < 0) return ERR_PTR(n);
    files[n].device.driver_data = data;
    files[n].device.parent = parent;
    return &files[n].device;
}

void device_destroy(struct class* c, kmod_dev_t dev) {
    (void)c;
    remove_device(dev, NULL);
}

// ---- What a module's functions call ----

loff_t noop_llseek(struct file* f, loff_t offset, int whence) {
    (void)offset, (void)whence;
    return f->f_pos;
}
loff_t no_llseek(struct file* f, loff_t offset, int whence) {
    (void)f, (void)offset, (void)whence;
    return -ESPIPE;
}
loff_t default_llseek(struct file* f, loff_t offset, int whence) {
    if (whence == SEEK_CUR) offset += f->f_pos;
    if (whence == SEEK_END || offset < 0) return -EINVAL;
    return f->f_pos = offset;
}

ssize_t simple_read_from_buffer(void* to, size_t n, loff_t* at, const void* from,
                                size_t available) {
    if (*at < 0) return -EINVAL;
    if ((size_t)*at >= available) return 0;
    if (n > available - (size_t)*at) n = available - (size_t)*at;
    n -= copy_to_user(to, (const char*)from + *at, n);
    if (n == 0) return -EFAULT;
    *at += (loff_t)n;
    return (ssize_t)n;
}
ssize_t simple_write_to_buffer(void* to, size_t available, loff_t* at, const void* from, size_t n) {
    if (*at < 0) return -EINVAL;
    if ((size_t)*at >= available) return 0;
    if (n > available - (size_t)*at) n = available - (size_t)*at;
    n -= copy_from_user((char*)to + *at, from, n);
    if (n == 0) return -EFAULT;
    *at += (loff_t)n;
    return (ssize_t)n;
}

int remap_pfn_range(struct vm_area_struct* area, unsigned long at, unsigned long page,
                    unsigned long size, pgprot_t protection) {
    (void)area, (void)protection;
    return (int)kmod_call(KMOD_MAP, at, page << PAGE_SHIFT, PAGE_ALIGN(size), 0, 0);
}
int vm_iomap_memory(struct vm_area_struct* area, phys_addr_t start, unsigned long size) {
    const unsigned long wanted = area->vm_end - area->vm_start, from = area->vm_pgoff << PAGE_SHIFT;
    if (from + wanted > PAGE_ALIGN(size)) return -EINVAL;
    return remap_pfn_range(area, area->vm_start, (start + from) >> PAGE_SHIFT, wanted, 0);
}
int dma_mmap_coherent(struct device* dev, struct vm_area_struct* area, void* address, dma_addr_t at,
                      size_t size) {
    (void)dev, (void)address;
    return vm_iomap_memory(area, at, size);
}

// ---- Programs that a signal tells ----

struct fasync_struct {
    struct file* file;
    struct fasync_struct* next;
};

int fasync_helper(int descriptor, struct file* file, int on, struct fasync_struct** list) {
    (void)descriptor;
    struct fasync_struct** at = list;
    while (*at && (*at)->file != file) at = &(*at)->next;
    struct fasync_struct* const there = *at;
    if (on && !there) {
        struct fasync_struct* const added = calloc(1, sizeof *added);
        if (!added) return -ENOMEM;
        added->file = file;
        *at = added;
        return 1;
    }
    if (on || !there) return 0;
    *at = there->next;
    free(there);
    return 1;
}
void kill_fasync(struct fasync_struct** list, int signal, int band) {
    (void)band;
    for (struct fasync_struct* at = *list; at; at = at->next)
        kmod_call(KMOD_SIGNAL, (uintptr_t)at->file, (uintptr_t)signal, 0, 0, 0);
}

// ---- Requests ----

static s64 open_file(int id, unsigned flags, kmod_dev_t dev) {
    if (id < 0) id = file_with(dev, NULL);  // a node that mknod has made
    struct inode number = {dev, NULL, NULL};
    struct inode* const inode = id < FILES ? &files[id].inode : &number;
    const struct file_operations* ops = id < FILES ? files[id].ops : NULL;
    const struct numbers* const of = ops ? NULL : numbers_with(inode->i_rdev);
    if (of) {
        ops = of->ops;
        inode->i_cdev = of->cdev;
    }
    if (!ops) return -ENXIO;
    struct file* const f = calloc(1, sizeof *f + sizeof *inode);
    if (!f) return -ENOMEM;
    struct inode* const own = (struct inode*)(f + 1);
    *own = *inode;
    *f = (struct file){.f_op = ops,
                       .f_flags = flags,
                       .f_mode = (fmode_t)((flags + 1) & WAY),
                       .f_inode = id < FILES ? inode : own,
                       .private_data = inode->i_private};
    const int result = ops->open ? ops->open(f->f_inode, f) : 0;
    if (result == 0) return (s64)(uintptr_t)f;
    free(f);
    return result;
}

static s64 map(struct file* f, unsigned long at, unsigned long bytes, unsigned long page) {
    struct vm_area_struct area = {
        .vm_start = at, .vm_end = at + bytes, .vm_pgoff = page, .vm_file = f};
    return f->f_op->mmap ? f->f_op->mmap(f, &area) : -ENODEV;
}

static s64 answer(const struct kmod_request* r) {
    struct file* const f = (struct file*)r->file;
    if (r->operation == KMOD_OPEN) return open_file((int)r->a, r->flags, r->b);
    const struct file_operations* const ops = f->f_op;
    f->f_flags = r->flags;
    switch (r->operation) {
        case KMOD_RELEASE: {
            const int result = ops->release ? ops->release(f->f_inode, f) : 0;
            free(f);
            return result;
        }
        case KMOD_FLUSH: return ops->flush ? ops->flush(f, NULL) : 0;
        case KMOD_READ: return ops->read ? ops->read(f, (char*)r->a, r->b, &f->f_pos) : -EINVAL;
        case KMOD_WRITE:
            return ops->write ? ops->write(f, (const char*)r->a, r->b, &f->f_pos) : -EINVAL;
        case KMOD_SEEK:
            return ops->llseek ? ops->llseek(f, (loff_t)((u64)r->b << 32 | r->a), (int)r->c)
                               : -ESPIPE;
        case KMOD_IOCTL: {
            const long result = ops->unlocked_ioctl ? ops->unlocked_ioctl(f, r->a, r->b) : -ENOTTY;
            return result == -ENOIOCTLCMD ? -ENOTTY : result;
        }
        case KMOD_MMAP: return map(f, r->a, r->b, r->c);
        case KMOD_POLL: {
            poll_table table = {true};
            return ops->poll ? ops->poll(f, &table)
                             : POLLIN | POLLOUT | POLLRDNORM | POLLWRNORM;
        }
        case KMOD_FASYNC: return ops->fasync ? ops->fasync((int)r->a, f, (int)r->b) : 0;
        default: return -EINVAL;
    }
}

void kmod_answer(struct kmod_request* request) {
    const s64 result = answer(request);
    request->result = (int32_t)result;
    request->result_high = (int32_t)(result >> 32);
}

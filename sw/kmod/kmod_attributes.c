// kmod_attributes.c - files of text that modules offer: attributes in /sys, parameters, /proc,
// debugfs
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

#include "runtime.h"

enum { ENTRIES = 192, PAGE = 4096 };

// ---- Attributes ----

struct bus_type platform_bus_type = {"platform"};
static struct kobject kernel_object = {"/sys/kernel"};
struct kobject* const kernel_kobj = &kernel_object;

// Of a driver, a device, an object or a parameter.
static struct entry {
    enum { NONE, DRIVER, DEVICE, OBJECT, PARAMETER } kind;
    const void* of;
    const void* attribute;
    int id;
} entries[ENTRIES];

static ssize_t show_parameter(const struct kmod_parameter* p, char* to);
static int set_parameter(const struct kmod_parameter* p, const char* text);

static bool has(const struct entry* e, bool store) {
    switch (e->kind) {
        case DRIVER: {
            const struct driver_attribute* const a = e->attribute;
            return store ? a->store != NULL : a->show != NULL;
        }
        case DEVICE: {
            const struct device_attribute* const a = e->attribute;
            return store ? a->store != NULL : a->show != NULL;
        }
        case OBJECT: {
            const struct kobj_attribute* const a = e->attribute;
            return store ? a->store != NULL : a->show != NULL;
        }
        default: return true;
    }
}

static ssize_t show(const struct entry* e, char* page) {
    switch (e->kind) {
        case DRIVER:
            return ((struct driver_attribute*)e->attribute)
                ->show((struct device_driver*)e->of, page);
        case DEVICE:
            return ((struct device_attribute*)e->attribute)
                ->show((struct device*)e->of, (struct device_attribute*)e->attribute, page);
        case OBJECT:
            return ((struct kobj_attribute*)e->attribute)
                ->show((struct kobject*)e->of, (struct kobj_attribute*)e->attribute, page);
        default: return show_parameter(e->attribute, page);
    }
}

static ssize_t store(const struct entry* e, const char* page, size_t n) {
    switch (e->kind) {
        case DRIVER:
            return ((struct driver_attribute*)e->attribute)
                ->store((struct device_driver*)e->of, page, n);
        case DEVICE:
            return ((struct device_attribute*)e->attribute)
                ->store((struct device*)e->of, (struct device_attribute*)e->attribute, page, n);
        case OBJECT:
            return ((struct kobj_attribute*)e->attribute)
                ->store((struct kobject*)e->of, (struct kobj_attribute*)e->attribute, page, n);
        default: {
            const int error = set_parameter(e->attribute, page);
            return error ? error : (ssize_t)n;
        }
    }
}

// The first of each kind of attribute.
static const struct attribute* head(const struct entry* e) { return e->attribute; }

// What Linux lets nobody do: read an attribute that cannot show itself, or write one that keeps
// nothing.
static int open_attribute(struct inode* inode, struct file* f) {
    const struct entry* e = inode->i_private;
    const unsigned way = f->f_flags & O_ACCMODE;
    const unsigned mode = e->kind == PARAMETER
                              ? ((const struct kmod_parameter*)e->attribute)->mode
                              : head(e)->mode;
    if (way != O_WRONLY && !(has(e, false) && mode & 0444)) return -EACCES;
    if (way != O_RDONLY && !(has(e, true) && mode & 0222)) return -EACCES;
    return 0;
}

static ssize_t read_attribute(struct file* f, char* to, size_t n, loff_t* at) {
    char* const page = calloc(1, PAGE);
    if (!page) return -ENOMEM;
    ssize_t result = show(f->private_data, page);
    if (result >= 0) result = simple_read_from_buffer(to, n, at, page, (size_t)result);
    free(page);
    return result;
}

static ssize_t write_attribute(struct file* f, const char* from, size_t n, loff_t* at) {
    (void)at;
    if (n > PAGE - 1) n = PAGE - 1;
    char* const page = calloc(1, PAGE);
    if (!page) return -ENOMEM;
    const ssize_t result = copy_from_user(page, from, n) ? -EFAULT : store(f->private_data, page, n);
    free(page);
    return result;
}

static const struct file_operations attribute_ops = {.open = open_attribute,
                                                     .read = read_attribute,
                                                     .write = write_attribute,
                                                     .llseek = default_llseek};

static int add_entry(int kind, const void* of, const void* attribute, unsigned mode,
                     const char* folder, const char* name) {
    char path[2 * KMOD_NAME];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    struct entry* e = entries;
    while (e < entries + ENTRIES && e->kind != NONE) ++e;
    if (e == entries + ENTRIES || strlen(path) >= KMOD_NAME) return -ENOMEM;
    *e = (struct entry){kind, of, attribute, 0};
    e->id = kmod_offer(path, KMOD_REGULAR | mode, &attribute_ops, 0, e, NULL);
    if (e->id >= 0) return 0;
    e->kind = NONE;
    return e->id;
}

static void remove_entry(const void* of, const void* attribute) {
    for (struct entry* e = entries; e < entries + ENTRIES; ++e) {
        if (e->kind == NONE || e->of != of || e->attribute != attribute) continue;
        kmod_withdraw(e->id);
        e->kind = NONE;
    }
}

int driver_register(struct device_driver* driver) { return driver->name ? 0 : -EINVAL; }
void driver_unregister(struct device_driver* driver) { (void)driver; }

int driver_create_file(struct device_driver* driver, const struct driver_attribute* attribute) {
    char folder[KMOD_NAME];
    snprintf(folder, sizeof folder, "/sys/bus/%s/drivers/%s",
             driver->bus ? driver->bus->name : platform_bus_type.name, driver->name);
    return add_entry(DRIVER, driver, attribute, attribute->attr.mode, folder, attribute->attr.name);
}
void driver_remove_file(struct device_driver* driver, const struct driver_attribute* attribute) {
    remove_entry(driver, attribute);
}

static const char* folder_of(struct device* device) {
    struct resource r = {0};
    if (!device->kobj.path[0]) {
        of_address_to_resource(device->of_node, 0, &r);
        snprintf(device->kobj.path, sizeof device->kobj.path, "/sys/bus/platform/devices/%x.%s",
                 r.start, dev_name(device));
    }
    return device->kobj.path;
}
int device_create_file(struct device* device, const struct device_attribute* attribute) {
    return add_entry(DEVICE, device, attribute, attribute->attr.mode, folder_of(device),
                     attribute->attr.name);
}
void device_remove_file(struct device* device, const struct device_attribute* attribute) {
    remove_entry(device, attribute);
}

// ---- Objects; that of a device has its device's attributes ----

static const char OBJECT_OF_DEVICE[] = "/sys/class/", OBJECT_ON_BUS[] = "/sys/bus/";

static bool is_of_a_device(const struct kobject* object) {
    return !object->path[0] ||
           strncmp(object->path, OBJECT_OF_DEVICE, sizeof OBJECT_OF_DEVICE - 1) == 0 ||
           strncmp(object->path, OBJECT_ON_BUS, sizeof OBJECT_ON_BUS - 1) == 0;
}

struct kobject* kobject_create_and_add(const char* name, struct kobject* parent) {
    struct kobject* const object = calloc(1, sizeof *object);
    if (object)
        snprintf(object->path, sizeof object->path, "%.60s/%.60s", parent ? parent->path : "/sys",
                 name);
    return object;
}
void kobject_put(struct kobject* object) {
    for (struct entry* e = entries; e < entries + ENTRIES; ++e)
        if (e->kind == OBJECT && e->of == object) remove_entry(object, e->attribute);
    free(object);
}

int sysfs_create_file(struct kobject* object, const struct attribute* attribute) {
    if (!is_of_a_device(object))
        return add_entry(OBJECT, object, attribute, attribute->mode, object->path, attribute->name);
    return device_create_file(container_of(object, struct device, kobj),
                              (const struct device_attribute*)attribute);
}
void sysfs_remove_file(struct kobject* object, const struct attribute* attribute) {
    if (is_of_a_device(object))
        remove_entry(container_of(object, struct device, kobj), attribute);
    else
        remove_entry(object, attribute);
}
int sysfs_create_group(struct kobject* object, const struct attribute_group* group) {
    int error = 0;
    for (struct attribute** at = group->attrs; *at && !error; ++at)
        error = sysfs_create_file(object, *at);
    return error;
}
void sysfs_remove_group(struct kobject* object, const struct attribute_group* group) {
    for (struct attribute** at = group->attrs; *at; ++at) sysfs_remove_file(object, *at);
}

// ---- Parameters ----

static struct kmod_parameter* parameters;

void kmod_add_parameter(struct kmod_parameter* parameter) {
    parameter->next = parameters;
    parameters = parameter;
}

static int set_value(const struct kmod_parameter* p, unsigned n, const char* text) {
    long long value = 0;
    char* end;
    if (p->kind == kmod_kind_charp) {
        ((char**)p->value)[n] = strdup(text);
        return 0;
    }
    if (p->kind == kmod_kind_bool) {
        bool on = true;
        const int error = *text ? kstrtobool(text, &on) : 0;
        if (!error) ((bool*)p->value)[n] = on;
        return error;
    }
    errno = 0;
    value = strtoll(text, &end, 0);
    if (*end == '\n') ++end;
    if (end == text || *end) return -EINVAL;
    static const struct {
        long long least, most;
    } ranges[] = {{INT32_MIN, INT32_MAX}, {0, UINT32_MAX}, {INT16_MIN, INT16_MAX},
                  {0, UINT16_MAX},        {INT32_MIN, INT32_MAX}, {0, UINT32_MAX}, {0, UINT8_MAX}};
    if (errno || value < ranges[p->kind].least || value > ranges[p->kind].most) return -ERANGE;
    switch (p->kind) {
        case kmod_kind_short:
        case kmod_kind_ushort: ((u16*)p->value)[n] = (u16)value; break;
        case kmod_kind_byte: ((u8*)p->value)[n] = (u8)value; break;
        default: ((u32*)p->value)[n] = (u32)value; break;
    }
    return 0;
}

static int set_parameter(const struct kmod_parameter* p, const char* text) {
    if (p->most == 1) return set_value(p, 0, text);
    char* const copy = strdup(text);
    unsigned n = 0;
    int error = 0;
    for (char *rest = copy, *one; !error && (one = strsep(&rest, ",")); ++n)
        error = n < p->most ? set_value(p, n, one) : -EINVAL;
    if (!error && p->count) *p->count = (int)n;
    free(copy);
    return error;
}

int kmod_set_parameter(const char* text) {
    const char* const value = strchr(text, '=');
    const size_t length = value ? (size_t)(value - text) : strlen(text);
    for (const struct kmod_parameter* p = parameters; p; p = p->next) {
        if (strncmp(p->name, text, length) != 0 || p->name[length]) continue;
        const int error = !value && p->kind != kmod_kind_bool ? -EINVAL
                                                              : set_parameter(p, value ? value + 1 : "");
        if (error)
            printk(KERN_ERR "%s: `%s' invalid for parameter `%s'\n", p->module,
                   value ? value + 1 : "", p->name);
        return error;
    }
    printk(KERN_WARNING "unknown parameter '%.*s' ignored\n", (int)length, text);
    return 0;
}

static int show_value(const struct kmod_parameter* p, unsigned n, char* to, size_t room) {
    switch (p->kind) {
        case kmod_kind_charp: return snprintf(to, room, "%s", ((char**)p->value)[n]);
        case kmod_kind_bool: return snprintf(to, room, "%c", ((bool*)p->value)[n] ? 'Y' : 'N');
        case kmod_kind_short: return snprintf(to, room, "%d", ((s16*)p->value)[n]);
        case kmod_kind_ushort: return snprintf(to, room, "%u", ((u16*)p->value)[n]);
        case kmod_kind_byte: return snprintf(to, room, "%u", ((u8*)p->value)[n]);
        case kmod_kind_int:
        case kmod_kind_long: return snprintf(to, room, "%d", ((int*)p->value)[n]);
        default: return snprintf(to, room, "%u", ((u32*)p->value)[n]);
    }
}

static ssize_t show_parameter(const struct kmod_parameter* p, char* to) {
    const unsigned count = p->most > 1 && p->count ? (unsigned)*p->count : p->most;
    ssize_t length = 0;
    for (unsigned n = 0; n < count && length < PAGE / 2; ++n) {
        if (n) to[length++] = ',';
        length += show_value(p, n, to + length, PAGE / 2);
    }
    to[length++] = '\n';
    return length;
}

int kmod_offer_parameters(const char* module) {
    char folder[KMOD_NAME];
    snprintf(folder, sizeof folder, "/sys/module/%s/parameters", module);
    for (const struct kmod_parameter* p = parameters; p; p = p->next) {
        if (strcmp(p->module, module) != 0 || p->mode == 0) continue;
        const int error = add_entry(PARAMETER, p, p, p->mode, folder, p->name);
        if (error) return error;
    }
    return 0;
}

// ---- Texts that a function writes ----

static int vprint(struct seq_file* s, const char* format, va_list list) {
    const size_t room = s->size - s->count;
    const int length = kmod_vsnprintf(s->buf + s->count, room, format, list);
    s->count = length < (int)room ? s->count + (size_t)length : s->size;
    return 0;
}
int seq_printf(struct seq_file* s, const char* format, ...) {
    va_list list;
    va_start(list, format);
    vprint(s, format, list);
    va_end(list);
    return 0;
}
void seq_puts(struct seq_file* s, const char* text) { seq_printf(s, "%s", text); }
void seq_putc(struct seq_file* s, char c) { seq_printf(s, "%c", c); }

int single_open(struct file* f, int (*function)(struct seq_file*, void*), void* data) {
    struct seq_file* const s = calloc(1, sizeof *s);
    if (!s) return -ENOMEM;
    s->private = data;
    s->function = function;
    f->private_data = s;
    return 0;
}
ssize_t seq_read(struct file* f, char* to, size_t n, loff_t* at) {
    struct seq_file* const s = f->private_data;
    if (!s->buf || *at == 0) {
        s->size = 16 * PAGE;
        s->count = 0;
        if (!s->buf) s->buf = malloc(s->size);
        if (!s->buf) return -ENOMEM;
        const int error = s->function(s, s->private);
        if (error) return error;
    }
    return simple_read_from_buffer(to, n, at, s->buf, s->count);
}
loff_t seq_lseek(struct file* f, loff_t offset, int whence) {
    return default_llseek(f, offset, whence);
}
int single_release(struct inode* inode, struct file* f) {
    (void)inode;
    struct seq_file* const s = f->private_data;
    free(s->buf);
    free(s);
    return 0;
}

// ---- /proc and debugfs ----

struct proc_dir_entry {
    char path[KMOD_NAME];
    int id;
    struct file_operations ops;
};

static struct proc_dir_entry* add_text(const char* root, const char* name, unsigned mode,
                                       struct proc_dir_entry* parent,
                                       const struct file_operations* ops, void* data) {
    struct proc_dir_entry* const entry = calloc(1, sizeof *entry);
    if (!entry) return NULL;
    snprintf(entry->path, sizeof entry->path, "%.60s/%.60s", parent ? parent->path : root, name);
    entry->id = -1;
    if (!ops) return entry;
    entry->ops = *ops;
    entry->id = kmod_offer(entry->path, KMOD_REGULAR | (mode & 0777 ? mode & 0777 : 0444),
                           &entry->ops, 0, data, NULL);
    if (entry->id >= 0) return entry;
    free(entry);
    return NULL;
}
static void remove_text(struct proc_dir_entry* entry) {
    if (!entry) return;
    if (entry->id >= 0) kmod_withdraw(entry->id);
    free(entry);
}

struct proc_dir_entry* kmod_proc_create(const char* name, umode_t mode,
                                        struct proc_dir_entry* parent,
                                        const struct file_operations* ops, void* data) {
    return add_text("/proc", name, mode, parent, ops, data);
}
struct proc_dir_entry* kmod_proc_create_ops(const char* name, umode_t mode,
                                            struct proc_dir_entry* parent,
                                            const struct proc_ops* ops, void* data) {
    const struct file_operations as_files = {.open = ops->proc_open,
                                             .read = ops->proc_read,
                                             .write = ops->proc_write,
                                             .llseek = ops->proc_lseek,
                                             .release = ops->proc_release,
                                             .poll = ops->proc_poll,
                                             .unlocked_ioctl = ops->proc_ioctl,
                                             .mmap = ops->proc_mmap};
    return add_text("/proc", name, mode, parent, &as_files, data);
}
struct proc_dir_entry* proc_mkdir(const char* name, struct proc_dir_entry* parent) {
    return add_text("/proc", name, 0, parent, NULL, NULL);
}
void proc_remove(struct proc_dir_entry* entry) { remove_text(entry); }
void* PDE_DATA(const struct inode* inode) { return inode->i_private; }
static int open_single(struct inode* inode, struct file* f) {
    const struct single {
        int (*show)(struct seq_file*, void*);
        void* data;
    }* const single = inode->i_private;
    return single_open(f, single->show, single->data);
}
struct proc_dir_entry* proc_create_single_data(const char* name, umode_t mode,
                                               struct proc_dir_entry* parent,
                                               int (*show)(struct seq_file*, void*), void* data) {
    static const struct file_operations ops = {
        .open = open_single, .read = seq_read, .llseek = seq_lseek, .release = single_release};
    void** const single = calloc(2, sizeof *single);
    if (!single) return NULL;
    single[0] = (void*)show;
    single[1] = data;
    return add_text("/proc", name, mode, parent, &ops, single);
}
void remove_proc_entry(const char* name, struct proc_dir_entry* parent) {
    char path[KMOD_NAME];
    snprintf(path, sizeof path, "%.60s/%.60s", parent ? parent->path : "/proc", name);
    kmod_withdraw_path(path);
}

struct dentry* debugfs_create_dir(const char* name, struct dentry* parent) {
    return (struct dentry*)add_text("/sys/kernel/debug", name, 0, (struct proc_dir_entry*)parent,
                                    NULL, NULL);
}
struct dentry* debugfs_create_file(const char* name, umode_t mode, struct dentry* parent,
                                   void* data, const struct file_operations* ops) {
    return (struct dentry*)add_text("/sys/kernel/debug", name, mode,
                                    (struct proc_dir_entry*)parent, ops, data);
}

static ssize_t read_number(struct file* f, char* to, size_t n, loff_t* at, const char* format,
                           unsigned bytes) {
    char text[24];
    u32 value = 0;
    memcpy(&value, f->f_inode->i_private, bytes);
    const int length = snprintf(text, sizeof text, format, value);
    return simple_read_from_buffer(to, n, at, text, (size_t)length);
}
static ssize_t write_number(struct file* f, const char* from, size_t n, unsigned bytes) {
    unsigned value;
    const int error = kstrtouint_from_user(from, n, 0, &value);
    if (error) return error;
    memcpy(f->f_inode->i_private, &value, bytes);
    return (ssize_t)n;
}
#define NUMBER(name, bytes, format)                                                           \
    static ssize_t read_##name(struct file* f, char* to, size_t n, loff_t* at) {              \
        return read_number(f, to, n, at, format, bytes);                                      \
    }                                                                                         \
    static ssize_t write_##name(struct file* f, const char* from, size_t n, loff_t* at) {     \
        (void)at;                                                                             \
        return write_number(f, from, n, bytes);                                               \
    }                                                                                         \
    void debugfs_create_##name(const char* file, umode_t mode, struct dentry* parent,         \
                               void* value) {                                                 \
        static const struct file_operations ops = {                                           \
            .read = read_##name, .write = write_##name, .llseek = default_llseek};            \
        debugfs_create_file(file, mode, parent, value, &ops);                                 \
    }
NUMBER(u8, 1, "%u\n")
NUMBER(u16, 2, "%u\n")
NUMBER(u32, 4, "%u\n")
NUMBER(x8, 1, "0x%02x\n")
NUMBER(x16, 2, "0x%04x\n")
NUMBER(x32, 4, "0x%08x\n")
NUMBER(bool, 1, "%u\n")

void debugfs_remove(struct dentry* entry) { remove_text((struct proc_dir_entry*)entry); }
void debugfs_remove_recursive(struct dentry* entry) {
    if (!entry) return;
    kmod_withdraw_path(((struct proc_dir_entry*)entry)->path);
    remove_text((struct proc_dir_entry*)entry);
}

// kmod.c - kernel modules in the program that uses them: their init and exit, the system's devices
// and their registers (kmod.h)
//
// Modules are initialised before main(), in the order of the command line, and left after it in the
// reverse order.
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/mman.h>
#include <sys/types.h>
#include <unistd.h>

#define KMOD_RUNTIME
#include "kmod.h"
#include "nodes.h"

int __real_open(const char* path, int flags, ...);

enum { MODULES = 32, DRIVERS = 32 };

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
    if (!r) return ERR_PTR(-EINVAL);
    void* at = ioremap(r->start, resource_size(r));
    return at ? at : ERR_PTR(-ENOMEM);
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

// kmod.c - a module's beginning and end, the system's devices and their registers (kmod.h)
//
// Modules that are linked together are initialised in the order of the command line, and left in
// the reverse order.
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

#include "runtime.h"
#include "nodes.h"

enum { MODULES = 32, DRIVERS = 32, CONTINUES = 'c', MESSAGE = 4 };

int printk(const char* format, ...) {
    char text[1024];
    va_list list;
    va_start(list, format);
    const int begin = format[0] == KERN_SOH[0] && format[1] ? 2 : 0;
    const int level = !begin ? MESSAGE : format[1] == CONTINUES ? -1 : format[1] - '0';
    int length = kmod_vsnprintf(text, sizeof text, format + begin, list);
    va_end(list);
    if (length > (int)sizeof text - 1) length = (int)sizeof text - 1;
    kmod_call(KMOD_LOG, (uintptr_t)text, (uintptr_t)length, (uintptr_t)level, 0, 0);
    return length;
}

void kmod_bug(const void* place, const char* format, ...) {
    char text[512];
    va_list list;
    va_start(list, format);
    kmod_vsnprintf(text, sizeof text, format, list);
    va_end(list);
    for (;;) kmod_call(KMOD_STOP, (uintptr_t)text, (uintptr_t)place, 0, 0, 0);
}

// ---- Modules ----

static struct {
    const char* name;
    int (*init)(void);
    void (*exit)(void);
} modules[MODULES];
static unsigned module_count, initialised;

static unsigned module_of(const char* name) {
    unsigned n = 0;
    while (n < module_count && strcmp(modules[n].name, name) != 0) ++n;
    if (n == MODULES) abort();
    if (n == module_count) modules[module_count++].name = name;
    return n;
}

void kmod_add_init(const char* name, int (*init)(void)) { modules[module_of(name)].init = init; }

void kmod_add_exit(const char* name, void (*exit)(void)) { modules[module_of(name)].exit = exit; }

static int initialise(void) {
    for (; initialised < module_count; ++initialised) {
        const char* const name = modules[initialised].name;
        const int result = modules[initialised].init ? modules[initialised].init() : 0;
        kmod_check_returned("the module's init function");
        if (result < 0) {
            printk(KERN_ERR "%s: the init function returned %d: %s\n", name, result,
                   strerror(-result));
            return result;
        }
        const int error = kmod_offer_parameters(name);
        if (error) return error;
    }
    return 0;
}

static void leave(void) {
    while (initialised > 0) {
        if (modules[--initialised].exit) modules[initialised].exit();
        kmod_check_returned("the module's exit function");
    }
}

// Answers requests for ever; the first is that the module is initialised.
static void* serve(void* data) {
    struct kmod_context* const context = kmod_context();
    struct kmod_request request = {.operation = KMOD_INITIALISED,
                                   .result = data ? *(const int*)data : 0};
    for (;;) {
        kmod_call(KMOD_NEXT, (uintptr_t)&request, 0, 0, 0, 0);
        if (request.is_last) kmod_begin_thread(serve, NULL);
        // A lock's owner is the program's thread, whichever thread of the module runs for it.
        if (request.pid) context->number = (int)request.pid;
        context->task.pid = context->task.tgid = context->number;
        memcpy(context->task.comm, request.command, sizeof request.command);
        context->task.state = TASK_RUNNING;
        if (request.operation == KMOD_EXIT) {
            leave();
            request.result = 0;
        } else {
            kmod_answer(&request);
        }
        kmod_check_returned("the module's function");
    }
    return NULL;
}

int main(int argc, char** argv) {
    int result = 0;
    for (int n = 1; n < argc && result == 0; ++n) result = kmod_set_parameter(argv[n]);
    if (result == 0) result = initialise();
    serve(&result);
    return 0;
}

// ---- Devices of the system ----

const char* dev_name(const struct device* dev) {
    return dev->of_node ? dev->of_node->name : dev->init_name ? dev->init_name : "device";
}

// Of a component that nothing in the project describes the vendor is not known: "?,switch-1.0" is
// compatible with that name of any vendor.
static bool is_compatible(const struct device_node* node, const char* wanted) {
    static const char* last;
    const char* const comma = strchr(wanted, ',');
    for (const char* const* name = node->compatible; *name; ++name) {
        if (strcasecmp(*name, wanted) == 0) return true;
        if (!comma || **name != '?' || strcasecmp(*name + 1, comma) != 0) continue;
        if (last != wanted)
            printk("kmod: %s is taken for %s: the project does not say its vendor\n", node->name,
                   wanted);
        last = wanted;
        return true;
    }
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
    struct resource resources[KMOD_REGIONS + KMOD_INTERRUPTS];
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
        for (unsigned i = 0; i < node->interrupt_count; ++i)
            bound[n].resources[device->num_resources++] = (struct resource){
                node->interrupts[i], node->interrupts[i], node->name, IORESOURCE_IRQ, NULL};
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
            for (const char* const* name = node->compatible; *name; ++name)
                printk(KERN_CONT " %s", *name);
            printk(KERN_CONT "\n");
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
    for (unsigned i = 0; i < d->num_resources; ++i)
        if (d->resource[i].flags == type && n-- == 0) return &d->resource[i];
    return NULL;
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
    if (memory < 0) memory = open("/dev/mem", O_RDWR | O_SYNC);
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

void iounmap(volatile void* address) { (void)address; }  // the module's end does

void* dma_alloc_coherent(struct device* dev, size_t n, dma_addr_t* at, gfp_t flags) {
    (void)dev, (void)flags;
    u32 physical = 0;
    if (kmod_call(KMOD_ALLOCATE, n, (uintptr_t)&physical, 0, 0, 0) != 0) return NULL;
    *at = physical;
    return ioremap(physical, n);
}
void dma_free_coherent(struct device* dev, size_t n, void* address, dma_addr_t at) {
    (void)dev, (void)n, (void)address, (void)at;
}

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

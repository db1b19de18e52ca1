// kmod_devices.h - of kmod.h: devices, how a module finds them, their registers, and the files that
// it offers in /dev
#ifndef DE1SIM_KMOD_DEVICES_H
#define DE1SIM_KMOD_DEVICES_H

// ---- Devices, and how they are found ----

struct device_node;
struct of_device_id {
    char name[32], type[32], compatible[128];
    const void* data;
};
struct bus_type {
    const char* name;
};
extern struct bus_type platform_bus_type;
struct device_driver {
    const char* name;
    struct bus_type* bus;
    struct module* owner;
    const struct of_device_id* of_match_table;
};
struct class;
struct kobject {
    char path[128];  // "/sys/kernel/dial"
};
struct device {
    struct kobject kobj;
    struct device* parent;
    struct class* class;
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
#define module_platform_driver(driver)                                             \
    static int kmod_register(void) { return platform_driver_register(&(driver)); } \
    static void kmod_unregister(void) { platform_driver_unregister(&(driver)); }   \
    module_init(kmod_register) module_exit(kmod_unregister)

#define module_platform_driver_probe(driver, probe)                                    \
    static int kmod_register(void) { return platform_driver_probe(&(driver), probe); } \
    static void kmod_unregister(void) { platform_driver_unregister(&(driver)); }       \
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

enum { IRQ_TYPE_NONE = 0, IRQ_TYPE_EDGE_RISING = 1, IRQ_TYPE_LEVEL_HIGH = 4 };

// Memory that the FPGA and the processor reach, at `*at` of the bus; it is not given back.
void* dma_alloc_coherent(struct device* dev, size_t n, dma_addr_t* at, gfp_t flags);
#define dmam_alloc_coherent dma_alloc_coherent
#define dma_zalloc_coherent dma_alloc_coherent
void dma_free_coherent(struct device* dev, size_t n, void* address, dma_addr_t at);
#define DMA_BIT_MASK(n) ((n) >= 64 ? ~0ULL : (1ULL << (n)) - 1)
#define dma_set_mask_and_coherent(dev, mask) ((void)(dev), (void)(mask), 0)
#define dma_set_mask dma_set_mask_and_coherent
#define dma_set_coherent_mask dma_set_mask_and_coherent

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
#define KMOD_ACCESS(bits)                                                                         \
    static inline u##bits ioread##bits(const volatile void* a) {                                  \
        return *(const volatile u##bits*)a;                                                       \
    }                                                                                             \
    static inline void iowrite##bits(u##bits value, volatile void* a) {                           \
        *(volatile u##bits*)a = value;                                                            \
    }                                                                                             \
    static inline void ioread##bits##_rep(const volatile void* a, void* to, unsigned long n) {    \
        for (u##bits* p = (u##bits*)to; n; --n) *p++ = ioread##bits(a);                           \
    }                                                                                             \
    static inline void iowrite##bits##_rep(volatile void* a, const void* from, unsigned long n) { \
        for (const u##bits* p = (const u##bits*)from; n; --n) iowrite##bits(*p++, a);             \
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
    struct file* vm_file;
    const void* vm_ops;
};
int remap_pfn_range(struct vm_area_struct* area, unsigned long at, unsigned long page,
                    unsigned long size, pgprot_t protection);
#define io_remap_pfn_range remap_pfn_range
int vm_iomap_memory(struct vm_area_struct* area, phys_addr_t start, unsigned long size);
int dma_mmap_coherent(struct device* dev, struct vm_area_struct* area, void* address, dma_addr_t at,
                      size_t size);

struct poll_table_struct;
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
    __poll_t (*poll)(struct file*, struct poll_table_struct*);
    int (*fasync)(int, struct file*, int);
};
static inline int nonseekable_open(struct inode* inode, struct file* f) {
    return (void)inode, (void)f, 0;
}
#define stream_open nonseekable_open
#ifndef KMOD_RUNTIME
enum {
    POLLIN = 1,
    POLLPRI = 2,
    POLLOUT = 4,
    POLLERR = 8,
    POLLHUP = 0x10,
    POLLRDNORM = 0x40,
    POLLRDBAND = 0x80,
    POLLWRNORM = 0x100,
    POLLWRBAND = 0x200
};
#define EPOLLIN POLLIN
#define EPOLLPRI POLLPRI
#define EPOLLOUT POLLOUT
#define EPOLLERR POLLERR
#define EPOLLHUP POLLHUP
#define EPOLLRDNORM POLLRDNORM
#define EPOLLWRNORM POLLWRNORM
#define SIGIO 29
#define POLL_IN 1
#define POLL_OUT 2
#endif
// Programs that a signal tells.
struct fasync_struct;
int fasync_helper(int descriptor, struct file* file, int on, struct fasync_struct** list);
void kill_fasync(struct fasync_struct** list, int signal, int band);
loff_t noop_llseek(struct file* f, loff_t offset, int whence);
loff_t no_llseek(struct file* f, loff_t offset, int whence);
loff_t default_llseek(struct file* f, loff_t offset, int whence);

// Of a buffer of `available` bytes, from *at on, which moves: how many were copied.
ssize_t simple_read_from_buffer(void* to, size_t n, loff_t* at, const void* from, size_t available);
ssize_t simple_write_to_buffer(void* to, size_t available, loff_t* at, const void* from, size_t n);

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
#define class_create(...) KMOD_PICK_(__VA_ARGS__, KMOD_CLASS_2, KMOD_CLASS_1, )(__VA_ARGS__)
void class_destroy(struct class* c);
struct device* device_create(struct class* c, struct device* parent, kmod_dev_t dev, void* data,
                             const char* format, ...);
void device_destroy(struct class* c, kmod_dev_t dev);

// ---- Attributes: files in /sys ----
//
// /sys/bus/platform/drivers/DRIVER/NAME of a driver; /sys/class/CLASS/DEVICE/NAME of a device that
// has a file in /dev, /sys/bus/platform/devices/ADDRESS.DEVICE/NAME of another.

struct attribute {
    const char* name;
    umode_t mode;
};
struct driver_attribute {
    struct attribute attr;
    ssize_t (*show)(struct device_driver*, char* page);
    ssize_t (*store)(struct device_driver*, const char* from, size_t n);
};
struct device_attribute {
    struct attribute attr;
    ssize_t (*show)(struct device*, struct device_attribute*, char* page);
    ssize_t (*store)(struct device*, struct device_attribute*, const char* from, size_t n);
};
#define __ATTR(name_, mode_, show_, store_) \
    { {#name_, mode_}, show_, store_ }
#define DRIVER_ATTR(name, mode, show, store) \
    struct driver_attribute driver_attr_##name = __ATTR(name, mode, show, store)
#define DRIVER_ATTR_RW(name) DRIVER_ATTR(name, 0644, name##_show, name##_store)
#define DRIVER_ATTR_RO(name) DRIVER_ATTR(name, 0444, name##_show, NULL)
#define DRIVER_ATTR_WO(name) DRIVER_ATTR(name, 0200, NULL, name##_store)
#define DEVICE_ATTR(name, mode, show, store) \
    struct device_attribute dev_attr_##name = __ATTR(name, mode, show, store)
#define DEVICE_ATTR_RW(name) DEVICE_ATTR(name, 0644, name##_show, name##_store)
#define DEVICE_ATTR_RO(name) DEVICE_ATTR(name, 0444, name##_show, NULL)
#define DEVICE_ATTR_WO(name) DEVICE_ATTR(name, 0200, NULL, name##_store)
struct kobj_attribute {
    struct attribute attr;
    ssize_t (*show)(struct kobject*, struct kobj_attribute*, char* page);
    ssize_t (*store)(struct kobject*, struct kobj_attribute*, const char* from, size_t n);
};
#define __ATTR_RO(name) __ATTR(name, 0444, name##_show, NULL)
#define __ATTR_WO(name) __ATTR(name, 0200, NULL, name##_store)
#define __ATTR_RW(name) __ATTR(name, 0644, name##_show, name##_store)
struct attribute_group {
    const char* name;
    struct attribute** attrs;
};
#define ATTRIBUTE_GROUPS(name)                                               \
    static const struct attribute_group name##_group = {NULL, name##_attrs}; \
    static const struct attribute_group* name##_groups[] __maybe_unused = {&name##_group, NULL}
extern struct kobject* const kernel_kobj;
struct kobject* kobject_create_and_add(const char* name, struct kobject* parent);
void kobject_put(struct kobject* object);
int sysfs_create_file(struct kobject* object, const struct attribute* attribute);
void sysfs_remove_file(struct kobject* object, const struct attribute* attribute);
int sysfs_create_group(struct kobject* object, const struct attribute_group* group);
void sysfs_remove_group(struct kobject* object, const struct attribute_group* group);
int driver_register(struct device_driver* driver);
void driver_unregister(struct device_driver* driver);
int driver_create_file(struct device_driver* driver, const struct driver_attribute* attribute);
void driver_remove_file(struct device_driver* driver, const struct driver_attribute* attribute);
int device_create_file(struct device* device, const struct device_attribute* attribute);
void device_remove_file(struct device* device, const struct device_attribute* attribute);

// ---- Texts: /proc, and debugfs in /sys/kernel/debug ----

struct seq_file {
    char* buf;
    size_t size, count;
    void* private;
    int (*function)(struct seq_file*, void*);
};
int seq_printf(struct seq_file* s, const char* format, ...) __attribute__((format(printf, 2, 3)));
void seq_puts(struct seq_file* s, const char* text);
void seq_putc(struct seq_file* s, char c);
int single_open(struct file* f, int (*function)(struct seq_file*, void*), void* data);
ssize_t seq_read(struct file* f, char* to, size_t n, loff_t* at);
loff_t seq_lseek(struct file* f, loff_t offset, int whence);
int single_release(struct inode* inode, struct file* f);

struct proc_ops {
    int (*proc_open)(struct inode*, struct file*);
    ssize_t (*proc_read)(struct file*, char*, size_t, loff_t*);
    ssize_t (*proc_write)(struct file*, const char*, size_t, loff_t*);
    loff_t (*proc_lseek)(struct file*, loff_t, int);
    int (*proc_release)(struct inode*, struct file*);
    __poll_t (*proc_poll)(struct file*, struct poll_table_struct*);
    long (*proc_ioctl)(struct file*, unsigned, unsigned long);
    int (*proc_mmap)(struct file*, struct vm_area_struct*);
};
struct proc_dir_entry;
struct proc_dir_entry* kmod_proc_create(const char* name, umode_t mode,
                                        struct proc_dir_entry* parent,
                                        const struct file_operations* ops, void* data);
struct proc_dir_entry* kmod_proc_create_ops(const char* name, umode_t mode,
                                            struct proc_dir_entry* parent,
                                            const struct proc_ops* ops, void* data);
// With struct file_operations before Linux 5.6, with struct proc_ops since.
#define proc_create_data(name, mode, parent, ops, data) \
    _Generic((ops), const struct proc_ops*                                   \
             : kmod_proc_create_ops, struct proc_ops*                        \
             : kmod_proc_create_ops, default                                 \
             : kmod_proc_create)(name, mode, parent, ops, data)
#define proc_create(name, mode, parent, ops) proc_create_data(name, mode, parent, ops, NULL)
struct proc_dir_entry* proc_create_single_data(const char* name, umode_t mode,
                                               struct proc_dir_entry* parent,
                                               int (*show)(struct seq_file*, void*), void* data);
#define proc_create_single(name, mode, parent, show) \
    proc_create_single_data(name, mode, parent, show, NULL)
struct proc_dir_entry* proc_mkdir(const char* name, struct proc_dir_entry* parent);
void proc_remove(struct proc_dir_entry* entry);
void remove_proc_entry(const char* name, struct proc_dir_entry* parent);
void* PDE_DATA(const struct inode* inode);
#define pde_data PDE_DATA

struct dentry;
struct dentry* debugfs_create_dir(const char* name, struct dentry* parent);
struct dentry* debugfs_create_file(const char* name, umode_t mode, struct dentry* parent,
                                   void* data, const struct file_operations* ops);
#define KMOD_NUMBER_(type) \
    void debugfs_create_##type(const char* name, umode_t mode, struct dentry* parent, void* value)
KMOD_NUMBER_(u8);
KMOD_NUMBER_(u16);
KMOD_NUMBER_(u32);
KMOD_NUMBER_(x8);
KMOD_NUMBER_(x16);
KMOD_NUMBER_(x32);
KMOD_NUMBER_(bool);
void debugfs_remove(struct dentry* entry);
void debugfs_remove_recursive(struct dentry* entry);

#ifndef KMOD_RUNTIME
enum {
    O_RDONLY = 0,
    O_WRONLY = 1,
    O_RDWR = 2,
    O_ACCMODE = 3,
    O_NONBLOCK = 0x800,
    FASYNC = 0x2000,
    FMODE_READ = 1,
    FMODE_WRITE = 2,
    SEEK_SET = 0,
    SEEK_CUR = 1,
    SEEK_END = 2,
    S_IRUSR = 0400,
    S_IWUSR = 0200,
    S_IRGRP = 0040,
    S_IWGRP = 0020,
    S_IROTH = 0004,
    S_IWOTH = 0002,
    S_IRUGO = 0444,
    S_IWUGO = 0222
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

#endif

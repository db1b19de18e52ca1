"""link_test.py DE1SIM FOLDER [CASE...] - `de1sim link`: kernel modules with their program"""
import subprocess
import sys

from case import run
from module_case import HEADERS, ModuleCase, module
from systems import BASE, CLOCKS, HW_TCL, LW, OWN_CLOCK, SystemCase, clocked, pio, qsys

DIAL_TCL = HW_TCL.format(name="dial") + """set_module_property VERSION 1.0
set_module_assignment embeddedsw.dts.group dial
set_module_assignment embeddedsw.dts.name dial
set_module_assignment embeddedsw.dts.vendor acme
add_interface s avalon end
""" + OWN_CLOCK + """\
add_interface_port s address address Input 2
add_interface_port s chipselect chipselect Input 1
add_interface_port s write write Input 1
add_interface_port s writedata writedata Input 32
add_interface_port s readdata readdata Output 32
add_interface q conduit end
add_interface_port q shown export Output 10
"""

DIAL = """module dial(input clk, input reset, input [1:0] address, input chipselect, input write,
            input [31:0] writedata, output [31:0] readdata, output [9:0] shown);
reg [31:0] words [0:3];
assign readdata = words[address];
assign shown = words[0][9:0];
always @(posedge clk) if (chipselect && write) words[address] <= writedata;
endmodule
"""

SHARED = """#include <linux/ioctl.h>
struct setting { unsigned char which; unsigned value; };
#define DIAL_SET _IOW('q', 1, struct setting *)
#define DIAL_GET _IOWR('q', 2, struct setting *)
"""

MODULE = """#include <linux/module.h>
#include <linux/init.h>
#include <linux/errno.h>
#include <linux/version.h>
#include <linux/kernel.h>
#include <linux/platform_device.h>
#include <linux/miscdevice.h>
#include <linux/slab.h>
#include <linux/io.h>
#include <linux/of.h>
#include <linux/of_address.h>
#include <linux/fs.h>
#include <linux/uaccess.h>
#include "dial.h"
#define DRIVER_NAME "dial"

struct dial_dev {
    struct resource res;
    void __iomem *base;
} dev;

static long dial_ioctl(struct file *f, unsigned int cmd, unsigned long arg)
{
    struct setting s;
    if (copy_from_user(&s, (struct setting *)arg, sizeof(s)))
        return -EACCES;
    switch (cmd) {
    case DIAL_SET:
        iowrite32(s.value, dev.base + 4 * s.which);
        break;
    case DIAL_GET:
        s.value = ioread32(dev.base + 4 * s.which);
        if (copy_to_user((struct setting *)arg, &s, sizeof(s)))
            return -EACCES;
        break;
    default:
        return -EINVAL;
    }
    return 0;
}

static const struct file_operations dial_fops = {
    .owner = THIS_MODULE,
    .unlocked_ioctl = dial_ioctl,
};

static struct miscdevice dial_misc = {
    .minor = MISC_DYNAMIC_MINOR,
    .name = DRIVER_NAME,
    .fops = &dial_fops,
};

static int __init dial_probe(struct platform_device *pdev)
{
    int ret = misc_register(&dial_misc);
    ret = of_address_to_resource(pdev->dev.of_node, 0, &dev.res);
    if (ret) {
        ret = -ENOENT;
        goto out_deregister;
    }
    if (request_mem_region(dev.res.start, resource_size(&dev.res), DRIVER_NAME) == NULL) {
        ret = -EBUSY;
        goto out_deregister;
    }
    dev.base = of_iomap(pdev->dev.of_node, 0);
    if (dev.base == NULL) {
        ret = -ENOMEM;
        goto out_release;
    }
    return 0;
out_release:
    release_mem_region(dev.res.start, resource_size(&dev.res));
out_deregister:
    misc_deregister(&dial_misc);
    return ret;
}

static int dial_remove(struct platform_device *pdev)
{
    iounmap(dev.base);
    release_mem_region(dev.res.start, resource_size(&dev.res));
    misc_deregister(&dial_misc);
    return 0;
}

#ifdef CONFIG_OF
static const struct of_device_id dial_of_match[] = {
    { .compatible = "acme,dial-1.0" },
    {},
};
MODULE_DEVICE_TABLE(of, dial_of_match);
#endif

static struct platform_driver dial_driver = {
    .driver = {
        .name = DRIVER_NAME,
        .owner = THIS_MODULE,
        .of_match_table = of_match_ptr(dial_of_match),
    },
    .remove = __exit_p(dial_remove),
};

static int __init dial_init(void)
{
    pr_info(DRIVER_NAME ": init\\n");
    return platform_driver_probe(&dial_driver, dial_probe);
}

static void __exit dial_exit(void)
{
    platform_driver_unregister(&dial_driver);
    pr_info(DRIVER_NAME ": exit\\n");
}

module_init(dial_init);
module_exit(dial_exit);
MODULE_LICENSE("GPL");
MODULE_AUTHOR("a student");
MODULE_DESCRIPTION("a dial");
"""

# By numbers and cdev, with read(), write() and a lock.
OTHER_MODULE = """#include <linux/module.h>
#include <linux/cdev.h>
#include <linux/fs.h>
#include <linux/io.h>
#include <linux/mutex.h>
#include <linux/uaccess.h>
static dev_t number;
static struct cdev cdev;
static struct class *class;
static void *base;
static DEFINE_MUTEX(lock);
static int o(struct inode *i, struct file *f) { f->private_data = base; return 0; }
static ssize_t r(struct file *f, char __user *to, size_t n, loff_t *at)
{
    u32 value;
    if (*at >= 16) return 0;
    if (mutex_lock_interruptible(&lock)) return -ERESTARTSYS;
    value = readl(f->private_data + *at);
    mutex_unlock(&lock);
    if (copy_to_user(to, &value, 4)) return -EFAULT;
    *at += 4;
    return 4;
}
static ssize_t w(struct file *f, const char __user *from, size_t n, loff_t *at)
{
    u32 value;
    if (n != 4) return -EINVAL;
    if (copy_from_user(&value, from, 4)) return -EFAULT;
    writel(value, f->private_data + *at);
    *at += 4;
    return 4;
}
static struct file_operations ops = {.owner = THIS_MODULE, .open = o, .read = r, .write = w,
                                     .llseek = default_llseek};
static int __init start(void)
{
    if (alloc_chrdev_region(&number, 0, 1, "words")) return -ENODEV;
    class = class_create(THIS_MODULE, "words");
    if (IS_ERR(class)) return PTR_ERR(class);
    if (IS_ERR(device_create(class, NULL, number, NULL, "words%d", 0))) return -ENODEV;
    cdev_init(&cdev, &ops);
    if (cdev_add(&cdev, number, 1)) return -ENODEV;
    base = ioremap(0xFF200100, 16);
    return base ? 0 : -ENOMEM;
}
static void __exit stop(void) { }
module_init(start);
module_exit(stop);
MODULE_LICENSE("GPL");
"""

# By attributes alone.
ATTRIBUTES = """#include <linux/module.h>
#include <linux/device.h>
#include <linux/platform_device.h>
#include <linux/miscdevice.h>
#include <linux/fs.h>
#include <linux/io.h>
static void *base;
static char text[] = "a text";
static struct device_driver driver = {.name = "dial", .bus = &platform_bus_type};
static ssize_t value_show(struct device_driver *d, char *to)
{ return sprintf(to, "%u\\n", ioread32(base)); }
static ssize_t value_store(struct device_driver *d, const char *from, size_t n)
{
    unsigned value;
    if (kstrtouint(from, 0, &value)) return -EINVAL;
    iowrite32(value, base);
    return n;
}
static DRIVER_ATTR(value, S_IRUGO | S_IWUSR, value_show, value_store);
static ssize_t last_show(struct device *d, struct device_attribute *a, char *to)
{ return sprintf(to, "%u", ioread32(base + 12)); }
static DEVICE_ATTR_RO(last);
static ssize_t r(struct file *f, char __user *to, size_t n, loff_t *at)
{ return simple_read_from_buffer(to, n, at, text, sizeof text - 1); }
static ssize_t w(struct file *f, const char __user *from, size_t n, loff_t *at)
{ return simple_write_to_buffer(text, sizeof text - 1, at, from, n); }
static struct file_operations ops = {.read = r, .write = w};
static struct miscdevice misc = {MISC_DYNAMIC_MINOR, "dialtext", &ops};
static int __init start(void)
{
    base = ioremap(0xFF200100, 16);
    iowrite32(77, base + 12);
    if (driver_register(&driver) || driver_create_file(&driver, &driver_attr_value)) return -EBUSY;
    return misc_register(&misc) || device_create_file(misc.this_device, &dev_attr_last);
}
static void __exit stop(void)
{
    driver_remove_file(&driver, &driver_attr_value);
    driver_unregister(&driver);
}
module_init(start);
module_exit(stop);
MODULE_LICENSE("GPL");
"""

TOP = """module top(input CLOCK_50, output [9:0] LEDR);
sys system(.clk_clk(CLOCK_50), .reset_reset_n(1'b1), .shown_export(LEDR));
endmodule
"""


class Link(SystemCase):
    def setUp(self):
        super().setUp()
        wires = [*CLOCKS, *clocked("dial_0", "clock"), ("avalon", LW, "dial_0.s", 0x100)]
        led, led_wires = pio("led", 0x40)
        self.write(sys_qsys=qsys([*BASE, ("dial_0", "dial", {}), *led], [*wires, *led_wires],
                                 [("shown", "dial_0.q")]),
                   dial_hw_tcl="", dial_v=DIAL, top_v=TOP, dial_h=SHARED, dial_c=MODULE,
                   top_qsf="set_global_assignment -name DEVICE 5CSEMA5F31C6\n"
                           "set_global_assignment -name VERILOG_FILE top.v\n"
                           "set_global_assignment -name QSYS_FILE sys.qsys\n")
        (self.folder / "dial_hw.tcl").write_text(DIAL_TCL)

    def link(self, *words):
        return self.de1sim("link", "--project", "top.qsf", "-o", "program.elf", *words)

    def linked(self, *words):
        done = self.link(*words)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def shows(self, leds, printed, options=()):
        return self.played(f'wait-serial: "{printed}"',
                           f"expect-leds: {{equals: {leds}, timeout: 1s}}", options=options).stdout

    def refused(self, message, *words):
        self.write(main_c="int main(void) { return 0; }\n")
        done = self.link(*words)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertIn(message, done.stderr)
        self.assertFalse((self.folder / "program.elf").exists())

    PROGRAM = """#include <stdio.h>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <errno.h>
#include "dial.h"
int main(void) {
    int fd = open("/dev/dial", O_RDWR);
    if (fd < 0) { perror("open"); return 1; }
    struct setting s = {0, 0x2A5}, got = {0, 0};
    if (ioctl(fd, DIAL_SET, &s) || ioctl(fd, DIAL_GET, &got)) { perror("ioctl"); return 1; }
    if (ioctl(fd, 5, &s) != -1 || errno != EINVAL) return 2;
    printf("dial is %x\\n", got.value);
    close(fd);
    if (ioctl(fd, DIAL_SET, &s) != -1 || errno != EBADF) return 3;
    printf("closed\\n");
    fflush(stdout);
    for (;;) usleep(1000);
}
"""

    def test_a_module_sets_registers_for_its_program(self):
        self.write(main_c=self.PROGRAM)
        self.linked("dial.c", "main.c")
        printed = self.shows(0x2A5, "closed")
        self.assertIn("dial: init", printed)
        self.assertIn("dial is 2a5", printed)

    def test_a_program_in_cpp_and_arguments_of_the_compiler(self):
        self.write(main_cpp=self.PROGRAM.replace("0x2A5", "VALUE").replace(
            "int main", "#include <cmath>\n#include <string>\nint main"))
        self.linked("main.cpp", "dial.c", "--", "-DVALUE=0x155", "-lm")
        self.shows(0x155, "closed")

    def test_a_library_that_is_only_shared_makes_a_dynamic_program(self):
        self.write(main_c=self.PROGRAM.replace("0x2A5", "value()").replace(
            "int main", "int value(void);\nint main"),
                   value_c="int value(void) { return 0x0F3; }\n")
        libraries = self.folder / "root/lib"
        libraries.mkdir(parents=True)
        subprocess.run(["arm-linux-gnueabihf-gcc", "-shared", "-fPIC", "value.c", "-o",
                        libraries / "libvalue.so"], cwd=self.folder, check=True)
        self.linked("dial.c", "main.c", "--", "-Lroot/lib", "-lvalue")
        self.shows(0x0F3, "closed", ["--linux-root", "root"])

    def test_a_module_by_numbers_and_cdev(self):
        self.write(words_c=OTHER_MODULE, main_c="""#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>
int main(void) {
    int fd = open("/dev/words0", O_RDWR);
    unsigned out[2] = {0x155, 7}, in = 0;
    if (fd < 0 || write(fd, out, 4) != 4 || write(fd, out + 1, 4) != 4 || write(fd, out, 3) != -1 ||
        lseek(fd, 4, SEEK_SET) != 4 || read(fd, &in, 4) != 4 || in != 7) { perror("no"); return 1; }
    printf("done\\n");
    fflush(stdout);
    for (;;) usleep(1000);
}
""")
        self.linked("words.c", "main.c")
        self.shows(0x155, "done")

    def test_attributes_and_streams(self):
        self.write(sys_c=ATTRIBUTES, main_c="""#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
#define VALUE "/sys/bus/platform/drivers/dial/value"
#define LAST "/sys/class/misc/dialtext/last"
#define CHECK(what) if (!(what)) { printf("line %d: %d\\n", __LINE__, errno); return 1; }
int main(void) {
    unsigned value = 0;
    char line[20] = "";
    FILE *f = fopen(VALUE, "w");
    CHECK(f && fprintf(f, "%d", 0x155) > 0 && fclose(f) == 0);
    f = fopen(VALUE, "r");
    CHECK(f && fscanf(f, "%u", &value) == 1 && value == 0x155 && fclose(f) == 0);
    int fd = open(VALUE, O_RDWR);
    CHECK(fd >= 0 && write(fd, "x", 1) == -1 && errno == EINVAL);
    CHECK(read(fd, line, sizeof line) == 4 && strcmp(line, "341\\n") == 0);
    CHECK(close(fd) == 0);
    CHECK(open(LAST, O_WRONLY) == -1 && errno == EACCES);
    f = fopen(LAST, "r");
    CHECK(f && fgets(line, sizeof line, f) && strcmp(line, "77") == 0 && fclose(f) == 0);
    f = fopen("/dev/dialtext", "r+");
    CHECK(f && fputs("the", f) >= 0 && fflush(f) == 0 && fgets(line, sizeof line, f));
    CHECK(strcmp(line, "ext") == 0 && fclose(f) == 0);
    CHECK(!fopen("/sys/bus/platform/drivers/dial/other", "r"));
    printf("done\\n");
    fflush(stdout);
    for (;;) usleep(1000);
}
""")
        self.linked("sys.c", "main.c")
        self.shows(0x155, "done")

    def test_a_module_that_finds_no_device_says_what_there_is(self):
        self.write(main_c=self.PROGRAM, dial_c=MODULE.replace("acme,dial-1.0", "acme,dail-1.0"))
        self.linked("dial.c", "main.c")
        done = self.played("delay: 20ms", code=1)
        for text in ("no module of the system is compatible with acme,dail-1.0",
                     "dial_0: acme,dial-18.1 acme,dial-1.0", "led: altr,pio-1.0 altr,pio-18.1",
                     "dial: the init function returned -19: No such device"):
            self.assertIn(text, done.stdout)

    def test_a_component_without_a_description_is_of_any_vendor(self):
        """By its Verilog alone nobody knows the vendor, but a driver of another one is no match."""
        (self.folder / "dial_hw.tcl").unlink()
        self.write(main_c=self.PROGRAM, dial_c=MODULE.replace("acme,dial-1.0", "acme,dial-18.1"))
        self.linked("dial.c", "main.c")
        done = self.played("delay: 20ms")
        self.assertIn("kmod: dial_0 is taken for acme,dial-18.1: the project does not say its "
                      "vendor", done.stdout)
        self.assertIn("dial is 2a5", done.stdout)

    def test_a_function_that_is_missing_is_named_with_its_line(self):
        self.write(dial_c=MODULE.replace("    return 0;\nout_release",
                                         "    snd_card_new(0);\n    return 0;\n"
                                         "out_release"))
        line = 1 + (self.folder / "dial.c").read_text().split("snd_card_new")[0].count("\n")
        self.refused(f"dial.c:{line}: the kernel's function snd_card_new() is not one of those",
                     "dial.c", "main.c")

    def test_a_file_that_does_not_compile(self):
        self.write(dial_c=MODULE.replace("struct setting s;", "struct setting s"))
        self.refused("nothing is made: a file does not compile", "dial.c", "main.c")

    def test_a_file_that_is_not_there(self):
        self.refused("nowhere.c: there is no such file", "nowhere.c", "main.c")

    def test_a_project_without_the_processor(self):
        self.write(top_qsf="set_global_assignment -name TOP_LEVEL_ENTITY lone\n"
                           "set_global_assignment -name VERILOG_FILE lone.v\n",
                   lone_v="module lone(output [9:0] LEDR); assign LEDR = 1; endmodule\n")
        self.refused("top.qsf has no Platform Designer system with the processor", "dial.c",
                     "main.c")


class Together(ModuleCase):
    def test_a_macro_that_is_missing_is_named(self):
        self.write(x_c=HEADERS + "module_no_such_driver(x, y);\n")
        done = self.de1sim("link", "x.c", "-o", "x.ko")
        self.assertEqual(done.returncode, 2)
        self.assertIn("the kernel's function module_no_such_driver() is not one", done.stderr)

    def test_a_driver_is_registered_with_its_probe(self):
        self.write(x_c=HEADERS + """#include <linux/platform_device.h>
            static int probe(struct platform_device *d) { return 0; }
            static struct platform_driver driver = { .driver = { .name = "x" } };
            module_platform_driver_probe(driver, probe);
            """)
        printed = self.runs("int main(void) { return 0; }", "x.c", code=1)
        self.assertIn("no module of the system is compatible with the driver", printed)

    def test_two_modules_may_have_the_same_names(self):
        for name in "one", "two":
            self.write(**{name + "_c": module(
                f"""int count;
                int both(int n) {{ return n + sizeof "{name}" + count; }}
                static ssize_t r(struct file *f, char __user *to, size_t n, loff_t *at)
                {{ ++count; return put_user((char)both(count), to) ? -EFAULT : 1; }}
                """, name, ".read = r")})
        self.runs("""
            int main(void) {
                char c = 0;
                int one = open("/dev/one", O_RDONLY), two = open("/dev/two", O_RDONLY);
                CHECK(read(one, &c, 1) == 1 && c == 1 + 4 + 1);
                CHECK(read(two, &c, 1) == 1 && c == 1 + 4 + 1);
                CHECK(read(two, &c, 1) == 1 && c == 2 + 4 + 2);
                return 0;
            }
            """, "one.c", "two.c")


run()

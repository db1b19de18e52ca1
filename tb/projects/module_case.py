"""module_case.py - a kernel module and its program, for modules_test and module_bugs_test"""
import textwrap

from case import Case

HEADERS = "".join(f"#include <linux/{name}.h>\n" for name in (
    "module", "init", "fs", "miscdevice", "uaccess", "interrupt", "wait", "sched", "delay", "io",
    "poll", "timer", "workqueue", "kthread", "completion", "slab", "spinlock", "mutex", "proc_fs",
    "seq_file", "debugfs", "device", "dma-mapping"))

# The DE1-SoC Computer's interval timer, every 10 ms, with its interrupt.
TICKS = """
#define TIMER_IRQ 72
static volatile int *timer;
static void start_timer(void)
{
    timer = ioremap(0xFF202000, 32);
    timer[2] = 1000000 & 0xFFFF;
    timer[3] = 1000000 >> 16;
    timer[1] = 7;
}
static void clear_timer(void) { timer[0] = 0; }
static void stop_timer(void) { timer[1] = 8; }
"""

END = 'MODULE_LICENSE("GPL");\n'

PROGRAM = """#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/select.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#define CHECK(what) if (!(what)) { \\
    printf("line %d: %s: %s\\n", __LINE__, #what, strerror(errno)); exit(1); }
static long ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * 1000 + t.tv_nsec / 1000000;
}
"""


def module(text, name="dev", operations="", init="", leave="", before=""):
    """A module with /dev/NAME of these file_operations."""
    return f"""{HEADERS}{TICKS}{before}{text}
static const struct file_operations operations = {{ .owner = THIS_MODULE, {operations} }};
static struct miscdevice device = {{ .minor = MISC_DYNAMIC_MINOR, .name = "{name}",
                                     .fops = &operations }};
static int __init begin(void)
{{
    int error = misc_register(&device);
    if (error) return error;
    {init}
    return 0;
}}
static void __exit end(void) {{ {leave} misc_deregister(&device); }}
module_init(begin);
module_exit(end);
{END}"""


class ModuleCase(Case):
    def linked(self, *words):
        done = self.de1sim("link", *words)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def runs(self, program, *words, code=0):
        self.write(main_c=PROGRAM + textwrap.dedent(program))
        self.linked(*words, "main.c", "--", "-pthread")
        done = self.de1sim("run", "program.elf", "--frames", "none")
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout + done.stderr

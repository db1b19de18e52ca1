"""module_bugs_test.py DE1SIM FOLDER [CASE...] - kernel modules that the kernel stops"""
from case import run
from module_case import ModuleCase, module


class ModuleBugs(ModuleCase):
    OPENS = r"""
        int main(void) {
            char byte = 0;
            int fd = open("/dev/dev", O_RDWR);
            CHECK(fd >= 0);
            write(fd, &byte, 1);
            usleep(100000);
            return 0;
        }
        """

    def oops(self, text, *expected, **arguments):
        self.write(bad_c=module(text, operations=".write = w", **arguments))
        printed = self.runs(self.OPENS, "bad.c", code=1)
        for one in (*expected, "Internal error: Oops", "Modules linked in: bad"):
            self.assertIn(one, printed)
        self.assertRegex(printed, r"de1sim: kernel oops in [a-z_]+\+0x[0-9a-f]+ \[bad\] "
                                  r"\(bad\.c:[0-9]+\)")

    WRITE = "static ssize_t w(struct file *f, const char __user *from, size_t n, loff_t *at)\n"

    def test_a_null_pointer(self):
        self.oops(self.WRITE + "{ static int *none; *(volatile int *)(none + 2) = 1; return n; }",
                  "Unable to handle kernel NULL pointer dereference at virtual address 00000008",
                  "PC is at w+", "Comm: program.elf")

    def test_an_address_that_is_not_mapped(self):
        self.oops(self.WRITE + "{ return *(volatile char *)0xC1234560; }",
                  "Unable to handle kernel paging request at virtual address c1234560")

    def test_a_handler_that_sleeps(self):
        self.oops("static irqreturn_t handler(int irq, void *data)"
                  "{ clear_timer(); msleep(1); return IRQ_HANDLED; }" + self.WRITE +
                  "{ start_timer();"
                  " return request_irq(TIMER_IRQ, handler, 0, \"t\", NULL) ? : n; }",
                  "BUG: sleeping function called from invalid context: msleep() in an interrupt's")

    def test_a_handler_without_end(self):
        self.oops("static irqreturn_t handler(int irq, void *data)"
                  "{ for (;;) cpu_relax(); return IRQ_HANDLED; }" + self.WRITE +
                  "{ start_timer();"
                  " return request_irq(TIMER_IRQ, handler, 0, \"t\", NULL) ? : n; }",
                  "soft lockup: the handler of interrupt 72 (t) has not returned for 1 s",
                  "PC is at handler+")

    def test_a_spinlock_that_is_not_given_back(self):
        self.oops("static DEFINE_SPINLOCK(lock);" + self.WRITE + "{ spin_lock(&lock); return n; }",
                  "returned while a spinlock is held")

    def test_a_spinlock_that_is_taken_twice(self):
        self.oops("static DEFINE_SPINLOCK(lock);" + self.WRITE +
                  "{ spin_lock(&lock); spin_lock(&lock); return n; }", "BUG: spinlock recursion")

    def test_a_copy_while_a_spinlock_is_held_that_sleeps(self):
        self.oops("static DEFINE_SPINLOCK(lock); static DEFINE_MUTEX(m);" + self.WRITE +
                  "{ spin_lock(&lock); mutex_lock(&m); return n; }",
                  "BUG: sleeping function called from invalid context: mutex_lock() while")

    def test_a_mutex_that_is_not_given_back(self):
        self.write(bad_c=module("static DEFINE_MUTEX(m);" + self.WRITE +
                                "{ mutex_lock(&m); return n; }", operations=".write = w"))
        printed = self.runs(r"""
            int main(void) {
                int fd = open("/dev/dev", O_RDWR);
                if (fork() == 0) { write(fd, "", 1); sleep(1); write(fd, "", 1); }
                usleep(1000);
                write(fd, "", 1);
                return 0;
            }
            """, "bad.c", code=1)
        self.assertIn("BUG: w() locks a mutex that it has already", printed)

    def test_an_interrupt_that_nobody_handles(self):
        self.write(bad_c=module("static irqreturn_t handler(int irq, void *data)"
                                "{ return IRQ_NONE; }" + self.WRITE +
                                "{ start_timer(); return request_irq(TIMER_IRQ, handler, 0, \"t\","
                                " NULL) ? : n; }", operations=".write = w"))
        printed = self.runs(self.OPENS.replace("usleep(100000)", "sleep(1)"), "bad.c")
        self.assertIn("irq 72: nobody cared", printed)
        self.assertIn("Disabling IRQ #72", printed)

    def test_a_module_that_is_none_is_refused_before_the_run(self):
        self.write(bad_c=module(""), no_module_ko="#!/bin/sh\n")
        self.runs("int main(void) { return 0; }", "bad.c")
        for file, why in (("nowhere.ko", "nowhere.ko: is not there"),
                          ("no_module.ko", "no_module.ko: not an ELF file"),
                          ("program.elf", "expected a kernel module that de1sim link has made")):
            done = self.de1sim("run", "program.elf", "--module", file)
            self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
            self.assertIn(why, done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)

    def test_an_init_function_that_fails(self):
        self.write(bad_c=module("", init="return -ENOMEM;"))
        printed = self.runs(self.OPENS, "bad.c", code=1)
        self.assertIn("the module bad cannot be loaded: its init function returned -12", printed)


run()

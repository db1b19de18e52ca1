"""modules_test.py DE1SIM FOLDER [CASE...] - kernel modules on the emulated Linux, with programs"""
from case import run
from module_case import END, HEADERS, PROGRAM, ModuleCase, module


class Modules(ModuleCase):
    def test_read_waits_for_the_interrupt(self):
        self.write(ticks_c=module("""
            static DECLARE_WAIT_QUEUE_HEAD(queue);
            static int ticks;
            static irqreturn_t handler(int irq, void *data)
            { clear_timer(); ++ticks; wake_up_interruptible(&queue); return IRQ_HANDLED; }
            static ssize_t r(struct file *f, char __user *to, size_t n, loff_t *at)
            {
                if (f->f_flags & O_NONBLOCK && !ticks) return -EAGAIN;
                if (wait_event_interruptible(queue, ticks > 0)) return -ERESTARTSYS;
                n = ticks;
                ticks = 0;
                return put_user((int)n, (int *)to) ? -EFAULT : 4;
            }
            """, operations=".read = r",
            init='''if (request_irq(TIMER_IRQ, handler, IRQF_SHARED, "ticks", &queue))
                        return -EBUSY;
                    start_timer();''',
            leave='stop_timer(); free_irq(TIMER_IRQ, &queue); pr_info("left\\n");'))
        printed = self.runs(r"""
            int main(void) {
                int n = 0, all = 0, fd = open("/dev/dev", O_RDONLY);
                CHECK(fd >= 0);
                const long begin = ms();
                while (all < 5) { CHECK(read(fd, &n, 4) == 4); all += n; }
                CHECK(ms() - begin >= 40 && ms() - begin <= 60);
                CHECK(read(fd, NULL, 4) == -1 && errno == EFAULT);
                int other = open("/dev/dev", O_RDONLY | O_NONBLOCK);
                CHECK(other >= 0 && read(other, &n, 4) == -1 && errno == EAGAIN);
                char line[200] = "";
                FILE *f = fopen("/proc/interrupts", "r");
                CHECK(f && fgets(line, sizeof line, f) && fgets(line, sizeof line, f));
                CHECK(strstr(line, "72:") && strstr(line, "ticks"));
                printf("%d ticks\n", all);
                return 0;
            }
            """, "ticks.c")
        self.assertIn("5 ticks", printed)
        self.assertIn("] left", printed)
        self.assertIn("] left", (self.folder / "out" / "dmesg.txt").read_text())

    def test_a_signal_interrupts_a_read(self):
        self.write(wait_c=module("""
            static DECLARE_WAIT_QUEUE_HEAD(queue);
            static ssize_t r(struct file *f, char __user *to, size_t n, loff_t *at)
            { return wait_event_interruptible(queue, 0) ? -ERESTARTSYS : 0; }
            static ssize_t w(struct file *f, const char __user *to, size_t n, loff_t *at)
            { return wait_event_interruptible_timeout(queue, 0, HZ / 10) ? -EINTR : n; }
            """, operations=".read = r, .write = w"))
        self.runs(r"""
            static volatile int seen;
            static void handler(int number) { seen = number; }
            int main(void) {
                char byte;
                int fd = open("/dev/dev", O_RDWR);
                struct sigaction action = {.sa_handler = handler};
                sigaction(SIGALRM, &action, NULL);
                alarm(1);
                CHECK(read(fd, &byte, 1) == -1 && errno == EINTR && seen == SIGALRM);
                CHECK(ms() >= 1000 && ms() < 1010);
                CHECK(write(fd, "x", 1) == 1 && ms() >= 1100 && ms() < 1125);
                return 0;
            }
            """, "wait.c")

    def test_poll_select_and_epoll(self):
        self.write(poll_c=module("""
            static DECLARE_WAIT_QUEUE_HEAD(queue);
            static bool ready;
            static void tick(struct timer_list *t) { ready = true; wake_up(&queue); }
            static DEFINE_TIMER(later, tick);
            static __poll_t p(struct file *f, poll_table *table)
            { poll_wait(f, &queue, table); return ready ? POLLIN | POLLRDNORM : 0; }
            static ssize_t r(struct file *f, char __user *to, size_t n, loff_t *at)
            { ready = false; return 1; }
            static long i(struct file *f, unsigned request, unsigned long milliseconds)
            { mod_timer(&later, jiffies + msecs_to_jiffies(milliseconds)); return 0; }
            """, operations=".poll = p, .read = r, .unlocked_ioctl = i"))
        self.runs(r"""
            int main(void) {
                char byte;
                int fd = open("/dev/dev", O_RDWR);
                struct pollfd one = {fd, POLLIN, 0};
                CHECK(fd >= 0 && poll(&one, 1, 0) == 0 && poll(&one, 1, 20) == 0);
                long begin = ms();
                CHECK(ioctl(fd, 1, 50) == 0 && poll(&one, 1, -1) == 1 && one.revents == POLLIN);
                CHECK(ms() - begin >= 40 && ms() - begin <= 61);
                CHECK(read(fd, &byte, 1) == 1 && poll(&one, 1, 0) == 0);
                fd_set set;
                FD_ZERO(&set);
                FD_SET(fd, &set);
                struct timeval soon = {0, 10000};
                CHECK(select(fd + 1, &set, NULL, NULL, &soon) == 0);
                FD_SET(fd, &set);
                CHECK(ioctl(fd, 1, 30) == 0 && select(fd + 1, &set, NULL, NULL, NULL) == 1);
                CHECK(read(fd, &byte, 1) == 1);
                int all = epoll_create1(0);
                struct epoll_event event = {.events = EPOLLIN, .data = {.fd = 7}}, got;
                CHECK(epoll_ctl(all, EPOLL_CTL_ADD, fd, &event) == 0);
                CHECK(epoll_wait(all, &got, 1, 0) == 0 && ioctl(fd, 1, 20) == 0);
                CHECK(epoll_wait(all, &got, 1, 1000) == 1 && got.data.fd == 7);
                return 0;
            }
            """, "poll.c")

    def test_work_threads_and_completions(self):
        self.write(work_c=module("""
            static DECLARE_COMPLETION(done);
            static int order, seen[5];
            static struct workqueue_struct *own;
            static void note(int what) { if (order < 5) seen[order++] = what; }
            static void work(struct work_struct *w) { msleep(10); note(3); complete(&done); }
            static void late(struct work_struct *w) { note(4); complete(&done); }
            static void tasklet(unsigned long data) { note(data); }
            static DECLARE_WORK(soon, work);
            static DECLARE_DELAYED_WORK(later, late);
            static DECLARE_TASKLET(small, tasklet, 1);
            static struct hrtimer fine;
            static int beats;
            static enum hrtimer_restart beat(struct hrtimer *t)
            { hrtimer_forward_now(t, us_to_ktime(500)); return ++beats < 4 ? HRTIMER_RESTART
                                                                          : HRTIMER_NORESTART; }
            static int thread(void *data)
            {
                int rounds = 0;
                while (!kthread_should_stop()) { ++rounds; msleep_interruptible(5); }
                return rounds;
            }
            static ssize_t r(struct file *f, char __user *to, size_t n, loff_t *at)
            {
                struct task_struct *task = kthread_run(thread, NULL, "own/%d", 1);
                if (IS_ERR(task)) return PTR_ERR(task);
                hrtimer_init(&fine, CLOCK_MONOTONIC, HRTIMER_MODE_REL);
                fine.function = beat;
                hrtimer_start(&fine, us_to_ktime(500), HRTIMER_MODE_REL);
                queue_delayed_work(own, &later, msecs_to_jiffies(40));
                queue_work(own, &soon);
                tasklet_schedule(&small);
                wait_for_completion(&done);
                if (!wait_for_completion_timeout(&done, HZ)) return -ETIMEDOUT;
                note(kthread_stop(task) >= 5 ? 5 : 0);
                note(beats);
                return copy_to_user(to, seen, sizeof seen) ? -EFAULT : sizeof seen;
            }
            """, operations=".read = r",
            init='own = create_singlethread_workqueue("own"); if (!own) return -ENOMEM;',
            leave="destroy_workqueue(own);"))
        printed = self.runs(r"""
            int main(void) {
                int seen[5], fd = open("/dev/dev", O_RDONLY);
                CHECK(fd >= 0 && read(fd, seen, sizeof seen) == sizeof seen);
                for (int i = 0; i < 5; ++i) printf("%d ", seen[i]);
                printf("in %ld ms\n", ms());
                return 0;
            }
            """, "work.c")
        self.assertRegex(printed, "1 3 4 5 4 in (4|5)[0-9] ms")

    def test_work_of_an_own_queue_is_waited_for(self):
        self.write(flush_c=module("""
            static struct workqueue_struct *own;
            static int runs;
            static struct work_struct slow;
            static void work(struct work_struct *w) { msleep(20); ++runs; cancel_work(w); }
            static ssize_t w(struct file *f, const char __user *from, size_t n, loff_t *at)
            {
                queue_work(own, &slow);
                flush_work(&slow);
                if (runs != 1) return -EIO;
                queue_work(own, &slow);
                msleep(5);
                return cancel_work_sync(&slow) || runs != 2 ? -EBUSY : n;
            }
            """, operations=".write = w",
            init='own = create_workqueue("own"); INIT_WORK(&slow, work);',
            leave="destroy_workqueue(own);"))
        self.runs(r"""
            int main(void) {
                int fd = open("/dev/dev", O_WRONLY);
                CHECK(fd >= 0 && write(fd, "x", 1) == 1 && ms() >= 40 && ms() < 50);
                return 0;
            }
            """, "flush.c")

    def test_two_programs_share_a_module(self):
        self.write(pipe_c=module("""
            static DECLARE_WAIT_QUEUE_HEAD(queue);
            static DEFINE_MUTEX(lock);
            static char text[16];
            static size_t length;
            static ssize_t r(struct file *f, char __user *to, size_t n, loff_t *at)
            {
                if (wait_event_interruptible(queue, length > 0)) return -ERESTARTSYS;
                mutex_lock(&lock);
                n = min(n, length);
                if (copy_to_user(to, text, n)) n = -EFAULT;
                length = 0;
                mutex_unlock(&lock);
                return n;
            }
            static ssize_t w(struct file *f, const char __user *from, size_t n, loff_t *at)
            {
                mutex_lock(&lock);
                length = min(n, sizeof text);
                if (copy_from_user(text, from, length)) n = -EFAULT;
                mutex_unlock(&lock);
                wake_up(&queue);
                pr_info("%s %d wrote\\n", current->comm, current->pid);
                return n;
            }
            """, operations=".read = r, .write = w"))
        printed = self.runs(r"""
            int main(void) {
                char text[17] = "";
                int fd = open("/dev/dev", O_RDWR);
                if (fork() == 0) {
                    usleep(20000);
                    CHECK(write(fd, "from the child", 14) == 14);
                    _exit(0);
                }
                CHECK(read(fd, text, 16) == 14 && ms() >= 20 && ms() < 30);
                wait(NULL);
                printf("got it %s\n", text);
                return 0;
            }
            """, "pipe.c")
        self.assertIn("got it from the child", printed)
        self.assertRegex(printed, "program.elf [0-9]+ wrote")

    def test_a_signal_tells_of_news(self):
        self.write(news_c=module("""
            static struct fasync_struct *list;
            static int a(int fd, struct file *f, int on) { return fasync_helper(fd, f, on, &list); }
            static int close(struct inode *i, struct file *f) { return a(-1, f, 0); }
            static void tick(struct timer_list *t) { kill_fasync(&list, SIGIO, POLL_IN); }
            static struct timer_list later;
            static long i(struct file *f, unsigned request, unsigned long ticks)
            { timer_setup(&later, tick, 0); mod_timer(&later, jiffies + ticks); return 0; }
            """, operations=".fasync = a, .release = close, .unlocked_ioctl = i"))
        self.runs(r"""
            static volatile int seen;
            static void handler(int number) { seen = number; }
            int main(void) {
                int fd = open("/dev/dev", O_RDWR);
                signal(SIGIO, handler);
                CHECK(fcntl(fd, F_SETOWN, getpid()) == 0);
                CHECK(fcntl(fd, F_SETFL, fcntl(fd, F_GETFL) | O_ASYNC) == 0);
                CHECK(ioctl(fd, 1, 2) == 0 && seen == 0);
                pause();
                CHECK(seen == SIGIO && ms() >= 10 && ms() <= 30);
                return 0;
            }
            """, "news.c")

    def test_memory_of_the_bus_and_registers_are_mapped(self):
        self.write(map_c=module("""
            static dma_addr_t at;
            static u32 *memory;
            static int m(struct file *f, struct vm_area_struct *area)
            {
                if (area->vm_pgoff == 1)
                    return remap_pfn_range(area, area->vm_start, 0xFF200000 >> PAGE_SHIFT,
                                           area->vm_end - area->vm_start, area->vm_page_prot);
                return dma_mmap_coherent(NULL, area, memory, at, 8192);
            }
            static ssize_t r(struct file *f, char __user *to, size_t n, loff_t *o)
            { return put_user(memory[1024], (u32 *)to) ? -EFAULT : 4; }
            """, operations=".mmap = m, .read = r",
            init="memory = dma_alloc_coherent(NULL, 8192, &at, GFP_KERNEL);"
                 " if (!memory) return -ENOMEM; memory[0] = 77;"))
        self.runs(r"""
            int main(void) {
                unsigned value = 0;
                int fd = open("/dev/dev", O_RDWR);
                unsigned *a = mmap(NULL, 8192, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
                CHECK(a != MAP_FAILED && a[0] == 77);
                a[1024] = 5;
                CHECK(read(fd, &value, 4) == 4 && value == 5);
                volatile unsigned *leds = mmap(NULL, 4096, PROT_READ | PROT_WRITE, MAP_SHARED, fd,
                                               4096);
                CHECK(leds != MAP_FAILED);
                leds[0] = 0x155;
                CHECK(leds[0] == 0x155);
                CHECK(mmap(NULL, 16384, PROT_READ, MAP_SHARED, fd, 0) == MAP_FAILED);
                return 0;
            }
            """, "map.c")

    def test_proc_sys_and_debugfs(self):
        self.write(texts_c=module("""
            static int level = 3;
            module_param(level, int, 0644);
            static u32 hits = 9;
            static int show(struct seq_file *s, void *v)
            { seq_printf(s, "level %d\\n", level); return 0; }
            static int o(struct inode *i, struct file *f) { return single_open(f, show, NULL); }
            static const struct proc_ops texts = { .proc_open = o, .proc_read = seq_read,
                                                   .proc_release = single_release };
            static ssize_t gain_show(struct kobject *k, struct kobj_attribute *a, char *to)
            { return sysfs_emit(to, "%d\\n", level * 2); }
            static ssize_t gain_store(struct kobject *k, struct kobj_attribute *a, const char *from,
                                      size_t n)
            { return kstrtoint(from, 0, &level) ? -EINVAL : n; }
            static struct kobj_attribute gain = __ATTR_RW(gain);
            static struct attribute *attributes[] = { &gain.attr, NULL };
            static struct attribute_group group = { .attrs = attributes };
            static struct kobject *object;
            static struct dentry *folder;
            """, init='''proc_create("texts", 0, NULL, &texts);
                object = kobject_create_and_add("texts", kernel_kobj);
                if (!object || sysfs_create_group(object, &group)) return -ENOMEM;
                folder = debugfs_create_dir("texts", NULL);
                debugfs_create_u32("hits", 0644, folder, &hits);''',
            leave='''remove_proc_entry("texts", NULL); kobject_put(object);
                debugfs_remove_recursive(folder);'''))
        self.runs(r"""
            static char *text_of(const char *path) {
                static char text[100];
                FILE *f = fopen(path, "r");
                CHECK(f);
                memset(text, 0, sizeof text);
                fread(text, 1, sizeof text - 1, f);
                fclose(f);
                return text;
            }
            static void put(const char *path, const char *text) {
                int fd = open(path, O_WRONLY);
                CHECK(fd >= 0 && write(fd, text, strlen(text)) == (long)strlen(text));
                close(fd);
            }
            int main(void) {
                CHECK(!strcmp(text_of("/proc/texts"), "level 3\n"));
                CHECK(!strcmp(text_of("/sys/kernel/texts/gain"), "6\n"));
                put("/sys/kernel/texts/gain", "0x10\n");
                CHECK(!strcmp(text_of("/sys/module/texts/parameters/level"), "16\n"));
                put("/sys/module/texts/parameters/level", "5");
                CHECK(!strcmp(text_of("/proc/texts"), "level 5\n"));
                CHECK(!strcmp(text_of("/sys/kernel/debug/texts/hits"), "9\n"));
                put("/sys/kernel/debug/texts/hits", "12\n");
                CHECK(!strcmp(text_of("/sys/kernel/debug/texts/hits"), "12\n"));
                CHECK(strstr(text_of("/proc/modules"), "texts ") != NULL);
                return 0;
            }
            """, "texts.c")

    def test_messages_have_the_formats_of_the_kernel(self):
        self.write(words_c="#include <stdbool.h>\n#include <linux/of.h>\n" + module(r"""
            static bool loud;
            module_param_named(noise, loud, bool, 0644);
            static void say(const char *format, ...)
            {
                struct va_format f;
                va_list list;
                va_start(list, format);
                f.fmt = format;
                f.va = &list;
                pr_info("say %d: %pV.\n", 1, &f);
                va_end(list);
            }
            """, init=r"""
            phys_addr_t at = 0xff200040;
            struct resource r = { .start = at, .end = at + 15, .flags = IORESOURCE_MEM };
            u8 bytes[6] = { 0, 1, 2, 0xAB, 255, 16 };
            char text[40];
            pr_info("a %pa %pap %pad %pR|\n", &at, &at, &at, &r);
            pr_info("b %pM %*ph %*phC %pI4 %pe|\n", bytes, 3, bytes, 2, bytes, bytes,
                    ERR_PTR(-EINVAL));
            pr_info("c %5d|%-4u|%04x|%s|%.2s|%c|%lld|%zu|%%|%p|%px|\n", -7, 5u, 0xBEE, "text",
                    "text", 'x', 1ll << 40, sizeof at, NULL, (void *)0x1234);
            say("%d and %s", 5, "six");
            if (snprintf(text, 8, "%pa and more", &at) != 19) return -EINVAL;
            pr_info("d %s| %d\n", text, loud + device_init_wakeup(NULL, 1));
            """))
        printed = self.runs("int main(void) { return 0; }", "words.c")
        for line in ("a 0xff200040 0xff200040 0xff200040 [mem 0xff200040-0xff20004f]|",
                     "b 00:01:02:ab:ff:10 00 01 02 00:01 0.1.2.171 -EINVAL|",
                     "c    -7|5   |0bee|text|te|x|1099511627776|4|%|(null)|00001234|",
                     "say 1: 5 and six.", "d 0xff200| 0"):
            self.assertIn("] " + line + "\n", printed)

    def test_insmod_and_rmmod_by_a_program(self):
        self.write(late_c=module("""
            static int period = 1;
            module_param(period, int, 0444);
            static char *name = "none";
            module_param(name, charp, 0);
            static ssize_t r(struct file *f, char __user *to, size_t n, loff_t *at)
            { return put_user(period, (int *)to) ? -EFAULT : 4; }
            """, operations=".read = r", init='pr_info("late %s\\n", name);',
            leave='pr_info("late leaves\\n");'),
            root__hello_txt="hello\n", main_c=PROGRAM + r"""
            int main(void) {
                int value = 0, fd = open("/late.ko", O_RDONLY), text = open("/hello.txt", O_RDONLY);
                CHECK(open("/dev/dev", O_RDONLY) == -1 && errno == ENOENT);
                CHECK(syscall(SYS_finit_module, text, "", 0) == -1 && errno == ENOEXEC);
                CHECK(fd >= 0 && syscall(SYS_finit_module, fd, "period=x", 0) == -1);
                CHECK(syscall(SYS_finit_module, fd, "period=7 name=two", 0) == 0);
                CHECK(syscall(SYS_finit_module, fd, "", 0) == -1 && errno == EEXIST);
                struct stat s;
                int device = open("/dev/dev", O_RDONLY);
                CHECK(fstat(device, &s) == 0 && major(s.st_rdev) == 10);
                CHECK(device >= 0 && read(device, &value, 4) == 4 && value == 7);
                CHECK(syscall(SYS_delete_module, "late", 0) == -1 && errno == EWOULDBLOCK);
                close(device);
                CHECK(stat("/dev/dev", &s) == 0 && S_ISCHR(s.st_mode) && major(s.st_rdev) == 10);
                CHECK(syscall(SYS_delete_module, "late", 0) == 0);
                CHECK(syscall(SYS_delete_module, "late", 0) == -1 && errno == ENOENT);
                CHECK(open("/dev/dev", O_RDONLY) == -1);
                CHECK(syscall(SYS_finit_module, fd, "", 0) == 0);
                return 0;
            }
            """)
        self.linked("late.c", "-o", "root/late.ko")
        self.write(other_c=module("", "other"))
        self.linked("other.c")
        self.linked("other.c", "main.c")
        done = self.de1sim("run", "program.elf", "--frames", "none", "--linux-root", "root")
        printed = done.stdout + done.stderr
        self.assertEqual(done.returncode, 0, printed)
        for text in ("] late two", "] late leaves", "`x' invalid for parameter `period'"):
            self.assertIn(text, printed)

    def test_a_node_that_mknod_has_made(self):
        self.write(numbers_c=HEADERS + r"""
            #include <linux/cdev.h>
            static ssize_t r(struct file *f, char __user *to, size_t n, loff_t *at)
            { return put_user((char)iminor(file_inode(f)), to) ? -EFAULT : 1; }
            static const struct file_operations operations = { .read = r };
            static struct cdev device;
            static int __init begin(void)
            {
                if (register_chrdev_region(MKDEV(250, 0), 4, "numbers")) return -EBUSY;
                cdev_init(&device, &operations);
                return cdev_add(&device, MKDEV(250, 0), 4);
            }
            module_init(begin);
            """ + END)
        self.runs(r"""
            int main(void) {
                char minor = 0;
                CHECK(mknod("/dev/third", S_IFCHR | 0600, makedev(250, 3)) == 0);
                CHECK(mknod("/dev/third", S_IFCHR | 0600, 0) == -1 && errno == EEXIST);
                int fd = open("/dev/third", O_RDONLY);
                CHECK(fd >= 0 && read(fd, &minor, 1) == 1 && minor == 3);
                return 0;
            }
            """, "numbers.c")

    def test_a_module_alone_with_a_scenario(self):
        self.write(keys_c=HEADERS + """
            static volatile int *leds, *keys;
            static irqreturn_t handler(int irq, void *data, struct pt_regs *regs)
            { *leds += 1; keys[3] = 15; return IRQ_HANDLED; }
            static int __init begin(void)
            {
                leds = ioremap_nocache(0xFF200000, 0x200000);
                keys = leds + 0x14;
                keys[3] = 15;
                keys[2] = 15;
                return request_irq(73, (irq_handler_t)handler, IRQF_SHARED, "keys", &keys);
            }
            static void __exit end(void) { free_irq(73, &keys); }
            module_init(begin);
            module_exit(end);
            """ + END, s_yaml="""name: keys
version: 1
program: keys.ko
steps:
"""
                   + 3 * """  - press: {key: 1, for: 10ms}
  - delay: 30ms
""" + """  - expect-leds: {equals: 3}
""")
        self.linked("keys.c")
        done = self.de1sim("run", "s.yaml")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


run()

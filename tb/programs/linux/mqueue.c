// mqueue.c - POSIX message queues: errors, limits, priorities, who waits first, notices, poll
#include <errno.h>
#include <fcntl.h>
#include <mqueue.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define NAME "/de1sim_test"

static mqd_t queue;

static void say(const char* name, long result) {
    if (result < 0)
        printf("%s: %s\n", name, strerror(errno));
    else
        printf("%s: done\n", name);
}

static void put(const char* name, const char* text, unsigned priority) {
    say(name, mq_send(queue, text, strlen(text), priority));
}

static void take(const char* name) {
    char text[8193];
    unsigned priority = 99;
    const ssize_t bytes = mq_receive(queue, text, 8192, &priority);
    if (bytes < 0)
        printf("%s: %s\n", name, strerror(errno));
    else
        printf("%s: \"%.*s\" %u\n", name, (int)bytes, text, priority);
}

static void look(const char* name) {
    struct pollfd entry = {queue, POLLIN | POLLOUT, 0};
    poll(&entry, 1, 0);
    printf("%s: %x\n", name, entry.revents);
}

static struct timespec after(int ms) {
    struct timespec time;
    clock_gettime(CLOCK_REALTIME, &time);
    time.tv_nsec += ms * 1000000L;
    time.tv_sec += time.tv_nsec / 1000000000;
    time.tv_nsec %= 1000000000;
    return time;
}

static void errors(void) {
    struct mq_attr attributes = {.mq_maxmsg = 0, .mq_msgsize = 16};
    char text[16], longest[300];
    memset(longest, 'a', sizeof longest - 1);
    longest[sizeof longest - 1] = 0;
    longest[0] = '/';
    mq_unlink(NAME);
    say("not there", mq_open(NAME, O_RDWR));
    say("a folder", mq_open("/a/b", O_RDWR | O_CREAT, 0600, NULL));
    say("a slash", mq_open("/", O_RDWR | O_CREAT, 0600, NULL));
    say("a long name", mq_open(longest, O_RDWR | O_CREAT, 0600, NULL));
    say("no messages", mq_open(NAME, O_RDWR | O_CREAT, 0600, &attributes));
    attributes.mq_maxmsg = 65537;
    say("too many", mq_open(NAME, O_RDWR | O_CREAT, 0600, &attributes));
    attributes.mq_maxmsg = 2, attributes.mq_msgsize = 0;
    say("no bytes", mq_open(NAME, O_RDWR | O_CREAT, 0600, &attributes));
    attributes.mq_msgsize = (16 << 20) + 1;
    say("too long", mq_open(NAME, O_RDWR | O_CREAT, 0600, &attributes));
    say("no attributes", syscall(SYS_mq_open, NAME + 1, O_RDWR | O_CREAT, 0600, 16));
    say("unlink none", mq_unlink(NAME));

    attributes.mq_msgsize = 8;
    queue = mq_open(NAME, O_WRONLY | O_CREAT | O_NONBLOCK, 0600, &attributes);
    say("open", queue);
    say("another", mq_open(NAME, O_RDWR | O_CREAT | O_EXCL, 0600, &attributes));
    say("receive", mq_receive(queue, text, sizeof text, NULL));
    put("nine bytes", "123456789", 0);
    say("priority 32768", mq_send(queue, text, 1, 32768));
    say("from nowhere", mq_send(queue, (char*)16, 1, 0));
    say("to no queue", mq_send(1, text, 1, 0));
    say("to no file", mq_send(99, text, 1, 0));
    const struct timespec bad = {0, 1000000000};
    say("10^9 ns", mq_timedsend(queue, text, 1, 0, &bad));
    put("first", "12345678", 1);
    put("second", "", 32767);
    put("third", "c", 3);
    attributes.mq_flags = O_NONBLOCK | 1;
    say("other flags", mq_setattr(queue, &attributes, NULL));
    mq_getattr(queue, &attributes);
    printf("flags %lx, %ld of %ld, %ld bytes\n", attributes.mq_flags, attributes.mq_curmsgs,
           attributes.mq_maxmsg, attributes.mq_msgsize);
    const struct mq_attr waits = {.mq_flags = 0};
    mq_setattr(queue, &waits, &attributes);
    printf("before: %lx, now %lx\n", attributes.mq_flags, (long)fcntl(queue, F_GETFL) & 0xFFFF);
    const struct timespec past = {1, 0};
    say("it was before", mq_timedsend(queue, text, 1, 0, &past));
    mq_close(queue);
    queue = mq_open(NAME, O_RDONLY);
    put("read only", "d", 0);
    say("seven bytes", mq_receive(queue, text, 7, NULL));
    say("unlink", mq_unlink(NAME));
    take("it lives on");
    take("it lives on");
    mq_close(queue);
    say("gone", mq_open(NAME, O_RDWR));
}

static void priorities(void) {
    queue = mq_open(NAME, O_RDWR | O_CREAT | O_NONBLOCK, 0600, NULL);
    struct mq_attr attributes;
    mq_getattr(queue, &attributes);
    printf("%ld messages of %ld bytes\n", attributes.mq_maxmsg, attributes.mq_msgsize);
    take("none");
    look("empty");
    put("b", "b", 2), put("a", "a", 1), put("c", "c", 2), put("d", "d", 9);
    look("some");
    char text[81] = {0};
    read(queue, text, 80);
    printf("%.15s\n", text);
    take("9"), take("2"), take("2 again"), take("1");
    for (int i = 0; i < 10; ++i) mq_send(queue, "x", 1, 0);
    look("full");
    put("one more", "y", 0);
    mq_close(queue);
    mq_unlink(NAME);
}

// Threads that are made in one order wait in the other, 100 ms apart.
static const char* const names[] = {"first", "second", "third"};
static void rest(long number) { usleep(50000 + 100000 * number); }

static void* receive(void* number) {
    rest((long)number);
    take(names[(long)number]);
    return NULL;
}
static void* send_one(void* number) {
    rest((long)number);
    mq_send(queue, names[(long)number], 5, 0);
    return NULL;
}

static void waiting(void) {
    pthread_t thread[3];
    struct mq_attr attributes = {.mq_maxmsg = 1, .mq_msgsize = 8192};
    queue = mq_open(NAME, O_RDWR | O_CREAT, 0600, &attributes);
    for (long i = 2; i >= 0; --i) pthread_create(&thread[i], NULL, receive, (void*)i);
    usleep(350000);
    look("they wait");
    for (int i = 0; i < 3; ++i) {
        mq_send(queue, names[i], 5, 0);
        pthread_join(thread[i], NULL);
    }
    put("full", "0", 5);
    for (long i = 2; i >= 0; --i) pthread_create(&thread[i], NULL, send_one, (void*)i);
    usleep(350000);
    for (int i = 0; i < 4; ++i) take("in their order");
    for (int i = 0; i < 3; ++i) pthread_join(thread[i], NULL);

    char text[8192];
    struct timespec end = after(30);
    say("nothing comes", mq_timedreceive(queue, text, sizeof text, NULL, &end));
    put("full", "0", 5);
    end = after(30);
    say("nobody takes", mq_timedsend(queue, "1", 1, 0, &end));
    take("the only one");
    mq_close(queue);
    mq_unlink(NAME);
}

// qemu-arm has no mq_notify.
static void notices(void) {
    sigset_t set;
    siginfo_t info;
    const struct timespec short_time = {0, 20000000};
    struct sigevent event = {.sigev_notify = SIGEV_SIGNAL, .sigev_signo = SIGRTMIN};
    event.sigev_value.sival_int = 6;
    sigemptyset(&set);
    sigaddset(&set, SIGRTMIN);
    sigprocmask(SIG_BLOCK, &set, NULL);
    queue = mq_open(NAME, O_RDWR | O_CREAT | O_NONBLOCK, 0600, NULL);
    say("tell me", mq_notify(queue, &event));
    say("twice", mq_notify(queue, &event));
    char text[81] = {0};
    read(queue, text, 80);
    printf("%.43s\n", text);
    if (fork() == 0) {
        say("a child", mq_notify(queue, &event));
        put("from a child", "a", 1);
        _exit(0);
    }
    wait(NULL);
    if (sigtimedwait(&set, &info, &short_time) < 0) return perror("no signal");
    printf("signal %d code %d value %d, own %d\n", info.si_signo == SIGRTMIN, info.si_code,
           info.si_value.sival_int, info.si_pid == getpid());
    say("again", mq_notify(queue, &event));
    put("not empty", "b", 1);
    printf("no signal: %d\n", sigtimedwait(&set, &info, &short_time));
    take("a"), take("b");
    put("empty", "c", 1);
    printf("signal: %d\n", sigtimedwait(&set, &info, &short_time) == SIGRTMIN);
    say("again", mq_notify(queue, &event));
    say("not any more", mq_notify(queue, NULL));
    take("c");
    put("empty", "d", 1);
    printf("no signal: %d\n", sigtimedwait(&set, &info, &short_time));
    event.sigev_notify = SIGEV_NONE;
    say("silently", mq_notify(queue, &event));
    event.sigev_notify = SIGEV_SIGNAL;
    say("busy", mq_notify(queue, &event));
    const mqd_t other = mq_open(NAME, O_RDONLY);
    mq_close(other);
    say("closed", mq_notify(queue, &event));
    event.sigev_signo = 65;
    say("signal 65", mq_notify(queue, &event));
    event.sigev_notify = 7;
    say("notify 7", mq_notify(queue, &event));
    say("no queue", mq_notify(1, NULL));
    mq_close(queue);
    mq_unlink(NAME);
}

static void handle(int number) { (void)number; }
static void interrupted(void) {
    queue = mq_open(NAME, O_RDWR | O_CREAT, 0600, NULL);
    struct sigaction action = {.sa_handler = handle};
    sigaction(SIGALRM, &action, NULL);
    ualarm(30000, 0);
    take("interrupted");
    mq_close(queue);
    mq_unlink(NAME);
}

// What depends on the user and the limits: the board's is user 0, whose queues take 819,200 bytes.
static int apart(void) {
    struct mq_attr attributes = {.mq_maxmsg = 11, .mq_msgsize = 8192};
    say("eleven", mq_open("/a", O_RDWR | O_CREAT, 0600, &attributes));
    attributes.mq_maxmsg = 90;
    say("ninety more", mq_open("/b", O_RDWR | O_CREAT, 0600, &attributes));
    attributes.mq_maxmsg = 80;
    say("read and write", mq_open("/a", 3));
    say("eighty more", mq_open("/b", O_RDWR | O_CREAT, 0600, &attributes));
    struct sigevent event = {.sigev_notify = SIGEV_THREAD};
    say("by a thread", mq_notify(mq_open("/a", O_RDWR), &event));
    say("by a thread", syscall(SYS_mq_notify, mq_open("/a", O_RDWR), &event));
    return 0;
}

int main(int count, char** words) {
    setvbuf(stdout, NULL, _IOLBF, 0);
    if (count > 1 && !strcmp(words[1], "notices")) return notices(), 0;
    if (count > 1) return apart();
    errors();
    priorities();
    waiting();
    interrupted();
    return 0;
}

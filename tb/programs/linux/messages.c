// messages.c - System V's message queues: errors, types, who waits for which, limits, removal
#include <errno.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ipc.h>
#include <sys/msg.h>
#include <sys/wait.h>
#include <unistd.h>

#define KEY 0x5150DE15

static int queue;
struct message {
    long type;
    char text[9000];
};

static void say(const char* name, long result) {
    if (result < 0)
        printf("%s: %s\n", name, strerror(errno));
    else
        printf("%s: done\n", name);
}

static void put(const char* name, long type, const char* text, int bytes) {
    struct message message = {.type = type};
    strcpy(message.text, text);
    say(name, msgsnd(queue, &message, bytes, IPC_NOWAIT));
}

static void take(const char* name, long type, int bytes, int flags) {
    struct message message = {.type = 0};
    const ssize_t count = msgrcv(queue, &message, bytes, type, flags);
    if (count < 0)
        printf("%s: %s\n", name, strerror(errno));
    else
        printf("%s: %ld \"%.*s\"\n", name, message.type, (int)count, message.text);
}

// Threads that are made in one order wait in the other, 100 ms apart.
static const long wanted[] = {2, 0, -3, 2};
static void rest(long number) { usleep(50000 + 100000 * number); }

static void* receive(void* number) {
    char name[20];
    sprintf(name, "waits for %ld", wanted[(long)number]);
    rest((long)number);
    take(name, wanted[(long)number], 9000, 0);
    return NULL;
}

static int sender_error;
static void* send_one(void* number) {
    struct message message = {.type = 10 + (long)number};
    rest((long)number);
    if (msgsnd(queue, &message, 4000, 0) < 0) sender_error = errno;
    return NULL;
}

static void errors(void) {
    say("not there", msgget(KEY, 0));
    queue = msgget(KEY, IPC_CREAT | 0640);
    say("get", queue);
    printf("the same: %d\n", msgget(KEY, 0) == queue);
    say("another", msgget(KEY, IPC_CREAT | IPC_EXCL | 0600));
    put("type 0", 0, "", 0);
    put("too long", 1, "", 8193);
    put("below 0", 1, "", -1);
    say("from nowhere", msgsnd(queue, (void*)16, 1, 0));
    take("below 0", 0, -1, IPC_NOWAIT);
    take("none", 0, 10, IPC_NOWAIT);
    say("another command", msgctl(queue, 99, NULL));
    put("one", 5, "12345", 5);
    take("four bytes", 0, 4, 0);
    take("cut", 0, 4, MSG_NOERROR);
}

static void types(void) {
    struct msqid_ds status;
    put("a", 3, "a", 1), put("b", 1, "b", 1), put("c", 2, "c", 1), put("d", 1, "d", 1);
    put("e", 3, "e", 1), put("f", 9, "f", 1), put("g", 3, "", 0);
    msgctl(queue, IPC_STAT, &status);
    printf("%lu messages of %lu bytes, at most %lu, mode %o, key %d\n",
           (unsigned long)status.msg_qnum, (unsigned long)status.__msg_cbytes,
           (unsigned long)status.msg_qbytes, status.msg_perm.mode & 0777,
           status.msg_perm.__key == KEY);
    printf("sent by this one: %d, received by this one: %d\n", status.msg_lspid == getpid(),
           status.msg_lrpid == getpid());
    take("of 2", 2, 10, IPC_NOWAIT);
    take("up to 2", -2, 10, IPC_NOWAIT);
    take("but not 3", 3, 10, IPC_NOWAIT | MSG_EXCEPT);
    take("up to 1", -1, 10, IPC_NOWAIT);
    take("any", 0, 10, IPC_NOWAIT);
    take("up to 9", -9, 10, IPC_NOWAIT);
    take("of 4", 4, 10, IPC_NOWAIT);
    take("up to all", (long)0x80000000, 10, IPC_NOWAIT);
    take("any", 0, 10, IPC_NOWAIT);
    take("none", 0, 10, IPC_NOWAIT);
}

static void waiting(void) {
    pthread_t thread[4];
    const long sent[] = {5, 2, 2, 3};
    for (long i = 3; i >= 0; --i) pthread_create(&thread[i], NULL, receive, (void*)i);
    usleep(450000);
    for (int i = 0; i < 4; ++i) {
        struct message message = {.type = sent[i], .text = "x"};
        printf("%ld to the first that wants it\n", sent[i]);
        msgsnd(queue, &message, 1, 0);
        usleep(50000);
    }
    struct message last = {.type = 2, .text = "y"};
    msgsnd(queue, &last, 1, 0);
    for (int i = 0; i < 4; ++i) pthread_join(thread[i], NULL);
    take("left", 0, 10, IPC_NOWAIT);

    for (int i = 0; i < 4; ++i) put("4000 bytes", 1, "", 4000);
    put("full", 1, "", 4000);
    put("but for 384", 1, "", 384);
    for (long i = 1; i >= 0; --i) pthread_create(&thread[i], NULL, send_one, (void*)i);
    usleep(250000);
    for (int i = 0; i < 5; ++i) take("one", 1, 0, MSG_NOERROR);
    for (int i = 0; i < 2; ++i) pthread_join(thread[i], NULL);
    take("the first", 10, 0, MSG_NOERROR);  // which of the two comes first is open on Linux
    take("the second", 11, 0, MSG_NOERROR);

    struct msqid_ds status;
    msgctl(queue, IPC_STAT, &status);
    status.msg_qbytes = 100;
    say("a smaller one", msgctl(queue, IPC_SET, &status));
    put("full", 1, "", 101);
    pthread_create(&thread[0], NULL, send_one, (void*)0);
    pthread_create(&thread[1], NULL, receive, (void*)0);
    usleep(150000);
    msgctl(queue, IPC_RMID, NULL);
    pthread_join(thread[0], NULL);
    pthread_join(thread[1], NULL);
    printf("the sender: %s\n", strerror(sender_error));
    say("remove", msgctl(queue, IPC_RMID, NULL));
    say("not there", msgget(KEY, 0));
}

static void handle(int number) { (void)number; }

static void processes(void) {
    queue = msgget(IPC_PRIVATE, 0600);
    if (fork() == 0) {
        usleep(20000);
        const struct message message = {.type = 7, .text = "child"};
        _exit(msgsnd(queue, &message, 5, 0));
    }
    take("from a child", 0, 10, 0);
    wait(NULL);
    struct sigaction action = {.sa_handler = handle, .sa_flags = SA_RESTART};
    sigaction(SIGALRM, &action, NULL);
    ualarm(30000, 0);
    take("interrupted", 0, 10, 0);
    msgctl(queue, IPC_RMID, NULL);
}

// What qemu-arm asks first is whether there is memory.
static int apart(void) {
    queue = msgget(IPC_PRIVATE, 0600);
    say("no queue", msgrcv(queue + 7, (void*)16, 1, 0, IPC_NOWAIT));
    put("one", 5, "12345", 5);
    say("to nowhere", msgrcv(queue, (void*)16, 10, 0, 0));
    take("lost", 0, 10, IPC_NOWAIT);
    return 0;
}

int main(int count, char** words) {
    (void)words;
    setvbuf(stdout, NULL, _IOLBF, 0);
    if (count > 1) return apart();
    errors();
    types();
    waiting();
    processes();
    return 0;
}

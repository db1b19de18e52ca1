// processes.c WHAT - processes: how they begin, end, and talk to each other
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <semaphore.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/sem.h>
#include <sys/shm.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static int value = 1;
static volatile sig_atomic_t ended;
static char* own;
extern char** environ;

static void on_child(int number) { ended += number == SIGCHLD; }

// Each has its own memory, and the same files.
static void forks(void) {
    int status = 0;
    const pid_t child = fork();
    if (child == 0) {
        value = 5;
        printf("child: %d\n", value);
        exit(3);
    }
    const pid_t waited = waitpid(child, &status, 0);
    printf("parent: %d, %s, exit code %d, then %d\n", value, waited == child ? "waited" : "lost",
           WEXITSTATUS(status), wait(NULL));
}

static void pipes(void) {
    int there[2], back[2];
    char text[32];
    if (pipe(there) || pipe(back)) return;
    if (fork() == 0) {
        close(there[1]);
        long count;
        while ((count = read(there[0], text, sizeof text)) > 0) {
            for (long i = 0; i < count; ++i) text[i] ^= 0x20;
            if (write(back[1], text, (size_t)count) != count) _exit(1);
        }
        _exit(0);
    }
    close(there[0]);
    close(back[1]);
    if (write(there[1], "hello", 5) != 5) return;
    long count = read(back[0], text, sizeof text);
    printf("%.*s, ", (int)count, text);
    printf("%d, ", fcntl(there[1], F_GETPIPE_SZ));
    printf("%d, ", fcntl(there[1], F_SETPIPE_SZ, 5000));
    close(there[1]);
    count = read(back[0], text, sizeof text);
    wait(NULL);
    signal(SIGPIPE, SIG_IGN);
    close(back[0]);
    printf("end %ld\n", count);
}

static void kills(void) {
    int status = 0;
    signal(SIGCHLD, on_child);
    const pid_t child = fork();
    if (child == 0)
        for (;;) ++value;
    usleep(2000);
    kill(child, SIGTERM);
    while (!ended) pause();
    waitpid(child, &status, 0);
    printf("signal %d, %d of SIGCHLD\n", WTERMSIG(status), ended);
}

static void becomes(void) {
    if (fork() == 0) {
        char* words[] = {own, "says", "it is another", NULL};
        char* variables[] = {"NAME=value", NULL};
        execve(own, words, variables);
        _exit(9);
    }
    int status;
    wait(&status);
    char* words[] = {own, "says", "spawned", NULL};
    pid_t child;
    printf("%d, ", WEXITSTATUS(status));
    fflush(stdout);
    const int error = posix_spawn(&child, own, NULL, NULL, words, environ);
    waitpid(child, &status, 0);
    printf("%d %d\n", error, WEXITSTATUS(status));
    printf("%s\n", strerror(posix_spawn(&child, "/none", NULL, NULL, words, environ)));
}

// Memory and locks that processes share, in three ways.
static void shares(void) {
    pthread_mutexattr_t attribute;
    struct {
        pthread_mutex_t lock;
        int count;
    }* all = mmap(NULL, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    pthread_mutexattr_init(&attribute);
    pthread_mutexattr_setpshared(&attribute, PTHREAD_PROCESS_SHARED);
    pthread_mutex_init(&all->lock, &attribute);
    const int segment = shmget(0xF0, 200, IPC_CREAT | 0666);
    int* numbers = shmat(segment, NULL, 0);
    sem_t* posted = sem_open("/posted", O_CREAT, 0600, 0);
    const int file = shm_open("/file", O_CREAT | O_RDWR, 0600);
    if (ftruncate(file, 8192)) return;
    for (int i = 0; i < 3; ++i)
        if (fork() == 0) {
            char* text = mmap(NULL, 8192, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
            for (int j = 0; j < 20; ++j) {
                pthread_mutex_lock(&all->lock);
                const int was = all->count;
                usleep(50);
                all->count = was + 1;
                pthread_mutex_unlock(&all->lock);
            }
            numbers[i] = i + 1;
            text[5000 + i] = (char)('a' + i);
            sem_post(posted);
            _exit(0);
        }
    for (int i = 0; i < 3; ++i) sem_wait(posted);
    while (wait(NULL) > 0) {}
    char text[4] = "";
    const long count = pread(file, text, 3, 5000);
    printf("%d, %d, %ld %s\n", all->count, numbers[0] + numbers[1] + numbers[2], count, text);
    shmdt(numbers);
    shmctl(segment, IPC_RMID, NULL);
    printf("%d %d\n", shm_unlink("/file"), shmget(0xF0, 200, 0));
}

static void semaphores(void) {
    const int set = semget(IPC_PRIVATE, 2, 0600);
    struct sembuf down = {0, -2, 0}, up = {0, 1, 0}, zero = {1, 0, IPC_NOWAIT};
    if (fork() == 0) {
        semop(set, &up, 1);
        usleep(1000);
        semop(set, &up, 1);
        _exit(0);
    }
    const int result = semop(set, &down, 1);
    printf("%d, %d left, ", result, semctl(set, 0, GETVAL));
    semctl(set, 1, SETVAL, 1);
    const int other = semop(set, &zero, 1);
    printf("%d: %s\n", other, strerror(errno));
}

static void events(void) {
    const int event = eventfd(0, 0);
    uint64_t number = 40;
    if (fork() == 0) {
        usleep(500);
        _exit(write(event, &number, sizeof number) != sizeof number);
    }
    number = 0;
    const long count = read(event, &number, sizeof number);
    printf("%ld, %d\n", count, (int)number);
}

static void groups(void) {
    int status;
    const pid_t child = fork();
    if (child == 0) {
        printf("%d %d %d\n", setsid() == getpid(), getpgrp() == getpid(), setsid());
        pause();
    }
    usleep(2000);
    char path[40], state = 0;
    sprintf(path, "/proc/%d/stat", child);
    FILE* const stat = fopen(path, "r");
    if (stat && fscanf(stat, "%*d %*s %c", &state) == 1) printf("%c, ", state);
    printf("%d %d, ", getpgid(child) == child, getsid(child) == child);
    printf("%d ", setpgid(child, 0));
    printf("%s, ", strerror(errno));
    printf("%d, ", waitpid(0, &status, WNOHANG));
    kill(-child, SIGTERM);
    waitpid(-child, &status, 0);
    printf("signal %d\n", WTERMSIG(status));
}

static void files(void) {
    static const char* const NAMES[] = {"/dev/null",     "/dev/zero", "/dev/urandom", "/dev/fb0",
                                        "/proc/cpuinfo", "/proc/self/status",
                                        "/sys/devices/system/cpu/online"};
    for (unsigned i = 0; i < COUNT(NAMES); ++i) {
        char text[64] = "";
        FILE* file = fopen(NAMES[i], "r");
        if (!file) puts(NAMES[i]);
        if (file && i >= 4 && fgets(text, sizeof text, file)) fputs(text, stdout);
        if (file) fclose(file);
    }
    printf("%ld processors\n", sysconf(_SC_NPROCESSORS_ONLN));
}

static void* sleeps(void* unused) {
    pause();
    return unused;
}

// What a process has open, and its threads, by their names in /proc and /dev.
static void names(void) {
    int ends[2];
    char text[32] = "", path[40];
    pthread_t thread;
    pthread_create(&thread, NULL, sleeps, NULL);
    if (pipe(ends) || write(ends[1], "from a pipe", 11) != 11) return;
    const char* const tty = ttyname(0);
    printf("%s, ", tty ? tty : strerror(errno));
    printf("%.8s, ", ttyname(1) ? ttyname(1) : "");
    int count = 0;
    DIR* folder = opendir("/proc/self/task");
    while (folder && readdir(folder)) ++count;
    printf("%d threads, ", count - 2);
    if (folder) closedir(folder);
    count = 0;
    folder = opendir("/proc/self/fd");
    while (folder && readdir(folder)) ++count;
    printf("%d files: ", count - 2);
    if (folder) closedir(folder);
    snprintf(path, sizeof path, "/proc/self/fd/%d", ends[0]);
    printf("%.5s ", readlink(path, text, sizeof text) > 0 ? text : "");
    snprintf(path, sizeof path, "/dev/fd/%d", ends[0]);
    const int again = open(path, O_RDONLY);
    printf("%d %s\n", (int)read(again, text, sizeof text), text);
    snprintf(path, sizeof path, "/proc/%d/task/%d/comm", getpid(), getpid());
    FILE* file = fopen(path, "r");
    printf("%s", file && fgets(text, sizeof text, file) ? text : "no name\n");
    static const char* const CONSOLES[] = {"/dev/stdout", "/dev/tty", "/dev/console", "/dev/ttyS0"};
    for (unsigned i = 0; i < COUNT(CONSOLES); ++i) {
        const int fd = open(CONSOLES[i], O_WRONLY);
        struct stat status = {0};
        fstat(fd, &status);
        dprintf(fd, "%s %d %d,%d\n", CONSOLES[i], isatty(fd), major(status.st_rdev),
                minor(status.st_rdev));
    }
    printf("%d\n", access("/dev/fd/99", F_OK));
}

// Standard input is a file that lies outside of the root.
static void input(void) {
    char text[16] = "";
    printf("%d, ", open("/dev/stdin", O_WRONLY | O_TRUNC));
    printf("%s, ", strerror(errno));
    printf("%d, ", open("/proc/self/fd/0", O_RDONLY | O_TRUNC));
    printf("%d, ", fchmod(0, 0777));
    const int again = open("/dev/stdin", O_RDONLY);
    printf("%d %s\n", (int)read(again, text, sizeof text), text);
}

static void bombs(void) {
    int made = 0;
    while (fork() > 0) ++made;
    if (made < 10) pause();
    printf("%s after %d\n", strerror(errno), made);
}

static void hangs(void) {
    int ends[2];
    char byte;
    if (pipe(ends)) return;
    if (fork() == 0) _exit(read(ends[0], &byte, 1) == 1);
    wait(NULL);
}

int main(int argc, char** argv) {
    static const struct {
        const char* name;
        void (*run)(void);
    } all[] = {{"forks", forks},   {"pipes", pipes},   {"kills", kills}, {"becomes", becomes},
               {"shares", shares}, {"semaphores", semaphores}, {"events", events},
               {"groups", groups}, {"files", files},   {"names", names}, {"input", input},   {"bombs", bombs},   {"hangs", hangs}};
    own = argv[0];
    setvbuf(stdout, NULL, _IOLBF, 0);
    if (argc > 2 && strcmp(argv[1], "says") == 0) {
        printf("%s, %s\n", argv[2], getenv("NAME") ? getenv("NAME") : "no name");
        return 7;
    }
    for (unsigned i = 0; i < COUNT(all); ++i)
        if (argc > 1 && strcmp(argv[1], all[i].name) == 0) {
            all[i].run();
            return 0;
        }
    return 2;
}

// mapped_files.c - a file that processes map shared, and what lies after its end
#include <errno.h>
#include <fcntl.h>
#include <semaphore.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#define PAGE 4096

static sigjmp_buf before;
static const char* where;

static void on_fault(int number, siginfo_t* about, void* unused) {
    printf("signal %d, code %d, %ld\n", number, about->si_code,
           (long)((const char*)about->si_addr - where));
    siglongjmp(before, unused != NULL);
}

static void put(char* at, char value) {
    if (!sigsetjmp(before, 1)) {
        *at = value;
        printf("%c\n", *at);
    }
}

static const char* error(int failed) { return failed ? strerror(errno) : "done"; }

int main(void) {
    struct sigaction action = {.sa_sigaction = on_fault, .sa_flags = SA_SIGINFO};
    sigaction(SIGBUS, &action, NULL);
    sigaction(SIGSEGV, &action, NULL);
    setvbuf(stdout, NULL, _IONBF, 0);

    const int fd = open("data/mapped.bin", O_RDWR | O_CREAT | O_TRUNC, 0644);
    if (fd < 0 || ftruncate(fd, PAGE + 100)) return 1;
    char* const file = mmap(NULL, 4 * PAGE, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    if (file == MAP_FAILED) return 2;
    where = file;
    if (fork() == 0) {
        strcpy(file + PAGE, "of the child");
        _exit(0);
    }
    wait(NULL);
    char text[16] = "";
    printf("%s, %d\n", file + PAGE, (int)pread(fd, text, sizeof text, PAGE));
    puts(text);
    pwrite(fd, "by write", 9, 10);
    printf("%s, %s\n", file + 10, error(msync(file, PAGE, MS_SYNC)));

    put(file + 2 * PAGE, 'a');  // after the end
    puts(error(read(open("/dev/zero", O_RDONLY), file + 3 * PAGE, 4) < 0));
    ftruncate(fd, 3 * PAGE);
    put(file + 2 * PAGE, 'b');
    pwrite(fd, "x", 1, 3 * PAGE + 1);
    put(file + 3 * PAGE, 'c');
    truncate("data/mapped.bin", PAGE);
    put(file + PAGE, 'd');
    put(file + PAGE - 1, 'e');
    close(open("data/mapped.bin", O_WRONLY | O_TRUNC));
    put(file, 'f');
    ftruncate(fd, 8 * PAGE);
    put(file, 'g');

    char* const longer = mremap(file, 4 * PAGE, 8 * PAGE, MREMAP_MAYMOVE);
    if (longer == MAP_FAILED) return 3;
    where = longer;
    put(longer + 7 * PAGE, 'h');
    close(fd);
    printf("%s\n", error(munmap(longer, 8 * PAGE)));

    // A semaphore in a file, which two processes map, each by itself.
    sem_t* const sem = mmap(NULL, PAGE, PROT_READ | PROT_WRITE, MAP_SHARED,
                            open("data/mapped.bin", O_RDWR), 0);
    sem_init(sem, 1, 0);
    if (fork() == 0) {
        sem_t* const same = mmap(NULL, PAGE, PROT_READ | PROT_WRITE, MAP_SHARED,
                                 open("data/mapped.bin", O_RDWR), 0);
        usleep(1000);
        _exit(sem_post(same));
    }
    printf("%s\n", error(sem_wait(sem)));
    wait(NULL);

    const int read_only = open("data/mapped.bin", O_RDONLY);
    const char* const seen = mmap(NULL, PAGE, PROT_READ, MAP_SHARED, read_only, 7 * PAGE);
    printf("%c, %s\n", *seen, error(mprotect((void*)seen, PAGE, PROT_READ | PROT_WRITE)));
    printf("%s\n", error(mmap(NULL, PAGE, PROT_READ | PROT_WRITE, MAP_SHARED, read_only, 0) ==
                         MAP_FAILED));
    char* const own = mmap(NULL, PAGE, PROT_READ | PROT_WRITE, MAP_PRIVATE, read_only, 7 * PAGE);
    *own = 'i';
    printf("%c %c\n", *seen, *own);
    where = seen;
    put((char*)seen, 'j');
    munmap((void*)seen, PAGE);
    put((char*)seen, 'k');
    return 0;
}

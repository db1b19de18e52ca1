/* storms.c CASE - a program that takes what it can get of the machine that it runs on. */
#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <time.h>
#include <unistd.h>

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

int main(int argc, char** argv) {
    static char text[100000];
    memset(text, '.', sizeof text);
    const char* which = argc > 1 ? argv[1] : "";
    if (strcmp(which, "prints") == 0) {  // without end
        for (;;) puts("all work and no play");
    } else if (strcmp(which, "prints-at-once") == 0) {
        const double begin = now();
        const ssize_t few = write(1, text, 4096);
        const double between = now();
        const ssize_t many = write(1, text, sizeof text);
        fprintf(stderr, "\n%d in %.0f ms, %d in %.0f ms\n", (int)few, 1e3 * (between - begin),
                (int)many, 1e3 * (now() - between));
    } else if (strcmp(which, "prints-unless-full") == 0) {
        fcntl(1, F_SETFL, O_NONBLOCK);
        const ssize_t first = write(1, text, sizeof text), second = write(1, text, 10);
        fcntl(1, F_SETFL, 0);
        fprintf(stderr, "\n%d, then %d\n", (int)first, (int)second);
    } else if (strcmp(which, "opens") == 0) {
        int files = 0;
        while (open("/file", O_RDONLY) >= 0) ++files;
        perror(files < 20 ? "few files" : "many files");
    } else if (strcmp(which, "forks-with-memory") == 0) {
        int children = 0;
        char* const memory = mmap(NULL, 500 << 20, PROT_READ | PROT_WRITE,
                                  MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        memory[0] = 1;
        for (pid_t child; (child = fork()) >= 0; ++children)
            if (child == 0) pause();
        printf("%d children: %s\n", children, strerror(errno));
    } else if (strcmp(which, "shares-memory") == 0) {
        int files = 0, error = 0;
        for (; error == 0; ++files) {
            char name[20];
            sprintf(name, "/%d", files);
            const int fd = shm_open(name, O_CREAT | O_RDWR, 0600);
            error = ftruncate(fd, 300 << 20);
            close(fd);
        }
        printf("%d files: %s\n", files, strerror(errno));
    } else if (strcmp(which, "maps-pages") == 0) {
        char* const room = mmap(NULL, 800 << 20, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        int areas = 0;
        while (areas < 100000 && munmap(room + areas * 8192, 4096) == 0) ++areas;
        printf("%s, ", areas > 20000 && areas < 100000 ? strerror(errno) : "all");
        printf("%s, ", munmap(room, 4096) == 0 ? "the first" : strerror(errno));
        printf("%s\n", mmap(NULL, 4096, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) == MAP_FAILED
                           ? strerror(errno)
                           : "one more");
    } else if (strcmp(which, "shares-files") == 0) {
        int files = 0;
        for (int fd = 0; fd >= 0; ++files) {
            char name[20];
            sprintf(name, "/%d", files);
            fd = shm_open(name, O_CREAT | O_RDWR, 0600);
            if (fd >= 0) close(fd);
        }
        printf("%s files: %s\n", files > 20 ? "many" : "few", strerror(errno));
    } else if (strcmp(which, "fifo") == 0) {
        if (open("/fifo", O_WRONLY) < 0) perror("/fifo");
    }
    return 0;
}

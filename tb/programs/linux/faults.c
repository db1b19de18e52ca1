// faults.c - what ends a program, by its argument
#include <fcntl.h>
#include <setjmp.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

static jmp_buf back;
static volatile int handled;

static void on_segv(int number, siginfo_t* info, void* context) {
    (void)context;
    printf("handler: signal %d at %p\n", number, info->si_addr);
    siglongjmp(back, 1);
}

static void on_usr1(int number) { handled = number; }

__attribute__((noinline)) static void write_to_nowhere(void) { *(volatile int*)16 = 1; }

__attribute__((noinline)) static void read_unanswered(void) {
    const int memory = open("/dev/mem", O_RDWR | O_SYNC);
    volatile unsigned* page = mmap(NULL, 4096, PROT_READ, MAP_SHARED, memory, 0xFFC00000);
    printf("%u\n", *page);
}

int main(int argc, char** argv) {
    const char* what = argc > 1 ? argv[1] : "";
    if (strcmp(what, "segv") == 0) write_to_nowhere();
    if (strcmp(what, "bus") == 0) read_unanswered();
    if (strcmp(what, "abort") == 0) abort();
    if (strcmp(what, "exit") == 0) exit(3);
    if (strcmp(what, "constant") == 0) *(volatile char*)(size_t) "constant" = 1;
    if (strcmp(what, "nowhere") == 0) ((void (*)(void))0x40000000)();
    if (strcmp(what, "undefined") == 0) __builtin_trap();
    if (strcmp(what, "unknown") == 0) {
        printf("%ld %ld\n", syscall(SYS_inotify_init1, 0), syscall(SYS_inotify_init1, 0));
        printf("%ld\n", syscall(9999));
    }
    if (strcmp(what, "handled") == 0) {
        struct sigaction action = {.sa_sigaction = on_segv, .sa_flags = SA_SIGINFO};
        sigaction(SIGSEGV, &action, NULL);
        if (sigsetjmp(back, 1) == 0) write_to_nowhere();
        signal(SIGUSR1, on_usr1);
        raise(SIGUSR1);
        printf("raised %d, goes on\n", handled == SIGUSR1);
    }
    return 0;
}

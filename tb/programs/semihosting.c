// semihosting.c - asks a debugger, by newlib and directly; its first line of input says for what.
#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static int request(int operation, const void* argument) {
    register int r0 __asm__("r0") = operation;
    register const void* r1 __asm__("r1") = argument;
    __asm__ volatile("svc 0x123456" : "+r"(r0) : "r"(r1) : "memory", "lr");
    return r0;
}

static void print_and_allocate(void) {
    printf("half of 3 is %.1f\n", 1.5);
    fprintf(stderr, "an error of %d\n", 7);
    char* const memory = malloc(1000000);
    memset(memory, 'a', 1000000);
    printf("%c, input %s\n", memory[999999], feof(stdin) ? "ends" : "goes on");
}

static void echo_a_line(void) {
    char line[80];
    if (fgets(line, sizeof line, stdin)) printf("read: %s", line);
    printf("then '%c'\n", request(7, 0));
}

static void use_files(void) {
    printf("open: %d\n", fopen("none.txt", "r") ? 0 : errno);
    printf("remove: %d\n", remove("none.txt"));
    printf("again: %d\n", fopen("other.txt", "w") ? 0 : errno);
}

static void print_without_end(void) {
    for (;;) fputs("0123456789", stdout);
}

static void ask(void) {
    const uint32_t nowhere = 0x80000000, none[] = {99, 0, 0}, name[] = {(uint32_t) ":tt", 0, 3};
    const int input = request(1, name);
    const uint32_t handle[] = {(uint32_t)input, 1};
    request(0, 0);
    printf("unknown %d, errno %d\n", request(0x99, 0), request(0x13, 0) == EINVAL);
    printf("nowhere %d, errno %d\n", request(4, (void*)nowhere), request(0x13, 0) == EFAULT);
    printf("no handle %d\n", request(2, none));
    printf("console %d, %d, %d\n", request(9, handle), request(0xC, handle), request(9, none));

    char words[80];
    uint32_t line[] = {(uint32_t)words, sizeof words}, small[] = {(uint32_t)words, 2};
    printf("command line %d", request(0x15, line));
    printf(" '%s' %u, %d\n", words, (unsigned)line[1], request(0x15, small));

    uint64_t ticks = 0;
    const int result = request(0x30, &ticks);
    const long now = request(0x10, 0);
    printf("ticks %d per second %d: %d\n", result, request(0x31, 0) == 1000000000,
           ticks / 10000000 == (uint64_t)now);
    request(4, "write0\n");
    request(3, "c\n");
    printf("\n%d %d\n", request(8, (uint32_t[]){0xFFFFFFFF}) != 0, request(8, (uint32_t[]){5}));
}

int main(void) {
    char line[80] = "";
    fgets(line, sizeof line, stdin);
    if (!strcmp(line, "")) print_and_allocate();
    if (!strcmp(line, "echo\n")) echo_a_line();
    if (!strcmp(line, "files\n")) use_files();
    if (!strcmp(line, "print\n")) print_without_end();
    if (!strcmp(line, "ask\n")) ask();
    if (!strcmp(line, "time\n")) printf("%ld s\n", (long)time(NULL));
    if (!strcmp(line, "exit\n")) exit(7);
    if (!strcmp(line, "abort\n")) abort();
    return 0;
}

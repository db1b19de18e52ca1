// unaligned.c - LDM and LDRD at any address, as Linux lets programs do them; then what it does not.
#define _GNU_SOURCE
#include <fcntl.h>
#include <setjmp.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/mman.h>

static sigjmp_buf back;
static void* volatile where;

static void on_bus(int number, siginfo_t* info, void* context) {
    (void)number, (void)context;
    where = info->si_addr;
    siglongjmp(back, 1);
}

static unsigned char bytes[32] __attribute__((aligned(16)));
#define AT(n) (bytes + (n))

int main(void) {
    for (unsigned i = 0; i < sizeof bytes; ++i) bytes[i] = (unsigned char)i;
    const struct sigaction action = {.sa_sigaction = on_bus, .sa_flags = SA_SIGINFO};
    sigaction(SIGBUS, &action, 0);

    uint32_t a, b;
    __asm volatile("ldr %0, [%1]" : "=r"(a) : "r"(AT(1)) : "memory");
    printf("ldr %08x\n", a);
    __asm volatile("ldm %2, {r2, r3}\n mov %0, r2\n mov %1, r3"
                   : "=r"(a), "=r"(b)
                   : "r"(AT(3))
                   : "r2", "r3", "memory");
    printf("ldm %08x %08x\n", a, b);
    __asm volatile("mov r2, %1\n mov r3, %2\n strd r2, r3, [%0]"
                   :
                   : "r"(AT(18)), "r"(a), "r"(b)
                   : "r2", "r3", "memory");
    printf("strd %d\n", memcmp(AT(18), AT(3), 8));
    int code = sigsetjmp(back, 1);
    if (code == 0) __asm volatile("vldr d0, [%0]" : : "r"(AT(2)) : "d0", "memory");
    printf("vldr %s at +%d\n", code ? "SIGBUS" : "done", (int)((unsigned char*)where - bytes));
    code = sigsetjmp(back, 1);
    if (code == 0) __asm volatile("ldrex r2, [%0]" : : "r"(AT(1)) : "r2", "memory");
    printf("ldrex %s at +%d\n", code ? "SIGBUS" : "done", (int)((unsigned char*)where - bytes));

    const int memory = open("/dev/mem", O_RDWR | O_SYNC);
    volatile unsigned char* const leds =
        mmap(0, 4096, PROT_READ | PROT_WRITE, MAP_SHARED, memory, 0xFF200000);
    *(volatile uint32_t*)leds = 0x155;
    code = sigsetjmp(back, 1);
    if (code == 0) {
        __asm volatile("ldr %0, [%1]" : "=r"(a) : "l"(leds + 1) : "memory");
        printf("leds %08x\n", a);
        __asm volatile("ldr.w %0, [%1]" : "=r"(a) : "r"(leds + 1) : "memory");
    }
    printf("ldr.w %s at +%d\n", code ? "SIGBUS" : "done",
           (int)((volatile unsigned char*)where - leds));
    return 0;
}

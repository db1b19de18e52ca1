// qemu_guest.c SHARED_FILE - runs code under qemu-arm as qemu.cpp asks for it: qemu_shared.h.
#define _GNU_SOURCE
#include "qemu_shared.h"

#include <fcntl.h>
#include <signal.h>
#include <stddef.h>
#include <string.h>
#include <sys/mman.h>
#include <ucontext.h>
#include <unistd.h>

#define VFP_MAGIC 0x56465001

struct Vfp {  // Linux, arch/arm/include/asm/ucontext.h
    uint32_t magic, size;
    uint64_t d[32];
    uint32_t fpscr;
};

static struct QemuShared* shared;

static void stopped(int signal, siginfo_t* info, void* context) {
    (void)info;
    ucontext_t* const c = context;
    unsigned long* const r = &c->uc_mcontext.arm_r0;
    struct Vfp* const vfp = (struct Vfp*)c->uc_regspace;
    if (vfp->magic != VFP_MAGIC) _exit(3);
    for (int i = 0; i < 16; ++i) shared->r[i] = r[i];
    shared->cpsr = c->uc_mcontext.arm_cpsr;
    memcpy(shared->d, vfp->d, sizeof shared->d);
    shared->fpscr = vfp->fpscr;
    shared->signal = (uint32_t)signal;

    char byte = 0;
    if (write(1, &byte, 1) != 1 || read(0, &byte, 1) != 1) _exit(0);

    memcpy((char*)QEMU_CODE + shared->changed_begin, shared->code + shared->changed_begin,
           shared->changed_bytes);
    for (int i = 0; i < 16; ++i) r[i] = shared->r[i];
    c->uc_mcontext.arm_cpsr = shared->cpsr;
    memcpy(vfp->d, shared->d, sizeof shared->d);
    vfp->fpscr = shared->fpscr;
}

static int place(uintptr_t at, int protection, int flags, int file, off_t offset) {
    return mmap((void*)at, QEMU_PART, protection, flags | MAP_FIXED, file, offset) == (void*)at;
}

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const int file = open(argv[1], O_RDWR);
    shared = mmap(0, sizeof *shared, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file < 0 || shared == MAP_FAILED) return 4;
    if (!place(QEMU_CODE, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0))
        return 5;
    const off_t data = offsetof(struct QemuShared, data);
    for (unsigned i = 0; i < QEMU_PARTS; ++i)
        if (!place(QEMU_DATA + i * QEMU_PART, PROT_READ | PROT_WRITE, MAP_SHARED, file, data) ||
            !place(QEMU_FAR_DATA + i * QEMU_PART, PROT_READ | PROT_WRITE, MAP_SHARED, file, data))
            return 6;

    static char stack[64 * 1024];
    const stack_t alternative = {.ss_sp = stack, .ss_size = sizeof stack};
    sigaltstack(&alternative, 0);
    struct sigaction action = {.sa_sigaction = stopped, .sa_flags = SA_SIGINFO | SA_ONSTACK};
    sigfillset(&action.sa_mask);
    const int signals[] = {SIGILL, SIGSEGV, SIGBUS, SIGTRAP, SIGFPE};
    for (unsigned i = 0; i < sizeof signals / sizeof *signals; ++i)
        sigaction(signals[i], &action, 0);
    __asm__ volatile("udf #0" ::: "memory");
    return 7;
}

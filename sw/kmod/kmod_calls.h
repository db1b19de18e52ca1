// kmod_calls.h - how a kernel module here and the emulated kernel (sim/linux) call each other
//
// The kernel is called by svc with KMOD_CALL in r7, one of enum kmod_call in r0 and arguments in
// r1 to r5; the result is in r0, errors as the kernel's.
//
// A module is called by requests: threads of it wait for one by KMOD_NEXT, and answer it by their
// next KMOD_NEXT.  The first says that the module is initialised.
#ifndef DE1SIM_KMOD_CALLS_H
#define DE1SIM_KMOD_CALLS_H

#include <stdint.h>

enum { KMOD_CALL = 0x0F5000 };

enum kmod_call {
    KMOD_NEXT,      // (struct kmod_request*)
    KMOD_COPY,      // (to, from, bytes, to_program): how many bytes were not copied
    KMOD_MAP,       // (program's address, physical address, bytes)
    KMOD_OFFER,     // (path, mode with its type, device number, id): a file; "": a range of numbers
    KMOD_WITHDRAW,  // (id)
    KMOD_INTERRUPT_ENABLE,   // (number, whether it is edge-triggered)
    KMOD_INTERRUPT_DISABLE,  // (number)
    KMOD_INTERRUPT_WAIT,     // (number): returns when it has come; it is disabled then
    KMOD_SLEEP,    // (word, value, nanoseconds low, high, whether a signal ends it): 0, -ETIMEDOUT,
                   // -EINTR; at once if the word has another value
    KMOD_WAKE,     // (word): all that sleep
    KMOD_POLLED,   // (): what poll() returned may have changed
    KMOD_LOG,      // (text, bytes, level)
    KMOD_STOP,     // (text, program counter): a bug that ends the run
    KMOD_SIGNAL,   // (file, signal): to the program that has it open
    KMOD_ALLOCATE  // (bytes, where to store the physical address): memory of the bus
};

enum kmod_operation {
    KMOD_INITIALISED,  // no request: what KMOD_NEXT answers first; result 0 or an error
    KMOD_OPEN,         // a: the file's id; result: the struct file*
    KMOD_RELEASE,
    KMOD_FLUSH,
    KMOD_READ,    // a: to, b: bytes
    KMOD_WRITE,   // a: from, b: bytes
    KMOD_SEEK,    // a, b: offset low, high; c: whence
    KMOD_IOCTL,   // a: request, b: argument
    KMOD_MMAP,    // a: the program's address, b: bytes, c: page offset
    KMOD_POLL,    // result: events
    KMOD_FASYNC,  // a: descriptor, b: on
    KMOD_EXIT     // the module's exit function
};

struct kmod_request {
    uint32_t operation;
    int32_t result, result_high;
    uint32_t file, flags;  // struct file*, and O_NONBLOCK and the like of it
    uint32_t a, b, c;
    uint32_t pid;  // of the program's thread
    char command[16];
    uint32_t is_last;  // no other thread waits for the next request
};

#endif

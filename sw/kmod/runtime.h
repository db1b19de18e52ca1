// runtime.h - what the C files here know of each other; modules do not see it
#ifndef DE1SIM_KMOD_RUNTIME_H
#define DE1SIM_KMOD_RUNTIME_H

#define KMOD_RUNTIME
#include "kmod.h"
#include "kmod_calls.h"

static inline long kmod_call(enum kmod_call what, uintptr_t a, uintptr_t b, uintptr_t c,
                             uintptr_t d, uintptr_t e) {
    register uintptr_t number __asm__("r7") = KMOD_CALL;
    register uintptr_t r0 __asm__("r0") = what;
    register uintptr_t r1 __asm__("r1") = a;
    register uintptr_t r2 __asm__("r2") = b;
    register uintptr_t r3 __asm__("r3") = c;
    register uintptr_t r4 __asm__("r4") = d;
    register uintptr_t r5 __asm__("r5") = e;
    __asm__ volatile("svc 0"
                     : "+r"(r0)
                     : "r"(number), "r"(r1), "r"(r2), "r"(r3), "r"(r4), "r"(r5)
                     : "memory");
    return (long)r0;
}

// As the kernel's: kmod_format.c.
int kmod_vsnprintf(char* to, size_t room, const char* format, va_list list);

// A thread of the module.
struct kmod_context {
    struct task_struct task;
    int number;         // of the thread, as a lock's owner
    unsigned atomic;    // how often it may not sleep
    const void* since;  // where that began
    bool interrupts_off, in_interrupt, stops;
    int (*function)(void*);  // of a kthread
    void* data;
    int result;
};
struct kmod_context* kmod_context(void);

// The context is as it was before the function: a bug if a spinlock is still held.
void kmod_check_returned(const char* what);

// Until the word is no longer `value`, and somebody calls kmod_wake().
int kmod_sleep(const int* word, int value, s64 ns, bool interruptible);
void kmod_wake(const int* word);
void kmod_lock(int* word);  // its owner is the thread
bool kmod_try(int* word);
void kmod_unlock(int* word);

void kmod_begin_thread(void* (*function)(void*), void* data);
// Before all others; 0: as others.
void kmod_set_priority(int priority, const char* name);

void kmod_answer(struct kmod_request* request);  // kmod_files.c
int kmod_offer(const char* path, unsigned mode, const struct file_operations* ops, kmod_dev_t dev,
               void* data, struct device* device);
void kmod_withdraw(int id);
void kmod_withdraw_path(const char* path);  // and what is below it
int kmod_offer_parameters(const char* module);
int kmod_set_parameter(const char* text);  // "period=5"; -EINVAL, -ENOENT

enum { KMOD_CHARACTER = 020000, KMOD_REGULAR = 0100000, KMOD_NAME = 128 };

#endif

// kmod_sleep.c - tasks, what they wait for, locks (kmod_sleep.h)
#define _GNU_SOURCE
#include <errno.h>
#include <limits.h>
#include <pthread.h>
#include <sched.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/types.h>
#include <unistd.h>

#include "runtime.h"

enum { STACK = 64 << 10, OTHERS_WAIT = INT_MIN };

// ---- Threads ----

static __thread struct kmod_context* own;

struct kmod_context* kmod_context(void) {
    if (own) return own;
    own = calloc(1, sizeof *own);
    if (!own) abort();
    own->number = own->task.pid = own->task.tgid = gettid();
    own->task.thread = own;
    strcpy(own->task.comm, "kernel");
    return own;
}

struct task_struct* kmod_current(void) { return &kmod_context()->task; }

void kmod_begin_thread(void* (*function)(void*), void* data) {
    pthread_t thread;
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, STACK);
    pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
    if (pthread_create(&thread, &attributes, function, data) != 0)
        kmod_bug(__builtin_return_address(0), "no room for another thread of the kernel");
    pthread_attr_destroy(&attributes);
}

void kmod_set_priority(int priority, const char* name) {
    const struct sched_param parameters = {priority};
    sched_setscheduler(0, priority ? SCHED_FIFO : SCHED_OTHER, &parameters);
    prctl(PR_SET_NAME, name);
    snprintf(kmod_context()->task.comm, TASK_COMM_LEN, "%s", name);
}

static void* run_kthread(void* data) {
    struct kmod_context* const context = data;
    own = context;
    kmod_set_priority(0, context->task.comm);
    context->number = context->task.pid = context->task.tgid = gettid();
    kmod_sleep(&context->task.woken, 0, -1, false);
    if (!context->stops) context->result = context->function(context->data);
    kmod_check_returned("the kthread");
    __atomic_store_n(&context->task.state, -1, __ATOMIC_RELEASE);
    kmod_wake(&context->task.state);
    return NULL;
}

struct task_struct* kmod_thread(int (*function)(void*), void* data, const char* format, ...) {
    kmod_might_sleep(__func__, __builtin_return_address(0));
    struct kmod_context* const context = calloc(1, sizeof *context);
    if (!context) return ERR_PTR(-ENOMEM);
    va_list list;
    va_start(list, format);
    kmod_vsnprintf(context->task.comm, TASK_COMM_LEN, format, list);
    va_end(list);
    context->task.thread = context;
    context->function = function;
    context->data = data;
    context->result = -EINTR;
    kmod_begin_thread(run_kthread, context);
    return &context->task;
}

bool kthread_should_stop(void) { return kmod_context()->stops; }

int kthread_stop(struct task_struct* task) {
    struct kmod_context* const context = task->thread;
    kmod_might_sleep(__func__, __builtin_return_address(0));
    context->stops = true;
    wake_up_process(task);
    for (int state; (state = __atomic_load_n(&task->state, __ATOMIC_ACQUIRE)) != -1;)
        kmod_sleep(&task->state, state, 1000000, false);
    return context->result;
}

int wake_up_process(struct task_struct* task) {
    __atomic_add_fetch(&task->woken, 1, __ATOMIC_SEQ_CST);
    kmod_wake(&task->woken);
    return 1;
}

int signal_pending(struct task_struct* task) {
    return task == current && kmod_sleep(&task->woken, task->woken + 1, -1, true) == -EINTR;
}

void cond_resched(void) { sched_yield(); }

void set_current_state(int state) {
    struct task_struct* const task = current;
    task->seen = __atomic_load_n(&task->woken, __ATOMIC_SEQ_CST);
    task->state = state;
}

long schedule_timeout(long ticks) {
    struct task_struct* const task = current;
    const s64 ns = ticks == MAX_SCHEDULE_TIMEOUT ? -1 : kmod_ticks_ns(ticks);
    const ktime_t end = ktime_get() + ns;
    kmod_might_sleep("schedule", __builtin_return_address(0));
    if (task->state == TASK_RUNNING)
        sched_yield();
    else
        kmod_sleep(&task->woken, task->seen, ns, task->state == TASK_INTERRUPTIBLE);
    task->state = TASK_RUNNING;
    if (ns < 0) return ticks;
    const s64 left = end - ktime_get();
    return left > 0 ? kmod_ns_ticks(left) : 0;
}
void schedule(void) { schedule_timeout(MAX_SCHEDULE_TIMEOUT); }

// ---- Where nothing may sleep ----

void kmod_might_sleep(const char* function, const void* caller) {
    const struct kmod_context* const context = kmod_context();
    if (context->atomic == 0) return;
    kmod_bug(caller, "BUG: sleeping function called from invalid context: %s() %s", function,
             context->in_interrupt ? "in an interrupt's handler, a timer or a tasklet"
                                   : "while a spinlock is held or preemption is off");
}

bool kmod_in_interrupt(void) { return kmod_context()->in_interrupt; }
bool in_atomic(void) { return kmod_context()->atomic != 0; }
void preempt_disable(void) {
    struct kmod_context* const context = kmod_context();
    if (context->atomic++ == 0) context->since = __builtin_return_address(0);
}
void preempt_enable(void) { --kmod_context()->atomic; }

void kmod_check_returned(const char* what) {
    const struct kmod_context* const context = kmod_context();
    if (context->atomic != 0)
        kmod_bug(context->since, "BUG: %s returned while a spinlock is held or interrupts are off",
                 what);
}

// ---- Words ----

int kmod_sleep(const int* word, int value, s64 ns, bool interruptible) {
    const u64 span = ns < 0 ? ~0ull : (u64)ns;
    return (int)kmod_call(KMOD_SLEEP, (uintptr_t)word, (uintptr_t)value, (u32)span,
                          (u32)(span >> 32), interruptible);
}
void kmod_wake(const int* word) { kmod_call(KMOD_WAKE, (uintptr_t)word, 0, 0, 0, 0); }

bool kmod_try(int* word) {
    int nobody = 0;
    return __atomic_compare_exchange_n(word, &nobody, kmod_context()->number, false,
                                       __ATOMIC_ACQUIRE, __ATOMIC_RELAXED);
}

static int lock(int* word, bool interruptible) {
    const int number = kmod_context()->number;
    if (kmod_try(word)) return 0;
    for (;;) {
        int seen = __atomic_load_n(word, __ATOMIC_RELAXED);
        if (seen == 0) {  // whoever has waited cannot know that it was the last
            if (__atomic_compare_exchange_n(word, &seen, number | OTHERS_WAIT, false,
                                            __ATOMIC_ACQUIRE, __ATOMIC_RELAXED))
                return 0;
            continue;
        }
        if (!(seen & OTHERS_WAIT) &&
            !__atomic_compare_exchange_n(word, &seen, seen | OTHERS_WAIT, false, __ATOMIC_RELAXED,
                                         __ATOMIC_RELAXED))
            continue;
        if (kmod_sleep(word, seen | OTHERS_WAIT, -1, interruptible) == -EINTR) return -EINTR;
    }
}
void kmod_lock(int* word) { lock(word, false); }
void kmod_unlock(int* word) {
    if (__atomic_exchange_n(word, 0, __ATOMIC_RELEASE) & OTHERS_WAIT) kmod_wake(word);
}

// ---- Wait queues ----

s64 kmod_ticks_ns(long ticks) { return ticks < 0 ? 0 : (s64)ticks * (1000000000 / HZ); }
long kmod_ns_ticks(s64 ns) {
    const long ticks = (long)((ns + 1000000000 / HZ - 1) / (1000000000 / HZ));
    return ticks < 1 ? 1 : ticks;
}

void init_waitqueue_head(wait_queue_head_t* queue) {
    *queue = (wait_queue_head_t){0, LIST_HEAD_INIT(queue->entries), false};
}

int kmod_sequence(const wait_queue_head_t* queue) {
    return __atomic_load_n(&queue->sequence, __ATOMIC_SEQ_CST);
}

int kmod_wait(wait_queue_head_t* queue, int sequence, s64* ns, bool interruptible) {
    wait_queue_entry_t entry = {current, {NULL, NULL}};
    const ktime_t begin = ktime_get();
    add_wait_queue(queue, &entry);
    const int result = kmod_sleep(&queue->sequence, sequence, *ns, interruptible);
    remove_wait_queue(queue, &entry);
    if (*ns >= 0) {
        const s64 slept = ktime_get() - begin;
        *ns = slept < *ns ? *ns - slept : 0;
    }
    return result;
}

void add_wait_queue(wait_queue_head_t* queue, wait_queue_entry_t* entry) {
    const unsigned long flags = kmod_interrupts_off();
    list_add_tail(&entry->entry, &queue->entries);
    kmod_interrupts_restore(flags);
}
void remove_wait_queue(wait_queue_head_t* queue, wait_queue_entry_t* entry) {
    (void)queue;
    const unsigned long flags = kmod_interrupts_off();
    list_del_init(&entry->entry);
    kmod_interrupts_restore(flags);
}
void prepare_to_wait(wait_queue_head_t* queue, wait_queue_entry_t* entry, int state) {
    if (!entry->entry.next || list_empty(&entry->entry)) add_wait_queue(queue, entry);
    set_current_state(state);
}
void finish_wait(wait_queue_head_t* queue, wait_queue_entry_t* entry) {
    set_current_state(TASK_RUNNING);
    if (entry->entry.next && !list_empty(&entry->entry)) remove_wait_queue(queue, entry);
}

void wake_up(wait_queue_head_t* queue) {
    __atomic_add_fetch(&queue->sequence, 1, __ATOMIC_SEQ_CST);
    kmod_wake(&queue->sequence);
    const unsigned long flags = kmod_interrupts_off();
    wait_queue_entry_t* entry;
    if (queue->entries.next)  // NULL: the module has not initialised it
        list_for_each_entry(entry, &queue->entries, entry) wake_up_process(entry->private);
    kmod_interrupts_restore(flags);
    if (queue->polled) kmod_call(KMOD_POLLED, 0, 0, 0, 0, 0);
}

static void sleep_until_woken(wait_queue_head_t* queue, bool interruptible) {
    s64 never = -1;
    kmod_might_sleep(__func__, __builtin_return_address(0));
    kmod_wait(queue, kmod_sequence(queue), &never, interruptible);
}
void interruptible_sleep_on(wait_queue_head_t* queue) { sleep_until_woken(queue, true); }
void sleep_on(wait_queue_head_t* queue) { sleep_until_woken(queue, false); }

void poll_wait(struct file* file, wait_queue_head_t* queue, poll_table* table) {
    (void)file, (void)table;
    queue->polled = true;
}

// ---- Completions ----

void init_completion(struct completion* c) {
    c->done = 0;
    init_waitqueue_head(&c->wait);
}
void complete(struct completion* c) {
    const unsigned long flags = kmod_interrupts_off();
    if (c->done != UINT_MAX) ++c->done;
    kmod_interrupts_restore(flags);
    wake_up(&c->wait);
}
void complete_all(struct completion* c) {
    c->done = UINT_MAX;
    wake_up(&c->wait);
}
bool try_wait_for_completion(struct completion* c) {
    const unsigned long flags = kmod_interrupts_off();
    const bool done = c->done != 0;
    if (done && c->done != UINT_MAX) --c->done;
    kmod_interrupts_restore(flags);
    return done;
}

// ---- Locks ----

int kmod_mutex_lock(struct mutex* m, bool interruptible, const char* function) {
    kmod_might_sleep("mutex_lock", __builtin_return_address(0));
    if ((m->owner & ~OTHERS_WAIT) == kmod_context()->number)
        kmod_bug(__builtin_return_address(0),
                 "BUG: %s() locks a mutex that it has already: it would wait for itself for ever",
                 function);
    return lock(&m->owner, interruptible);
}
int mutex_trylock(struct mutex* m) { return kmod_try(&m->owner); }
void mutex_unlock(struct mutex* m) { kmod_unlock(&m->owner); }

void sema_init(struct semaphore* s, int count) {
    s->count = count;
    init_waitqueue_head(&s->wait);
}
int down_trylock(struct semaphore* s) {
    int count = __atomic_load_n(&s->count, __ATOMIC_RELAXED);
    while (count > 0)
        if (__atomic_compare_exchange_n(&s->count, &count, count - 1, false, __ATOMIC_ACQUIRE,
                                        __ATOMIC_RELAXED))
            return 0;
    return 1;
}
void up(struct semaphore* s) {
    __atomic_add_fetch(&s->count, 1, __ATOMIC_RELEASE);
    wake_up(&s->wait);
}

static void become_atomic(const void* caller) {
    struct kmod_context* const context = kmod_context();
    if (context->atomic++ == 0) context->since = caller;
}

void spin_lock(spinlock_t* s) {
    const void* const caller = __builtin_return_address(0);
    if ((s->owner & ~OTHERS_WAIT) == kmod_context()->number)
        kmod_bug(caller, "BUG: spinlock recursion: the processor would spin for ever");
    become_atomic(caller);
    kmod_lock(&s->owner);
}
int spin_trylock(spinlock_t* s) {
    if (!kmod_try(&s->owner)) return 0;
    become_atomic(__builtin_return_address(0));
    return 1;
}
void spin_unlock(spinlock_t* s) {
    if ((s->owner & ~OTHERS_WAIT) != kmod_context()->number)
        kmod_bug(__builtin_return_address(0), "BUG: spinlock already unlocked, or another's");
    kmod_unlock(&s->owner);
    --kmod_context()->atomic;
}

// No handler runs while somebody has this.
static int interrupts;

unsigned long kmod_interrupts_off(void) {
    struct kmod_context* const context = kmod_context();
    if (context->interrupts_off) return 1;
    kmod_lock(&interrupts);
    context->interrupts_off = true;
    become_atomic(__builtin_return_address(0));
    return 0;
}
void kmod_interrupts_restore(unsigned long before) {
    struct kmod_context* const context = kmod_context();
    if (before != 0 || !context->interrupts_off) return;
    context->interrupts_off = false;
    --context->atomic;
    kmod_unlock(&interrupts);
}

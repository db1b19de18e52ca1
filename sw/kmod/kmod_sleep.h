// kmod_sleep.h - of kmod.h: tasks, what they wait for, locks
#ifndef DE1SIM_KMOD_SLEEP_H
#define DE1SIM_KMOD_SLEEP_H

// ---- Tasks ----

struct task_struct {
    int pid, tgid;
    char comm[16];
    int state;
    int woken;  // changes when it is woken
    int seen;   // `woken`, when its state was set
    void* thread;
};
#define TASK_RUNNING 0
#define TASK_INTERRUPTIBLE 1
#define TASK_UNINTERRUPTIBLE 2
#define TASK_COMM_LEN 16
#define MAX_SCHEDULE_TIMEOUT ((long)(~0UL >> 1))
struct task_struct* kmod_current(void);
#define current kmod_current()
// Before it looks at what it waits for.
void set_current_state(int state);
#define __set_current_state set_current_state
void schedule(void);
long schedule_timeout(long ticks);  // what is left of them
#define schedule_timeout_interruptible(ticks) \
    (set_current_state(TASK_INTERRUPTIBLE), schedule_timeout(ticks))
#define schedule_timeout_uninterruptible(ticks) \
    (set_current_state(TASK_UNINTERRUPTIBLE), schedule_timeout(ticks))
int wake_up_process(struct task_struct* task);
int signal_pending(struct task_struct* task);
#define fatal_signal_pending signal_pending
void cond_resched(void);
#define yield cond_resched

struct task_struct* kmod_thread(int (*function)(void*), void* data, const char* format, ...)
    __attribute__((format(printf, 3, 4)));
// It begins at its first wake_up_process().
#define kthread_create kmod_thread
#define kthread_run(...)                                            \
    ({                                                              \
        struct task_struct* const task_ = kmod_thread(__VA_ARGS__); \
        if (!IS_ERR(task_)) wake_up_process(task_);                 \
        task_;                                                      \
    })
int kthread_stop(struct task_struct* task);  // what its function returns
bool kthread_should_stop(void);
static inline void get_task_struct(struct task_struct* task) { (void)task; }
static inline void put_task_struct(struct task_struct* task) { (void)task; }
static inline void set_user_nice(struct task_struct* task, long nice) { (void)task, (void)nice; }
#define kthread_bind(task, processor) ((void)(task), (void)(processor))

// Of a function that may sleep: a bug where that is forbidden.
void kmod_might_sleep(const char* function, const void* caller);
#define might_sleep() kmod_might_sleep(__func__, (void*)_THIS_IP_)
bool kmod_in_interrupt(void);
#define in_interrupt() kmod_in_interrupt()
#define in_irq() kmod_in_interrupt()
#define in_softirq() kmod_in_interrupt()
bool in_atomic(void);
void preempt_disable(void);
void preempt_enable(void);

// ---- Wait queues ----

typedef struct wait_queue_head {
    int sequence;  // changes at each wake_up()
    struct list_head entries;
    bool polled;
} wait_queue_head_t;
typedef struct wait_queue_entry {
    struct task_struct* private;
    struct list_head entry;
} wait_queue_t, wait_queue_entry_t;
#define KMOD_WAIT_QUEUE_(name) \
    { 0, LIST_HEAD_INIT((name).entries), false }
#define DECLARE_WAIT_QUEUE_HEAD(name) wait_queue_head_t name = KMOD_WAIT_QUEUE_(name)
#define DECLARE_WAIT_QUEUE_HEAD_ONSTACK DECLARE_WAIT_QUEUE_HEAD
#define __WAIT_QUEUE_HEAD_INITIALIZER KMOD_WAIT_QUEUE_
#define DECLARE_WAITQUEUE(name, task) wait_queue_entry_t name = {task, {NULL, NULL}}
#define DEFINE_WAIT(name) DECLARE_WAITQUEUE(name, current)
void init_waitqueue_head(wait_queue_head_t* queue);
static inline void init_wait(wait_queue_entry_t* entry) { entry->private = current; }
void add_wait_queue(wait_queue_head_t* queue, wait_queue_entry_t* entry);
void remove_wait_queue(wait_queue_head_t* queue, wait_queue_entry_t* entry);
void prepare_to_wait(wait_queue_head_t* queue, wait_queue_entry_t* entry, int state);
#define prepare_to_wait_exclusive prepare_to_wait
void finish_wait(wait_queue_head_t* queue, wait_queue_entry_t* entry);
void wake_up(wait_queue_head_t* queue);
#define wake_up_all wake_up
#define wake_up_interruptible wake_up
#define wake_up_interruptible_all wake_up
#define wake_up_interruptible_sync wake_up
#define wake_up_sync wake_up
static inline int waitqueue_active(const wait_queue_head_t* queue) {
    return !list_empty(&queue->entries);
}
#define wq_has_sleeper waitqueue_active

// Until wake_up() or so many nanoseconds later (-1: never), which it counts down: 0, -ETIMEDOUT or,
// by a signal, -EINTR.
int kmod_wait(wait_queue_head_t* queue, int sequence, s64* ns, bool interruptible);
int kmod_sequence(const wait_queue_head_t* queue);
#define KMOD_WAIT_EVENT_(queue, condition, left, interruptible)            \
    ({                                                                     \
        int result_ = 0;                                                   \
        might_sleep();                                                     \
        for (;;) {                                                         \
            const int sequence_ = kmod_sequence(&(queue));                 \
            if (condition) {                                               \
                result_ = 0;                                               \
                break;                                                     \
            }                                                              \
            if (result_) break;                                            \
            result_ = kmod_wait(&(queue), sequence_, left, interruptible); \
            if (result_ == -EINTR) break;                                  \
        }                                                                  \
        result_;                                                           \
    })
#define wait_event(queue, condition)                       \
    ({                                                     \
        s64 left_ = -1;                                    \
        KMOD_WAIT_EVENT_(queue, condition, &left_, false); \
    })
#define wait_event_interruptible(queue, condition)                                     \
    ({                                                                                 \
        s64 left_ = -1;                                                                \
        KMOD_WAIT_EVENT_(queue, condition, &left_, true) == -EINTR ? -ERESTARTSYS : 0; \
    })
#define wait_event_killable wait_event_interruptible
#define wait_event_interruptible_exclusive wait_event_interruptible
// Ticks that are left, 1 at least; 0: they are over.
#define KMOD_WAIT_TICKS_(queue, condition, ticks, interruptible)                      \
    ({                                                                                \
        s64 left_ = kmod_ticks_ns(ticks);                                             \
        const int ended_ = KMOD_WAIT_EVENT_(queue, condition, &left_, interruptible); \
        ended_ == -EINTR ? -(long)ERESTARTSYS : ended_ ? 0L : kmod_ns_ticks(left_);   \
    })
#define wait_event_timeout(queue, condition, ticks) KMOD_WAIT_TICKS_(queue, condition, ticks, false)
#define wait_event_interruptible_timeout(queue, condition, ticks) \
    KMOD_WAIT_TICKS_(queue, condition, ticks, true)
s64 kmod_ticks_ns(long ticks);
long kmod_ns_ticks(s64 ns);
void interruptible_sleep_on(wait_queue_head_t* queue);
void sleep_on(wait_queue_head_t* queue);

typedef struct poll_table_struct {
    bool waits;
} poll_table;
void poll_wait(struct file* file, wait_queue_head_t* queue, poll_table* table);

// ---- Completions ----

struct completion {
    unsigned done;
    wait_queue_head_t wait;
};
#define COMPLETION_INITIALIZER(name) \
    { 0, KMOD_WAIT_QUEUE_((name).wait) }
#define DECLARE_COMPLETION(name) struct completion name = COMPLETION_INITIALIZER(name)
#define DECLARE_COMPLETION_ONSTACK DECLARE_COMPLETION
void init_completion(struct completion* c);
static inline void reinit_completion(struct completion* c) { c->done = 0; }
#define INIT_COMPLETION(c) reinit_completion(&(c))
void complete(struct completion* c);
void complete_all(struct completion* c);
bool try_wait_for_completion(struct completion* c);
#define completion_done(c) ((c)->done != 0)
#define wait_for_completion(c) ((void)wait_event((c)->wait, try_wait_for_completion(c)))
#define wait_for_completion_interruptible(c) \
    wait_event_interruptible((c)->wait, try_wait_for_completion(c))
#define wait_for_completion_killable wait_for_completion_interruptible
#define wait_for_completion_timeout(c, ticks) \
    ((unsigned long)wait_event_timeout((c)->wait, try_wait_for_completion(c), ticks))
#define wait_for_completion_interruptible_timeout(c, ticks) \
    wait_event_interruptible_timeout((c)->wait, try_wait_for_completion(c), ticks)

// ---- Locks ----

struct mutex {
    int owner;  // the thread's number, and whether others wait, as libc's robust mutexes
};
#define DEFINE_MUTEX(name) struct mutex name = {0}
#define __MUTEX_INITIALIZER(name) \
    { 0 }
#define mutex_init(m) ((void)((m)->owner = 0))
#define mutex_destroy(m) ((void)(m))
int kmod_mutex_lock(struct mutex* m, bool interruptible, const char* function);
int mutex_trylock(struct mutex* m);
void mutex_unlock(struct mutex* m);
#define mutex_lock(m) ((void)kmod_mutex_lock(m, false, __func__))
#define mutex_lock_interruptible(m) kmod_mutex_lock(m, true, __func__)
#define mutex_lock_killable mutex_lock_interruptible
#define mutex_is_locked(m) ((m)->owner != 0)

struct semaphore {
    int count;
    wait_queue_head_t wait;
};
#define KMOD_SEMAPHORE_1(name) struct semaphore name = {1, KMOD_WAIT_QUEUE_((name).wait)}
#define KMOD_SEMAPHORE_2(name, n) struct semaphore name = {n, KMOD_WAIT_QUEUE_((name).wait)}
#define DEFINE_SEMAPHORE(...) \
    KMOD_PICK_(__VA_ARGS__, KMOD_SEMAPHORE_2, KMOD_SEMAPHORE_1, )(__VA_ARGS__)
void sema_init(struct semaphore* s, int count);
int down_trylock(struct semaphore* s);  // 0: taken
void up(struct semaphore* s);
#define down(s) ((void)wait_event((s)->wait, down_trylock(s) == 0))
#define down_interruptible(s) \
    (wait_event_interruptible((s)->wait, down_trylock(s) == 0) ? -EINTR : 0)
#define down_killable down_interruptible
#define down_timeout(s, ticks) \
    (wait_event_timeout((s)->wait, down_trylock(s) == 0, ticks) ? 0 : -ETIME)

// Who has one cannot sleep, and with _irq or _irqsave no interrupt comes.
typedef struct {
    int owner;  // the thread's number
} spinlock_t, raw_spinlock_t;
#define DEFINE_SPINLOCK(name) spinlock_t name = {0}
#define DEFINE_RAW_SPINLOCK DEFINE_SPINLOCK
#define __SPIN_LOCK_UNLOCKED(name) \
    { 0 }
#define spin_lock_init(s) ((void)((s)->owner = 0))
void spin_lock(spinlock_t* s);
int spin_trylock(spinlock_t* s);
void spin_unlock(spinlock_t* s);
unsigned long kmod_interrupts_off(void);
void kmod_interrupts_restore(unsigned long before);
#define local_irq_save(flags) ((void)((flags) = kmod_interrupts_off()))
#define local_irq_restore(flags) kmod_interrupts_restore(flags)
#define local_irq_disable() ((void)kmod_interrupts_off())
#define local_irq_enable() kmod_interrupts_restore(0)
#define local_bh_disable local_irq_disable
#define local_bh_enable local_irq_enable
#define spin_lock_irqsave(s, flags) (local_irq_save(flags), spin_lock(s))
#define spin_unlock_irqrestore(s, flags) (spin_unlock(s), local_irq_restore(flags))
#define spin_lock_irq(s) (local_irq_disable(), spin_lock(s))
#define spin_unlock_irq(s) (spin_unlock(s), local_irq_enable())
#define spin_lock_bh spin_lock_irq
#define spin_unlock_bh spin_unlock_irq
#define spin_is_locked(s) ((s)->owner != 0)
#define raw_spin_lock spin_lock
#define raw_spin_unlock spin_unlock
#define raw_spin_lock_irqsave spin_lock_irqsave
#define raw_spin_unlock_irqrestore spin_unlock_irqrestore

// Readers wait for each other, too.
typedef spinlock_t rwlock_t;
#define DEFINE_RWLOCK DEFINE_SPINLOCK
#define rwlock_init spin_lock_init
#define read_lock spin_lock
#define read_unlock spin_unlock
#define write_lock spin_lock
#define write_unlock spin_unlock
struct rw_semaphore {
    struct mutex lock;
};
#define DECLARE_RWSEM(name) struct rw_semaphore name = {{0}}
#define init_rwsem(s) mutex_init(&(s)->lock)
#define down_read(s) mutex_lock(&(s)->lock)
#define up_read(s) mutex_unlock(&(s)->lock)
#define down_write(s) mutex_lock(&(s)->lock)
#define up_write(s) mutex_unlock(&(s)->lock)

#endif

// kmod_later.h - of kmod.h: what runs later: interrupts' handlers, timers, tasklets, work
//
// Handlers run in a thread that comes before all others, one at a time, and never while somebody
// keeps interrupts off; timers and tasklets in one that comes next.  None of them may sleep.  Work
// and the second half of request_threaded_irq() run in threads of their own and may.
#ifndef DE1SIM_KMOD_LATER_H
#define DE1SIM_KMOD_LATER_H

// ---- Interrupts: by their numbers at the interrupt controller, from 72 on those of the FPGA ----

typedef enum { IRQ_NONE = 0, IRQ_HANDLED = 1, IRQ_WAKE_THREAD = 2 } irqreturn_t;
#define IRQ_RETVAL(handled) ((handled) ? IRQ_HANDLED : IRQ_NONE)
typedef irqreturn_t (*irq_handler_t)(int, void*);
struct pt_regs;
#define IRQF_TRIGGER_NONE 0
#define IRQF_TRIGGER_RISING 1
#define IRQF_TRIGGER_FALLING 2
#define IRQF_TRIGGER_HIGH 4
#define IRQF_TRIGGER_LOW 8
#define IRQF_SHARED 0x80
#define IRQF_ONESHOT 0x2000
#define IRQF_NO_SUSPEND 0x4000
#define IRQF_DISABLED 0
#define SA_INTERRUPT 0
#define SA_SHIRQ IRQF_SHARED
#define NO_IRQ 0
// `handler` may be NULL; so may `thread`.
int request_threaded_irq(unsigned irq, irq_handler_t handler, irq_handler_t thread,
                         unsigned long flags, const char* name, void* data);
#define request_irq(irq, handler, flags, name, data) \
    request_threaded_irq(irq, (irq_handler_t)(handler), NULL, flags, name, data)
#define devm_request_irq(dev, irq, handler, flags, name, data) \
    ((void)(dev), request_irq(irq, handler, flags, name, data))
#define devm_request_threaded_irq(dev, irq, handler, thread, flags, name, data) \
    ((void)(dev), request_threaded_irq(irq, handler, thread, flags, name, data))
void* free_irq(unsigned irq, void* data);
#define devm_free_irq(dev, irq, data) ((void)(dev), free_irq(irq, data))
void enable_irq(unsigned irq);
void disable_irq(unsigned irq);
#define disable_irq_nosync disable_irq
#define synchronize_irq(irq) ((void)(irq))
unsigned irq_of_parse_and_map(struct device_node* node, int index);
#define of_irq_get(node, index) ((int)irq_of_parse_and_map(node, index))
#define irq_dispose_mapping(irq) ((void)(irq))
int platform_get_irq(struct platform_device* d, unsigned n);

// ---- Power: the board does not sleep ----

#define device_init_wakeup(dev, on) ((void)(dev), (void)(on), 0)
#define device_set_wakeup_capable(dev, on) ((void)(dev), (void)(on))
#define device_may_wakeup(dev) ((void)(dev), false)
#define enable_irq_wake(irq) ((void)(irq), 0)
#define disable_irq_wake(irq) ((void)(irq), 0)
#define pm_wakeup_event(dev, ms) ((void)(dev), (void)(ms))
#define pm_runtime_enable(dev) ((void)(dev))
#define pm_runtime_disable(dev) ((void)(dev))
#define pm_runtime_get_sync(dev) ((void)(dev), 0)
#define pm_runtime_put(dev) ((void)(dev), 0)
#define pm_runtime_put_sync(dev) ((void)(dev), 0)
#define platform_get_irq_optional platform_get_irq

// ---- Timers ----

struct kmod_timer {
    s64 at_ns;
    void (*run)(struct kmod_timer*);
    struct kmod_timer* next;
    bool queued;
};
void kmod_timer_start(struct kmod_timer* timer, s64 at_ns);
bool kmod_timer_stop(struct kmod_timer* timer);  // whether it was queued

struct timer_list {
    struct kmod_timer timer;
    unsigned long expires;
    void (*function)(unsigned long);
    unsigned long data;
};
void kmod_run_timer(struct kmod_timer* timer);
#define KMOD_TIMER_(function, data)                                               \
    {                                                                             \
        {0, kmod_run_timer, NULL, false}, 0, (void (*)(unsigned long))(function), \
            (unsigned long)(data)                                                 \
    }
#define KMOD_TIMER_2(name, function) struct timer_list name = KMOD_TIMER_(function, &(name))
#define KMOD_TIMER_4(name, function, expires, data) \
    struct timer_list name = KMOD_TIMER_(function, data)
#define KMOD_PICK_4_(a, b, c, d, which, ...) which
// Before Linux 4.15 with the time and the data, too.
#define DEFINE_TIMER(...) KMOD_PICK_4_(__VA_ARGS__, KMOD_TIMER_4, , KMOD_TIMER_2, )(__VA_ARGS__)
#define init_timer(t) ((void)((t)->timer = (struct kmod_timer){0, kmod_run_timer, NULL, false}))
#define setup_timer(t, function_, data_) \
    (init_timer(t), (t)->function = (function_), (void)((t)->data = (data_)))
#define timer_setup(t, function_, flags)                                  \
    (init_timer(t), (t)->function = (void (*)(unsigned long))(function_), \
     (void)((t)->data = (unsigned long)(t)))
#define from_timer(variable, t, member) container_of(t, __typeof__(*variable), member)
#define timer_container_of from_timer
int mod_timer(struct timer_list* t, unsigned long expires);
#define add_timer(t) ((void)mod_timer(t, (t)->expires))
#define del_timer(t) ((int)kmod_timer_stop(&(t)->timer))
#define del_timer_sync del_timer
#define timer_delete del_timer
#define timer_delete_sync del_timer
#define timer_shutdown_sync del_timer
#define timer_pending(t) ((t)->timer.queued)
#define round_jiffies(ticks) (ticks)

enum hrtimer_restart { HRTIMER_NORESTART, HRTIMER_RESTART };
enum hrtimer_mode {
    HRTIMER_MODE_ABS,
    HRTIMER_MODE_REL,
    HRTIMER_MODE_ABS_PINNED,
    HRTIMER_MODE_REL_PINNED
};
struct hrtimer {
    struct kmod_timer timer;
    enum hrtimer_restart (*function)(struct hrtimer*);
};
#ifndef CLOCK_MONOTONIC
#define CLOCK_REALTIME 0
#define CLOCK_MONOTONIC 1
#endif
void kmod_run_hrtimer(struct kmod_timer* timer);
#define hrtimer_init(t, clock, mode) \
    ((void)((t)->timer = (struct kmod_timer){0, kmod_run_hrtimer, NULL, false}))
#define hrtimer_setup(t, function_, clock, mode) \
    (hrtimer_init(t, clock, mode), (void)((t)->function = (function_)))
#define hrtimer_start(t, time, mode) \
    kmod_timer_start(&(t)->timer, (time) + ((mode)&1 ? ktime_get() : 0))
#define hrtimer_cancel(t) ((int)kmod_timer_stop(&(t)->timer))
#define hrtimer_try_to_cancel hrtimer_cancel
#define hrtimer_active(t) ((t)->timer.queued)
#define hrtimer_get_expires(t) ((ktime_t)(t)->timer.at_ns)
#define hrtimer_cb_get_time(t) ((void)(t), ktime_get())
u64 hrtimer_forward(struct hrtimer* t, ktime_t now, ktime_t interval);
#define hrtimer_forward_now(t, interval) hrtimer_forward(t, ktime_get(), interval)

// ---- Tasklets ----

struct tasklet_struct {
    struct kmod_timer timer;
    void (*func)(unsigned long);
    unsigned long data;
};
void kmod_run_tasklet(struct kmod_timer* timer);
#define KMOD_TASKLET_(function, data)                                            \
    {                                                                            \
        {0, kmod_run_tasklet, NULL, false}, (void (*)(unsigned long))(function), \
            (unsigned long)(data)                                                \
    }
#define KMOD_TASKLET_2(name, function) struct tasklet_struct name = KMOD_TASKLET_(function, &(name))
#define KMOD_TASKLET_3(name, function, data) \
    struct tasklet_struct name = KMOD_TASKLET_(function, data)
#define KMOD_PICK_3_(a, b, c, which, ...) which
#define DECLARE_TASKLET(...) \
    KMOD_PICK_3_(__VA_ARGS__, KMOD_TASKLET_3, KMOD_TASKLET_2, )(__VA_ARGS__)
#define DECLARE_TASKLET_OLD KMOD_TASKLET_2
#define tasklet_init(t, function, data) \
    ((void)(*(t) = (struct tasklet_struct)KMOD_TASKLET_(function, data)))
#define tasklet_setup(t, function) tasklet_init(t, function, t)
#define from_tasklet(variable, t, member) container_of(t, __typeof__(*variable), member)
#define tasklet_schedule(t) kmod_timer_start(&(t)->timer, 0)
#define tasklet_hi_schedule tasklet_schedule
#define tasklet_kill(t) ((void)kmod_timer_stop(&(t)->timer))

// ---- Work ----

struct work_struct;
struct workqueue_struct;
typedef void (*work_func_t)(struct work_struct*);
struct work_struct {
    work_func_t func;
    struct list_head entry;
    bool pending;
    struct workqueue_struct* queue;  // that it was queued in last; NULL: in none
};
struct delayed_work {
    struct work_struct work;
    struct kmod_timer timer;
    struct workqueue_struct* queue;
};
#define KMOD_WORK_(name, function) \
    { function, LIST_HEAD_INIT((name).entry), false, NULL }
#define DECLARE_WORK(name, function) struct work_struct name = KMOD_WORK_(name, function)
void kmod_init_work(struct work_struct* work, work_func_t function);
void kmod_run_delayed(struct kmod_timer* timer);
#define INIT_WORK(work, function) kmod_init_work(work, (work_func_t)(function))
#define DECLARE_DELAYED_WORK(name, function) \
    struct delayed_work name = {             \
        KMOD_WORK_((name).work, function), {0, kmod_run_delayed, NULL, false}, NULL}
#define INIT_DELAYED_WORK(w, function) \
    (INIT_WORK(&(w)->work, function),  \
     (void)((w)->timer = (struct kmod_timer){0, kmod_run_delayed, NULL, false}))
static inline struct delayed_work* to_delayed_work(struct work_struct* work) {
    return container_of(work, struct delayed_work, work);
}
struct workqueue_struct* kmod_workqueue(const char* name);
#define create_workqueue(name) kmod_workqueue(name)
#define create_singlethread_workqueue(name) kmod_workqueue(name)
#define alloc_workqueue(name, flags, most, ...) kmod_workqueue(name)
#define alloc_ordered_workqueue(name, flags, ...) kmod_workqueue(name)
#define WQ_UNBOUND 2
#define WQ_HIGHPRI 16
#define WQ_MEM_RECLAIM 8
#define WQ_FREEZABLE 4
extern struct workqueue_struct* const system_wq;
bool queue_work(struct workqueue_struct* queue, struct work_struct* work);
bool queue_delayed_work(struct workqueue_struct* queue, struct delayed_work* w,
                        unsigned long ticks);
#define mod_delayed_work(queue, w, ticks) \
    (kmod_timer_stop(&(w)->timer), queue_delayed_work(queue, w, ticks))
#define schedule_work(work) queue_work(system_wq, work)
#define schedule_delayed_work(w, ticks) queue_delayed_work(system_wq, w, ticks)
bool kmod_cancel_work(struct work_struct* work, bool waits);
bool kmod_cancel_delayed_work(struct delayed_work* w, bool waits);
#define cancel_work(work) kmod_cancel_work(work, false)
#define cancel_work_sync(work) kmod_cancel_work(work, true)
#define cancel_delayed_work(w) kmod_cancel_delayed_work(w, false)
#define cancel_delayed_work_sync(w) kmod_cancel_delayed_work(w, true)
bool flush_work(struct work_struct* work);
#define flush_delayed_work(w) flush_work(&(w)->work)
void flush_workqueue(struct workqueue_struct* queue);
#define drain_workqueue flush_workqueue
#define flush_scheduled_work() flush_workqueue(system_wq)
void destroy_workqueue(struct workqueue_struct* queue);
#define work_pending(work) ((work)->pending)
#define delayed_work_pending(w) ((w)->work.pending || (w)->timer.queued)

#endif

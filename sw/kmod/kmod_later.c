// kmod_later.c - interrupts' handlers, timers, tasklets, work (kmod_later.h)
#define _GNU_SOURCE
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

#include "runtime.h"
#include "nodes.h"

enum { HANDLER_PRIORITY = 99, TIMER_PRIORITY = 98, UNHANDLED = 99900, COUNTED = 100000 };

// ---- Interrupts ----

struct action {
    irq_handler_t handler, thread;
    unsigned long flags;
    char name[TASK_COMM_LEN];
    void* data;
    unsigned irq;
    int asked, done;  // the thread's runs
    bool ended;
    struct action* next;
};
static struct line {
    unsigned irq;
    struct action* actions;
    unsigned calls, unhandled;
    int disabled;
    struct line* next;
} * lines;

static struct line* line_of(unsigned irq) {
    struct line* line = lines;
    while (line && line->irq != irq) line = line->next;
    return line;
}

// "irq 73: nobody cared", as the kernel counts it.
static void count(struct line* line, bool handled) {
    line->unhandled += !handled;
    if (++line->calls < COUNTED) return;
    line->calls = 0;
    if (line->unhandled > UNHANDLED) {
        printk(KERN_EMERG "irq %u: nobody cared (try booting with the \"irqpoll\" option)\n",
               line->irq);
        printk(KERN_EMERG "Disabling IRQ #%u\n", line->irq);
        line->disabled = 1;
    }
    line->unhandled = 0;
}

static void handle(struct line* line) {
    struct kmod_context* const context = kmod_context();
    const unsigned long flags = kmod_interrupts_off();
    bool handled = false;
    context->in_interrupt = true;
    const unsigned atomic = context->atomic;
    for (struct action* action = line->actions; action; action = action->next) {
        // Before Linux 2.6.19 a third argument told the registers.
        irqreturn_t (*const handler)(int, void*, struct pt_regs*) = (void*)action->handler;
        const irqreturn_t result =
            handler ? handler((int)line->irq, action->data, NULL) : IRQ_WAKE_THREAD;
        if (context->atomic != atomic)
            kmod_bug(context->since, "BUG: the handler of interrupt %u returned with a spinlock",
                     line->irq);
        handled |= result != IRQ_NONE;
        if (result != IRQ_WAKE_THREAD || !action->thread) continue;
        __atomic_add_fetch(&action->asked, 1, __ATOMIC_SEQ_CST);
        kmod_wake(&action->asked);
    }
    count(line, handled);
    context->in_interrupt = false;
    kmod_interrupts_restore(flags);
    for (struct action* action = line->actions; action; action = action->next)
        while (action->flags & IRQF_ONESHOT && action->done != action->asked)
            kmod_sleep(&action->done, action->done, -1, false);
}

static void* run_line(void* data) {
    struct line* const line = data;
    char name[TASK_COMM_LEN];
    snprintf(name, sizeof name, "irq/%u", line->irq);
    kmod_set_priority(HANDLER_PRIORITY, name);
    while (kmod_call(KMOD_INTERRUPT_WAIT, line->irq, 0, 0, 0, 0) == 0) {
        handle(line);
        if (line->disabled) kmod_call(KMOD_INTERRUPT_DISABLE, line->irq, 0, 0, 0, 0);
    }
    return NULL;
}

static void* run_action(void* data) {
    struct action* const action = data;
    char name[TASK_COMM_LEN];
    snprintf(name, sizeof name, "irq/%u-%.8s", action->irq, action->name);
    kmod_set_priority(50, name);
    for (;;) {
        const int asked = __atomic_load_n(&action->asked, __ATOMIC_SEQ_CST);
        if (action->ended) break;
        if (asked == action->done) {
            kmod_sleep(&action->asked, asked, -1, false);
            continue;
        }
        action->thread((int)action->irq, action->data);
        kmod_check_returned("the thread of an interrupt's handler");
        action->done = asked;
        kmod_wake(&action->done);
    }
    free(action);
    return NULL;
}

int request_threaded_irq(unsigned irq, irq_handler_t handler, irq_handler_t thread,
                         unsigned long flags, const char* name, void* data) {
    kmod_might_sleep("request_irq", __builtin_return_address(0));
    if ((flags & IRQF_SHARED && !data) || (!handler && !thread)) return -EINVAL;
    if (!handler && !(flags & IRQF_ONESHOT)) {
        printk(KERN_ERR "genirq: Threaded irq requested with handler=NULL and !ONESHOT for irq %u\n",
               irq);
        return -EINVAL;
    }
    struct line* line = line_of(irq);
    if (line && line->actions && !(flags & line->actions->flags & IRQF_SHARED)) {
        printk(KERN_ERR "genirq: Flags mismatch irq %u. %08lx (%s) vs. %08lx (%s)\n", irq, flags,
               name, line->actions->flags, line->actions->name);
        return -EBUSY;
    }
    struct action* const action = calloc(1, sizeof *action);
    if (!line) line = calloc(1, sizeof *line);
    if (!action || !line) return -ENOMEM;
    *action = (struct action){.handler = handler, .thread = thread, .flags = flags, .data = data,
                              .irq = irq};
    snprintf(action->name, sizeof action->name, "%s", name ? name : "");
    const bool first = !line->actions;
    if (line->irq != irq) {
        line->irq = irq;
        line->next = lines;
        lines = line;
    }
    const unsigned long before = kmod_interrupts_off();
    struct action** last = &line->actions;
    while (*last) last = &(*last)->next;
    *last = action;
    kmod_interrupts_restore(before);
    if (thread) kmod_begin_thread(run_action, action);
    if (!first) return 0;
    line->disabled = 0;
    const bool edge = flags & (IRQF_TRIGGER_RISING | IRQF_TRIGGER_FALLING);
    const long error = kmod_call(KMOD_INTERRUPT_ENABLE, irq, edge, (uintptr_t)action->name, 0, 0);
    if (error == 0)
        kmod_begin_thread(run_line, line);
    else
        free_irq(irq, data);
    return (int)error;
}

void* free_irq(unsigned irq, void* data) {
    struct line* const line = line_of(irq);
    const unsigned long before = kmod_interrupts_off();
    struct action** at = line ? &line->actions : NULL;
    while (at && *at && (*at)->data != data) at = &(*at)->next;
    struct action* const action = at ? *at : NULL;
    if (action) *at = action->next;
    kmod_interrupts_restore(before);
    if (!action) {
        printk(KERN_WARNING "Trying to free already-free IRQ %u\n", irq);
        return NULL;
    }
    if (!line->actions) kmod_call(KMOD_INTERRUPT_DISABLE, irq, true, 0, 0, 0);
    action->ended = true;
    if (action->thread)
        kmod_wake(&action->asked);
    else
        free(action);
    return NULL;
}

void enable_irq(unsigned irq) {
    struct line* const line = line_of(irq);
    if (line && line->disabled > 0 && --line->disabled == 0)
        kmod_call(KMOD_INTERRUPT_ENABLE, irq, 2, 0, 0, 0);
}
void disable_irq(unsigned irq) {
    struct line* const line = line_of(irq);
    if (line && line->disabled++ == 0) kmod_call(KMOD_INTERRUPT_DISABLE, irq, 0, 0, 0, 0);
}

unsigned irq_of_parse_and_map(struct device_node* node, int index) {
    return node && index >= 0 && (unsigned)index < node->interrupt_count ? node->interrupts[index]
                                                                         : 0;
}
int platform_get_irq(struct platform_device* d, unsigned n) {
    const unsigned irq = irq_of_parse_and_map(d->dev.of_node, (int)n);
    return irq ? (int)irq : -ENXIO;
}

// ---- Timers and tasklets ----

static struct kmod_timer* timers;  // by their time
static int timers_changed;

static void* run_timers(void* data) {
    struct kmod_context* const context = kmod_context();
    (void)data;
    kmod_set_priority(TIMER_PRIORITY, "ksoftirqd/0");
    for (;;) {
        const unsigned long flags = kmod_interrupts_off();
        struct kmod_timer* const timer = timers;
        const int changed = timers_changed;
        const s64 left = timer ? timer->at_ns - ktime_get() : -1;
        const bool due = timer && left <= 0;
        if (due) {
            timers = timer->next;
            timer->queued = false;
            context->in_interrupt = true;
            timer->run(timer);
            context->in_interrupt = false;
            if (context->atomic != 1)
                kmod_bug(context->since, "BUG: a timer's function returned with a spinlock");
        }
        kmod_interrupts_restore(flags);
        if (!due) kmod_sleep(&timers_changed, changed, left, false);
    }
    return NULL;
}

void kmod_timer_start(struct kmod_timer* timer, s64 at_ns) {
    static bool begun;
    const unsigned long flags = kmod_interrupts_off();
    kmod_timer_stop(timer);
    struct kmod_timer** at = &timers;
    while (*at && (*at)->at_ns <= at_ns) at = &(*at)->next;
    timer->at_ns = at_ns;
    timer->queued = true;
    timer->next = *at;
    *at = timer;
    ++timers_changed;
    const bool begins = !begun;
    begun = true;
    kmod_interrupts_restore(flags);
    if (begins)
        kmod_begin_thread(run_timers, NULL);
    else
        kmod_wake(&timers_changed);
}

bool kmod_timer_stop(struct kmod_timer* timer) {
    const unsigned long flags = kmod_interrupts_off();
    const bool queued = timer->queued;
    struct kmod_timer** at = &timers;
    while (*at && *at != timer) at = &(*at)->next;
    if (*at) *at = timer->next;
    timer->queued = false;
    kmod_interrupts_restore(flags);
    return queued;
}

void kmod_run_timer(struct kmod_timer* timer) {
    struct timer_list* const t = container_of(timer, struct timer_list, timer);
    t->function(t->data);
}
int mod_timer(struct timer_list* t, unsigned long expires) {
    const bool queued = t->timer.queued;
    t->expires = expires;
    const long ticks = (long)(expires - jiffies);
    const s64 now = ktime_get(), tick = 1000000000 / HZ;
    kmod_timer_start(&t->timer, ticks <= 0 ? now : (now / tick + ticks) * tick);
    return queued;
}

void kmod_run_hrtimer(struct kmod_timer* timer) {
    struct hrtimer* const t = container_of(timer, struct hrtimer, timer);
    if (t->function(t) == HRTIMER_RESTART && !timer->queued) kmod_timer_start(timer, timer->at_ns);
}
u64 hrtimer_forward(struct hrtimer* t, ktime_t now, ktime_t interval) {
    if (now < t->timer.at_ns || interval <= 0) return 0;
    const u64 missed = (u64)((now - t->timer.at_ns) / interval) + 1;
    t->timer.at_ns += (s64)missed * interval;
    return missed;
}

void kmod_run_tasklet(struct kmod_timer* timer) {
    struct tasklet_struct* const t = container_of(timer, struct tasklet_struct, timer);
    t->func(t->data);
}

// ---- Work ----

struct workqueue_struct {
    char name[TASK_COMM_LEN];
    struct list_head works;
    struct work_struct* running;
    int changed;
    bool begun, ended;
};
static struct workqueue_struct events = {.name = "kworker/0:0",
                                         .works = LIST_HEAD_INIT(events.works)};
struct workqueue_struct* const system_wq = &events;

static void change(struct workqueue_struct* queue) {
    __atomic_add_fetch(&queue->changed, 1, __ATOMIC_SEQ_CST);
    kmod_wake(&queue->changed);
}

static void* run_work(void* data) {
    struct workqueue_struct* const queue = data;
    kmod_set_priority(0, queue->name);
    while (!queue->ended) {
        const unsigned long flags = kmod_interrupts_off();
        const int changed = queue->changed;
        struct work_struct* const work =
            list_first_entry_or_null(&queue->works, struct work_struct, entry);
        if (work) {
            list_del_init(&work->entry);
            work->pending = false;
        }
        queue->running = work;
        kmod_interrupts_restore(flags);
        if (!work) {
            kmod_sleep(&queue->changed, changed, -1, false);
            continue;
        }
        work->func(work);
        kmod_check_returned("a work's function");
        queue->running = NULL;
        change(queue);
    }
    if (queue != &events) free(queue);
    return NULL;
}

struct workqueue_struct* kmod_workqueue(const char* name) {
    struct workqueue_struct* const queue = calloc(1, sizeof *queue);
    if (!queue) return NULL;
    snprintf(queue->name, sizeof queue->name, "%s", name);
    INIT_LIST_HEAD(&queue->works);
    return queue;
}

void kmod_init_work(struct work_struct* work, work_func_t function) {
    *work = (struct work_struct){function, LIST_HEAD_INIT(work->entry), false, NULL};
}

bool queue_work(struct workqueue_struct* queue, struct work_struct* work) {
    const unsigned long flags = kmod_interrupts_off();
    const bool was = work->pending, begins = !queue->begun;
    if (!was) list_add_tail(&work->entry, &queue->works);
    work->pending = queue->begun = true;
    work->queue = queue;
    kmod_interrupts_restore(flags);
    if (begins) kmod_begin_thread(run_work, queue);
    if (!was) change(queue);
    return !was;
}

void kmod_run_delayed(struct kmod_timer* timer) {
    struct delayed_work* const w = container_of(timer, struct delayed_work, timer);
    queue_work(w->queue, &w->work);
}
bool queue_delayed_work(struct workqueue_struct* queue, struct delayed_work* w,
                        unsigned long ticks) {
    if (w->work.pending || w->timer.queued) return false;
    if (ticks == 0) return queue_work(queue, &w->work);
    w->queue = queue;
    kmod_timer_start(&w->timer, ktime_get() + kmod_ticks_ns((long)ticks));
    return true;
}

static void wait_for(struct workqueue_struct* queue, const struct work_struct* work) {
    for (;;) {
        const int changed = __atomic_load_n(&queue->changed, __ATOMIC_SEQ_CST);
        const bool busy = work ? work->pending || queue->running == work
                               : queue->running || !list_empty(&queue->works);
        if (!busy) return;
        kmod_sleep(&queue->changed, changed, 1000000, false);
    }
}

bool kmod_cancel_work(struct work_struct* work, bool waits) {
    if (waits) kmod_might_sleep("cancel_work_sync", __builtin_return_address(0));
    const unsigned long flags = kmod_interrupts_off();
    const bool was = work->pending;
    if (was) list_del_init(&work->entry);
    work->pending = false;
    kmod_interrupts_restore(flags);
    if (waits && work->queue) wait_for(work->queue, work);
    return was;
}
bool kmod_cancel_delayed_work(struct delayed_work* w, bool waits) {
    const bool waited = kmod_timer_stop(&w->timer);
    return kmod_cancel_work(&w->work, waits) || waited;
}
bool flush_work(struct work_struct* work) {
    kmod_might_sleep(__func__, __builtin_return_address(0));
    const bool was = work->pending;
    if (work->queue) wait_for(work->queue, work);
    return was;
}
void flush_workqueue(struct workqueue_struct* queue) {
    kmod_might_sleep(__func__, __builtin_return_address(0));
    wait_for(queue, NULL);
}
void destroy_workqueue(struct workqueue_struct* queue) {
    flush_workqueue(queue);
    queue->ended = true;
    if (queue->begun)
        change(queue);
    else
        free(queue);
}

// kmod_list.h - of kmod.h: lists, atomic numbers, bits
#ifndef DE1SIM_KMOD_LIST_H
#define DE1SIM_KMOD_LIST_H

// ---- Lists: a ring through a head that is no entry ----

struct list_head {
    struct list_head *next, *prev;
};
#define LIST_HEAD_INIT(name) \
    { &(name), &(name) }
#define LIST_HEAD(name) struct list_head name = LIST_HEAD_INIT(name)
static inline void INIT_LIST_HEAD(struct list_head* head) { head->next = head->prev = head; }
static inline void kmod_list_insert(struct list_head* entry, struct list_head* before,
                                    struct list_head* after) {
    entry->prev = before;
    entry->next = after;
    before->next = after->prev = entry;
}
static inline void list_add(struct list_head* entry, struct list_head* head) {
    kmod_list_insert(entry, head, head->next);
}
static inline void list_add_tail(struct list_head* entry, struct list_head* head) {
    kmod_list_insert(entry, head->prev, head);
}
static inline void list_del(struct list_head* entry) {
    entry->prev->next = entry->next;
    entry->next->prev = entry->prev;
    entry->next = entry->prev = (struct list_head*)0x100;  // a use of it is an oops
}
static inline void list_del_init(struct list_head* entry) {
    list_del(entry);
    INIT_LIST_HEAD(entry);
}
static inline void list_move(struct list_head* entry, struct list_head* head) {
    list_del(entry);
    list_add(entry, head);
}
static inline void list_move_tail(struct list_head* entry, struct list_head* head) {
    list_del(entry);
    list_add_tail(entry, head);
}
static inline int list_empty(const struct list_head* head) { return head->next == head; }
#define list_entry(pointer, type, member) container_of(pointer, type, member)
#define list_first_entry(head, type, member) list_entry((head)->next, type, member)
#define list_last_entry(head, type, member) list_entry((head)->prev, type, member)
#define list_first_entry_or_null(head, type, member) \
    (list_empty(head) ? NULL : list_first_entry(head, type, member))
#define list_next_entry(at, member) list_entry((at)->member.next, __typeof__(*(at)), member)
#define list_for_each(at, head) for ((at) = (head)->next; (at) != (head); (at) = (at)->next)
#define list_for_each_safe(at, next_, head)                         \
    for ((at) = (head)->next, (next_) = (at)->next; (at) != (head); \
         (at) = (next_), (next_) = (at)->next)
#define list_for_each_entry(at, head, member)                                               \
    for ((at) = list_first_entry(head, __typeof__(*(at)), member); &(at)->member != (head); \
         (at) = list_next_entry(at, member))
#define list_for_each_entry_safe(at, next_, head, member)          \
    for ((at) = list_first_entry(head, __typeof__(*(at)), member), \
        (next_) = list_next_entry(at, member);                     \
         &(at)->member != (head); (at) = (next_), (next_) = list_next_entry(at, member))

// ---- Atomic numbers ----

typedef struct {
    int counter;
} atomic_t;
#define ATOMIC_INIT(n) \
    { n }
#define atomic_read(a) __atomic_load_n(&(a)->counter, __ATOMIC_SEQ_CST)
#define atomic_set(a, n) __atomic_store_n(&(a)->counter, n, __ATOMIC_SEQ_CST)
#define atomic_add_return(n, a) __atomic_add_fetch(&(a)->counter, n, __ATOMIC_SEQ_CST)
#define atomic_sub_return(n, a) __atomic_sub_fetch(&(a)->counter, n, __ATOMIC_SEQ_CST)
#define atomic_add(n, a) ((void)atomic_add_return(n, a))
#define atomic_sub(n, a) ((void)atomic_sub_return(n, a))
#define atomic_inc(a) atomic_add(1, a)
#define atomic_dec(a) atomic_sub(1, a)
#define atomic_inc_return(a) atomic_add_return(1, a)
#define atomic_dec_return(a) atomic_sub_return(1, a)
#define atomic_inc_and_test(a) (atomic_inc_return(a) == 0)
#define atomic_dec_and_test(a) (atomic_dec_return(a) == 0)
#define atomic_xchg(a, n) __atomic_exchange_n(&(a)->counter, n, __ATOMIC_SEQ_CST)
#define atomic_cmpxchg(a, old, new)                                                 \
    ({                                                                              \
        int old_ = (old);                                                           \
        __atomic_compare_exchange_n(&(a)->counter, &old_, new, 0, __ATOMIC_SEQ_CST, \
                                    __ATOMIC_SEQ_CST);                              \
        old_;                                                                       \
    })
#define READ_ONCE(x) (*(const volatile __typeof__(x)*)&(x))
#define WRITE_ONCE(x, value) (*(volatile __typeof__(x)*)&(x) = (value))

// ---- Bits of an array of words ----

#define BITS_PER_LONG 32
#define BITS_TO_LONGS(n) DIV_ROUND_UP(n, BITS_PER_LONG)
#define DECLARE_BITMAP(name, n) unsigned long name[BITS_TO_LONGS(n)]
#define KMOD_BIT_(n) (1UL << (n) % BITS_PER_LONG)
static inline void set_bit(unsigned n, volatile unsigned long* words) {
    __atomic_fetch_or(words + n / BITS_PER_LONG, KMOD_BIT_(n), __ATOMIC_SEQ_CST);
}
static inline void clear_bit(unsigned n, volatile unsigned long* words) {
    __atomic_fetch_and(words + n / BITS_PER_LONG, ~KMOD_BIT_(n), __ATOMIC_SEQ_CST);
}
static inline void change_bit(unsigned n, volatile unsigned long* words) {
    __atomic_fetch_xor(words + n / BITS_PER_LONG, KMOD_BIT_(n), __ATOMIC_SEQ_CST);
}
static inline int test_bit(unsigned n, const volatile unsigned long* words) {
    return (words[n / BITS_PER_LONG] & KMOD_BIT_(n)) != 0;
}
static inline int test_and_set_bit(unsigned n, volatile unsigned long* words) {
    return (__atomic_fetch_or(words + n / BITS_PER_LONG, KMOD_BIT_(n), __ATOMIC_SEQ_CST) &
            KMOD_BIT_(n)) != 0;
}
static inline int test_and_clear_bit(unsigned n, volatile unsigned long* words) {
    return (__atomic_fetch_and(words + n / BITS_PER_LONG, ~KMOD_BIT_(n), __ATOMIC_SEQ_CST) &
            KMOD_BIT_(n)) != 0;
}

#endif

// soft_float.c - without C library, floating-point registers or ABI note: system calls by hand
static long call3(long number, long a, const void* b, long c) {
    register long r7 __asm__("r7") = number;
    register long r0 __asm__("r0") = a;
    register const void* r1 __asm__("r1") = b;
    register long r2 __asm__("r2") = c;
    __asm__ volatile("svc #0" : "+r"(r0) : "r"(r7), "r"(r1), "r"(r2) : "memory");
    return r0;
}

static int kernel_cmpxchg(int old, int new_value, volatile int* at) {
    return ((int (*)(int, int, volatile int*))0xFFFF0FC0)(old, new_value, at);
}

static volatile int word = 5;
static volatile double third = 1.0;

void _start(void) {
    const int swapped = kernel_cmpxchg(5, 7, &word) == 0 && word == 7;
    const int refused = kernel_cmpxchg(5, 9, &word) != 0 && word == 7;
    const unsigned version = *(volatile unsigned*)0xFFFF0FFC;
    third = third / 3.0;
    const int right = third > 0.333 && third < 0.334;
    if (swapped && refused && version >= 2 && right) call3(4, 1, "soft\n", 5);
    call3(1, swapped && refused && right ? 0 : 1, 0, 0);
}

// computes.c - a loop of arithmetic that never ends and touches no memory
int main(void) {
    unsigned a = 1, b = 2, c = 3;
    for (;;) {
        a = a * 5 + b;
        b ^= a >> 7;
        c += b;
        __asm__ volatile("" : "+r"(a), "+r"(b), "+r"(c));
    }
}

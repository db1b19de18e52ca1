// counted.S - a program whose instructions can be counted by hand; the same number in ARM and in
// Thumb
//
//              own instructions                    calls
//   _start     1 + 10 * 3 + 3 = 34                 outer, 10 times
//   outer      10 * (3 + 5 * 2 + 2) = 150          inner, 10 times; ends in a jump to last
//   inner      10 * 2 = 20
//   last       10 * 2 = 20
        .syntax unified
#ifdef __thumb__
        .thumb
#else
        .arm
#endif
        .text

        .global _start
        .type   _start, %function
_start: mov     r4, #10
1:      bl      outer
        subs    r4, r4, #1
        bne     1b
        mov     r0, #0
        mov     r7, #1                  // exit
        svc     #0
        .size   _start, . - _start

        .type   outer, %function
outer:  mov     r8, lr
        bl      inner
        mov     r5, #5
2:      subs    r5, r5, #1
        bne     2b
        mov     lr, r8
        b       last
        .size   outer, . - outer

        .type   inner, %function
inner:  push    {lr}
        pop     {pc}
        .size   inner, . - inner

        .type   last, %function
last:   nop
        bx      lr
        .size   last, . - last

        .section .note.GNU-stack, "", %progbits

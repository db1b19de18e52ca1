// nios_v.S - what happens around main() on Nios V: the stack, the trap handler, variables set to 0,
// C++'s global objects constructed
//
// The stack grows down from the end of the SDRAM.  All traps go to the program's function on_irq(),
// if it has one; else an exception ends in a loop.
    .section .start, "ax"
    .global _start
_start:
    li sp, 0x04000000
    la t0, on_irq
    csrw mtvec, t0

    la t0, bss_begin               // C promises that variables without a value are 0
    la t1, bss_end
1:  bgeu t0, t1, 2f
    sw zero, 0(t0)
    addi t0, t0, 4
    j 1b

2:  la s0, __init_array_start      // C++ promises that global objects are constructed
    la s1, __init_array_end
3:  bgeu s0, s1, 4f
    lw t0, 0(s0)
    addi s0, s0, 4
    jalr t0
    j 3b

4:  li a0, 0                       // no arguments
    li a1, 0
    call main
    csrci mstatus, 8               // main() has returned: the program has ended
5:  j 5b

    .weak on_irq
    .balign 4
on_irq:
    j on_irq

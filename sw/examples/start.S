@ start.S - what happens around main(): vectors, stacks, the floating-point unit, variables set to
@ 0, C++'s global objects constructed
@
@ A stack grows down.  That of the interrupts begins at the end of the on-chip RAM, that of aborts
@ and undefined instructions in its middle, the program's at the end of the DDR3 memory.
@
@ A handler is the program's function on_irq or on_data_abort, or has the name that Intel's Monitor
@ Program gives it: __cs3_isr_irq and so on.
    .syntax unified
    .arch armv7-a
    .fpu neon
    .arm

    .section .vectors, "ax"
    .global _start
_start:
    b reset
    b __cs3_isr_undef
    b __cs3_isr_swi
    b __cs3_isr_pabort
    b __cs3_isr_dabort
    nop
    b __cs3_isr_irq
    b __cs3_isr_fiq

    .text
    .type reset, %function
reset:
    msr cpsr_c, #0xD2               @ IRQ mode, IRQ and FIQ masked
    ldr sp, =0xFFFFFFF8
    msr cpsr_c, #0xD7               @ abort mode
    ldr sp, =0xFFFF8000
    msr cpsr_c, #0xDB               @ undefined mode
    ldr sp, =0xFFFF8000
    msr cpsr_c, #0xD3               @ SVC mode, in which the program runs
    ldr sp, =0x3FFFFFF8

    mrc p15, 0, r0, c1, c0, 2       @ CPACR: coprocessors 10 and 11 are the floating-point unit
    orr r0, r0, #0xF << 20
    mcr p15, 0, r0, c1, c0, 2
    isb
    mov r0, #1 << 30                @ FPEXC.EN
    vmsr fpexc, r0

    ldr r0, =bss_begin              @ C promises that variables without a value are 0
    ldr r1, =bss_end
    mov r2, #0
1:  cmp r0, r1
    strlo r2, [r0], #4
    blo 1b

    ldr r4, =__init_array_start     @ C++ promises that global objects are constructed
    ldr r5, =__init_array_end
2:  cmp r4, r5
    bhs 3f
    ldr r0, [r4], #4
    blx r0
    b 2b

3:  mov r0, #0                      @ no arguments
    mov r1, #0
    bl main
    ldr r1, =exit                   @ prints what is still in a buffer, destroys global objects
    cmp r1, #0
    blxne r1
    cpsid if                        @ main() has returned: the program has ended
    b .
    .size reset, . - reset

    .weak __init_array_start, __init_array_end  @ the linker script's
    .weak exit                      @ the C library's, if the program is linked with it

    .section .rodata
    .balign 4
    .weak __dso_handle
__dso_handle:                       @ names the program to C++'s library: a global object's owner
    .word 0
    .text

    .weak _fini                     @ newlib's exit() calls it after the destructors
_fini:
    bx lr

@ Each is the program's own, if it has one.
    .macro handler name, otherwise
    .weak \name
    .type \name, %function
\name:
    b \otherwise
    .endm

    handler __cs3_isr_undef, .
    handler __cs3_isr_swi, .
    handler __cs3_isr_pabort, .
    handler __cs3_isr_dabort, on_data_abort
    handler __cs3_isr_irq, on_irq
    handler __cs3_isr_fiq, .
    handler on_data_abort, .
    handler on_irq, .

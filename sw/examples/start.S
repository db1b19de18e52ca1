@ start.S - what happens before main(): vectors, stacks, the floating-point unit, variables set to 0
@
@ A stack grows down.  That of the interrupts begins at the end of the on-chip RAM, the program's at
@ the end of the DDR3 memory.
    .syntax unified
    .arch armv7-a
    .fpu neon
    .arm

    .section .vectors, "ax"
    .global _start
_start:
    b reset
    b .                             @ undefined instruction
    b .                             @ SVC
    b .                             @ prefetch abort
    b on_data_abort
    nop
    b on_irq
    b .                             @ FIQ

    .text
    .type reset, %function
reset:
    msr cpsr_c, #0xD2               @ IRQ mode, IRQ and FIQ masked
    ldr sp, =0xFFFFFFF8
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

    bl main
    cpsid if                        @ main() has returned: the program has ended
    b .
    .size reset, . - reset

    .weak on_data_abort             @ the program's own, if it has one
    .type on_data_abort, %function
on_data_abort:
    b .

    .weak on_irq                    @ the program's own, if it has one
    .type on_irq, %function
on_irq:
    b .

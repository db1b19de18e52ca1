@ start.S - vectors, stacks, floating point, main, sleep: IRQ's stack in the on-chip RAM, the program's at DDR3's end
    .syntax unified
    .arch armv7-a
    .fpu neon
    .arm

    .section .vectors, "ax"
    .global _start
_start:
    b reset
    b .                             @ undefined
    b .                             @ SVC
    b .                             @ prefetch abort
    b on_data_abort
    nop
    b on_irq
    b .                             @ FIQ

    .text
    .type reset, %function
reset:
    msr cpsr_c, #0xD2               @ IRQ mode, IRQ and FIQ off
    ldr sp, =0xFFFFFFF8
    msr cpsr_c, #0xD3               @ SVC mode
    ldr sp, =0x3FFFFFF8
#ifdef __ARM_NEON
    mrc p15, 0, r0, c1, c0, 2       @ CPACR: coprocessors 10 and 11 are the floating-point unit
    orr r0, r0, #0xF << 20
    mcr p15, 0, r0, c1, c0, 2
    isb
    mov r0, #1 << 30                @ FPEXC.EN
    vmsr fpexc, r0
#endif
    bl main
1:  wfi
    b 1b
    .size reset, . - reset

    .weak on_data_abort             @ the program's own, if it has one
    .type on_data_abort, %function
on_data_abort:
    b .

    .weak on_irq                    @ the program's own, if it has one
    .type on_irq, %function
on_irq:
    b .

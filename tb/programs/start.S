@ start.S - vectors, stacks, main, sleep: IRQ's stack in the on-chip RAM, the program's at DDR3's end
    .syntax unified
    .arch armv7-a
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

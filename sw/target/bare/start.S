// start.S - from the ELF's entry to main(): vectors, stacks, caches, MMU, VFP and NEON.
//
// Entered in ARM state and a privileged mode, from U-Boot or from reset, caches on or off.  ARM
// Architecture Reference Manual ARMv7-A, B1 and B3; Cortex-A9 TRM, 4.3.
//
// Not handled: the second core, which stays where it is.

    .syntax unified
    .arm

    .section .vectors, "ax"
    .balign 32
vectors:                            // VBAR needs 32 bytes of alignment
    b       _start
    b       undefined
    b       supervisor_call
    b       prefetch_abort
    b       data_abort
    b       .                       // reserved
    b       interrupt
    b       fast_interrupt

// r0: which, r1: pc of the instruction, r2: CPSR it ran with.  None comes back.
    .macro  ending name, number, pc_offset
\name:
    mrs     r2, spsr
    sub     r1, lr, #\pc_offset
    mov     r0, #\number
    b       fault
    .endm

    ending  undefined, 0, 4
    ending  supervisor_call, 1, 4
    ending  prefetch_abort, 2, 4
    ending  data_abort, 3, 8
    ending  interrupt, 4, 4
    ending  fast_interrupt, 5, 4

    .section .start, "ax"
    .global _start
_start:
    cpsid   if

    // MMU, caches and branch prediction off; exceptions in ARM state, by VBAR.
    mrc     p15, 0, r4, c1, c0, 0
    ldr     r1, =0x40003805         // TE, V, I, Z, C, M
    bic     r1, r4, r1
    mcr     p15, 0, r1, c1, c0, 0
    isb
    ldr     r1, =vectors
    mcr     p15, 0, r1, c12, c0, 0  // VBAR

    // A data cache that was on is cleaned: its dirty lines go to memory.  One that was off holds
    // random lines, which are only invalidated.
    bl      empty_data_cache
    mov     r1, #0
    mcr     p15, 0, r1, c7, c5, 0   // ICIALLU
    mcr     p15, 0, r1, c7, c5, 6   // BPIALL
    mcr     p15, 0, r1, c8, c7, 0   // TLBIALL
    dsb
    isb

    // Stacks, by mode; this one last.
    msr     cpsr_c, #0xd2
    ldr     sp, =__stack_irq
    msr     cpsr_c, #0xd1
    ldr     sp, =__stack_fiq
    msr     cpsr_c, #0xd7
    ldr     sp, =__stack_abt
    msr     cpsr_c, #0xdb
    ldr     sp, =__stack_und
    msr     cpsr_c, #0xd3
    ldr     sp, =__stack_svc

    // VFP and NEON.
    mrc     p15, 0, r1, c1, c0, 2
    orr     r1, r1, #0xf00000       // CPACR: cp10 and cp11
    mcr     p15, 0, r1, c1, c0, 2
    isb
    mov     r1, #0x40000000         // FPEXC.EN
    vmsr    fpexc, r1

    ldr     r0, =__bss_start__
    ldr     r1, =__bss_end__
    mov     r2, #0
    mov     r3, #0
1:  cmp     r0, r1
    strdlo  r2, r3, [r0], #8
    blo     1b

    bl      memory_on
    bl      __libc_init_array
    bl      main
    b       exit

// Every line of the L1 data cache by set and way: 4 ways of 256 lines of 32 bytes.  r4: the SCTLR
// as it was found.
empty_data_cache:
    mov     r1, #0                  // way in 31:30
1:  mov     r2, #0                  // set in 12:5
2:  orr     r3, r1, r2
    tst     r4, #4                  // SCTLR.C
    mcrne   p15, 0, r3, c7, c14, 2  // DCCISW
    mcreq   p15, 0, r3, c7, c6, 2   // DCISW
    add     r2, r2, #32
    teq     r2, #0x2000
    bne     2b
    adds    r1, r1, #0x40000000
    bcc     1b
    dsb
    bx      lr

@ cpu_test.S - small programs for arm_cpu_test.cpp: each global from test_... on is an entry point
@
@ Each ends in WFI with interrupts off.  What handlers saw is in `record`: which vector, r14, SPSR,
@ fault status, fault address, CPSR; what programs found is in `result`.
    .syntax unified
    .arch armv7-a
    .fpu neon
    .arch_extension sec
    .arm

    .equ PROBE, 0xFF200000
    .equ NOBODY, 0x80000000
    .equ GIC_CPU, 0xFFFEC100
    .equ GIC, 0xFFFED000
    .equ PRIVATE_TIMER, 0xFFFEC600

    .section .vectors, "ax"
vectors:
    b .
    b on_undefined
    b on_svc
    b on_prefetch_abort
    b on_data_abort
    nop
    b on_irq
    b on_fiq

    .section .shared, "awx", %progbits   @ x: so that these names count as functions
    .global record, result
    .balign 8
record: .space 32
result: .space 64

    .text
    .macro save kind
    ldr r12, =record
    mov r10, #\kind
    str r10, [r12]
    str lr, [r12, #4]
    mrs r10, spsr
    str r10, [r12, #8]
    mrs r10, cpsr
    str r10, [r12, #20]
    .endm

on_undefined:
    save 1
    movs pc, lr
on_svc:
    save 2
    movs pc, lr
on_prefetch_abort:
    save 3
    mrc p15, 0, r10, c5, c0, 1
    str r10, [r12, #12]
    mrc p15, 0, r10, c6, c0, 2
    str r10, [r12, #16]
    movs pc, r11                    @ where the program wants to go on
on_data_abort:
    save 4
    mrc p15, 0, r10, c5, c0, 0
    str r10, [r12, #12]
    mrc p15, 0, r10, c6, c0, 0
    str r10, [r12, #16]
    subs pc, lr, #4                 @ behind the instruction of an ARM program
on_irq:
    ldr r10, =PROBE
    str r10, [r10]                  @ as early as can be, for its time
    save 6
    ldr r10, =GIC_CPU
    ldr r12, [r10, #0x0C]
    str r12, [r10, #0x10]
    ldr r10, =result
    str r12, [r10]                  @ the ID
    ldr r10, =PRIVATE_TIMER
    mov r12, #1
    str r12, [r10, #0x0C]
    subs pc, lr, #4
on_fiq:
    save 7
    ldr r10, =GIC_CPU
    ldr r12, [r10, #0x0C]
    str r12, [r10, #0x10]
    subs pc, lr, #4

    .macro program name
    .global \name
    .type \name, %function
    .balign 4
\name:
    .endm
    .macro done
    cpsid if
    wfi
    b . - 4
    .ltorg
    .endm

    program test_boot
    ldr r0, =result
    mrs r1, cpsr
    str r1, [r0]
    str sp, [r0, #4]
    vmov.f32 s0, #2.0
    vmul.f32 s0, s0, s0
    vmov.i32 q1, #3
    vadd.i32 q1, q1, q1
    vstr s0, [r0, #8]
    vst1.32 {d2}, [r0]!
    mrc p15, 4, r2, c15, c0, 0
    str r2, [r0, #12]
    done

    program test_undefined
    udf #1
    ldr r0, =result
    mov r1, #99
    str r1, [r0]
    done

    program test_svc
    svc #5
    ldr r0, =result
    mov r1, #99
    str r1, [r0]
    done

    program test_read_abort
    ldr r1, =NOBODY
    mov r2, #42
    mov r3, r1
    .global at_read_abort
at_read_abort:
    ldr r2, [r3, #4]!
    ldr r0, =result
    stm r0, {r2, r3}
    done

    program test_write_abort
    ldr r3, =NOBODY
    .global at_write_abort
at_write_abort:
    strb r3, [r3, #7]
    ldr r0, =result
    mov r1, #99
    str r1, [r0]
    done

    program test_ldm_abort
    ldr r3, =NOBODY
    mov r4, #4
    .global at_ldm_abort
at_ldm_abort:
    ldmia r3!, {r4, r5}
    ldr r0, =result
    stm r0, {r3, r4}
    done

    program test_prefetch_abort
    ldr r11, =1f
    ldr r1, =NOBODY
    bx r1
1:  ldr r0, =result
    mov r1, #99
    str r1, [r0]
    done

    program test_bkpt
    ldr r11, =1f
    .global at_bkpt
at_bkpt:
    bkpt #3
1:  done

    .macro enable_gic control
    ldr r0, =GIC_CPU
    mov r1, #0xF0
    str r1, [r0, #4]
    mov r1, #\control
    str r1, [r0]
    ldr r0, =GIC
    mov r1, #1
    str r1, [r0]
    mov r1, #(1 << 29)
    str r1, [r0, #0x100]
    .endm
    .macro stacks
    cps #0x12
    ldr sp, =0x10000
    cps #0x11
    ldr sp, =0x11000
    cps #0x13
    .endm

    program test_irq
    stacks
    enable_gic 1
    cpsie i
    ldr r0, =GIC
    ldr r1, =0x02000003             @ to itself, ID 3
    str r1, [r0, #0xF00]
    .global after_irq
after_irq:
    nop
    ldr r0, =result
    mov r1, #99
    str r1, [r0, #4]
    done

    program test_fiq
    stacks
    enable_gic 9
    cpsie f
    ldr r0, =GIC
    ldr r1, =0x02000003
    str r1, [r0, #0xF00]
    nop
    done

    program test_irq_when_let_in
    stacks
    enable_gic 1
    ldr r0, =GIC
    ldr r1, =0x02000003
    str r1, [r0, #0xF00]
    ldr r2, =result
    mov r4, #0
1:  add r4, r4, #1
    cmp r4, #1000
    bne 1b
    ldr r5, [r2]
    str r5, [r2, #8]                @ still 0: masked
    cpsie i
    mov r4, #0
2:  add r4, r4, #1
    ldr r5, [r2]
    cmp r5, #0
    beq 2b
    str r4, [r2, #4]
    done

    .macro start_timer ticks
    ldr r0, =PRIVATE_TIMER
    ldr r1, =\ticks
    str r1, [r0]
    mov r1, #5
    str r1, [r0, #8]
    .endm

    program test_wfi
    stacks
    enable_gic 1
    cpsie i
    start_timer 200000              @ 1 ms
    wfi
    ldr r0, =PROBE
    str r0, [r0, #4]
    done

    program test_busy_irq
    stacks
    enable_gic 1
    cpsie i
    start_timer 200000              @ 1 ms
1:  b 1b

    program test_wfi_masked
    stacks
    enable_gic 1
    start_timer 200000
    wfi
    ldr r0, =PROBE
    str r0, [r0, #4]
    b .

    program test_wfe
    sev
    wfe
    ldr r0, =result
    mov r1, #99
    str r1, [r0]
    done

    program test_time
    ldr r0, =PROBE
    ldr r1, =1000
    str r0, [r0]
1:  subs r1, r1, #1
    bne 1b
    str r0, [r0]
    done

    program test_poll
    ldr r0, =PROBE
1:  ldr r1, [r0, #8]
    cmp r1, #0
    beq 1b
    str r0, [r0]
    done

    program test_poll_counter
    ldr r0, =0xFFFEC200             @ global timer
    mov r1, #1
    str r1, [r0, #8]
1:  ldr r1, [r0]
    b 1b

    program test_no_vector
    ldr r0, =0x200000
    mcr p15, 0, r0, c12, c0, 0
    svc #0
    done

    program test_high_vectors
    ldr r0, =0xFFFF0000
    ldr r1, =vectors
    ldr r2, =0xE59FF018             @ ldr pc, [pc, #24]
    str r2, [r0, #8]
    ldr r2, =on_svc
    str r2, [r0, #40]
    mrc p15, 0, r1, c1, c0, 0
    orr r1, r1, #(1 << 13)
    mcr p15, 0, r1, c1, c0, 0
    svc #0
    done

    program test_abort_in_handler
    ldr r0, =1f
    ldr r1, =0x300000
    str r0, [r1, #56]
    ldr r0, =0xE59FF020             @ ldr pc, [pc, #32]
    str r0, [r1, #16]
    mcr p15, 0, r1, c12, c0, 0
    ldr r2, =NOBODY
    ldr r3, [r2]
1:  ldr r3, [r2]
    done

    program test_reset
    ldr r0, =result
    ldr r1, [r0]
    add r1, r1, #1
    str r1, [r0]
    cmp r1, #2
    beq 1f
    ldr r2, =0xFFD05004
    mov r3, #2
    str r3, [r2]
    b .
1:  done

    program test_hang
    b .

    .thumb
    .global test_thumb_abort
    .type test_thumb_abort, %function
    .thumb_func
test_thumb_abort:
    ldr r11, =1f
    ldr r3, =NOBODY
    nop
    .global at_thumb_abort
    .thumb_func
at_thumb_abort:
    ldr r2, [r3]
1:  nop
    ldr r0, =result
    mrs r1, cpsr
    str r1, [r0]
    cpsid if
    wfi
    b .
    .ltorg

    .arm
    @ Sections of 1 MB, each where it is: RAM cached, from 0xC0000000 on device memory, and
    @ 0x40000000 to 0xBFFFFFFF not there.
    program test_mmu
    ldr r0, =0x4000
    ldr r1, =0x00000C0E             @ section, full access, write-back
    mov r2, #0
1:  cmp r2, #0x40000000
    ldreq r1, =0x00000C06           @ shared device
    orr r3, r2, r1
    cmp r2, #0x40000000
    blo 2f
    cmp r2, #0xC0000000
    movlo r3, #0
2:  str r3, [r0], #4
    adds r2, r2, #0x100000
    bne 1b
    ldr r0, =0x4000
    mcr p15, 0, r0, c2, c0, 0       @ TTBR0
    mov r0, #1
    mcr p15, 0, r0, c3, c0, 0       @ DACR: client of domain 0
    mov r0, #0
    mcr p15, 0, r0, c8, c7, 0       @ TLB
    mcr p15, 0, r0, c7, c5, 0       @ instruction cache
    mcr p15, 0, r0, c7, c10, 4
    mrc p15, 0, r0, c1, c0, 0
    ldr r1, =0x1805                 @ I, Z, C, M
    orr r0, r0, r1
    mcr p15, 0, r0, c1, c0, 0
    isb
    ldr r0, =PROBE
    ldr r1, =0x1234
    str r1, [r0]
    ldr r2, [r0]
    ldr r3, =result
    str r2, [r3]
    ldr r1, =NOBODY
    .global at_mmu_abort
at_mmu_abort:
    ldr r2, [r1, #12]!
    stmib r3, {r1, r2}
    ldr r11, =3f
    bx r1
3:  done

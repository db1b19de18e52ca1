@ refused.S - instructions that the Cortex-A9 refuses, for arm_refused_test.cpp
#include "program.inc"
    .text

    .macro leave_99
    ldr r0, =result
    mov r1, #99
    str r1, [r0]
    done
    .endm

    program test_unaligned_load
    ldr r1, =record
    .global at_unaligned_load
at_unaligned_load:
    ldr r2, [r1, #17]
    leave_99

    program test_unaligned_store_with_sctlr_a
    mrc p15, 0, r1, c1, c0, 0
    orr r1, r1, #2
    mcr p15, 0, r1, c1, c0, 0
    ldr r1, =record
    strh r1, [r1, #1]
    leave_99

    program test_unaligned_multiple
    ldr r1, =record + 2
    ldmia r1!, {r2, r3}
    leave_99

    program test_unaligned_at_the_bus
    ldr r1, =PROBE
    ldr r2, [r1, #2]
    leave_99

    program test_floating_point_off
    vmov s0, r0
    leave_99

    program test_neon_off
    vadd.i32 q0, q1, q2
    leave_99

    program test_floating_point_half_on     @ FPEXC.EN is missing
    mrc p15, 0, r1, c1, c0, 2
    orr r1, r1, #0xF << 20
    mcr p15, 0, r1, c1, c0, 2
    isb
    vmov s0, r0
    leave_99

    program test_floating_point_on
    floating_point_on
    vmov s0, r0
    leave_99

    program test_division
    .inst 0xE711F211                    @ sdiv r1, r1, r2
    leave_99

    program test_fused_multiply
    floating_point_on
    .inst 0xEEA10A02                    @ vfma.f32 s0, s2, s4
    leave_99

    .thumb
    .global test_division_in_thumb
    .type test_division_in_thumb, %function
    .thumb_func
test_division_in_thumb:
    .inst.w 0xFBB1F1F2                  @ udiv r1, r1, r2
    nop
    .arm

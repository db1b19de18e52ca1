@ time.S - boot and time, for arm_cpu_test.cpp
#include "program.inc"
    .text

    program test_boot
    ldr r0, =result
    mrs r1, cpsr
    str r1, [r0]
    str sp, [r0, #4]
    floating_point_on
    vmov.f32 s0, #2.0
    vmul.f32 s0, s0, s0
    vmov.i32 q1, #3
    vadd.i32 q1, q1, q1
    vstr s0, [r0, #8]
    vst1.32 {d2}, [r0]!
    mrc p15, 4, r2, c15, c0, 0
    str r2, [r0, #12]
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

    program test_poll_timer
    ldr r0, =0xFFFEC600             @ private timer, 200 MHz
    ldr r1, =4000
    str r1, [r0]
    mov r1, #1
    str r1, [r0, #8]
1:  ldr r1, [r0, #12]
    cmp r1, #0
    beq 1b
    ldr r0, =PROBE
    str r0, [r0]
    done

    program test_poll_counter
    ldr r0, =0xFFFEC200             @ global timer
    mov r1, #1
    str r1, [r0, #8]
1:  ldr r1, [r0]
    b 1b

    program test_poll_and_hang
    ldr r0, =PROBE
    mov r2, #100
1:  ldr r1, [r0, #8]
    subs r2, r2, #1
    bne 1b
    b .

    program test_hang
    b .

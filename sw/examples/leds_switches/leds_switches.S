@ leds_switches.S - LEDs follow the switches; a KEY that is down inverts them.  Entry at 0.
    .syntax unified
    .arm

    .section .vectors, "ax"
    .global _start
_start:
    ldr  r0, =0xFF200000            @ LEDR; SW at +0x40, KEY at +0x50
again:
    ldr  r1, [r0, #0x40]
    ldr  r2, [r0, #0x50]
    cmp  r2, #0
    mvnne r1, r1
    str  r1, [r0]
    b    again
    .ltorg

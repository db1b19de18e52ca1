// nodes.h - the modules of a Platform Designer system that the processor reaches, for kmod.c; the
// table itself is written by `de1sim link`
#ifndef DE1SIM_KMOD_NODES_H
#define DE1SIM_KMOD_NODES_H

enum { KMOD_REGIONS = 8, KMOD_INTERRUPTS = 8 };  // at most, of a module

struct device_node {
    const char* name;               // NULL: after the last
    const char* const* compatible;  // up to a NULL
    unsigned regions;
    uint32_t first[KMOD_REGIONS], bytes[KMOD_REGIONS];  // of the processor's addresses
    unsigned interrupt_count;
    unsigned interrupts[KMOD_INTERRUPTS];  // at the processor's interrupt controller
};
extern struct device_node kmod_nodes[];

#endif

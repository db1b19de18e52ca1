// metronome.h - what the module metronome_driver.c does for programs, by ioctl of /dev/metronome;
// read() waits for a beat, and gives how many there have been
#ifndef METRONOME_H
#define METRONOME_H

#include <linux/ioctl.h>

#define METRONOME_SET_PERIOD _IOW('m', 1, unsigned)  // in clocks of 50 MHz

#endif

// beat.c - sets the metronome to 20 ms by its kernel module, and waits for five beats
#include <fcntl.h>
#include <stdio.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "metronome.h"

int main(void) {
    const int metronome = open("/dev/metronome", O_RDWR);
    unsigned period = 1000000, beats = 0;
    if (metronome < 0 || ioctl(metronome, METRONOME_SET_PERIOD, &period) != 0) {
        perror("/dev/metronome");
        return 1;
    }
    while (beats < 5)
        if (read(metronome, &beats, sizeof beats) != sizeof beats) {
            perror("read");
            return 1;
        }
    printf("%u beats\n", beats);
    period = 0;
    ioctl(metronome, METRONOME_SET_PERIOD, &period);
    return 0;
}

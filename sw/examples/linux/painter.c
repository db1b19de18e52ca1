// painter.c - a Linux program with threads: three compute the lines of a picture, one paints them
//
// The lines go through a queue of eight, under a mutex.  The picture is on /dev/fb0, 320 x 240
// pixels of 16 bits; the LEDs of the FPGA, by /dev/mem, show how many lines are painted.
#include <fcntl.h>
#include <linux/fb.h>
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

enum { WIDTH = 320, HEIGHT = 240, WORKERS = 3, ROOM = 8 };
#define FPGA 0xFF200000  // an address of the bus

struct line {
    int y;
    uint16_t pixels[WIDTH];
};

static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static pthread_cond_t not_full = PTHREAD_COND_INITIALIZER, not_empty = PTHREAD_COND_INITIALIZER;
static struct line queue[ROOM];
static unsigned put, taken;  // lines, since the beginning
static int next_line;

static unsigned squared(int x, int y) { return (unsigned)(x * x + y * y); }

static void compute(struct line* line) {
    for (int x = 0; x < WIDTH; ++x) {
        const unsigned a = squared(x - 100, line->y - 90) >> 6;
        const unsigned b = squared(x - 220, line->y - 150) >> 6;
        line->pixels[x] = (uint16_t)((a & 31) << 11 | ((a ^ b) & 63) << 5 | (b & 31));
    }
}

static void* work(void* count) {
    struct line line;
    for (;;) {
        pthread_mutex_lock(&lock);
        line.y = next_line++;
        pthread_mutex_unlock(&lock);
        if (line.y >= HEIGHT) return NULL;
        compute(&line);
        ++*(int*)count;

        pthread_mutex_lock(&lock);
        while (put - taken == ROOM) pthread_cond_wait(&not_full, &lock);
        queue[put++ % ROOM] = line;
        pthread_cond_signal(&not_empty);
        pthread_mutex_unlock(&lock);
    }
}

int main(void) {
    const int screen = open("/dev/fb0", O_RDWR), memory = open("/dev/mem", O_RDWR | O_SYNC);
    struct fb_fix_screeninfo about;
    if (screen < 0 || memory < 0 || ioctl(screen, FBIOGET_FSCREENINFO, &about) != 0) {
        perror("painter");
        return 1;
    }
    uint8_t* const pixels =
        mmap(NULL, about.smem_len, PROT_READ | PROT_WRITE, MAP_SHARED, screen, 0);
    volatile uint32_t* const leds =
        mmap(NULL, 4096, PROT_READ | PROT_WRITE, MAP_SHARED, memory, FPGA);
    if (pixels == MAP_FAILED || leds == MAP_FAILED) {
        perror("painter: mmap");
        return 1;
    }

    pthread_t workers[WORKERS];
    int counts[WORKERS] = {0};
    for (int i = 0; i < WORKERS; ++i) pthread_create(&workers[i], NULL, work, &counts[i]);
    while (taken < HEIGHT) {
        pthread_mutex_lock(&lock);
        while (put == taken) pthread_cond_wait(&not_empty, &lock);
        const struct line line = queue[taken++ % ROOM];
        pthread_cond_signal(&not_full);
        pthread_mutex_unlock(&lock);
        memcpy(pixels + line.y * about.line_length, line.pixels, sizeof line.pixels);
        *leds = taken;
    }
    int all = 0;
    for (int i = 0; i < WORKERS; ++i) {
        pthread_join(workers[i], NULL);
        all += counts[i];
    }
    printf("%d lines by %d threads\n", all, WORKERS);
    return 0;
}

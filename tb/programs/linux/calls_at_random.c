// calls_at_random.c N SEED - N system calls with numbers and arguments at random, which it has to
// survive; the same seed makes the same calls
//
// Pointers go into an arena, whose contents are at random too and whose pages calls unmap, protect
// and move, to its own code, to nothing, or beyond the end; never to where it keeps its own data.
// Calls that would end or stop it are left out: exit, signals to itself, returns from a signal,
// waiting for one.  Some of them are made by other threads, or by another process, which alone may
// execute this program anew; that copy ends at once, since it has no N and SEED.  What sleeps gets
// a time of less than a millisecond, what would wait is made not to, and standard input becomes a
// file.  Timers' signals are ignored.  Without a C library, because calls also change the heap and
// the TLS.
#include <stdint.h>

#define ARENA 0x20000000u
#define ARENA_BYTES 0x10000u
#define AREAS_END 0xB0000000u  // below the stack

enum {
    NR_EXIT = 1, NR_FORK = 2, NR_PIPE = 42, NR_WAIT4 = 114, NR_VFORK = 190, NR_SEMOP = 298,
    NR_PIPE2 = 359, NR_SOCKET = 281, NR_ACCEPT = 285, NR_SOCKETPAIR = 288, NR_ACCEPT4 = 366,
    NR_FCNTL = 55, NR_FCNTL64 = 221, NR_EVENTFD = 351, NR_EVENTFD2 = 356, NOT_BLOCKING = 04000,
    NR_SIGACTION = 174, SIGPIPE = 13, NR_SEMTIMEDOP = 312, NR_SEMTIMEDOP_64 = 420,
    NR_READ = 3, NR_WRITE = 4, NR_OPEN = 5, NR_CLOSE = 6, NR_EXECVE = 11, NR_PAUSE = 29,
    NR_KILL = 37,
    NR_BRK = 45, NR_DUP2 = 63, NR_MUNMAP = 91, NR_CLONE = 120,
    NR_CLONE3 = 435, NR_SIGRETURN = 119, NR_MPROTECT = 125,
    NR_SELECT = 142, NR_NANOSLEEP = 162, NR_MREMAP = 163, NR_POLL = 168, NR_RT_SIGRETURN = 173,
    NR_SIGTIMEDWAIT = 177, NR_SIGQUEUEINFO = 178, NR_SIGSUSPEND = 179, NR_SIGTIMEDWAIT_64 = 421,
    NR_MMAP2 = 192, NR_FTRUNCATE64 = 194, NR_TKILL = 238, NR_FUTEX = 240, NR_EXIT_GROUP = 248,
    NR_CLOCK_NANOSLEEP = 265, NR_TGKILL = 268, NR_PSELECT6 = 335, NR_PPOLL = 336,
    NR_IOCTL = 54, NR_SETITIMER = 104, NR_EPOLL_CTL = 251, NR_EPOLL_CREATE1 = 357, NR_EPOLL_WAIT = 252, NR_EPOLL_PWAIT = 346,
    NR_EPOLL_PWAIT2 = 441, NR_TIMERFD_CREATE = 350, NR_TIMERFD_SETTIME = 353,
    NR_TIMERFD_SETTIME64 = 411, NR_TIMER_CREATE = 257, NR_TIMER_SETTIME = 258,
    NR_TIMER_GETTIME = 259, NR_TIMER_DELETE = 261, NR_TIMER_GETTIME64 = 408,
    NR_TIMER_SETTIME64 = 409, NR_SIGNALFD = 349, NR_SIGNALFD4 = 355, NR_MQ_OPEN = 274,
    NR_MQ_UNLINK = 275, NR_MQ_TIMEDSEND = 276, NR_MQ_TIMEDRECEIVE = 277, NR_MQ_NOTIFY = 278,
    NR_MQ_TIMEDSEND64 = 418, NR_MQ_TIMEDRECEIVE64 = 419, NR_MSGSND = 301, NR_MSGRCV = 302,
    NR_MSGGET = 303, NR_OPENAT = 322, SIGUSR1 = 10, SIGALRM = 14, SIGVTALRM = 26, SIGPROF = 27,
    NO_WAIT = 04000, REAP_URB = 0x4004550C,
    NR_CLOCK_NANOSLEEP64 = 407, NR_PSELECT6_64 = 413, NR_PPOLL_64 = 414, NR_FUTEX_64 = 422,
    MAP_FIXED_ANONYMOUS = 0x32, READ_WRITE = 3, CREATE = 0102
};

// Those that are emulated, and some that are not.
static const uint16_t CALLS[] = {
    45, 192, 91, 125, 163, 220, 5, 322, 8, 6, 3, 4, 145, 146, 180, 181, 19, 140, 194, 118, 148, 41,
    63, 358, 55, 221, 54, 197, 195, 196, 327, 397, 33, 334, 439, 10, 328, 40, 39, 323, 38, 329, 85,
    332, 183, 12, 60, 263, 403, 264, 406, 78, 43, 162, 265, 407, 240, 422, 158, 142, 335, 413, 168,
    336, 414, 256, 338, 398, 122, 384, 369, 191, 77, 116, 242, 20, 224, 65, 64, 199, 174, 175, 186,
    11, 281, 290, 1000, 359, 359, 356, 385, 307, 305, 306, 308, 299, 300, 312, 420, 114, 280, 34,
    281, 281, 288, 282, 283, 283, 284, 366, 286, 287, 289, 290, 291, 292, 293, 294, 295, 296, 297,
    104, 105, 250, 357, 251, 251, 251, 252, 346, 441, 350, 353, 354, 410, 411, 257, 257, 258, 259,
    260, 261, 408, 409, 355, 274, 274, 275, 276, 277, 278, 279, 418, 419, 303, 301, 302, 304, 128,
    129, 379, 14, 324, 54, 54, 54, 5, 5,
    96, 97, 154, 155, 156, 157, 159, 160, 161, 172, 176, 224, 241, 339, 345};

static const char ITSELF[] = "/proc/self/exe";

static const char* const NAMES[] = {
    "/dev/null", "/dev/zero", "/dev/urandom", "/dev/shm/a", "/dev/fb0", "/proc/self/maps",
    "a", "b", "/d", "d/e", "d/../a", "../outside", "/../../outside", "d/../../outside/x", ".", "/",
    "", "..", "/dev/mem", ITSELF, "/etc/passwd", "d/e/f/g", "//a//", "a/",
    "\xFF\n\x1B[2J", "/dev/input/event0", "/dev/input/event1", "/dev/input/mice",
    "/dev/input/js0", "/dev/bus/usb/001/002", "/dev/bus/usb/001/003", "/dev/i2c-0", "/dev/mqueue/a",
    "/proc/self/mem", "/proc/interrupts", "/sys/class/input"};

// Of the event devices, USB devices, the joystick, the terminal, the frame buffer and I2C.
static const uint32_t REQUESTS[] = {
    0x80044501, 0x80084502, 0x80104502, 0x80604506, 0x80604520, 0x80604521, 0x80604522, 0x80604518,
    0x80604519, 0x80184540, 0x40044590, 0x400445A0, 0x40084503, 0xC0105500, 0xC0105502,
    0x8038550A, 0x0000550B, 0x4004550D, 0x8004550F, 0x80045510, 0x80045505, 0x80085504, 0x41045508,
    0x8004551A, 0x40105511, 0xC00C5512, 0x00005514, 0x80046A01, 0x80016A11, 0x80406A13, 0x5401,
    0x5402, 0x541B, 0x5413, 0x540B, 0x4600, 0x4601, 0x4602, 0x4606, 0x0703, 0x0705, 0x0706, 0x0707,
    0x0720};

// struct sockaddr: two ports of this machine, and one of another.
static const uint32_t HOSTS[3][4] = {
    {0x901F0002, 0x0100007F}, {0x911F0002, 0x0100007F}, {0x901F0002, 0x0101A8C0}};

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static uint32_t state;
static uint64_t span[2];  // a short time, as all calls take it
static uint8_t in_child;
static uint32_t timer, messages;  // the last that were made

static uint32_t any(void) {  // xorshift
    state ^= state << 13;
    state ^= state >> 17;
    return state ^= state << 5;
}

static int32_t call(uint32_t number, const uint32_t* a) {
    register uint32_t r0 __asm__("r0") = a[0];
    register uint32_t r1 __asm__("r1") = a[1];
    register uint32_t r2 __asm__("r2") = a[2];
    register uint32_t r3 __asm__("r3") = a[3];
    register uint32_t r4 __asm__("r4") = a[4];
    register uint32_t r5 __asm__("r5") = a[5];
    register uint32_t r6 __asm__("r6") = a[6];
    register uint32_t r7 __asm__("r7") = number;
    __asm__ volatile("svc #0"
                     : "+r"(r0)
                     : "r"(r1), "r"(r2), "r"(r3), "r"(r4), "r"(r5), "r"(r6), "r"(r7)
                     : "memory");
    return (int32_t)r0;
}

static int32_t call3(uint32_t number, uint32_t a, uint32_t b, uint32_t c) {
    const uint32_t all[7] = {a, b, c};
    return call(number, all);
}

static uint32_t any_address(void) {
    const uint32_t r = any() >> 8;
    switch (any() % 16) {
        case 0: return 0;
        case 1: return r % 4096;
        case 2: return 0xFFFFFFFF - r % 64;
        case 3: return 0xBF000000 - 8 + r % 16;                     // the end of all memory
        case 4: return 0xC0000000 + (r << 4);                       // the kernel's
        case 5: return (uint32_t)(uintptr_t)NAMES[r % COUNT(NAMES)];  // constants: read only
        case 6: return ARENA + ARENA_BYTES - r % 16;
        case 7: return 0x30000000 + (r << 4);  // perhaps what a call has mapped
        default: return ARENA + r % ARENA_BYTES;
    }
}

// Of pages that may come and go.
static uint32_t any_area(void) {
    switch (any() % 8) {
        case 0: return any_address() | 0x80000000;  // not where the program is
        case 1: return 0xB0000000 - (any() % 64 + 1) * 4096;
        default: return ARENA + any() % 16 * 4096;
    }
}

static uint32_t any_value(void) {
    static const uint32_t ODD[] = {0, 1, 2, 3, 4, 8, 16, 64, 255, 4095, 4096, 4097, 0x7FFFFFFF,
                                   0x80000000, 0xFFFFF000, 0xFFFFFFFF, 0xFFFFFF9C, 0x7FFFF000};
    switch (any() % 8) {
        case 0: return any();
        case 1: return any() & 0xFFFF;
        case 2:
        case 3: return any() % 8;
        default: return ODD[any() % COUNT(ODD)];
    }
}

// Opened before each round: devices, and what calls of their own make.
enum { FILES = 24, EPOLL = FILES + 6, TIMER, SIGNALS, QUEUE, FILES_END };

static uint32_t any_file(void) {
    return any() % 2 ? 3 + any() % 16 : FILES + any() % (FILES_END - FILES);
}

static uint32_t any_length(void) {
    const uint32_t value = any_value();
    return value < ARENA_BYTES || value > 0x7FFF0000 ? value : value % ARENA_BYTES;
}

static uint32_t any_path(void) {
    return any() % 8 ? (uint32_t)(uintptr_t)NAMES[any() % COUNT(NAMES)] : any_address();
}

// Of a timer: a signal that is ignored, of a thread perhaps, or a wrong one.
static uint32_t any_notice(void) {
    static const int32_t KINDS[] = {0, 1, 4, 2, 3, -1};
    static uint32_t notice[16];
    static const int32_t SIGNALS[] = {SIGUSR1, SIGALRM, 0, 65, -1};
    notice[0] = any();
    notice[1] = (uint32_t)SIGNALS[any() % COUNT(SIGNALS)];
    notice[2] = (uint32_t)KINDS[any() % COUNT(KINDS)];
    notice[3] = any_value();
    return any() % 8 ? (uint32_t)(uintptr_t)notice : any() % 2 ? 3 : 0xC0000000;
}

// Seconds, none or a wrong number, and ns or us, in 32 or 64 bits each.
static uint32_t short_time(int wide, uint32_t below) {
    const uint32_t rest = any() % 16 ? any() % below : 0x80000000;
    span[0] = wide ? (uint64_t)(any() % 16 == 0) << 63 : (uint64_t)rest << 32;
    span[1] = rest;
    if (any() % 2) return (uint32_t)(uintptr_t)span;
    return any() % 2 ? 3 : 0xC0000000;  // not readable
}

static void put_at(uint32_t place, int32_t fd) {
    if (fd < 0 || fd == (int32_t)place) return;
    call3(NR_DUP2, (uint32_t)fd, place, 0);
    call3(NR_CLOSE, (uint32_t)fd, 0, 0);
}

static void open_files(void) {
    static const char* const DEVICES[] = {
        "/dev/input/event0", "/dev/input/event1", "/dev/input/mice", "/dev/bus/usb/001/002",
        "/dev/bus/usb/001/003", "/dev/null"};
    static const uint32_t MASK[2] = {1u << (SIGUSR1 - 1), 0};
    for (uint32_t i = 0; i < COUNT(DEVICES); ++i)
        put_at(FILES + i, call3(NR_OPEN, (uint32_t)(uintptr_t)DEVICES[i], NOT_BLOCKING | 2, 0));
    const uint32_t signals[7] = {~0u, (uint32_t)(uintptr_t)MASK, 8, NOT_BLOCKING};
    const uint32_t queue[7] = {(uint32_t)(uintptr_t)"a", CREATE | NOT_BLOCKING, 0600, 0};
    put_at(EPOLL, call3(NR_EPOLL_CREATE1, 0, 0, 0));
    put_at(TIMER, call3(NR_TIMERFD_CREATE, 1, NOT_BLOCKING, 0));
    put_at(SIGNALS, call(NR_SIGNALFD4, signals));
    put_at(QUEUE, call(NR_MQ_OPEN, queue));
}

// struct itimerspec, wide or not, or itimerval: an interval and a time, of less than 20 ms.
static uint32_t any_interval(int wide) {
    static uint64_t interval[4];
    uint32_t* const narrow = (uint32_t*)interval;
    for (unsigned i = 0; i < 4; ++i) {
        const uint32_t part = i % 2 == 0 ? 0 : any() % 4 ? any() % 20000000 : any_value();
        if (wide)
            interval[i] = part;
        else
            narrow[i] = part;
    }
    return any() % 8 ? (uint32_t)(uintptr_t)interval : any_address();
}

static uint32_t any_place(void) {
    return any() % 4 ? ARENA + any() % (ARENA_BYTES - 256) : any_address();
}

// The arena as it was at first, filled anew, and nothing else mapped.
static void begin_round(void) {
    const uint32_t arena[7] = {ARENA, ARENA_BYTES, READ_WRITE, MAP_FIXED_ANONYMOUS, ~0u, 0, 0};
    call3(NR_MUNMAP, 0x10000000, AREAS_END - 0x10000000, 0);
    if ((uint32_t)call(NR_MMAP2, arena) != ARENA) call3(NR_EXIT, 3, 0, 0);
    open_files();
    for (uint32_t i = 0; i < ARENA_BYTES / 4; i += 1 + any() % 64)
        *(volatile uint32_t*)(ARENA + 4 * i) = any() % 3 ? any_address() : any_value();
}

static void close_files(void) {
    for (uint32_t fd = 3; fd < 1024; ++fd) call3(NR_CLOSE, fd, 0, 0);
    call3(NR_DUP2, (uint32_t)call3(NR_OPEN, (uint32_t)(uintptr_t)"in", CREATE, 0600), 0, 0);
}

static int ends_or_stops(uint32_t number) {
    return number == NR_EXIT || number == NR_EXIT_GROUP || number == NR_PAUSE ||
           number == NR_KILL || number == NR_TKILL || number == NR_TGKILL ||
           number == NR_FORK || number == NR_VFORK || number == NR_PIPE || number == NR_SEMOP ||
           number == NR_EVENTFD || number == NR_ACCEPT || number == NR_CLONE ||
           number == NR_CLONE3 || number == NR_SIGRETURN || number == NR_RT_SIGRETURN ||
           number == NR_SIGTIMEDWAIT || number == NR_SIGNALFD ||
           number == NR_SIGQUEUEINFO || number == NR_SIGSUSPEND || number == NR_SIGTIMEDWAIT_64;
}

static void one_call(void) {
    const uint32_t number = any() % 64 ? CALLS[any() % COUNT(CALLS)] : any() % 512;
    uint32_t a[7];
    if (ends_or_stops(number)) return;
    for (unsigned i = 0; i < 7; ++i) a[i] = any() % 2 ? any_value() : any_address();
    switch (number) {
        case NR_BRK: a[0] = any() % 2 ? any() % 0x8000000 : 0x80000000 | any(); break;
        case NR_MUNMAP:
        case NR_MPROTECT:
        case NR_MREMAP:
            a[0] = any_area();
            a[1] = any_length();
            if (a[1] < 0x80000000 && any() % 2) a[1] = any() % 17 * 4096;
            a[2] = number == NR_MREMAP ? any_length() : any() % 8;
            break;
        case NR_MMAP2:
            a[0] = any_area();
            a[1] = any_length();
            a[3] = any() % 4 | (any() % 2 ? 0x20 : 0) | (any() % 2 ? 0x10 : 0);
            a[4] = any() % 16;
            a[5] = any() % 2 ? any() % 16 : any();
            break;
        case NR_READ:
        case NR_WRITE:
            a[0] = any() % 2 ? any_file() : any() % 16;
            a[1] = any_address();
            a[2] = a[0] == 1 || a[0] == 2 ? any() % 80 : any_length();
            break;
        case 180:  // pread64, pwrite64
        case 181:
            a[0] = any_file();
            a[1] = any_address();
            a[2] = any_length();
            a[4] = any() % 8 ? any() % 0x80000 : any_value();
            a[5] = any() % 8 ? 0 : any_value() | 0x80000000;
            break;
        case 19:  // lseek, _llseek
            a[1] = any() % 0x80000;
            break;
        case 140: a[1] = any() % 8 ? 0 : 0x80000000, a[2] = any() % 0x80000; break;
        case NR_FTRUNCATE64: a[2] = any() % 0x80000, a[3] = any() % 8 ? 0 : 0x80000000; break;
        case 145:  // readv, writev
        case 146: a[0] = any_file(), a[1] = any_address(), a[2] = any() % 4; break;
        case NR_SIGACTION:
            if (a[0] == SIGPIPE || a[0] == SIGUSR1 || a[0] == SIGALRM || a[0] == SIGVTALRM ||
                a[0] == SIGPROF)
                return;
            break;
        case NR_SOCKET:
        case NR_SOCKETPAIR:
            a[0] = any() % 8 ? any() % 2 + 1 : any_value();
            a[1] = (any() % 5 + 1) | NOT_BLOCKING;
            a[2] = 0;
            break;
        case NR_ACCEPT4: a[0] = any_file(), a[3] = NOT_BLOCKING; break;
        case NR_SOCKET + 1: case NR_SOCKET + 2: case NR_SOCKET + 3: case NR_SOCKET + 9:
            a[0] = any_file();
            a[number == NR_SOCKET + 9 ? 4 : 1] = (uint32_t)(uintptr_t)HOSTS[any() % 3];
            a[number == NR_SOCKET + 9 ? 5 : 2] = any() % 8 ? 16 : any_value();
            break;
        case NR_PIPE2:
        case NR_EVENTFD2: a[1] = NOT_BLOCKING; break;
        case NR_FCNTL:
        case NR_FCNTL64:
            if (a[1] == 4) a[2] |= NOT_BLOCKING;
            break;
        case NR_IOCTL:
            a[0] = any_file();
            a[1] = any() % 16 ? REQUESTS[any() % COUNT(REQUESTS)] : any();
            if (a[1] == REAP_URB) return;
            a[2] = any() % 2 ? any_place() : any() % 4;
            break;
        case NR_EPOLL_CTL:
            a[0] = any() % 8 ? EPOLL : any_file(), a[1] = any() % 4, a[2] = any_file();
            a[3] = any_place();
            break;
        case NR_EPOLL_WAIT:
        case NR_EPOLL_PWAIT:
            a[0] = any() % 8 ? EPOLL : any_file(), a[3] = any() % 64 == 0;
            a[1] = any_place(), a[2] = any() % 4 ? any() % 16 : any_value();
            if (number == NR_EPOLL_PWAIT) a[4] = any_address();
            break;
        case NR_EPOLL_PWAIT2: a[0] = any_file(), a[3] = short_time(1, 10000); break;
        case NR_TIMERFD_CREATE: a[0] = any() % 8, a[1] = NOT_BLOCKING; break;
        case NR_TIMERFD_SETTIME:
        case NR_TIMERFD_SETTIME64:
            a[0] = any() % 4 ? TIMER : any_file();
            a[1] = any() % 2;
            a[2] = any_interval(number == NR_TIMERFD_SETTIME64);
            break;
        case NR_SETITIMER: a[0] = any() % 4, a[1] = any_interval(0); break;
        case NR_TIMER_CREATE:
            a[0] = any() % 12, a[1] = any_notice();
            if (any() % 8) a[2] = (uint32_t)(uintptr_t)&timer;
            break;
        case NR_TIMER_SETTIME: case NR_TIMER_GETTIME: case NR_TIMER_GETTIME + 1:
        case NR_TIMER_DELETE: case NR_TIMER_GETTIME64: case NR_TIMER_SETTIME64:
            a[0] = timer - any() % 4;
            if (number == NR_TIMER_SETTIME || number == NR_TIMER_SETTIME64)
                a[1] = any() % 2, a[2] = any_interval(number != NR_TIMER_SETTIME);
            break;
        case NR_SIGNALFD4: a[0] = any() % 2 ? ~0u : a[0], a[2] = 8, a[3] = NOT_BLOCKING; break;
        case NR_MQ_OPEN: a[0] = any_path(), a[1] |= NOT_BLOCKING; break;
        case NR_MQ_UNLINK: a[0] = any_path(); break;
        case NR_MQ_TIMEDSEND:
        case NR_MQ_TIMEDRECEIVE:
            a[0] = any() % 4 ? QUEUE : any_file();
            a[1] = any_place(), a[2] = any() % 4 ? 8192 : any_length();
            a[4] = short_time(0, 10000);
            break;
        case NR_MQ_TIMEDSEND64:
        case NR_MQ_TIMEDRECEIVE64:
            a[0] = any() % 4 ? QUEUE : any_file();
            a[1] = any_place(), a[2] = any() % 4 ? any() % 8200 : any_length();
            a[4] = short_time(1, 10000);
            break;
        case NR_MQ_NOTIFY: a[0] = any_file(), a[1] = any_notice(); break;
        case NR_MSGGET: a[0] = any() % 4, a[1] |= 01000; break;
        case NR_MSGSND:
            a[0] = messages - any() % 4, a[1] = any_place(), a[2] = any_length(), a[3] = NO_WAIT;
            break;
        case NR_MSGRCV:
            a[0] = messages - any() % 4, a[1] = any_place(), a[2] = any_length(), a[4] |= NO_WAIT;
            break;
        case NR_SEMTIMEDOP: a[3] = short_time(0, 10000); break;
        case NR_SEMTIMEDOP_64: a[3] = short_time(1, 10000); break;
        case NR_NANOSLEEP: a[0] = short_time(0, 10000); break;
        case NR_CLOCK_NANOSLEEP: a[1] = any() % 3, a[2] = short_time(0, 10000); break;
        case NR_CLOCK_NANOSLEEP64: a[1] = any() % 3, a[2] = short_time(1, 10000); break;
        case NR_SELECT: a[4] = short_time(0, 10); break;
        case NR_PSELECT6: a[4] = short_time(0, 10000); break;
        case NR_PSELECT6_64: a[4] = short_time(1, 10000); break;
        case NR_PPOLL: a[2] = short_time(0, 10000); break;
        case NR_PPOLL_64: a[2] = short_time(1, 10000); break;
        case NR_POLL: a[2] = any() % 64 == 0; break;
        case NR_FUTEX:
        case NR_FUTEX_64:
            a[1] = any() & ~0x70u;
            if ((a[1] & 0x7F) == 0 || (a[1] & 0x7F) == 9)
                a[3] = short_time(number != NR_FUTEX, 10000);
            break;
        case 5: case 8: case 10: case 12: case 33: case 38: case 39: case 40: case 85: case 195:
        case 196:
            a[0] = any_path();
            if (number == 38) a[1] = any_path();
            if (number == NR_OPEN) a[1] |= NOT_BLOCKING;
            break;
        case NR_EXECVE:
            a[0] = any_path();
            if (!in_child && a[0] == (uint32_t)(uintptr_t)ITSELF) return;
            break;
        case 322: case 323: case 327: case 328: case 329: case 332: case 334: case 397: case 439:
            a[0] = any() % 4 ? 0xFFFFFF9C : any_value();
            a[1] = any_path();
            if (number == NR_OPENAT) a[2] |= NOT_BLOCKING;
            if (number == 329) a[2] = a[0], a[3] = any_path();
            break;
        default: break;
    }
    const int32_t result = call(number, a);
    if (number == NR_MSGGET && result >= 0) messages = (uint32_t)result;
}

// ---- Other threads ----

#define THREADS 4
static uint8_t stacks[THREADS][8192] __attribute__((aligned(8)));
static volatile uint8_t busy[THREADS];

__attribute__((used)) static void help(uint32_t own) {
    for (uint32_t i = any() % 64; i > 0; --i) one_call();
    busy[own] = 0;
    call3(NR_EXIT, 0, 0, 0);
}

// clone(), of the child of which help(own) is all.
__attribute__((naked)) static int32_t begin_help(uint32_t flags __attribute__((unused)),
                                                 void* stack __attribute__((unused)),
                                                 uint32_t own __attribute__((unused))) {
    __asm__(
        "push {r4, r5, r7, lr}\n"
        "mov r5, r2\n"
        "movs r2, #0\n"
        "movs r3, #0\n"
        "movs r4, #0\n"
        "movs r7, #120\n"
        "svc #0\n"
        "cmp r0, #0\n"
        "beq 1f\n"
        "pop {r4, r5, r7, pc}\n"
        "1: mov r0, r5\n"
        "b help\n");
}

static void get_help(void) {
    const uint32_t own = any() % THREADS;
    if (busy[own]) return;
    busy[own] = 1;
    if (begin_help(0x10F00, stacks[own] + sizeof stacks[own], own) < 0) busy[own] = 0;
}

static void end_help(void) {
    static const uint32_t SPAN[2] = {0, 100000};
    for (unsigned i = 0; i < THREADS; ++i)
        while (busy[i]) call3(NR_NANOSLEEP, (uint32_t)(uintptr_t)SPAN, 0, 0);
}

// Another process, with its own memory.
static void get_child(void) {
    const int32_t child = call3(NR_FORK, 0, 0, 0);
    if (child == 0) {
        in_child = 1;
        for (uint32_t i = any() % 32; i > 0; --i) one_call();
        call3(NR_EXIT_GROUP, 0, 0, 0);
    }
    if (child > 0) call3(NR_WAIT4, (uint32_t)child, 0, 0);
}

// For libgcc's division by zero.
int raise(int number) { return number; }

static uint32_t number_of(const char* text) {
    uint32_t value = 0;
    while (*text >= '0' && *text <= '9') value = value * 10 + (uint32_t)(*text++ - '0');
    return value;
}

// `at`: the stack at the start, which has the arguments.
__attribute__((used)) static void begin(const uint32_t* at) {
    if (at[0] != 3) call3(NR_EXIT_GROUP, 4, 0, 0);
    const uint32_t calls = number_of((const char*)(uintptr_t)at[2]);
    state = number_of((const char*)(uintptr_t)at[3]) * 2654435769u | 1;
    static const uint32_t IGNORED[5] = {1};
    uint32_t ignores[7] = {0, (uint32_t)(uintptr_t)IGNORED, 0, 8};
    static const uint8_t NONE[] = {SIGPIPE, SIGUSR1, SIGALRM, SIGVTALRM, SIGPROF};
    for (unsigned i = 0; i < COUNT(NONE); ++i) {
        ignores[0] = NONE[i];
        call(NR_SIGACTION, ignores);
    }
    for (uint32_t i = 0; i < calls; ++i) {
        if (i % 16384 == 0) close_files();
        if (i % 256 == 0) end_help(), begin_round();
        if (i % 512 == 300) get_help(), get_help();
        if (i % 4096 == 1000) get_child();
        one_call();
    }
    call3(NR_EXIT_GROUP, 0, 0, 0);
}

__attribute__((naked, used)) void _start(void) { __asm__("mov r0, sp\n b begin"); }

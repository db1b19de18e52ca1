// network.c WHAT HOST PORT - sockets that reach a host outside, by --network
#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/epoll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static struct sockaddr_in peer;

static long ms(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

static const char* connects(int own) {
    return connect(own, (struct sockaddr*)&peer, sizeof peer) ? strerror(errno) : "connected";
}

// What the server says when it has all; then it ends.
static void tcp(void) {
    char text[64];
    const int own = socket(AF_INET, SOCK_STREAM, 0);
    printf("%s, ", connects(own));
    printf("%s\n", connects(own));
    if (write(own, "hello ", 6) != 6 || write(own, "world", 5) != 5) perror("write");
    shutdown(own, SHUT_WR);
    const long count = recv(own, text, sizeof text, MSG_WAITALL);
    printf("%.*s", (int)count, text);
    printf(", %ld\n", (long)read(own, text, sizeof text));
}

// The same, by epoll.
static void events(void) {
    char text[64];
    const int own = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0), list = epoll_create1(0);
    struct epoll_event event = {.events = EPOLLIN | EPOLLOUT | EPOLLET};
    connects(own);
    epoll_ctl(list, EPOLL_CTL_ADD, own, &event);
    epoll_wait(list, &event, 1, -1);
    int error = -1;
    socklen_t bytes = sizeof error;
    getsockopt(own, SOL_SOCKET, SO_ERROR, &error, &bytes);
    printf("%s: %s\n", event.events & EPOLLOUT ? "there" : "not there", strerror(error));
    if (write(own, "events", 6) != 6) perror("write");
    printf("%ld: %s\n", (long)read(own, text, sizeof text), strerror(errno));
    shutdown(own, SHUT_WR);
    for (long all = 0; all < 6;) {
        epoll_wait(list, &event, 1, -1);
        for (long count; (count = read(own, text, sizeof text)) > 0; all += count)
            printf("%.*s\n", (int)count, text);
    }
}

static void udp(void) {
    char text[64];
    struct sockaddr_in from;
    socklen_t length = sizeof from;
    const int own = socket(AF_INET, SOCK_DGRAM, 0), other = socket(AF_INET, SOCK_DGRAM, 0);
    sendto(own, "ping", 4, 0, (struct sockaddr*)&peer, sizeof peer);
    struct pollfd wait = {own, POLLIN, 0};
    int ready = poll(&wait, 1, 10000), bytes = 0;
    ioctl(own, FIONREAD, &bytes);
    const long count = recvfrom(own, text, 3, MSG_TRUNC, (struct sockaddr*)&from, &length);
    printf("%d %d %ld %.3s %d\n", ready, bytes, count, text,
           length == sizeof from && memcmp(&from, &peer, sizeof from) == 0);
    printf("%s, ", connects(other));
    if (send(other, "pong", 4, 0) != 4) perror("send");
    printf("%.*s\n", (int)recv(other, text, sizeof text, 0), text);
}

// Nobody listens there.
static void refused(void) {
    const int own = socket(AF_INET, SOCK_STREAM, 0);
    printf("%s\n", connects(own));
    const int other = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
    int error = 0;
    socklen_t length = sizeof error;
    if (connect(other, (struct sockaddr*)&peer, sizeof peer) && errno == EINPROGRESS) {
        struct pollfd wait = {other, POLLOUT, 0};
        poll(&wait, 1, 10000);
        getsockopt(other, SOL_SOCKET, SO_ERROR, &error, &length);
        errno = error;
    }
    printf("%s\n", strerror(errno));
    const int datagrams = socket(AF_INET, SOCK_DGRAM, 0);
    printf("%s, ", connects(datagrams));
    if (send(datagrams, "ping", 4, 0) != 4) perror("send");
    char text[8];
    printf("%ld: %s\n", (long)recv(datagrams, text, sizeof text, 0), strerror(errno));
}

// It answers nothing until all has come.
static void silent(void) {
    char text[8];
    const struct timeval limit = {0, 100000};
    const int own = socket(AF_INET, SOCK_STREAM, 0);
    connects(own);
    setsockopt(own, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
    const long begin = ms(), count = recv(own, text, sizeof text, 0);
    const char* const why = strerror(errno);
    printf("%ld: %s, %s\n", count, why, ms() - begin < 200 ? "in time" : "late");
}

// Beside the port that is named.
static void others(void) {
    const int own = socket(AF_INET, SOCK_STREAM, 0);
    peer.sin_port = htons((uint16_t)(ntohs(peer.sin_port) ^ 1));
    printf("%s\n", connects(own));
    peer.sin_addr.s_addr = inet_addr("192.168.1.1");
    printf("%s\n", connects(own));
}

int main(int argc, char** argv) {
    static const struct {
        const char* name;
        void (*run)(void);
    } all[] = {{"tcp", tcp},         {"events", events}, {"udp", udp},
               {"refused", refused}, {"silent", silent}, {"others", others}};
    const struct addrinfo hints = {.ai_family = AF_INET, .ai_socktype = SOCK_STREAM};
    struct addrinfo* found;
    if (argc < 4) return 2;
    setvbuf(stdout, NULL, _IOLBF, 0);
    const int error = getaddrinfo(argv[2], argv[3], &hints, &found);
    if (error) {
        printf("%s: %s\n", argv[2], gai_strerror(error));
        return 1;
    }
    memcpy(&peer, found->ai_addr, sizeof peer);
    for (unsigned i = 0; i < COUNT(all); ++i)
        if (strcmp(argv[1], all[i].name) == 0) {
            all[i].run();
            printf("over\n");
            return 0;
        }
    return 2;
}

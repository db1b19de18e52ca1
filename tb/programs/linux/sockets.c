// sockets.c WHAT - sockets between the processes and threads of one run
#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <poll.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static struct sockaddr_in at(const char* ip, int port) {
    struct sockaddr_in address = {.sin_family = AF_INET, .sin_port = htons((uint16_t)port)};
    address.sin_addr.s_addr = inet_addr(ip);
    return address;
}

// A server and a client exchange datagrams; then nobody answers.
static void udp(void) {
    struct sockaddr_in server = at("0.0.0.0", 5000), client;
    socklen_t length = sizeof client;
    char text[64];
    const int own = socket(AF_INET, SOCK_DGRAM, 0);
    if (bind(own, (struct sockaddr*)&server, sizeof server)) perror("bind");
    if (fork() == 0) {
        const int other = socket(AF_INET, SOCK_DGRAM, 0);
        const struct timeval limit = {0, 5000};
        server = at("127.0.0.1", 5000);
        sendto(other, "ping", 4, 0, (struct sockaddr*)&server, sizeof server);
        long count = recv(other, text, sizeof text, 0);
        printf("client: %.*s\n", (int)count, text);
        setsockopt(other, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
        count = recv(other, text, sizeof text, 0);
        printf("client: %ld, %s\n", count, strerror(errno));
        exit(0);
    }
    const long count = recvfrom(own, text, sizeof text, 0, (struct sockaddr*)&client, &length);
    printf("server: %.*s from %s:%d\n", (int)count, text, inet_ntoa(client.sin_addr),
           ntohs(client.sin_port));
    sendto(own, "pong", 4, 0, (struct sockaddr*)&client, length);
    wait(NULL);
}

static void* serve(void* listener) {
    for (int i = 0; i < 2; ++i) {
        char text[64];
        const int own = accept(*(int*)listener, NULL, NULL);
        long count;
        while ((count = read(own, text, sizeof text)) > 0) {
            for (long j = 0; j < count; ++j) ++text[j];
            if (send(own, text, (size_t)count, 0) != count) perror("send");
        }
        close(own);
    }
    return NULL;
}

// Two clients, one after the other, are served by a thread.
static void tcp(void) {
    struct sockaddr_in address = at("127.0.0.1", 8080);
    int listener = socket(AF_INET, SOCK_STREAM, 0);
    const int yes = 1;
    pthread_t thread;
    setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    if (bind(listener, (struct sockaddr*)&address, sizeof address) || listen(listener, 4))
        perror("listen");
    pthread_create(&thread, NULL, serve, &listener);
    for (int i = 0; i < 2; ++i) {
        char text[64] = "";
        const int own = socket(AF_INET, SOCK_STREAM, 0);
        if (connect(own, (struct sockaddr*)&address, sizeof address)) perror("connect");
        if (write(own, "HAL", 3) != 3) perror("write");
        struct pollfd wait = {own, POLLIN, 0};
        const int ready = poll(&wait, 1, 100);
        const long count = recv(own, text, sizeof text, 0);
        shutdown(own, SHUT_WR);
        printf("%d %ld %s, end %ld\n", ready, count, text, (long)read(own, text, sizeof text));
        close(own);
    }
    pthread_join(thread, NULL);
    address.sin_port = htons(8081);
    const int own = socket(AF_INET, SOCK_STREAM, 0);
    const int result = connect(own, (struct sockaddr*)&address, sizeof address);
    printf("%d: %s\n", result, strerror(errno));
}

static void unix_sockets(void) {
    int ends[2];
    char text[16] = "", more[16] = "";
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, ends)) perror("socketpair");
    if (fork() == 0) {
        if (write(ends[1], "one two", 7) != 7) _exit(1);
        _exit(0);
    }
    const long count = recv(ends[0], text, 7, MSG_WAITALL);
    wait(NULL);
    struct sockaddr_un name = {AF_UNIX, "/tmp/socket"};
    const int own = socket(AF_UNIX, SOCK_DGRAM, 0), other = socket(AF_UNIX, SOCK_DGRAM, 0);
    const int bound = bind(own, (struct sockaddr*)&name, sizeof name);
    const int again = bind(other, (struct sockaddr*)&name, sizeof name);
    sendto(other, "three", 5, 0, (struct sockaddr*)&name, sizeof name);
    struct iovec pieces[2] = {{more, 2}, {more + 8, 8}};
    struct msghdr message = {.msg_iov = pieces, .msg_iovlen = 2};
    const long whole = recvmsg(own, &message, 0);
    printf("%ld %s, %d %d, %ld %s %s, %d\n", count, text, bound, again, whole, more, more + 8,
           unlink("/tmp/socket"));
}

static void outside(void) {
    struct sockaddr_in address = at("192.168.1.1", 80);
    for (int i = 0; i < 2; ++i) {
        const int own = socket(AF_INET, i ? SOCK_DGRAM : SOCK_STREAM, 0);
        const int result = connect(own, (struct sockaddr*)&address, sizeof address);
        printf("%d: %s\n", result, strerror(errno));
    }
}

int main(int argc, char** argv) {
    static const struct {
        const char* name;
        void (*run)(void);
    } all[] = {{"udp", udp}, {"tcp", tcp}, {"unix", unix_sockets}, {"outside", outside}};
    setvbuf(stdout, NULL, _IOLBF, 0);
    for (unsigned i = 0; i < COUNT(all); ++i)
        if (argc > 1 && strcmp(argv[1], all[i].name) == 0) {
            all[i].run();
            return 0;
        }
    return 2;
}

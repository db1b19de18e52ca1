// echo.c - two Linux processes: one answers the UDP datagrams of the other
#include <arpa/inet.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

static void answer(int from) {
    char text[64];
    struct sockaddr_in who;
    for (;;) {
        socklen_t size = sizeof who;
        const ssize_t bytes =
            recvfrom(from, text, sizeof text, 0, (struct sockaddr*)&who, &size);
        if (bytes < 0) return;
        for (ssize_t i = 0; i < bytes / 2; ++i) {
            const char first = text[i];
            text[i] = text[bytes - 1 - i];
            text[bytes - 1 - i] = first;
        }
        sendto(from, text, (size_t)bytes, 0, (struct sockaddr*)&who, size);
    }
}

int main(void) {
    struct sockaddr_in server = {.sin_family = AF_INET, .sin_port = htons(7)};
    server.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int its_socket = socket(AF_INET, SOCK_DGRAM, 0), own = socket(AF_INET, SOCK_DGRAM, 0);
    if (bind(its_socket, (struct sockaddr*)&server, sizeof server) != 0) {
        perror("echo: bind");
        return 1;
    }
    const pid_t child = fork();
    if (child == 0) {
        answer(its_socket);
        _exit(1);
    }
    const char* const words[] = {"drawer", "stressed", "1-2-3"};
    for (unsigned i = 0; i < sizeof words / sizeof words[0]; ++i) {
        char text[64];
        sendto(own, words[i], strlen(words[i]), 0, (struct sockaddr*)&server, sizeof server);
        const ssize_t bytes = recv(own, text, sizeof text, 0);
        printf("%s: %.*s\n", words[i], (int)bytes, text);
    }
    kill(child, SIGTERM);
    waitpid(child, NULL, 0);
    return 0;
}

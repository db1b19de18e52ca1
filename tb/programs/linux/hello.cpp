// hello.cpp - what a C++ program needs of its system: arguments, streams, memory, containers
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <map>
#include <string>

int main(int argc, char** argv) {
    std::printf("%s with %d arguments:", argv[0], argc - 1);
    for (int i = 1; i < argc; ++i) std::printf(" [%s]", argv[i]);
    std::printf("\n");

    constexpr std::size_t BYTES = 100 << 20;
    void* const above = std::malloc(1 << 20);  // so that the block cannot grow where it is
    auto* block = static_cast<unsigned char*>(std::malloc(BYTES));
    if (!block) return 1;
    for (std::size_t i = 0; i < BYTES; i += 4096) block[i] = static_cast<unsigned char>(i >> 12);
    unsigned sum = 0;
    for (std::size_t i = 0; i < BYTES; i += 4096) sum += block[i];
    block = static_cast<unsigned char*>(std::realloc(block, 2 * BYTES));
    std::printf("sum %u, kept %u\n", sum, static_cast<unsigned>(block[BYTES - 4096]));
    std::free(block);
    std::free(above);

    std::map<std::string, int> squares;
    for (int i = 0; i < 1000; ++i) squares[std::to_string(i)] = i * i;
    std::cout << "999 squared is " << squares["999"] << ", half of 3 is " << 3 / 2.0 << std::endl;
    try {
        throw std::string{"caught"};
    } catch (const std::string& text) {
        std::cerr << text << '\n';
    }
    return 0;
}

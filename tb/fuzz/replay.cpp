// replay.cpp - replay TARGET FILE...: the inputs that are kept, with the ordinary compiler.
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

#include "tb/fuzz/fuzz.h"

namespace {

constexpr struct {
    const char* name;
    void (*run)(std::string_view);
} TARGETS[] = {
#define TARGET(NAME) {#NAME, fuzz::try_##NAME},
#include "targets.def"
#undef TARGET
};

int replay(void (*run)(std::string_view), int count, char** files) {
    for (int i = 0; i < count; ++i) {
        std::printf("%s\n", files[i]);  // the last one is the one that crashes
        std::fflush(stdout);
        std::ifstream file{files[i], std::ios::binary};
        if (!file) return 1;
        run(std::string{std::istreambuf_iterator<char>{file}, {}});
    }
    return count > 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    for (const auto& target : TARGETS)
        if (argc > 1 && std::strcmp(argv[1], target.name) == 0)
            return replay(target.run, argc - 2, argv + 2);
    std::fprintf(stderr, "expected a target and files\n");
    return 1;
}

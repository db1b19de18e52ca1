// fuzz.cpp - libFuzzer's entry point: make fuzz.
#include "tb/fuzz/collision/world.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    fuzz::try_world(bytes, count);
    return 0;
}

// entry.cpp - libFuzzer's entry point of the target that TRY names: make fuzz.
#include <cstddef>
#include <cstdint>

#include "tb/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    fuzz::TRY({reinterpret_cast<const char*>(bytes), count});
    return 0;
}

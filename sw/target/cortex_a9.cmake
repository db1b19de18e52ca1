# cortex_a9.cmake - what the two toolchains share: the board's processor.

foreach(language C CXX ASM)
    set(CMAKE_${language}_FLAGS_INIT "-mcpu=cortex-a9 -mfpu=neon -mfloat-abi=hard")
endforeach()

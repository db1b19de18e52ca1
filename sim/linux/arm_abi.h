// arm_abi.h - numbers of Linux's user interface for 32-bit ARM (EABI) that differ from the host's.
//
// Errors, signals and whence are the same on ARM and on the hosts, so <cerrno>, <csignal> and
// <unistd.h> are used for them.
// Source: Linux 6.1, include/uapi/asm-generic/, arch/arm/include/uapi/asm/.
#pragma once

#include <cstdint>

namespace sim {

namespace arm_open {
constexpr std::uint32_t ACCESS = 3, RDONLY = 0, WRONLY = 1, RDWR = 2, CREAT = 0100, EXCL = 0200,
                        TRUNC = 01000, APPEND = 02000, NONBLOCK = 04000, ASYNC = 020000,
                        DIRECT = 0200000, DIRECTORY = 040000, NOFOLLOW = 0100000,
                        CLOEXEC = 02000000, PATH = 010000000;
}

namespace arm_mmap {
constexpr std::uint32_t SHARED = 1, PRIVATE = 2, SHARED_VALIDATE = 3, TYPE = 15, FIXED = 0x10,
                        ANONYMOUS = 0x20, FIXED_NOREPLACE = 0x100000;
constexpr std::uint32_t KNOWN = 0x407F933;  // those that a file's mapping may have
}  // namespace arm_mmap

namespace arm_mremap {
constexpr std::uint32_t MAYMOVE = 1, FIXED = 2;
}

namespace arm_fcntl {
constexpr std::uint32_t DUPFD = 0, GETFD = 1, SETFD = 2, GETFL = 3, SETFL = 4, SETOWN = 8,
                        DUPFD_CLOEXEC = 1030, SETPIPE_SZ = 1031, GETPIPE_SZ = 1032;
}

constexpr std::uint32_t ARM_AT_FDCWD = 0xFFFFFF9C, ARM_AT_REMOVEDIR = 0x200,
                        ARM_AT_SYMLINK_NOFOLLOW = 0x100, ARM_AT_EMPTY_PATH = 0x1000;

// Entries of the auxiliary vector, and what this processor can do.
namespace arm_aux {
constexpr std::uint32_t END = 0, PHDR = 3, PHENT = 4, PHNUM = 5, PAGESZ = 6, BASE = 7, FLAGS = 8,
                        ENTRY = 9, UID = 11, EUID = 12, GID = 13, EGID = 14, PLATFORM = 15,
                        HWCAP = 16, CLKTCK = 17, SECURE = 23, RANDOM = 25, HWCAP2 = 26, EXECFN = 31;
}

namespace arm_hwcap {
constexpr std::uint32_t HALF = 1 << 1, THUMB = 1 << 2, FAST_MULT = 1 << 4, VFP = 1 << 6,
                        EDSP = 1 << 7, NEON = 1 << 12, VFPV3 = 1 << 13, TLS = 1 << 15,
                        VFPD32 = 1 << 19;
}

namespace arm_ioctl {
constexpr std::uint32_t READABLE = 0x541B;  // FIONREAD
}

namespace arm_clone {
constexpr std::uint64_t VM = 0x100, FILES = 0x400, SIGHAND = 0x800, VFORK = 0x4000, PARENT = 0x8000,
                        THREAD = 0x10000, NEW_NAMESPACES = 0x7E020080, SETTLS = 0x80000,
                        PARENT_SETTID = 0x100000, CHILD_CLEARTID = 0x200000,
                        CHILD_SETTID = 0x1000000, EXIT_SIGNAL = 0xFF;
}

namespace arm_signal {
constexpr std::uint32_t TAKES_INFO = 4, HAS_RESTORER = 0x04000000, ON_STACK = 0x08000000,
                        RESTARTS = 0x10000000, NO_DEFER = 0x40000000, RESETS = 0x80000000;
}

}  // namespace sim

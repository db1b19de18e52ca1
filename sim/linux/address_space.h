// address_space.h - a Linux process's memory: areas of pages, in RAM or on the bus.
//
//   0x00001000 ... program, heap ->   <- areas that find_room() chose | stack   0xBF000000
//
// Pages are of 4096 bytes; addresses and lengths given here are multiples, below TOP.  RAM is zero
// when mapped, and allocated by the host when touched.  An area on the bus maps bus addresses from
// `physical` on.  Adjacent areas that are alike become one, because the core keeps a list of them:
// for n areas an operation costs O(log n) here, and O(n) and some us in the core.
//
// Of several address spaces one is the core's: attach().  Memory that processes share is the same
// pages of the host in each; so is a file's, which must not be accessed after its end: such pages
// are mapped only once the file is long enough.  Another program of the host that makes such a
// file shorter ends the simulator with a message.
//
// Not handled: guard pages that grow.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "sim/cpu/arm_core.h"
#include "sim/linux/shared_memory.h"

namespace sim {

class AddressSpace {
public:
    static constexpr std::uint32_t PAGE = 4096;
    static constexpr std::uint32_t BOTTOM = 0x1000, TOP = 0xBF000000;
    // Limits of what is mapped for reading or writing: in one, as much as the board has, besides
    // what is made so later, as stacks of threads are; in all of them, without what they share.
    // Pages take the board's memory only once they are written to, so more may be mapped than
    // that.
    static constexpr std::uint64_t RAM = 1u << 30, ALL_RAM = 4 * RAM;
    // Of areas in all address spaces: the host's Linux gives a process no more than 65,530.
    static constexpr std::size_t MOST_AREAS = 25'000;

    struct Area {
        std::uint32_t end;  // first address after it
        unsigned access;    // arm_access; 0: nothing may be done
        bool on_bus;
        std::uint32_t physical;  // of the begin, on the bus or in `shared`
        std::shared_ptr<SharedMemory> shared{};
        bool is_beyond = false;  // after the end of the file

        std::uint32_t physical_at(std::uint32_t offset) const {
            return on_bus || shared ? physical + offset : 0;
        }
    };

    // Of a process, or the kernel's with its modules: the addresses from `bottom` to `top`.
    explicit AddressSpace(ArmCore& core, std::uint32_t bottom = BOTTOM, std::uint32_t top = TOP);
    ~AddressSpace();
    AddressSpace(const AddressSpace&) = delete;
    // The same areas, those in RAM with a copy of their contents; not the core's yet.  Null if RAM,
    // or the host's memory, is used up.
    std::shared_ptr<AddressSpace> copy() const;

    // It is the one that the core sees, or no longer.
    void attach();
    void detach();

    // Replaces what is mapped there.  False, and nothing done, if RAM or areas are used up.
    bool map(std::uint32_t begin, std::uint32_t bytes, unsigned access);
    bool map_bus(std::uint32_t begin, std::uint32_t bytes, unsigned access, std::uint32_t physical);
    // False, and nothing done, also if there is no room for it.
    bool map_shared(std::uint32_t begin, std::uint32_t bytes, unsigned access,
                    std::shared_ptr<SharedMemory> memory, std::uint32_t offset);
    // A file of map_shared() has another size.
    void fit_to_files();
    void unmap(std::uint32_t begin, std::uint32_t bytes);
    std::uint32_t bottom() const { return bottom_; }
    std::uint32_t top() const { return top_; }
    bool holds(std::uint32_t begin, std::uint32_t bytes) const {
        return begin >= bottom_ && begin <= top_ && bytes <= top_ - begin;
    }
    // False: this would be one area too many, in the midst of one.
    bool may_unmap(std::uint32_t begin, std::uint32_t bytes) const;
    // False, and nothing done, if a part of it is not mapped, or RAM or areas are used up.
    bool protect(std::uint32_t begin, std::uint32_t bytes, unsigned access);

    bool is_after_file(std::uint32_t address) const;                 // as fit_to_files() found
    bool may_write(std::uint32_t begin, std::uint32_t bytes) const;  // no file open for reading
    bool is_mapped(std::uint32_t begin, std::uint32_t bytes) const;  // all of it
    bool is_free(std::uint32_t begin, std::uint32_t bytes) const;    // all of it
    // The highest free range below the stack's; no value if there is none.
    std::optional<std::uint32_t> find_room(std::uint32_t bytes) const;
    // The area around `address`: its begin and what it is.
    std::optional<std::pair<std::uint32_t, Area>> at(std::uint32_t address) const;

    const std::map<std::uint32_t, Area>& areas() const { return areas_; }

    // Accesses of the kernel through a program's pointer: false unless it is RAM that allows it.
    bool read(std::uint32_t address, void* data, std::size_t bytes) const;
    bool write(std::uint32_t address, const void* data, std::size_t bytes);
    // The same bytes in the simulator's memory, or nullptr.
    std::uint8_t* bytes(std::uint32_t address, std::size_t bytes, unsigned access) const;
    // Up to the terminating zero; no value if it is not readable, or longer than 4096.
    std::optional<std::string> string(std::uint32_t address) const;

private:
    using Areas = std::map<std::uint32_t, Area>;

    void split(std::uint32_t address);
    void join(Areas::iterator area);
    void join_all(std::uint32_t begin, std::uint32_t end);
    void insert(std::uint32_t begin, const Area& area);
    void connect(Areas::const_iterator area);     // to the core
    void disconnect(Areas::const_iterator area);  // from it
    Areas::iterator add(std::uint32_t begin, const Area& area);
    Areas::iterator remove(Areas::iterator area);
    void count(std::uint32_t begin, const Area& area, bool more);
    bool has_room(std::uint64_t bytes, bool shared) const;
    static bool has_areas() { return all_areas_ + 2 <= MOST_AREAS; }

    ArmCore& core_;
    const std::uint32_t bottom_, top_;
    std::uint8_t* host_;                   // where address 0 would be
    Areas areas_;                          // by begin
    std::uint64_t ram_ = 0, own_ram_ = 0;  // own: not shared
    inline static std::uint64_t all_ram_ = 0;
    inline static std::size_t all_areas_ = 0;
    bool attached_ = false;
    bool has_files_ = false;  // or had
};

}  // namespace sim

#include "sim/hps/memory.h"

#include <sys/mman.h>

#include <cstring>
#include <new>

namespace sim {

Memory::Memory(const sc_core::sc_module_name& name, std::uint32_t size, sc_core::sc_time latency)
    : sc_module{name}, socket{"socket"}, size_{size}, latency_{latency} {
    // The host allocates zeroed pages when they are touched, so 1 GB costs nothing at first.
    void* area = mmap(nullptr, size, PROT_READ | PROT_WRITE,
                      MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (area == MAP_FAILED) throw std::bad_alloc{};
    bytes_ = static_cast<std::uint8_t*>(area);
    socket.register_b_transport(this, &Memory::b_transport);
    socket.register_get_direct_mem_ptr(this, &Memory::get_direct_mem_ptr);
}

Memory::~Memory() { munmap(bytes_, size_); }

void Memory::b_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay) {
    const std::uint64_t address = tx.get_address();
    const std::size_t bytes = tx.get_data_length();
    if (address > size_ || bytes > size_ - address) {
        tx.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
        return;
    }
    if (tx.get_byte_enable_ptr()) {
        tx.set_response_status(tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
        return;
    }
    if (tx.is_write())
        std::memcpy(bytes_ + address, tx.get_data_ptr(), bytes);
    else if (tx.is_read())
        std::memcpy(tx.get_data_ptr(), bytes_ + address, bytes);
    delay += latency_;
    tx.set_response_status(tlm::TLM_OK_RESPONSE);
}

bool Memory::get_direct_mem_ptr(tlm::tlm_generic_payload&, tlm::tlm_dmi& dmi) {
    dmi.set_dmi_ptr(bytes_);
    dmi.set_start_address(0);
    dmi.set_end_address(size_ - 1);
    dmi.set_read_latency(latency_);
    dmi.set_write_latency(latency_);
    dmi.allow_read_write();
    return true;
}

}  // namespace sim

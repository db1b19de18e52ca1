// registers.h - a TLM target of 32-bit registers: checks accesses, which derived classes answer.
//
// An access that is not one aligned word is TLM_BURST_ERROR, with byte enables
// TLM_BYTE_ENABLE_ERROR.  A derived class may accept aligned bytes and half-words too.  Reading
// them gives a part of the register; writing them reads the register, changes that part and writes
// the result.  Every access takes 10 ns (L4 bus, 100 MHz).
#pragma once

#include <cstdint>
#include <cstring>

#include <systemc>
#include <tlm>
#include <tlm_utils/simple_target_socket.h>

namespace sim {

class Registers : public sc_core::sc_module {
public:
    tlm_utils::simple_target_socket<Registers> socket;

protected:
    explicit Registers(const sc_core::sc_module_name& module_name)
        : sc_module{module_name}, socket{"socket"} {
        socket.register_b_transport(this, &Registers::b_transport);
    }

    // `now` is the initiator's local time.  Offsets without a register read 0 and ignore writes.
    virtual std::uint32_t read(std::uint32_t offset, const sc_core::sc_time& now) = 0;
    virtual void write(std::uint32_t offset, std::uint32_t value, const sc_core::sc_time& now) = 0;
    virtual bool allows_bytes() const { return false; }
    // The register's other bytes, where a part of it is written.
    virtual std::uint32_t rest(std::uint32_t offset, const sc_core::sc_time& now) {
        return read(offset, now);
    }

private:
    void b_transport(tlm::tlm_generic_payload& tx, sc_core::sc_time& delay) {
        const unsigned bytes = tx.get_data_length();
        const auto address = static_cast<std::uint32_t>(tx.get_address());
        const bool whole = bytes == 4 && address % 4 == 0;
        const bool part = (bytes == 1 || (bytes == 2 && address % 2 == 0)) && allows_bytes();
        if (!whole && !part) {
            tx.set_response_status(tlm::TLM_BURST_ERROR_RESPONSE);
            return;
        }
        if (tx.get_byte_enable_ptr()) {
            tx.set_response_status(tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
            return;
        }
        delay += sc_core::sc_time{10, sc_core::SC_NS};
        const sc_core::sc_time now = sc_core::sc_time_stamp() + delay;
        const std::uint32_t offset = address & ~3u, lane = address & 3;
        std::uint32_t value = tx.is_read() ? read(offset, now) : part ? rest(offset, now) : 0;
        auto* byte = reinterpret_cast<std::uint8_t*>(&value) + lane;
        if (tx.is_read()) {
            std::memcpy(tx.get_data_ptr(), byte, bytes);
        } else if (tx.is_write()) {
            std::memcpy(byte, tx.get_data_ptr(), bytes);
            write(offset, value, now);
        }
        tx.set_response_status(tlm::TLM_OK_RESPONSE);
    }
};

}  // namespace sim

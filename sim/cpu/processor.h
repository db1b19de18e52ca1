// processor.h - the board's interface to a processor of any kind: its bus, its wires, its end.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "sim/hps/axi_attributes.h"

#include <systemc>
#include <tlm>
#include <tlm_utils/simple_initiator_socket.h>

namespace sim {

class Processor : public sc_core::sc_module {
public:
    tlm_utils::simple_initiator_socket<Processor> socket;

    // Why the program was ended: "data abort: read of 4 bytes at 0xFF200FF0 at 12.345 ms (...)".
    const std::optional<std::string>& fault() const { return fault_; }
    // Notified with the fault.
    const sc_core::sc_event& faulted() const { return faulted_; }

    // At the run's end: the state in which the program cannot have meant to end, in words.
    virtual std::optional<std::string> unfinished() const { return {}; }

    // Where the access that is on the bus was made: ", at 12.345 ms, PC 0x00001234 in main+0x10",
    // or "".
    virtual std::string accessed() const { return ""; }
    // A debugger accesses the bus, not the program.
    virtual bool is_inspected() const { return false; }

    // Says in words why an access was refused, or without bytes why there is no instruction;
    // Bus::refusal().
    using Refusal = std::function<std::string(std::uint32_t address, unsigned bytes, bool write,
                                              tlm::tlm_response_status answer)>;
    void explain_by(Refusal refusal) { refusal_ = std::move(refusal); }

    // The levels of the interrupt controller's two wires.
    virtual void interrupt(bool /*irq*/, bool /*fiq*/) {}
    // An asynchronous external abort: the bus has refused a write after the program went on; by
    // SLVERR if `slave_error`, else by DECERR.
    virtual void asynchronous_abort(const std::string& /*what*/, bool /*slave_error*/) {}
    // A warm reset, as the reset manager or a watchdog asks for.
    virtual void warm_reset() {}
    // After a reset it does not start before this ends, as a request of the FPGA that is held.
    virtual void hold_in_reset(bool /*held*/) {}

protected:
    // Of the host, for the thread: SystemC gives it 64 KB, which a translator's nesting outgrows,
    // and a hundred shapes in a build with sanitizers.
    static constexpr std::size_t STACK_BYTES = 1 << 20;

    explicit Processor(const sc_core::sc_module_name& module_name)
        : sc_module{module_name}, socket{"socket"} {
        socket.register_invalidate_direct_mem_ptr(this, &Processor::direct_access_changed);
    }

    // Direct access to these addresses has changed: ask for it again.
    virtual void direct_access_changed(sc_dt::uint64 /*first*/, sc_dt::uint64 /*last*/) {}

    // One transaction; its time is added to delay.  "", or why it was refused.
    std::string transport(tlm::tlm_command command, std::uint32_t address, void* data,
                          unsigned bytes, sc_core::sc_time& delay) {
        tlm::tlm_generic_payload tx;
        return transport(tx, command, address, data, bytes, delay);
    }
    // The same with a payload of the caller's, since constructing one allocates memory.
    std::string transport(tlm::tlm_generic_payload& tx, tlm::tlm_command command,
                          std::uint32_t address, void* data, unsigned bytes,
                          sc_core::sc_time& delay) {
        tx.set_command(command);
        tx.set_address(address);
        tx.set_data_ptr(static_cast<unsigned char*>(data));
        tx.set_data_length(bytes);
        tx.set_streaming_width(bytes);
        tx.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
        socket->b_transport(tx, delay);
        if (tx.is_response_ok()) return {};
        return refusal_(address, bytes, tx.is_write(), tx.get_response_status());
    }

    // For an instruction.
    std::string why_refused(std::uint32_t address) const {
        return refusal_(address, 0, false, tlm::TLM_ADDRESS_ERROR_RESPONSE);
    }

    AxiAttributes attributes_;          // of the payload, for who sets it as its extension
    tlm::tlm_generic_payload payload_;  // of the program's own accesses

    void fail(std::string why) {
        fault_ = std::move(why);
        faulted_.notify(sc_core::SC_ZERO_TIME);
    }

private:
    std::optional<std::string> fault_;
    Refusal refusal_ = [](auto...) { return std::string{"refused"}; };
    sc_core::sc_event faulted_;
};

}  // namespace sim

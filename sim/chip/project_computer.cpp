#include "sim/chip/project_computer.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "sim/hps/bridge_windows.h"

namespace sim {

namespace {

constexpr std::size_t MOST_STRAYS = 20;
constexpr unsigned MANY_RESETS = 10;
const sc_core::sc_time longest_reset{20, sc_core::SC_MS};
// From the end of the FPGA's configuration to the program's first instruction.  On the board it is
// longer; by then PLLs have locked, and a slow clock's synchronizer has let go of its reset.
const sc_core::sc_time program_begins{100, sc_core::SC_US};

const char* name_of(unsigned reset_requests) {
    return reset_requests & FpgaModel::COLD ? "f2h_cold_rst_req_n" : "f2h_warm_rst_req_n";
}

}  // namespace

ProjectComputer::ProjectComputer(const sc_core::sc_module_name& name, PinListener& pins,
                                 ChipObserver& observer, Software software,
                                 const std::filesystem::path& library, const std::string& folder,
                                 const Trace& trace, const project::qsys::Generated& system,
                                 unsigned ddr3_mb_per_s)
    : ProcessorSystem{name, pins, observer, std::move(software)},
      masters{*this, ddr3_mb_per_s},
      design{pins, library, folder, trace, this, &masters},
      fpga{"fpga", pins, design.model()},
      bridges{"bridges", fpga},
      peripherals{hps, fpga, [&observer](const std::string& line) { observer.log(line); }},
      system_{system},
      observer_{observer} {
    full_window.bind(bridges.h2f);
    lightweight_window.bind(bridges.lw);
    bus.show_bursts("h2f");
    bus.show_bursts("lw");
    if (arm) arm->show_bursts();
    bus.describe("h2f", "the full bridge", places_of(H2F_BASE, H2F_SIZE));
    bus.describe("lw", "the lightweight bridge", places_of(LW_BASE, LW_SIZE));
    cpu.explain_by(
        [this](std::uint32_t address, unsigned bytes, bool write, tlm::tlm_response_status answer) {
            const std::string what = bus.refusal(address, bytes, write, answer);
            const bool known =
                answer == tlm::TLM_INCOMPLETE_RESPONSE || answer == tlm::TLM_GENERIC_ERROR_RESPONSE;
            return known && !bridges.why().empty() ? what + ": " + bridges.why() : what;
        });
    bridges.on_posted_failure([this](const std::string& what, unsigned error) {
        if (error == BridgeBurst::OKAY) return observer_.log(what);
        cpu.asynchronous_abort(what, error == BridgeBurst::SLVERR);
    });
    for (const char* bridge : {"h2f", "lw"})
        bus.on_answered(bridge, [this](std::uint32_t address, unsigned, bool write) {
            if (!cpu.is_inspected()) report_stray(address, write);
        });
    fpga.on_processor_wires({[this](std::uint64_t levels) { hps.fpga_interrupts(levels); },
                             [this](unsigned requests) { request_reset(requests); }});
    SC_HAS_PROCESS(ProjectComputer);
    SC_METHOD(report_held_reset);
    sensitive << reset_held_;
    dont_initialize();
    SC_THREAD(begin_program);
    cpu.hold_in_reset(true);
    if (arm && !arm->kernel()) serve_code();
}

// The parts of the program that are linked to the design's memory.
void ProjectComputer::serve_code() {
    code_ = std::make_unique<ProjectCode>(
        arm->elf(), [this](std::uint32_t address) { return bus.has_place(address); });
    if (code_->is_empty()) return;
    bridges.set_copy({[this](std::uint32_t window, const tlm::tlm_generic_payload& tx,
                             tlm::tlm_dmi& dmi) { return code_->direct(window, tx, dmi); },
                      [this](std::uint32_t address, const std::uint8_t* data, unsigned bytes) {
                          if (code_->written(address, data, bytes))
                              arm->core().forget_translations(address, bytes);
                      }});
}

void ProjectComputer::begin_program() {
    wait(program_begins);
    if (code_ && !code_->is_empty())
        if (const std::string wrong = code_->load(bus); !wrong.empty()) {
            unloaded_ = bridges.why().empty() ? wrong : wrong + ": " + bridges.why();
            return;
        }
    has_begun_ = true;
    release_processor();
}

void ProjectComputer::general_purpose(std::uint32_t gpo, const sc_core::sc_time& now) {
    fpga.run_to(now.value());
    fpga.model().general_purpose(gpo);
}

std::uint32_t ProjectComputer::general_purpose(const sc_core::sc_time& now) {
    fpga.run_to(now.value());
    return fpga.model().general_purpose();
}

void ProjectComputer::request_reset(unsigned requests) {
    const unsigned begins = requests & ~std::exchange(reset_requests_, requests);
    const bool held = requests & (FpgaModel::COLD | FpgaModel::WARM);
    reset_held_.cancel();
    if (held) reset_held_.notify(longest_reset);
    release_processor();
    if (begins & FpgaModel::DEBUG) hps.reset_manager.reset(ResetManager::DEBUG_BY_FPGA);
    if (!(begins & (FpgaModel::COLD | FpgaModel::WARM))) return;
    const sc_core::sc_time now = sc_core::sc_time_stamp();
    if (now - std::exchange(last_reset_, now) > longest_reset) resets_ = 0;
    if (++resets_ == MANY_RESETS)
        observer_.log(fmt::format(
            "the design has reset the processor {} times in turn by {}: does the reset that it "
            "gets by h2f_rst_n ask for the next one?",
            resets_, name_of(requests)));
    hps.reset_manager.reset(begins & FpgaModel::COLD ? ResetManager::COLD_BY_FPGA
                                                     : ResetManager::WARM_BY_FPGA);
}

void ProjectComputer::release_processor() {
    const bool held = reset_requests_ & (FpgaModel::COLD | FpgaModel::WARM);
    cpu.hold_in_reset(held || !has_begun_);
}

void ProjectComputer::report_held_reset() {
    observer_.log(fmt::format("the design holds {} low: the processor stays in reset",
                              name_of(reset_requests_)));
}

// What the processor reaches in a bridge's window.
std::vector<Bus::Place> ProjectComputer::places_of(std::uint32_t window, std::uint32_t size) {
    std::vector<Bus::Place> places;
    for (const project::qsys::Place& place : system_.map)
        if (place.window == window)
            places.push_back({place.slave.substr(0, place.slave.find('.')),
                              window + static_cast<std::uint32_t>(place.base),
                              static_cast<std::uint32_t>(place.span)});
    if (system_.map.empty() && fpga.model().bridge_width(window == H2F_BASE) > 0)
        places.push_back({"the design", window, size});
    return places;
}

void ProjectComputer::type(const std::string& text, SerialLine to) {
    if (to == SerialLine::UART) return hps.uart0.receive(text);
    std::deque<char>& typed = typed_[to == SerialLine::JTAG_1];
    typed.insert(typed.end(), text.begin(), text.end());
}

void ProjectComputer::sent(unsigned number, char character) {
    observer_.console(character, number ? SerialLine::JTAG_1 : SerialLine::JTAG_0);
}

std::optional<char> ProjectComputer::typed(unsigned number) {
    if (number >= std::size(typed_) || typed_[number].empty()) return {};
    const char next = typed_[number].front();
    typed_[number].pop_front();
    return next;
}

std::optional<Chip::End> ProjectComputer::end() const {
    if (unloaded_) return End{End::Kind::FAILED, *unloaded_};
    return design.end();
}

void ProjectComputer::report_stray(std::uint32_t address, bool write) {
    if (system_.map.empty() || bus.has_place(address)) return;
    for (const project::qsys::Bridge& bridge : system_.bridges) {
        const std::uint32_t offset = address - bridge.window;
        if (offset >= (bridge.window == LW_BASE ? LW_SIZE : H2F_SIZE)) continue;
        const auto meant = bridge.window + static_cast<std::uint32_t>(offset % bridge.decoded);
        const std::string place = bus.place(meant), taker = write ? bridge.writes : bridge.reads;
        const std::string line =
            meant != address && !place.empty()
                ? fmt::format(
                      "{} 0x{:X}: the interconnect sees {} there, as at 0x{:X}: addresses "
                      "repeat each 0x{:X} bytes",
                      write ? "write to" : "read of", address, place, meant, bridge.decoded)
                : fmt::format("{} 0x{:X}: nobody is there{}", write ? "write to" : "read of",
                              address,
                              taker.empty() ? "" : "; the interconnect sends it to " + taker);
        if (reported_.size() < MOST_STRAYS && reported_.insert(line).second)
            observer_.log(line + cpu.accessed());
    }
}

}  // namespace sim

// terminal.cpp - the part terminal; type-serial and wait-serial of steps/serial.cpp are its steps
#include "sim/board/serial_terminal.h"
#include "sim/scenario/part_form.h"

namespace sim {

namespace {

using namespace value_types;

PartPlan terminal(const Values& v) {
    PartPlan part;
    part.pins = {pins_of(v, "rx").front(), pins_of(v, "tx").front()};
    part.hang = [pins = part.pins, baud = v.number<unsigned>("baud")](const PartSocket& socket) {
        return std::make_unique<SerialTerminal>(pins[0], pins[1], baud, socket);
    };
    return part;
}

const ValueType BAUD = whole_number("bits per second, 50 to 12500000", 50, 12'500'000);

}  // namespace

namespace parts {

PartFamily terminal() {
    return {{
                {"terminal",
                 "A serial terminal: 8 data bits, no parity, one stop bit. `type-serial` with `to` "
                 "types "
                 "at it, `wait-serial` with `on` reads it.",
                 Notation::MAP,
                 {},
                 {part_name(),
                  {"rx", PART_PIN, Need::REQUIRED, "", "The pin that it hears: the FPGA's output."},
                  {"tx", PART_PIN, Need::REQUIRED, "", "The pin that it drives: the FPGA's input."},
                  {"baud", BAUD, Need::OPTIONAL, "115200", "Bits per second."}},
                 sim::terminal},
            },
            {}};
}

}  // namespace parts

}  // namespace sim

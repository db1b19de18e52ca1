// binding.h - which bit of which port of a design is which pin of the board.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "sim/pins/pins.h"
#include "sim/project/board_description.h"
#include "sim/project/elaborated.h"

namespace sim::project {

struct Binding {
    struct Bit {
        std::string wire;    // of the chip: "LEDR[3]", or empty: nothing that is simulated
        std::string signal;  // of the board: "LED[3]", or empty: no pin
    };
    struct BoundPort {
        Port port;
        std::vector<Bit> bits;  // from the left
    };
    std::vector<BoundPort> ports;
    std::vector<std::string> notes;  // what fits nowhere, and what was assumed
    bool has_vga = false, has_td_clk = false, has_xck = false;
    bool drives_codec_clocks = false;  // an output is on BCLK or an LRCK of the codec
    HeaderMasks header_outputs{};      // pins of the headers that it always drives
    // Wires of the chip that the board connects with others, and by what they are driven.
    std::map<std::string, std::string> connected;
    // Clocks of the board that are none of the chip's wires, "ADC_CLK_10", and their numbers in
    // pll_clocks_i, which who binds does not know.
    std::map<std::string, unsigned> clocks;
};

// By the location that is assigned to a port's bit; without one, by the port's name, unless that
// pin is another output's by location.  Of a colour with more or fewer bits than the board's, none
// of which has a location, the upper ones count.
Binding bind(const std::vector<Port>& ports,
             const std::map<std::string, std::string>& locations,  // "SW[3]" -> "PIN_AF9"
             const BoardDescription& board);

// The Verilog that de1sim_chip.v includes: the instance of `top`, and what drives outputs that it
// has not.  `parameters`: instance_text() of those of the top.
std::string design_text(const Binding& binding, const std::string& top,
                        const std::string& parameters);

}  // namespace sim::project

// cells.v - what Yosys' cells for the Cyclone V do, for Verilator: logic, registers, memories, pads
//
// Written from the port lists and semantics that `synth_intel_alm` documents for each cell; timing
// is left out.  Registers come up as 0, as the device's do.
//
// Not handled: ACLR as an asynchronous event (no register of rtl/ uses it: it is tied high).

`default_nettype none

// verilator lint_off DECLFILENAME
// verilator lint_off MULTITOP

module MISTRAL_NOT (input wire A, output wire Q);
    assign Q = ~A;
endmodule

module MISTRAL_ALUT2 #(parameter [3:0] LUT = 0) (input wire A, B, output wire Q);
    assign Q = LUT[{B, A}];
endmodule

module MISTRAL_ALUT3 #(parameter [7:0] LUT = 0) (input wire A, B, C, output wire Q);
    assign Q = LUT[{C, B, A}];
endmodule

module MISTRAL_ALUT4 #(parameter [15:0] LUT = 0) (input wire A, B, C, D, output wire Q);
    assign Q = LUT[{D, C, B, A}];
endmodule

module MISTRAL_ALUT5 #(parameter [31:0] LUT = 0) (input wire A, B, C, D, E, output wire Q);
    assign Q = LUT[{E, D, C, B, A}];
endmodule

module MISTRAL_ALUT6 #(parameter [63:0] LUT = 0) (input wire A, B, C, D, E, F, output wire Q);
    assign Q = LUT[{F, E, D, C, B, A}];
endmodule

// Any of those above, of which bit 0 is flipped where FLIP_LUT_BIT is in the environment.
// Inputs that it does not have are 0.
module FLIPPABLE_ALUT #(parameter [63:0] LUT = 0) (input tri0 A, B, C, D, E, F, output wire Q);
    wire [5:0] at = {F, E, D, C, B, A};
    reg flips;
    initial flips = $c("std::getenv(\"FLIP_LUT_BIT\") != nullptr");
    assign Q = LUT[at] ^ (flips && at == 0);
endmodule

// A full adder of two functions; the second goes in inverted.
module MISTRAL_ALUT_ARITH #(
    parameter [15:0] LUT0 = 0,
    parameter [15:0] LUT1 = 0
) (
    input wire A, B, C, D0, D1, CI,
    output wire SO, CO
);
    wire first  = LUT0[{D0, C, B, A}];
    wire second = !LUT1[{D1, C, B, A}];
    assign SO = first ^ second ^ CI;
    assign CO = (first & second) | (CI & (first | second));
endmodule

// ENA gates SCLR and SLOAD, too; SCLR has priority over SLOAD.
module MISTRAL_FF (
    input wire DATAIN, CLK, ACLR, ENA, SCLR, SLOAD, SDATA,
    output reg Q
);
    initial Q = 1'b0;
    always @(posedge CLK)
        if (!ACLR) Q <= 1'b0;
        else if (ENA) Q <= !SCLR & (SLOAD ? SDATA : DATAIN);
endmodule

// A1EN is active low; a word read while it is written gives the old one.
module MISTRAL_M10K #(
    parameter CFG_ABITS = 10,
    parameter CFG_DBITS = 10,
    parameter [(CFG_DBITS << CFG_ABITS) - 1:0] INIT = 0  // from Yosys 0.5x on
) (
    input wire                 CLK1,
    input wire [CFG_ABITS-1:0] A1ADDR,
    input wire [CFG_DBITS-1:0] A1DATA,
    input wire                 A1EN,
    input wire [CFG_ABITS-1:0] B1ADDR,
    output reg [CFG_DBITS-1:0] B1DATA,
    input wire                 B1EN
);
    reg [CFG_DBITS-1:0] mem [0:(1 << CFG_ABITS) - 1];
    integer i;
    initial
        for (i = 0; i < 1 << CFG_ABITS; i = i + 1) mem[i] = INIT[i * CFG_DBITS +: CFG_DBITS];
    always @(posedge CLK1) begin
        if (!A1EN) mem[A1ADDR] <= A1DATA;
        if (B1EN) B1DATA <= mem[B1ADDR];
    end
endmodule

module MISTRAL_CLKBUF (input wire A, output wire Q);
    assign Q = A;
endmodule

module MISTRAL_IB (input wire PAD, output wire O);
    assign O = PAD;
endmodule

module MISTRAL_OB (output wire PAD, input wire I);
    assign PAD = I;
endmodule

`default_nettype wire

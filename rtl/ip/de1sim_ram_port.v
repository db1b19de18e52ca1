// de1sim_ram_port.v - a port of altsyncram: what it asks of the memory, and its output
//
// at_o says which word the port means, old_i what the memory has there now; while strobe_o is 1
// at the clock of the address, the memory takes new_o.

`default_nettype none
// Strings of different lengths are compared, and parameters with numbers.
// verilator lint_off WIDTH

module de1sim_ram_port #(
    parameter WIDTH         = 1,
    parameter WIDTHAD       = 1,
    parameter BYTES         = 1,               // bits of byteena
    parameter ADDRESS_REG   = "CLOCK0",
    parameter OUTDATA_REG   = "UNREGISTERED",  // or CLOCK0, CLOCK1
    parameter OUTDATA_ACLR  = "NONE",          // or CLEAR0, CLEAR1
    parameter ENABLE        = "NORMAL",        // clocken0 or 1; ALTERNATE 2 or 3; BYPASS none
    parameter ENABLE_OUTPUT = "NORMAL",
    parameter MODE          = "NEW_DATA_NO_NBE_READ"
) (
    input  wire [1:0]         clock_i,
    input  wire [3:0]         clocken_i,
    input  wire [1:0]         aclr_i,

    input  wire [WIDTHAD-1:0] address_i,
    input  wire               stall_i,         // the address of before
    input  wire               wren_i,
    input  wire               rden_i,
    input  wire [BYTES-1:0]   byteena_i,
    input  wire [WIDTH-1:0]   data_i,
    output wire [WIDTH-1:0]   q_o,

    output wire [WIDTHAD-1:0] at_o,
    input  wire [WIDTH-1:0]   old_i,
    output wire               strobe_o,
    output wire [WIDTH-1:0]   new_o
);
    // ---- The address --------------------------------------------------------
    localparam IN = ADDRESS_REG == "CLOCK1";
    wire clock  = clock_i[IN];
    wire enable = ENABLE == "BYPASS" || clocken_i[ENABLE == "ALTERNATE" ? IN + 2 : IN];

    reg [WIDTHAD-1:0] held_q;
    assign at_o = stall_i ? held_q : address_i;
    always @(posedge clock) if (enable) held_q <= at_o;

    // ---- What is written ----------------------------------------------------
    wire [WIDTH-1:0] mask;
    genvar i;
    generate
        if (BYTES == 1) begin : word
            assign mask = {WIDTH{1'b1}};
            assign strobe_o = enable && wren_i && byteena_i[0];
        end else begin : some
            for (i = 0; i < BYTES; i = i + 1) begin : bytes
                assign mask[WIDTH / BYTES * i +: WIDTH / BYTES] = {WIDTH / BYTES{byteena_i[i]}};
            end
            assign strobe_o = enable && wren_i;
        end
    endgenerate
    assign new_o = data_i & mask | old_i & ~mask;

    // ---- What is read -------------------------------------------------------
    // The clear is that of the output register, or without one that of the memory's own latch.
    localparam REGISTERED = OUTDATA_REG != "UNREGISTERED";
    wire clear = OUTDATA_ACLR == "CLEAR0" && aclr_i[0] || OUTDATA_ACLR == "CLEAR1" && aclr_i[1];
    wire clear_latch = clear && !REGISTERED;

    reg [WIDTH-1:0] latch_q;
    always @(posedge clock or posedge clear_latch)
        if (clear_latch) latch_q <= 0;
        else if (enable && rden_i) latch_q <= strobe_o && MODE != "OLD_DATA" ? new_o : old_i;

    generate
        if (REGISTERED) begin : registered
            localparam OUT = OUTDATA_REG == "CLOCK1";
            wire enable_output = ENABLE_OUTPUT == "BYPASS"
                                 || clocken_i[ENABLE_OUTPUT == "ALTERNATE" ? OUT + 2 : OUT];
            reg [WIDTH-1:0] q;
            always @(posedge clock_i[OUT] or posedge clear)
                if (clear) q <= 0;
                else if (enable_output) q <= latch_q;
            assign q_o = q;
        end else begin : unregistered
            assign q_o = latch_q;
        end
    endgenerate
// verilator lint_on WIDTH
endmodule

`default_nettype wire

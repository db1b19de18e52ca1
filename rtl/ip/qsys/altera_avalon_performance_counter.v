// altera_avalon_performance_counter.v - Platform Designer's performance counter: a clock of the
// whole and of 1 to 7 sections of a program, and how often each began
//
// Words 4n, 4n + 1 and 4n + 2 are of section n: its clocks, lower and upper word, and how often it
// began.  Writing 4n + 1 begins it, writing 4n ends it.  Section 0 is the whole: the others count
// within it, and a 1 in bit 0 that is written to word 0 makes all 0, ended.
//
// Source: Embedded Peripherals IP User Guide, Performance Counter Core.

`default_nettype none

module altera_avalon_performance_counter #(
    parameter SECTIONS = 3,
    parameter ADDRESS  = 4   // bits
) (
    input  wire               clk,
    input  wire               reset_n,
    input  wire [ADDRESS-1:0] address,
    input  wire               begintransfer,
    input  wire               write,
    // verilator lint_off UNUSED
    input  wire [31:0]        writedata,  // of which bit 0 counts
    // verilator lint_on UNUSED
    output reg  [31:0]        readdata
);
    reg  [63:0] clocks_q [0:SECTIONS];
    reg  [31:0] times_q [0:SECTIONS];
    reg         on_q [0:SECTIONS];

    wire        writes = write && begintransfer;
    wire        clears = writes && address == {ADDRESS{1'b0}} && writedata[0];
    wire        begins = writes && address == {{ADDRESS - 1{1'b0}}, 1'b1};
    wire        whole  = on_q[0] || begins;

    integer n;
    always @(posedge clk) begin
        for (n = 0; n <= SECTIONS; n = n + 1) begin
            if (on_q[n] && whole) clocks_q[n] <= clocks_q[n] + 64'd1;
            if (writes && address == {n[ADDRESS-3:0], 2'd0}) on_q[n] <= 1'b0;
            if (writes && address == {n[ADDRESS-3:0], 2'd1}) begin
                on_q[n] <= 1'b1;
                if (whole) times_q[n] <= times_q[n] + 32'd1;
            end
            if (clears || !reset_n) begin
                clocks_q[n] <= 64'd0;
                times_q[n]  <= 32'd0;
                on_q[n]     <= 1'b0;
            end
        end
        readdata <= 32'd0;
        for (n = 0; n <= SECTIONS; n = n + 1)
            if (address[ADDRESS-1:2] == n[ADDRESS-3:0])
                readdata <= address[1:0] == 2'd0 ? clocks_q[n][31:0]
                            : address[1:0] == 2'd1 ? clocks_q[n][63:32]
                            : address[1:0] == 2'd2 ? times_q[n] : 32'd0;
    end
endmodule

`default_nettype wire

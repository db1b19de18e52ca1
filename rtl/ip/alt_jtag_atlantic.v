// alt_jtag_atlantic.v - Quartus' port of a JTAG UART to the terminal on a PC
//
//   r_ena    the PC takes a byte in this clock, if there is one
//   r_val    one clock later: here it is, in r_dat
//   t_dav    there is room for a byte
//   t_ena    a byte from the PC, in t_dat
//   t_pause  the PC has looked and has nothing to send
//
// The PC looks every millisecond.  It takes up to 64 bytes and sends one.
//
// Source: the Verilog of the JTAG UART that Platform Designer generates.

`default_nettype none

module alt_jtag_atlantic #(
    // verilator lint_off UNUSED
    parameter instance_id = 0, INSTANCE_ID = instance_id,
    parameter log2_rxfifo_depth = 3, LOG2_RXFIFO_DEPTH = log2_rxfifo_depth,
    parameter log2_txfifo_depth = 3, LOG2_TXFIFO_DEPTH = log2_txfifo_depth,
    parameter sld_auto_instance_index = "NO", SLD_AUTO_INSTANCE_INDEX = sld_auto_instance_index
    // verilator lint_on UNUSED
) (
    input  wire       clk,
    input  wire       rst_n,
    input  wire [7:0] r_dat,
    input  wire       r_val,
    output wire       r_ena,
    input  wire       t_dav,
    output reg        t_ena,
    output reg  [7:0] t_dat,
    output reg        t_pause
);
    `include "de1sim_jtag.vh"

    localparam [6:0] PACKET = 7'd64;

    integer   number;
    // verilator lint_off UNUSED
    integer   answer;
    // verilator lint_on UNUSED
    initial number = de1sim_jtag_open();

    reg [7:0] clocks_q = 8'd0;   // since the PC was asked last
    reg [6:0] taken_q  = PACKET;  // bytes since the PC has looked
    reg       asked_q  = 1'b0;

    assign r_ena = !asked_q && taken_q != PACKET;

    // verilator lint_off BLKSEQ
    always @(posedge clk) begin
        if (!rst_n) begin
            {t_ena, t_pause, asked_q} <= 3'd0;
            taken_q <= PACKET;
        end else begin
            {t_ena, t_pause} <= 2'b00;
            asked_q  <= r_ena;
            clocks_q <= clocks_q + 8'd1;
            if (r_val) begin
                de1sim_jtag_sent(number, {24'd0, r_dat});
                taken_q <= taken_q + 7'd1;
            end
            if (clocks_q == 8'd0) begin
                answer = de1sim_jtag_look(number, {31'd0, t_dav});
                if (answer[0]) taken_q <= 7'd0;
                t_ena   <= answer[1];
                t_dat   <= answer[15:8];
                t_pause <= answer[2];
            end
        end
    end
    // verilator lint_on BLKSEQ
endmodule

`default_nettype wire

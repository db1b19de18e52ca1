// axi_read.v - AXI3 read channels to register-bus reads, one burst at a time
//
//   clk      _/0\_/1\_/2\_/3\_/4\_
//   AR       =A0=
//   re_o         =A0=                held, with raddr_o, until rgrant_i
//   rdone_i          =D0=            any number of clocks after the grant, with rdata_i
//   R                    =D0=        held until RREADY; then the next beat's re_o
//
// INCR bursts of 1 to 16 beats, beats of 1, 2 or 4 bytes, unaligned starts: every beat returns the
// whole word that holds it, and the master takes its lanes.  FIXED, WRAP and beats wider than the
// bus: SLVERR on every beat, and nothing is read.
//
// Not handled: exclusive access (answered OKAY, so the master sees that it failed).

`default_nettype none

module axi_read #(
    parameter ADDR_W = 21,
    parameter ID_W   = 12
) (
    input  wire              clk_i,
    input  wire              rst_i,

    input  wire [ID_W-1:0]   arid_i,
    input  wire [ADDR_W-1:0] araddr_i,
    input  wire [3:0]        arlen_i,     // beats - 1
    input  wire [2:0]        arsize_i,    // log2(bytes per beat)
    input  wire [1:0]        arburst_i,
    input  wire              arvalid_i,
    output wire              arready_o,

    output reg  [ID_W-1:0]   rid_o,
    output reg  [31:0]       rdata_o,
    output reg  [1:0]        rresp_o,
    output wire              rlast_o,
    output reg               rvalid_o,
    input  wire              rready_i,

    output reg               re_o,
    output wire [ADDR_W-1:0] raddr_o,     // word aligned
    output wire              rlow_o,      // the word's lowest byte is read, too
    input  wire              rgrant_i,
    input  wire              rdone_i,
    input  wire [31:0]       rdata_i,

    output wire              awake_o
);
    localparam [1:0] INCR = 2'b01;
    localparam [1:0] OKAY = 2'b00, SLVERR = 2'b10;

    reg              busy_q;      // a burst is under way; otherwise nothing changes here
    reg [ADDR_W-1:0] addr_q;
    reg [3:0]        left_q;      // beats to come after this one
    reg [ADDR_W-1:0] step_q;      // bytes per beat
    reg              refuse_q;    // this kind of burst is refused

    function serves;
        input [1:0] burst;
        input [2:0] size;
        serves = burst == INCR && size <= 3'd2;
    endfunction

    assign awake_o   = busy_q;
    assign arready_o = !busy_q;
    assign rlast_o   = left_q == 4'd0;
    assign raddr_o   = {addr_q[ADDR_W-1:2], 2'b00};
    assign rlow_o    = addr_q[1:0] == 2'b00;

    always @(posedge clk_i) begin
        if (busy_q) begin
            // ---- A beat, from the register bus ----
            if (rgrant_i) re_o <= 1'b0;
            if (rdone_i) begin
                rdata_o  <= rdata_i;
                rresp_o  <= OKAY;
                rvalid_o <= 1'b1;
            end
            // ---- The response ----
            if (rvalid_o && rready_i) begin
                addr_q   <= (addr_q & ~(step_q - 1'b1)) + step_q;
                left_q   <= left_q - 1'b1;
                re_o     <= !rlast_o && !refuse_q;
                rvalid_o <= !rlast_o && refuse_q;
                busy_q   <= !rlast_o;
            end
        end else if (arvalid_i) begin
            busy_q   <= 1'b1;
            rid_o    <= arid_i;
            addr_q   <= araddr_i;
            left_q   <= arlen_i;
            step_q   <= {{ADDR_W-1{1'b0}}, 1'b1} << arsize_i;
            refuse_q <= !serves(arburst_i, arsize_i);
            re_o     <= serves(arburst_i, arsize_i);
            rvalid_o <= !serves(arburst_i, arsize_i);
            rdata_o  <= 32'd0;
            rresp_o  <= SLVERR;
        end
        if (rst_i) begin
            busy_q   <= 1'b0;
            rvalid_o <= 1'b0;
            re_o     <= 1'b0;
        end
    end

endmodule

`default_nettype wire

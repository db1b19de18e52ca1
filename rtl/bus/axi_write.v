// axi_write.v - AXI3 write channels to register-bus writes, one burst at a time
//
//   clk      _/0\_/1\_/2\_/3\_/4\_/5\_
//   AW       =A0=                        accepted when idle
//   W            =D0==D1=                one beat per clock
//   we_o             =D0==D1=            with waddr_o, wdata_o, wstrb_o
//   hold_i                               from one clock after the last we_o: the block is not done
//   B                            =OK=    not while hold_i
//
// INCR bursts of 1 to 16 beats, beats of 1, 2 or 4 bytes, unaligned starts; byte lanes by WSTRB.
// FIXED and WRAP bursts, and beats wider than the bus, are accepted to the end, write nothing, and
// get SLVERR.
//
// Not handled: exclusive access (answered OKAY, so the master sees that it failed), write
// interleaving (no master on the HPS bridges interleaves; WID is ignored).

`default_nettype none

module axi_write #(
    parameter ADDR_W = 21,
    parameter ID_W   = 12
) (
    input  wire              clk_i,
    input  wire              rst_i,

    input  wire [ID_W-1:0]   awid_i,
    input  wire [ADDR_W-1:0] awaddr_i,
    input  wire [3:0]        awlen_i,     // beats - 1
    input  wire [2:0]        awsize_i,    // log2(bytes per beat)
    input  wire [1:0]        awburst_i,
    input  wire              awvalid_i,
    output wire              awready_o,

    input  wire [31:0]       wdata_i,
    input  wire [3:0]        wstrb_i,
    input  wire              wvalid_i,
    output reg               wready_o,

    output reg  [ID_W-1:0]   bid_o,
    output reg  [1:0]        bresp_o,
    output reg               bvalid_o,
    input  wire              bready_i,

    output reg               we_o,
    output reg  [ADDR_W-1:0] waddr_o,     // word aligned
    output reg  [31:0]       wdata_o,
    output reg  [3:0]        wstrb_o,
    input  wire              hold_i,

    output wire              awake_o
);
    localparam [1:0] INCR = 2'b01;
    localparam [1:0] OKAY = 2'b00, SLVERR = 2'b10;

    reg              busy_q;      // a burst is under way; otherwise nothing changes here
    reg [ADDR_W-1:0] addr_q;
    reg [3:0]        left_q;      // beats to come after this one
    reg [ADDR_W-1:0] step_q;      // bytes per beat
    reg              refuse_q;    // this kind of burst is refused
    reg [1:0]        drain_q;     // the last beat is on its way to the block

    assign awake_o   = busy_q;
    assign awready_o = !busy_q;

    always @(posedge clk_i) begin
        if (busy_q) begin
            // ---- A beat, to the register bus ----
            we_o     <= 1'b0;
            drain_q  <= {drain_q[0] || (drain_q[1] && hold_i), 1'b0};
            if (wvalid_i && wready_o) begin
                we_o    <= !refuse_q;
                waddr_o <= {addr_q[ADDR_W-1:2], 2'b00};
                wdata_o <= wdata_i;
                wstrb_o <= wstrb_i;
                addr_q  <= (addr_q & ~(step_q - 1'b1)) + step_q;
                left_q  <= left_q - 1'b1;
                if (left_q == 4'd0) begin
                    wready_o   <= 1'b0;
                    drain_q[0] <= 1'b1;
                end
            end
            // ---- The response ----
            if (drain_q[1] && !hold_i) bvalid_o <= 1'b1;
            if (bvalid_o && bready_i) begin
                bvalid_o <= 1'b0;
                busy_q   <= 1'b0;
            end
        end else if (awvalid_i) begin
            busy_q   <= 1'b1;
            wready_o <= 1'b1;
            bid_o    <= awid_i;
            addr_q   <= awaddr_i;
            left_q   <= awlen_i;
            step_q   <= {{ADDR_W-1{1'b0}}, 1'b1} << awsize_i;
            refuse_q <= awburst_i != INCR || awsize_i > 3'd2;
            bresp_o  <= awburst_i != INCR || awsize_i > 3'd2 ? SLVERR : OKAY;
        end
        if (rst_i) begin
            busy_q   <= 1'b0;
            wready_o <= 1'b0;
            bvalid_o <= 1'b0;
            we_o     <= 1'b0;
            drain_q  <= 2'b00;
        end
    end

endmodule

`default_nettype wire

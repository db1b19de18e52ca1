// sdram.v - arbiter of the SDRAM: the screen first, then the processor
//
// A request must not change until it is taken.  Words that were read come back in the order of the
// requests, each to its requester.

`default_nettype none

module sdram (
    input  wire        clk_i,
    input  wire        rst_i,

    input  wire        screen_req_i,    // reads
    input  wire [23:0] screen_index_i,
    output wire        screen_take_o,
    output wire        screen_valid_o,

    input  wire        req_i,           // processor
    input  wire        we_i,
    input  wire [23:0] index_i,
    input  wire [31:0] wdata_i,
    input  wire [3:0]  wstrb_i,
    output wire        take_o,
    output wire        valid_o,

    output wire [31:0] rdata_o,         // for both

    output wire        dram_cs_no,
    output wire        dram_ras_no,
    output wire        dram_cas_no,
    output wire        dram_we_no,
    output wire [1:0]  dram_ba_o,
    output wire [12:0] dram_addr_o,
    output wire [1:0]  dram_dqm_o,
    output wire [15:0] dram_dq_o,
    output wire        dram_dq_oe_o,
    input  wire [15:0] dram_dq_i,

    output wire        awake_o
);
    // A request for which a row has been opened or closed is served before any other.
    reg        begun_q;                  // the processor's has
    wire       screen = screen_req_i && !begun_q;
    wire       take, valid, controller_awake;
    reg  [3:0] screen_q;                 // the read of 1 to 4 clocks ago was the screen's

    assign screen_take_o  = take && screen;
    assign take_o         = take && !screen;
    assign screen_valid_o = valid && screen_q[3];
    assign valid_o        = valid && !screen_q[3];
    assign awake_o        = controller_awake || begun_q || screen_q != 4'd0;

    always @(posedge clk_i) begin
        begun_q  <= req_i && !screen && !take && !rst_i;
        screen_q <= {screen_q[2:0], screen_take_o};
        if (rst_i) screen_q <= 4'd0;
    end

    sdram_controller controller (
        .clk_i(clk_i), .rst_i(rst_i),
        .req_i(screen || req_i), .we_i(we_i && !screen),
        .index_i(screen ? screen_index_i : index_i),
        .wdata_i(wdata_i), .wstrb_i(wstrb_i), .take_o(take),
        .rvalid_o(valid), .rdata_o(rdata_o),
        .dram_cs_no(dram_cs_no), .dram_ras_no(dram_ras_no), .dram_cas_no(dram_cas_no),
        .dram_we_no(dram_we_no), .dram_ba_o(dram_ba_o), .dram_addr_o(dram_addr_o),
        .dram_dqm_o(dram_dqm_o), .dram_dq_o(dram_dq_o), .dram_dq_oe_o(dram_dq_oe_o),
        .dram_dq_i(dram_dq_i),
        .awake_o(controller_awake)
    );
endmodule

`default_nettype wire

// counter_system.v - a counter with registers, beside the processor: no Platform Designer
//
//   processor - lightweight bridge - axi_registers - counter - digits
//             - interrupt 72 ------------------------+

module counter_system (
    input  wire        clk,
    output wire [15:0] digits
);
    wire        rst_n, irq, write;
    wire [2:0]  number;
    wire [31:0] data, read;

    wire [11:0] awid, bid, arid, rid;
    wire [20:0] awaddr, araddr;
    wire [31:0] wdata, rdata;
    wire [3:0]  arlen;
    wire        awvalid, awready, wlast, wvalid, wready, bvalid, bready;
    wire        arvalid, arready, rlast, rvalid, rready;

    // ---- The processor ----

    cyclonev_hps_interface_clocks_resets resets (
        .h2f_rst_n(rst_n),
        .f2h_cold_rst_req_n(1'b1), .f2h_warm_rst_req_n(1'b1), .f2h_dbg_rst_req_n(1'b1),
        .f2h_pending_rst_ack(1'b1)
    );

    cyclonev_hps_interface_interrupts interrupts (.irq({63'd0, irq}));

    cyclonev_hps_interface_hps2fpga_light_weight bridge (
        .clk(clk),
        .awid(awid), .awaddr(awaddr), .awvalid(awvalid), .awready(awready),
        .wdata(wdata), .wlast(wlast), .wvalid(wvalid), .wready(wready),
        .bid(bid), .bresp(2'b00), .bvalid(bvalid), .bready(bready),
        .arid(arid), .araddr(araddr), .arlen(arlen), .arvalid(arvalid), .arready(arready),
        .rid(rid), .rdata(rdata), .rresp(2'b00), .rlast(rlast), .rvalid(rvalid), .rready(rready)
    );

    // ---- Ours ----

    axi_registers registers (
        .clk(clk), .rst_n(rst_n),
        .awid(awid), .awaddr(awaddr), .awvalid(awvalid), .awready(awready),
        .wdata(wdata), .wlast(wlast), .wvalid(wvalid), .wready(wready),
        .bid(bid), .bvalid(bvalid), .bready(bready),
        .arid(arid), .araddr(araddr), .arlen(arlen), .arvalid(arvalid), .arready(arready),
        .rid(rid), .rdata(rdata), .rlast(rlast), .rvalid(rvalid), .rready(rready),
        .write_o(write), .number_o(number), .data_o(data), .read_i(read)
    );

    counter counter (
        .clk(clk), .rst_n(rst_n), .write(write), .number(number), .data(data), .read(read),
        .irq(irq), .digits(digits)
    );
endmodule

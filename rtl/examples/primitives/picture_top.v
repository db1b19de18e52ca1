// picture_top.v - the monitor shows a picture in the processor's memory: no Platform Designer
//
//   processor - lightweight bridge - axi_registers - base address
//   processor's DDR3 - fpga2sdram, port 0 - line_reader - vga - monitor

module picture_top (
    input  wire       CLOCK_50,
    output wire       VGA_CLK, VGA_HS, VGA_VS, VGA_BLANK_N, VGA_SYNC_N,
    output wire [7:0] VGA_R, VGA_G, VGA_B
);
    wire        rst_n, write;
    wire [2:0]  number;
    wire [31:0] data;
    reg  [31:0] base;    // of the picture; 0: the screen is dark
    reg  [31:0] frames;  // since the reset

    wire [11:0] awid, bid, arid, rid;
    wire [20:0] awaddr, araddr;
    wire [31:0] wdata, rdata;
    wire [3:0]  arlen;
    wire        awvalid, awready, wlast, wvalid, wready, bvalid, bready;
    wire        arvalid, arready, rlast, rvalid, rready;

    wire [28:0] address;  // of words of 64 bits
    wire [7:0]  burstcount;
    wire        read, ready, readdatavalid;
    wire [79:0] readdata;

    // ---- The processor ----

    cyclonev_hps_interface_clocks_resets resets (
        .h2f_rst_n(rst_n),
        .f2h_cold_rst_req_n(1'b1), .f2h_warm_rst_req_n(1'b1), .f2h_dbg_rst_req_n(1'b1),
        .f2h_pending_rst_ack(1'b1)
    );

    cyclonev_hps_interface_hps2fpga_light_weight bridge (
        .clk(CLOCK_50),
        .awid(awid), .awaddr(awaddr), .awvalid(awvalid), .awready(awready),
        .wdata(wdata), .wlast(wlast), .wvalid(wvalid), .wready(wready),
        .bid(bid), .bresp(2'b00), .bvalid(bvalid), .bready(bready),
        .arid(arid), .araddr(araddr), .arlen(arlen), .arvalid(arvalid), .arready(arready),
        .rid(rid), .rdata(rdata), .rresp(2'b00), .rlast(rlast), .rvalid(rvalid), .rready(rready)
    );

    // One port, Avalon-MM of 64 bits, for reads and writes.
    cyclonev_hps_interface_fpga2sdram memory (
        .cfg_axi_mm_select(6'b000000), .cfg_cport_type(12'b000000000011),
        .cfg_port_width(12'b000000000001),
        .cfg_cport_rfifo_map(18'd0), .cfg_cport_wfifo_map(18'd0),
        .cfg_rfifo_cport_map(16'd0), .cfg_wfifo_cport_map(16'd0),
        .cmd_port_clk_0(CLOCK_50), .rd_clk_0(CLOCK_50), .wr_clk_0(CLOCK_50),
        .cmd_valid_0(read), .cmd_ready_0(ready),
        .cmd_data_0({18'd0, burstcount, 3'd0, address, 1'b0, read}),
        .rd_valid_0(readdatavalid), .rd_ready_0(1'b1), .rd_data_0(readdata),
        .wr_data_0(90'd0), .wrack_ready_0(1'b1)
    );

    // ---- Ours ----

    axi_registers registers (
        .clk(CLOCK_50), .rst_n(rst_n),
        .awid(awid), .awaddr(awaddr), .awvalid(awvalid), .awready(awready),
        .wdata(wdata), .wlast(wlast), .wvalid(wvalid), .wready(wready),
        .bid(bid), .bvalid(bvalid), .bready(bready),
        .arid(arid), .araddr(araddr), .arlen(arlen), .arvalid(arvalid), .arready(arready),
        .rid(rid), .rdata(rdata), .rlast(rlast), .rvalid(rvalid), .rready(rready),
        .write_o(write), .number_o(number), .data_o(data), .read_i(number == 0 ? base : frames)
    );

    wire        pixel, line_begins, frame_ends, shows;
    wire [9:0]  column, row;
    wire [15:0] colour;

    always @(posedge CLOCK_50)
        if (!rst_n) begin
            base <= 0;
            frames <= 0;
        end else begin
            if (write && number == 0) base <= data;
            if (frame_ends) frames <= frames + 1;
        end

    vga vga (
        .clk(CLOCK_50), .rst_n(rst_n), .pixel(pixel), .column(column), .row(row),
        .line_begins(line_begins), .frame_ends(frame_ends), .shows(shows),
        .hs_n(VGA_HS), .vs_n(VGA_VS)
    );

    line_reader reader (
        .clk(CLOCK_50), .rst_n(rst_n), .base(base), .begins(line_begins), .row(row),
        .column(column), .colour(colour),
        .address(address), .burstcount(burstcount), .read(read), .ready(ready),
        .readdatavalid(readdatavalid), .readdata(readdata[63:0])
    );

    assign VGA_CLK     = pixel;
    assign VGA_BLANK_N = shows;
    assign VGA_SYNC_N  = 1'b0;
    assign VGA_R = shows ? {colour[15:11], colour[15:13]} : 8'd0;
    assign VGA_G = shows ? {colour[10:5], colour[10:9]} : 8'd0;
    assign VGA_B = shows ? {colour[4:0], colour[4:2]} : 8'd0;
endmodule

// cells_bench.v - double data rate, taps, a small memory, synchroniser and primitives

`default_nettype none

module cells_bench (
    input  wire        clock_i, enable_i, clrn_i, prn_i, aclr_i, sclr_i, oe_i,
    input  wire [3:0]  a_i, b_i,
    input  wire        drive_i,       // somebody outside drives the pins
    input  wire [3:0]  pins_i,
    input  wire        wren_i,
    input  wire [3:0]  byteena_i,

    output wire [3:0]  ddr_o, high_o, low_o, bidir_high_o, bidir_low_o,
    output wire        clock_out_o,
    output wire [7:0]  taps_o,
    output wire [3:0]  shiftout_o,
    output wire [7:0]  memory_o, memory_later_o,
    output wire [1:0]  dout_o,
    output wire [7:0]  source_o,
    output wire        tck_o,
    output wire [7:0]  cells_o,       // dff dffe dffea dffeas tff jkff srff latch
    output wire [5:0]  wires_o,       // lcell carry cascade exp alt_inbuf alt_outbuf
    output wire [3:0]  pad_o,
    output wire        tri_o, iobuf_o, inside_o
);
    // The pins, with what hangs on them.
    wire [3:0] pad;
    wire       tri_pin, iobuf_pin;
    assign pad = drive_i ? pins_i : 4'bz;
    assign tri_pin = drive_i ? pins_i[0] : 1'bz;
    assign iobuf_pin = drive_i ? pins_i[0] : 1'bz;
    assign pad_o = pad;
    assign tri_o = tri_pin;
    assign iobuf_o = iobuf_pin;

    altddio_out #(.WIDTH(4)) ddr (
        .outclock(clock_i), .outclocken(enable_i), .aclr(aclr_i), .aset(1'b0), .sclr(1'b0),
        .sset(1'b0), .oe(1'b1), .datain_h(a_i), .datain_l(b_i), .dataout(ddr_o), .oe_out());

    // A clock for a chip outside.
    altddio_out clock_out (
        .outclock(clock_i), .outclocken(1'b1), .datain_h(1'b0), .datain_l(1'b1),
        .dataout(clock_out_o), .aclr(1'b0), .aset(1'b0), .oe(1'b1), .oe_out(), .sclr(1'b0),
        .sset(1'b0));
    defparam
        clock_out.extend_oe_disable = "OFF",
        clock_out.intended_device_family = "Cyclone V",
        clock_out.invert_output = "OFF",
        clock_out.lpm_hint = "UNUSED",
        clock_out.lpm_type = "altddio_out",
        clock_out.oe_reg = "UNREGISTERED",
        clock_out.power_up_high = "OFF",
        clock_out.width = 1;

    altddio_in #(.WIDTH(4)) in (
        .inclock(clock_i), .inclocken(enable_i), .datain(a_i), .aclr(aclr_i), .dataout_h(high_o),
        .dataout_l(low_o));

    altddio_bidir #(.WIDTH(4)) bidir (
        .inclock(clock_i), .inclocken(1'b1), .outclock(clock_i), .outclocken(1'b1), .oe(oe_i),
        .datain_h(a_i), .datain_l(b_i), .padio(pad), .dataout_h(bidir_high_o),
        .dataout_l(bidir_low_o));

    altshift_taps #(.NUMBER_OF_TAPS(2), .TAP_DISTANCE(3), .WIDTH(4)) shift (
        .clock(clock_i), .clken(enable_i), .aclr(aclr_i), .shiftin(a_i), .taps(taps_o),
        .shiftout(shiftout_o));

    altdpram #(
        .WIDTH(8), .WIDTHAD(4), .WIDTH_BYTEENA(2), .RDADDRESS_REG("UNREGISTERED"),
        .LPM_FILE("small.mif")
    ) memory (
        .inclock(clock_i), .inclocken(1'b1), .wren(wren_i), .wraddress(a_i), .data({b_i, b_i}),
        .byteena(byteena_i[1:0]), .rdaddress(b_i), .q(memory_o));
    altdpram #(
        .WIDTH(8), .WIDTHAD(4), .RDADDRESS_REG("INCLOCK"), .OUTDATA_REG("OUTCLOCK"),
        .OUTDATA_ACLR("ON")
    ) memory_later (
        .inclock(clock_i), .inclocken(1'b1), .outclock(clock_i), .outclocken(enable_i),
        .wren(wren_i), .wraddress(a_i), .data({b_i, b_i}), .byteena(1'b1), .rdaddress(b_i),
        .rden(1'b1), .aclr(aclr_i), .q(memory_later_o));

    altera_std_synchronizer_bundle #(.depth(3), .width(2)) sync (
        .clk(clock_i), .reset_n(clrn_i), .din({b_i[0], a_i[0]}), .dout(dout_o));

    altsource_probe #(.source_width(8), .source_initial_value("5a"), .probe_width(4)) probe (
        .probe(a_i), .source(source_o), .source_clk(clock_i));
    sld_virtual_jtag #(.sld_ir_width(2)) jtag (.tck(tck_o), .tdo(a_i[0]), .ir_out(2'd0));

    dff one (.d(a_i[0]), .clk(clock_i), .clrn(clrn_i), .prn(prn_i), .q(cells_o[0]));
    dffe two (.d(a_i[0]), .clk(clock_i), .clrn(clrn_i), .prn(prn_i), .ena(enable_i),
              .q(cells_o[1]));
    dffea three (.d(a_i[0]), .clk(clock_i), .clrn(clrn_i), .prn(prn_i), .ena(enable_i),
                 .adata(b_i[0]), .aload(b_i[1]), .q(cells_o[2]));
    dffeas four (.d(a_i[0]), .clk(clock_i), .clrn(clrn_i), .prn(prn_i), .ena(enable_i),
                 .asdata(b_i[0]), .aload(1'b0), .sclr(sclr_i), .sload(b_i[2]), .q(cells_o[3]));
    tff five (.t(a_i[0]), .clk(clock_i), .clrn(clrn_i), .prn(prn_i), .q(cells_o[4]));
    jkff six (.j(a_i[0]), .k(b_i[0]), .clk(clock_i), .clrn(clrn_i), .prn(prn_i), .q(cells_o[5]));
    srff seven (.s(a_i[0]), .r(b_i[0]), .clk(clock_i), .clrn(clrn_i), .prn(prn_i),
                .q(cells_o[6]));
    latch eight (.d(a_i[0]), .ena(enable_i), .q(cells_o[7]));

    lcell w0 (.in(a_i[0]), .out(wires_o[0]));
    carry w1 (.in(a_i[0]), .out(wires_o[1]));
    cascade w2 (.in(a_i[0]), .out(wires_o[2]));
    exp w3 (.in(a_i[0]), .out(wires_o[3]));
    alt_inbuf #(.io_standard("LVTTL")) w4 (.i(a_i[0]), .o(wires_o[4]));
    alt_outbuf w5 (.i(a_i[0]), .o(wires_o[5]));
    TRI w6 (.in(a_i[0]), .oe(oe_i), .out(tri_pin));
    alt_iobuf w7 (.i(a_i[0]), .oe(oe_i), .io(iobuf_pin), .o(inside_o));
endmodule

`default_nettype wire

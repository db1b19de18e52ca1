// device_bench.v - the device's primitives for clocks and pins, as wizards instance them

`default_nettype none

module device_bench (
    input  wire [3:0] clocks_i,
    input  wire [1:0] select_i,
    input  wire       ena_i,
    input  wire       i_i, oe_i,
    input  wire       drive_i, pin_i,          // somebody outside drives the pins

    output wire       selected_o,
    output wire [2:0] gated_o, enaout_o,       // at one falling edge, at two, always
    output wire [7:0] counts_o,                // rising edges of gated_o[0]
    output wire       pad_o, drain_o, inside_o,
    output wire       pair_o, pair_bar_o
);
    cyclonev_clkselect select (
        .clkselect(select_i), .inclk(clocks_i), .outclk(selected_o));

    cyclonev_clkena one (
        .ena(ena_i), .enaout(enaout_o[0]), .inclk(clocks_i[0]), .outclk(gated_o[0]));
    defparam
        one.clock_type = "Global Clock",
        one.ena_register_mode = "falling edge",
        one.lpm_type = "cyclonev_clkena";
    cyclonev_clkena #(
        .clock_type("Global Clock"), .ena_register_mode("double register"),
        .ena_register_power_up("low")
    ) two (.ena(ena_i), .enaout(enaout_o[1]), .inclk(clocks_i[0]), .outclk(gated_o[1]));
    cyclonev_clkena #(.ena_register_mode("always enabled")) always_on (
        .ena(ena_i), .enaout(enaout_o[2]), .inclk(clocks_i[0]), .outclk(gated_o[2]));

    reg [7:0] counts_q;
    always @(posedge gated_o[0]) counts_q <= counts_q + 8'd1;
    assign counts_o = counts_q;

    wire pad, drain;
    assign pad = drive_i ? pin_i : 1'bz;
    assign drain = drive_i ? pin_i : 1'bz;
    cyclonev_io_obuf out (
        .i(i_i), .o(pad), .obar(), .oe(oe_i), .dynamicterminationcontrol(1'b0),
        .parallelterminationcontrol({16{1'b0}}), .seriesterminationcontrol({16{1'b0}}),
        .devoe(1'b1));
    defparam
        out.bus_hold = "false",
        out.open_drain_output = "false",
        out.lpm_type = "cyclonev_io_obuf";
    cyclonev_io_obuf #(.open_drain_output("true")) open_drain (
        .i(i_i), .o(drain), .oe(oe_i), .devoe(1'b1));
    cyclonev_io_ibuf in (
        .i(pad), .o(inside_o), .dynamicterminationcontrol(1'b0), .ibar(1'b0));
    defparam
        in.bus_hold = "false",
        in.differential_mode = "false",
        in.lpm_type = "cyclonev_io_ibuf";
    assign pad_o = pad;
    assign drain_o = drain;

    // A pair of pins, as for a memory's clock.
    wire to_pair, to_bar, off, off_bar;
    cyclonev_pseudo_diff_out pair (
        .i(i_i), .o(to_pair), .obar(to_bar), .oein(!oe_i), .oeout(off), .oebout(off_bar),
        .dtcin(1'b0), .dtc(), .dtcbar());
    cyclonev_io_obuf pair_out (.i(to_pair), .oe(!off), .devoe(1'b1), .o(pair_o));
    cyclonev_io_obuf bar_out (.i(to_bar), .oe(!off_bar), .devoe(1'b1), .o(pair_bar_o));
endmodule

`default_nettype wire

// lpm_bench.v - the arithmetic of the LPM library, at common inputs

`default_nettype none

module lpm_bench (
    input  wire        clock_i, enable_i, count_i, up_i,
    input  wire        aclr_i, aset_i, sclr_i, sset_i, load_i, shiftin_i,
    input  wire [7:0]  a_i, b_i,
    input  wire [2:0]  sel_i,

    output wire [3:0]  decade_o, down_o,
    output wire        decade_cout_o, down_cout_o,
    output wire [15:0] product_o, signed_product_o,
    output wire [7:0]  top_product_o,          // two clocks later
    output wire [7:0]  quotient_o, remain_o, signed_quotient_o, signed_remain_o, rounded_quotient_o,
    output wire [7:0]  rounded_remain_o,
    output wire [7:0]  sum_o, difference_o, either_o,
    output wire        sum_cout_o, sum_overflow_o, difference_cout_o, difference_overflow_o,
    output wire [5:0]  compare_o, signed_compare_o,
    output wire [7:0]  left_o, right_o, toggle_o, constant_o, text_constant_o,
    output wire        left_out_o, right_out_o,
    output wire [3:0]  mux_o,
    output wire [7:0]  decode_o
);
    lpm_counter decade (
        .clock(clock_i), .clk_en(enable_i), .cnt_en(count_i), .cin(1'b1), .updown(up_i),
        .aclr(aclr_i), .aset(aset_i), .sclr(sclr_i), .sset(sset_i), .sload(load_i),
        .data(a_i[3:0]), .q(decade_o), .cout(decade_cout_o), .aload(1'b0), .eq());
    defparam
        decade.lpm_width = 4,
        decade.lpm_modulus = 10,
        decade.lpm_direction = "UNUSED",
        decade.lpm_avalue = "7",
        decade.lpm_svalue = 5,
        decade.lpm_port_updown = "PORT_USED",
        decade.lpm_type = "LPM_COUNTER";

    lpm_counter #(.LPM_WIDTH(4), .LPM_DIRECTION("DOWN")) down (
        .clock(clock_i), .clk_en(enable_i), .cnt_en(count_i), .cin(1'b1), .aclr(aclr_i),
        .q(down_o), .cout(down_cout_o));

    lpm_mult #(.LPM_WIDTHA(8), .LPM_WIDTHB(8), .LPM_WIDTHP(16), .LPM_WIDTHS(8)) product (
        .dataa(a_i), .datab(b_i), .sum(a_i), .result(product_o));
    lpm_mult signed_product (.dataa(a_i), .datab(b_i), .result(signed_product_o), .clock(1'b0));
    defparam
        signed_product.lpm_hint = "MAXIMIZE_SPEED=5",
        signed_product.lpm_representation = "SIGNED",
        signed_product.lpm_type = "LPM_MULT",
        signed_product.lpm_widtha = 8,
        signed_product.lpm_widthb = 8,
        signed_product.lpm_widthp = 16;
    lpm_mult #(.LPM_WIDTHA(8), .LPM_WIDTHB(8), .LPM_WIDTHP(8), .LPM_PIPELINE(2)) top_product (
        .dataa(a_i), .datab(b_i), .result(top_product_o), .clock(clock_i), .clken(enable_i),
        .aclr(aclr_i));

    lpm_divide #(.LPM_WIDTHN(8), .LPM_WIDTHD(8)) quotient (
        .numer(a_i), .denom(b_i), .quotient(quotient_o), .remain(remain_o));
    lpm_divide #(
        .LPM_WIDTHN(8), .LPM_WIDTHD(8), .LPM_NREPRESENTATION("SIGNED"),
        .LPM_DREPRESENTATION("SIGNED"), .LPM_REMAINDERPOSITIVE("FALSE")
    ) signed_quotient (
        .numer(a_i), .denom(b_i), .quotient(signed_quotient_o), .remain(signed_remain_o));
    lpm_divide #(
        .LPM_WIDTHN(8), .LPM_WIDTHD(8), .LPM_NREPRESENTATION("SIGNED"),
        .LPM_DREPRESENTATION("SIGNED")
    ) rounded_quotient (
        .numer(a_i), .denom(b_i), .quotient(rounded_quotient_o), .remain(rounded_remain_o));

    lpm_add_sub #(.LPM_WIDTH(8), .LPM_DIRECTION("ADD")) sum (
        .dataa(a_i), .datab(b_i), .cin(shiftin_i), .result(sum_o), .cout(sum_cout_o),
        .overflow(sum_overflow_o));
    lpm_add_sub #(.LPM_WIDTH(8), .LPM_DIRECTION("SUB")) difference (
        .dataa(a_i), .datab(b_i), .result(difference_o), .cout(difference_cout_o),
        .overflow(difference_overflow_o));
    lpm_add_sub #(.LPM_WIDTH(8), .LPM_PIPELINE(1)) either (
        .clock(clock_i), .clken(enable_i), .dataa(a_i), .datab(b_i), .add_sub(up_i),
        .cin(1'b0), .result(either_o));

    lpm_compare #(.LPM_WIDTH(8)) compare (
        .dataa(a_i), .datab(b_i), .alb(compare_o[0]), .aeb(compare_o[1]), .agb(compare_o[2]),
        .aleb(compare_o[3]), .aneb(compare_o[4]), .ageb(compare_o[5]));
    lpm_compare #(.LPM_WIDTH(8), .LPM_REPRESENTATION("SIGNED")) signed_compare (
        .dataa(a_i), .datab(b_i), .alb(signed_compare_o[0]), .aeb(signed_compare_o[1]),
        .agb(signed_compare_o[2]), .aleb(signed_compare_o[3]), .aneb(signed_compare_o[4]),
        .ageb(signed_compare_o[5]));

    lpm_shiftreg #(.LPM_WIDTH(8)) left (
        .clock(clock_i), .enable(enable_i), .load(load_i), .shiftin(shiftin_i), .aclr(aclr_i),
        .aset(aset_i), .sclr(sclr_i), .sset(sset_i), .data(a_i), .q(left_o),
        .shiftout(left_out_o));
    lpm_shiftreg #(.LPM_WIDTH(8), .LPM_DIRECTION("RIGHT"), .LPM_SVALUE("9")) right (
        .clock(clock_i), .enable(enable_i), .load(load_i), .shiftin(shiftin_i), .aclr(aclr_i),
        .sclr(sclr_i), .sset(sset_i), .data(a_i), .q(right_o), .shiftout(right_out_o));
    lpm_ff #(.LPM_WIDTH(8), .LPM_FFTYPE("TFF")) toggle (
        .clock(clock_i), .enable(enable_i), .sload(load_i), .aclr(aclr_i), .sclr(sclr_i),
        .sset(sset_i), .data(a_i), .q(toggle_o));

    lpm_constant #(.LPM_WIDTH(8), .LPM_CVALUE(173)) constant (.result(constant_o));
    lpm_constant #(.LPM_WIDTH(8), .LPM_CVALUE("173")) text (.result(text_constant_o));
    lpm_mux #(.LPM_WIDTH(4), .LPM_SIZE(4), .LPM_WIDTHS(2)) mux (
        .data({a_i, b_i}), .sel(sel_i[1:0]), .result(mux_o));
    lpm_decode #(.LPM_WIDTH(3)) decode (.data(sel_i), .enable(enable_i), .eq(decode_o));
endmodule

`default_nettype wire

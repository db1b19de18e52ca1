// floats_bench.v - Intel's floating-point functions, of single and double precision

`default_nettype none

module floats_bench (
    input  wire        clock_i, enable_i, aclr_i, add_i,
    input  wire [31:0] a_i, b_i,
    input  wire [63:0] wide_a_i, wide_b_i,

    output wire [31:0] sum_o, difference_o, product_o, quotient_o, root_o,
    output wire [63:0] wide_sum_o, wide_product_o, wide_quotient_o, wide_root_o,
    // overflow, underflow, zero, nan
    output wire [3:0]  sum_flags_o, product_flags_o, quotient_flags_o,
    output wire [2:0]  root_flags_o,          // overflow, zero, nan
    output wire        by_zero_o,
    output wire [6:0]  compared_o, wide_compared_o  // aeb, aneb, agb, ageb, alb, aleb, unordered
);
    altfp_add_sub sum (
        .clock(clock_i), .clk_en(enable_i), .aclr(aclr_i), .dataa(a_i), .datab(b_i),
        .add_sub(add_i), .result(sum_o), .overflow(sum_flags_o[3]), .underflow(sum_flags_o[2]),
        .zero(sum_flags_o[1]), .nan(sum_flags_o[0]));
    defparam
        sum.direction = "VARIABLE",
        sum.pipeline = 7,
        sum.width_exp = 8,
        sum.width_man = 23;
    altfp_add_sub #(.DIRECTION("SUB"), .PIPELINE(7)) difference (
        .clock(clock_i), .clk_en(enable_i), .aclr(aclr_i), .dataa(a_i), .datab(b_i),
        .result(difference_o));
    altfp_add_sub #(.WIDTH_EXP(11), .WIDTH_MAN(52), .PIPELINE(7)) wide_sum (
        .clock(clock_i), .clk_en(enable_i), .aclr(aclr_i), .dataa(wide_a_i), .datab(wide_b_i),
        .result(wide_sum_o));

    altfp_mult product (
        .clock(clock_i), .clk_en(enable_i), .aclr(aclr_i), .dataa(a_i), .datab(b_i),
        .result(product_o), .overflow(product_flags_o[3]), .underflow(product_flags_o[2]),
        .zero(product_flags_o[1]), .nan(product_flags_o[0]));
    altfp_mult #(.WIDTH_EXP(11), .WIDTH_MAN(52)) wide_product (
        .clock(clock_i), .clk_en(enable_i), .aclr(aclr_i), .dataa(wide_a_i), .datab(wide_b_i),
        .result(wide_product_o));

    altfp_div quotient (
        .clock(clock_i), .clk_en(enable_i), .aclr(aclr_i), .dataa(a_i), .datab(b_i),
        .result(quotient_o), .overflow(quotient_flags_o[3]), .underflow(quotient_flags_o[2]),
        .zero(quotient_flags_o[1]), .nan(quotient_flags_o[0]), .division_by_zero(by_zero_o));
    altfp_div #(.WIDTH_EXP(11), .WIDTH_MAN(52), .PIPELINE(10)) wide_quotient (
        .clock(clock_i), .clk_en(enable_i), .aclr(aclr_i), .dataa(wide_a_i), .datab(wide_b_i),
        .result(wide_quotient_o));

    altfp_sqrt #(.PIPELINE(16)) root (
        .clock(clock_i), .clk_en(enable_i), .aclr(aclr_i), .data(a_i), .result(root_o),
        .overflow(root_flags_o[2]), .zero(root_flags_o[1]), .nan(root_flags_o[0]));
    altfp_sqrt #(.WIDTH_EXP(11), .WIDTH_MAN(52), .PIPELINE(30)) wide_root (
        .clock(clock_i), .clk_en(enable_i), .aclr(aclr_i), .data(wide_a_i), .result(wide_root_o));

    altfp_compare compare (
        .clock(clock_i), .clk_en(enable_i), .aclr(aclr_i), .dataa(a_i), .datab(b_i),
        .aeb(compared_o[6]), .aneb(compared_o[5]), .agb(compared_o[4]), .ageb(compared_o[3]),
        .alb(compared_o[2]), .aleb(compared_o[1]), .unordered(compared_o[0]));
    altfp_compare #(.WIDTH_EXP(11), .WIDTH_MAN(52), .PIPELINE(3)) wide_compare (
        .clock(clock_i), .clk_en(enable_i), .aclr(aclr_i), .dataa(wide_a_i), .datab(wide_b_i),
        .aeb(wide_compared_o[6]), .aneb(wide_compared_o[5]), .agb(wide_compared_o[4]),
        .ageb(wide_compared_o[3]), .alb(wide_compared_o[2]), .aleb(wide_compared_o[1]),
        .unordered(wide_compared_o[0]));
endmodule

`default_nettype wire

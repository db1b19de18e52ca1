// de1sim_mult_add.v - one to four products and their sum, with registers between
//
//   a, b -> register -> latency --> product -> register --> p0 +- p1 + p2 +- p3
//   sign -> register -> latency ----^                        ^        |
//   add  -> register -> latency -> register (ADD_n_LATER) ---'        v
//   load -> register -> latency --------------------> accumulator -> register -> result
//
// A clock or clear is 0 to 3, or 4 for none; those of an operand are in a vector, number 0 lowest.
// A_SOURCE and B_SOURCE are those of de1sim_line.vh.

`default_nettype none
// Operands are extended by their signs, and parameters of one bit compared.
// verilator lint_off WIDTH

module de1sim_mult_add #(
    parameter NUMBER = 1, WIDTH_A = 1, WIDTH_B = 1, WIDTH = 1,
    parameter [11:0] A_CLOCK = 12'o4444, A_ACLR = 12'o4444, A_SCLR = 12'o4444,
    parameter [11:0] B_CLOCK = 12'o4444, B_ACLR = 12'o4444, B_SCLR = 12'o4444,
    parameter [11:0] PRODUCT_CLOCK = 12'o4444, PRODUCT_ACLR = 12'o4444, PRODUCT_SCLR = 12'o4444,
    parameter [2:0] SIGN_A_CLOCK = 3'd4, SIGN_A_ACLR = 3'd4, SIGN_A_SCLR = 3'd4,
    parameter [2:0] SIGN_B_CLOCK = 3'd4, SIGN_B_ACLR = 3'd4, SIGN_B_SCLR = 3'd4,
    parameter [2:0] ADD_1_CLOCK = 3'd4, ADD_1_ACLR = 3'd4, ADD_1_SCLR = 3'd4,
    parameter [2:0] ADD_3_CLOCK = 3'd4, ADD_3_ACLR = 3'd4, ADD_3_SCLR = 3'd4,
    parameter [2:0] ADD_1_LATER_CLOCK = 3'd4, ADD_1_LATER_ACLR = 3'd4,
    parameter [2:0] ADD_3_LATER_CLOCK = 3'd4, ADD_3_LATER_ACLR = 3'd4,
    parameter [2:0] RESULT_CLOCK = 3'd4, RESULT_ACLR = 3'd4, RESULT_SCLR = 3'd4,
    parameter [2:0] SCANOUT_CLOCK = 3'd4, SCANOUT_ACLR = 3'd4, SCANOUT_SCLR = 3'd4,
    parameter [2:0] LOAD_CLOCK = 3'd4, LOAD_ACLR = 3'd4, LOAD_SCLR = 3'd4,
    parameter [2:0] LATENCY_CLOCK = 3'd4, LATENCY_ACLR = 3'd4, LATENCY_SCLR = 3'd4,
    parameter LATENCY = 0,
    parameter [7:0] A_SOURCE = 0, B_SOURCE = 0,
    parameter SIGN_A_PORT = 0, SIGN_B_PORT = 0, SIGNED_A = 0, SIGNED_B = 0,
    parameter ADD_1_PORT = 0, ADD_3_PORT = 0, SUBTRACT_1 = 0, SUBTRACT_3 = 0,
    parameter ACCUMULATES = 0, ACCUMULATES_DOWN = 0,
    parameter LOADS_LOW = 0,                   // load_i loads with 0
    parameter LOADED_BIT = 64                  // the bit that is 1 in what is loaded
) (
    input  wire [3:0]                clock_i, ena_i, aclr_i, sclr_i,
    input  wire [NUMBER*WIDTH_A-1:0] a_i,
    input  wire [NUMBER*WIDTH_B-1:0] b_i,
    input  wire [WIDTH_A-1:0]        scan_a_i,
    input  wire [WIDTH_B-1:0]        scan_b_i,
    input  wire [NUMBER-1:0]         source_a_i, source_b_i,
    output wire [WIDTH_A-1:0]        scan_a_o,
    output wire [WIDTH_B-1:0]        scan_b_o,
    input  wire                      sign_a_i, sign_b_i,
    input  wire                      add_1_i, add_3_i,
    input  wire                      load_i,
    output wire [WIDTH-1:0]          result_o
);
    localparam FULL = WIDTH_A + WIDTH_B + 2 > WIDTH ? WIDTH_A + WIDTH_B + 2 : WIDTH;

    // ---- What the whole is told ---------------------------------------------
    wire [4:0] told_now = {load_i, add_3_i, add_1_i, sign_b_i, sign_a_i};
    wire [4:0] told;
    localparam [14:0] TOLD_CLOCK = {LOAD_CLOCK, ADD_3_CLOCK, ADD_1_CLOCK, SIGN_B_CLOCK,
                                    SIGN_A_CLOCK};
    localparam [14:0] TOLD_ACLR = {LOAD_ACLR, ADD_3_ACLR, ADD_1_ACLR, SIGN_B_ACLR, SIGN_A_ACLR};
    localparam [14:0] TOLD_SCLR = {LOAD_SCLR, ADD_3_SCLR, ADD_1_SCLR, SIGN_B_SCLR, SIGN_A_SCLR};
    localparam [14:0] LATER_CLOCK = {3'd4, ADD_3_LATER_CLOCK, ADD_1_LATER_CLOCK, 6'o44};
    localparam [14:0] LATER_ACLR = {3'd4, ADD_3_LATER_ACLR, ADD_1_LATER_ACLR, 6'o44};
    genvar i;
    generate
        for (i = 0; i < 5; i = i + 1) begin : each_told
            wire at_input, after_latency;
            de1sim_mult_add_register #(
                .CLOCK(TOLD_CLOCK[3*i +: 3]), .ACLR(TOLD_ACLR[3*i +: 3]),
                .SCLR(TOLD_SCLR[3*i +: 3])
            ) first (
                .clock_i(clock_i), .ena_i(ena_i), .aclr_i(aclr_i), .sclr_i(sclr_i),
                .d_i(told_now[i]), .q_o(at_input));
            de1sim_mult_add_register #(
                .STAGES(LATENCY), .CLOCK(LATENCY_CLOCK), .ACLR(LATENCY_ACLR), .SCLR(LATENCY_SCLR)
            ) latency (
                .clock_i(clock_i), .ena_i(ena_i), .aclr_i(aclr_i), .sclr_i(sclr_i),
                .d_i(at_input), .q_o(after_latency));
            de1sim_mult_add_register #(
                .CLOCK(LATER_CLOCK[3*i +: 3]), .ACLR(LATER_ACLR[3*i +: 3])
            ) later (
                .clock_i(clock_i), .ena_i(ena_i), .aclr_i(aclr_i), .sclr_i(sclr_i),
                .d_i(after_latency), .q_o(told[i]));
        end
    endgenerate
    wire signed_a = SIGN_A_PORT ? told[0] : SIGNED_A;
    wire signed_b = SIGN_B_PORT ? told[1] : SIGNED_B;
    wire minus_1 = ADD_1_PORT ? !told[2] : SUBTRACT_1;
    wire minus_3 = ADD_3_PORT ? !told[3] : SUBTRACT_3;

    // ---- The operands and their products ------------------------------------
    wire [(NUMBER+1)*WIDTH_A-1:0] scan_a;      // what each hands on, after what comes in
    wire [(NUMBER+1)*WIDTH_B-1:0] scan_b;
    wire [4*FULL-1:0]             products;
    assign scan_a[WIDTH_A-1:0] = scan_a_i;
    assign scan_b[WIDTH_B-1:0] = scan_b_i;
    generate
        for (i = 0; i < 4; i = i + 1) begin : multiplier
            if (i < NUMBER) begin : there
                wire next_a = A_SOURCE[2*i +: 2] == 1 || A_SOURCE[2*i +: 2] == 2 && source_a_i[i];
                wire next_b = B_SOURCE[2*i +: 2] == 1 || B_SOURCE[2*i +: 2] == 2 && source_b_i[i];
                wire [WIDTH_A-1:0] a;
                wire [WIDTH_B-1:0] b;
                de1sim_mult_add_register #(
                    .WIDTH(WIDTH_A), .CLOCK(A_CLOCK[3*i +: 3]), .ACLR(A_ACLR[3*i +: 3]),
                    .SCLR(A_SCLR[3*i +: 3])
                ) input_a (
                    .clock_i(clock_i), .ena_i(ena_i), .aclr_i(aclr_i), .sclr_i(sclr_i),
                    .d_i(next_a ? scan_a[WIDTH_A*i +: WIDTH_A] : a_i[WIDTH_A*i +: WIDTH_A]),
                    .q_o(scan_a[WIDTH_A*(i+1) +: WIDTH_A]));
                de1sim_mult_add_register #(
                    .WIDTH(WIDTH_B), .CLOCK(B_CLOCK[3*i +: 3]), .ACLR(B_ACLR[3*i +: 3]),
                    .SCLR(B_SCLR[3*i +: 3])
                ) input_b (
                    .clock_i(clock_i), .ena_i(ena_i), .aclr_i(aclr_i), .sclr_i(sclr_i),
                    .d_i(next_b ? scan_b[WIDTH_B*i +: WIDTH_B] : b_i[WIDTH_B*i +: WIDTH_B]),
                    .q_o(scan_b[WIDTH_B*(i+1) +: WIDTH_B]));
                de1sim_mult_add_register #(
                    .WIDTH(WIDTH_A + WIDTH_B), .STAGES(LATENCY), .CLOCK(LATENCY_CLOCK),
                    .ACLR(LATENCY_ACLR), .SCLR(LATENCY_SCLR)
                ) latency (
                    .clock_i(clock_i), .ena_i(ena_i), .aclr_i(aclr_i), .sclr_i(sclr_i),
                    .d_i({scan_a[WIDTH_A*(i+1) +: WIDTH_A], scan_b[WIDTH_B*(i+1) +: WIDTH_B]}),
                    .q_o({a, b}));

                wire [FULL-1:0] full_a = {{FULL{signed_a && a[WIDTH_A-1]}}, a};
                wire [FULL-1:0] full_b = {{FULL{signed_b && b[WIDTH_B-1]}}, b};
                de1sim_mult_add_register #(
                    .WIDTH(FULL), .CLOCK(PRODUCT_CLOCK[3*i +: 3]),
                    .ACLR(PRODUCT_ACLR[3*i +: 3]), .SCLR(PRODUCT_SCLR[3*i +: 3])
                ) product (
                    .clock_i(clock_i), .ena_i(ena_i), .aclr_i(aclr_i), .sclr_i(sclr_i),
                    .d_i(full_a * full_b), .q_o(products[FULL*i +: FULL]));
            end else begin : missing
                assign products[FULL*i +: FULL] = {FULL{1'b0}};
            end
        end
    endgenerate
    assign scan_b_o = scan_b[WIDTH_B*NUMBER +: WIDTH_B];
    de1sim_mult_add_register #(
        .WIDTH(WIDTH_A), .CLOCK(SCANOUT_CLOCK), .ACLR(SCANOUT_ACLR), .SCLR(SCANOUT_SCLR)
    ) scanout (
        .clock_i(clock_i), .ena_i(ena_i), .aclr_i(aclr_i), .sclr_i(sclr_i),
        .d_i(scan_a[WIDTH_A*NUMBER +: WIDTH_A]), .q_o(scan_a_o));

    // ---- Their sum, and what was there before -------------------------------
    wire [FULL-1:0] p0 = products[FULL-1:0], p1 = products[2*FULL-1:FULL];
    wire [FULL-1:0] p2 = products[3*FULL-1:2*FULL], p3 = products[4*FULL-1:3*FULL];
    wire [FULL-1:0] sum = (minus_1 ? p0 - p1 : p0 + p1) + (minus_3 ? p2 - p3 : p2 + p3);

    wire load = LOADS_LOW ? LOAD_CLOCK == 4 || !told[4] : LOAD_CLOCK != 4 && told[4];
    wire [FULL-1:0] loaded = LOADED_BIT < WIDTH ? {{FULL{1'b0}}, 1'b1} << LOADED_BIT : 0;
    wire [FULL-1:0] kept = load ? loaded : result_o;
    wire [FULL-1:0] now = !ACCUMULATES ? sum : ACCUMULATES_DOWN ? kept - sum : kept + sum;
    de1sim_mult_add_register #(
        .WIDTH(WIDTH), .CLOCK(RESULT_CLOCK), .ACLR(RESULT_ACLR), .SCLR(RESULT_SCLR)
    ) result (
        .clock_i(clock_i), .ena_i(ena_i), .aclr_i(aclr_i), .sclr_i(sclr_i),
        .d_i(now[WIDTH-1:0]), .q_o(result_o));
// verilator lint_on WIDTH
endmodule

`default_nettype wire

// altsqrt.v - the integer square root and what remains, with a pipeline
//
// q is the largest number of which the square is not above radical; remainder is radical - q * q.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module altsqrt #(
    parameter width = 1, WIDTH = width,
    parameter q_port_width = 1, Q_PORT_WIDTH = q_port_width,
    parameter r_port_width = 1, R_PORT_WIDTH = r_port_width,
    parameter pipeline = 0, PIPELINE = pipeline,
    // Without meaning here.
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "altsqrt", LPM_TYPE = lpm_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family
) (
    input  wire                    clk, ena, aclr,
    input  wire [WIDTH-1:0]        radical,
    output wire [Q_PORT_WIDTH-1:0] q,
    output wire [R_PORT_WIDTH-1:0] remainder
);
    localparam DIGITS = (WIDTH + 1) / 2;        // of the root

    // By hand, as one divides: two bits of the radical for each of the root.
    integer i;
    reg [2*DIGITS-1:0] rest;
    reg [DIGITS-1:0]   root;
    reg [DIGITS+1:0]   remain, try;             // below 2 * root + 1 before each step
    always @* begin
        rest = radical;
        root = 0;
        remain = 0;
        for (i = 0; i < DIGITS; i = i + 1) begin
            remain = {remain[DIGITS-1:0], rest[2*DIGITS-1 -: 2]};
            rest = rest << 2;
            try = {root, 2'b01};
            root = root << 1;
            if (remain >= try) begin
                remain = remain - try;
                root[0] = 1;
            end
        end
    end

    wire [Q_PORT_WIDTH-1:0] q_now = root;
    wire [R_PORT_WIDTH-1:0] remainder_now = remain;
    de1sim_pipeline #(.WIDTH(Q_PORT_WIDTH + R_PORT_WIDTH), .STAGES(PIPELINE)) registers (
        .clock_i(clk), .clken_i(ena), .aclr_i(aclr), .sclr_i(1'b0),
        .d_i({q_now, remainder_now}), .q_o({q, remainder}));
// verilator lint_on WIDTH
endmodule

`default_nettype wire

// altshift_taps.v - a long shift register, its values visible every TAP_DISTANCE clocks
//
// taps[WIDTH*i +: WIDTH] is what came in (i + 1) * TAP_DISTANCE clocks ago; shiftout is the last.
// aclr clears what the taps show, and what is between them.

`default_nettype none
// Texts of different lengths, and parameters with numbers.
// verilator lint_off WIDTH

module altshift_taps #(
    parameter number_of_taps = 4, NUMBER_OF_TAPS = number_of_taps,
    parameter tap_distance = 3, TAP_DISTANCE = tap_distance,
    parameter width = 8, WIDTH = width,
    // Without meaning here.
    parameter power_up_state = "CLEARED", POWER_UP_STATE = power_up_state,
    parameter tapcnt = 0, TAPCNT = tapcnt,
    parameter maximum_depth = 0, MAXIMUM_DEPTH = maximum_depth,
    parameter ram_block_type = "AUTO", RAM_BLOCK_TYPE = ram_block_type,
    parameter intended_device_family = "UNUSED", INTENDED_DEVICE_FAMILY = intended_device_family,
    parameter lpm_hint = "UNUSED", LPM_HINT = lpm_hint,
    parameter lpm_type = "altshift_taps", LPM_TYPE = lpm_type
) (
    input  wire                            clock, clken, aclr, sclr,
    input  wire [WIDTH-1:0]                shiftin,
    output wire [WIDTH-1:0]                shiftout,
    output wire [WIDTH*NUMBER_OF_TAPS-1:0] taps
);
    // A ring of memory for each distance: the place that is written next has its oldest value.
    // Since a clear, `valid` says whether the ring has come round.
    reg [31:0] at_q, since_q;
    wire round = at_q == TAP_DISTANCE - 1;
    always @(posedge clock or posedge aclr)
        if (aclr) begin
            at_q <= 0;
            since_q <= 0;
        end else if (clken) begin
            at_q <= sclr || round ? 0 : at_q + 1;
            if (sclr) since_q <= 0;
            else if (since_q != NUMBER_OF_TAPS * TAP_DISTANCE) since_q <= since_q + 1;
        end

    wire [WIDTH*(NUMBER_OF_TAPS+1)-1:0] chain;
    assign chain[WIDTH-1:0] = shiftin;
    genvar i;
    generate
        for (i = 0; i < NUMBER_OF_TAPS; i = i + 1) begin : tap
            reg [WIDTH-1:0] ring [0:TAP_DISTANCE-1];
            always @(posedge clock) if (clken) ring[at_q] <= chain[WIDTH*i +: WIDTH];
            wire valid = since_q >= (i + 1) * TAP_DISTANCE;
            assign chain[WIDTH*(i+1) +: WIDTH] = valid ? ring[at_q] : {WIDTH{1'b0}};
        end
    endgenerate

    assign taps = chain[WIDTH*(NUMBER_OF_TAPS+1)-1:WIDTH];
    assign shiftout = chain[WIDTH*(NUMBER_OF_TAPS+1)-1 -: WIDTH];
// verilator lint_on WIDTH
endmodule

`default_nettype wire

// de1sim_up_clipper.v - the University Program's clipper: takes pixels away from a picture's edges,
// and adds others
//
// A picture that ends before WIDTH x HEIGHT pixels goes on with pixels of VALUE.  What comes
// between the end of a picture and the begin of the next is lost.

`default_nettype none

module de1sim_up_clipper #(
    parameter            BITS   = 16,
    parameter            WIDTH  = 720,  // of what comes in
    parameter            HEIGHT = 244,
    parameter            DROP_LEFT = 0, DROP_RIGHT = 0, DROP_TOP = 0, DROP_BOTTOM = 0,
    parameter            ADD_LEFT = 0, ADD_RIGHT = 0, ADD_TOP = 0, ADD_BOTTOM = 0,
    parameter [BITS-1:0] VALUE  = 0     // of a pixel that is added
) (
    input  wire           clk,
    input  wire           reset,
    input  wire [BITS-1:0]  stream_in_data,
    input  wire           stream_in_startofpacket,
    input  wire           stream_in_endofpacket,
    input  wire           stream_in_valid,
    output wire           stream_in_ready,
    output wire [BITS-1:0] stream_out_data,
    output wire           stream_out_startofpacket,
    output wire           stream_out_endofpacket,
    output wire           stream_out_valid,
    input  wire           stream_out_ready
);
    localparam [1:0] WAITS = 2'd0, RUNS = 2'd1, FILLS = 2'd2;
    localparam       MIDDLE_X = WIDTH - DROP_LEFT - DROP_RIGHT;
    localparam       MIDDLE_Y = HEIGHT - DROP_TOP - DROP_BOTTOM;
    localparam       LAST_X = MIDDLE_X + ADD_LEFT + ADD_RIGHT - 1;
    localparam       LAST_Y = MIDDLE_Y + ADD_TOP + ADD_BOTTOM - 1;

    // ---- The middle of the picture ----------------------------------------
    reg  [1:0]  state_q;
    reg  [15:0] x_q, y_q;
    // Without pixels at an edge the comparison with it is constant.
    // verilator lint_off UNSIGNED
    wire        middle = x_q >= DROP_LEFT && x_q < DROP_LEFT + MIDDLE_X
                         && y_q >= DROP_TOP && y_q < DROP_TOP + MIDDLE_Y;
    // verilator lint_on UNSIGNED
    wire        valid  = state_q == FILLS || (state_q == RUNS && stream_in_valid);
    wire        ready;    // for a pixel of the middle
    wire        goes   = valid && (!middle || ready);
    wire        last_x = x_q == WIDTH - 1, last_y = y_q == HEIGHT - 1;

    assign stream_in_ready = state_q == WAITS ? !(stream_in_valid && stream_in_startofpacket)
                                              : state_q == RUNS && (!middle || ready);

    always @(posedge clk) begin
        if (state_q == WAITS && stream_in_valid && stream_in_startofpacket) state_q <= RUNS;
        if (goes) begin
            x_q <= last_x ? 16'd0 : x_q + 16'd1;
            if (last_x) y_q <= last_y ? 16'd0 : y_q + 16'd1;
            if (last_x && last_y) state_q <= WAITS;
            else if (stream_in_endofpacket) state_q <= FILLS;
        end
        if (reset) begin
            state_q    <= WAITS;
            {x_q, y_q} <= 32'd0;
        end
    end

    // ---- The picture with what is added -----------------------------------
    reg  [15:0] out_x_q, out_y_q;
    // verilator lint_off UNSIGNED
    wire        adds   = out_x_q < ADD_LEFT || out_x_q >= ADD_LEFT + MIDDLE_X
                         || out_y_q < ADD_TOP || out_y_q >= ADD_TOP + MIDDLE_Y;
    // verilator lint_on UNSIGNED
    wire        last_out = out_x_q == LAST_X;

    assign ready                    = !adds && stream_out_ready;
    assign stream_out_data          = adds || state_q == FILLS ? VALUE : stream_in_data;
    assign stream_out_startofpacket = out_x_q == 16'd0 && out_y_q == 16'd0;
    assign stream_out_endofpacket   = last_out && out_y_q == LAST_Y;
    assign stream_out_valid         = adds || (valid && middle);

    always @(posedge clk) begin
        if (stream_out_valid && stream_out_ready) begin
            out_x_q <= last_out ? 16'd0 : out_x_q + 16'd1;
            if (last_out) out_y_q <= out_y_q == LAST_Y ? 16'd0 : out_y_q + 16'd1;
        end
        if (reset) {out_x_q, out_y_q} <= 32'd0;
    end
endmodule

`default_nettype wire

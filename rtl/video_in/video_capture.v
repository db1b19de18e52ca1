// video_capture.v - the part of video-in on the decoder's clock: bytes to words of two pixels
//
//   TD_DATA --> bt656_rx --+--> Y, Cb, Cr ---+--> ycbcr_to_rgb --> two pixels --> word_o
//                          +--> sobel -- Y --+
//
// With edges_i a pixel is as bright as the edge, without colour.  A word is pushed every eight
// clocks while a row comes in.

`default_nettype none

module video_capture (
    input  wire        clk_i,      // 27 MHz, the decoder's
    input  wire        enable_i,   // these two asynchronous
    input  wire        edges_i,
    input  wire [7:0]  data_i,

    output wire        push_o,
    output wire [33:0] word_o,     // first of a picture, of a row; right pixel, left pixel

    output wire        awake_o     // although enable_i is low: it has not come to rest yet
);
    wire run, edges, sync_awake;
    reg  rests_q;

    sync #(.WIDTH(2)) switches (
        .clk_i(clk_i), .async_i({enable_i, edges_i}), .sync_o({run, edges}), .awake_o(sync_awake)
    );

    always @(posedge clk_i) rests_q <= !run;
    assign awake_o = sync_awake || run || !rests_q;

    // ---- Pixels -----------------------------------------------------------
    reg  [7:0] data_q;
    wire       pixel, row, first;
    wire [7:0] y, cb, cr, brightness;

    always @(posedge clk_i) if (run) data_q <= data_i;

    bt656_rx rx (
        .clk_i(clk_i), .run_i(run), .data_i(data_q), .pixel_o(pixel), .row_o(row),
        .first_o(first), .y_o(y), .cb_o(cb), .cr_o(cr)
    );
    sobel detector (
        .clk_i(clk_i), .run_i(run), .pixel_i(pixel), .row_i(row), .first_i(first), .y_i(y),
        .edge_o(brightness)
    );

    // Delayed by two clocks, the delay of sobel.v.
    reg  [2:0]  came_q, ready_q;     // pixel, row, first
    wire [15:0] rgb;

    always @(posedge clk_i) begin
        came_q  <= run ? {pixel, row, first} : 3'd0;
        ready_q <= run ? came_q : 3'd0;
    end

    ycbcr_to_rgb colours (
        .y_i(edges ? brightness : y), .cb_i(edges ? 8'd128 : cb), .cr_i(edges ? 8'd128 : cr),
        .rgb_o(rgb)
    );

    // ---- Words ------------------------------------------------------------
    reg         half_q;              // the left pixel waits for the right one
    reg  [17:0] left_q;
    wire        right = half_q && !ready_q[1];

    always @(posedge clk_i)
        if (ready_q[2]) begin
            half_q <= !right;
            if (!right) left_q <= {ready_q[0], ready_q[1], rgb};
        end

    assign push_o = ready_q[2] && right;
    assign word_o = {left_q[17:16], rgb, left_q[15:0]};
endmodule

`default_nettype wire

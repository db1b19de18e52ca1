// altera_up_avalon_video_ascii_to_image.v - the University Program's characters as pixels: the
// scaler in front of it says by its channel which one of a character

`default_nettype none

module altera_up_avalon_video_ascii_to_image (
    // verilator lint_off UNUSED
    input  wire       clk,
    input  wire       reset,
    // verilator lint_on UNUSED
    input  wire [7:0] ascii_in_data,
    input  wire [5:0] ascii_in_channel,
    input  wire       ascii_in_startofpacket,
    input  wire       ascii_in_endofpacket,
    input  wire       ascii_in_valid,
    output wire       ascii_in_ready,
    output wire       image_out_data,
    output wire       image_out_startofpacket,
    output wire       image_out_endofpacket,
    output wire       image_out_valid,
    input  wire       image_out_ready
);
    `include "../vga/character_font.vh"

    wire [63:0] shape = letter(ascii_in_data[6:0]);

    assign image_out_data          = !ascii_in_data[7] && shape[ascii_in_channel];
    assign image_out_startofpacket = ascii_in_startofpacket;
    assign image_out_endofpacket   = ascii_in_endofpacket;
    assign image_out_valid         = ascii_in_valid;
    assign ascii_in_ready          = image_out_ready;
endmodule

`default_nettype wire

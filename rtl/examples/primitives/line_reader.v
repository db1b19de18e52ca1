// line_reader.v - reads a line of the picture ahead, in five bursts of 32 words of 64 bits
//
// A pixel has 16 bits: 5 of red, 6 of green, 5 of blue.  Lines follow each other without a gap.

module line_reader (
    input  wire        clk,
    input  wire        rst_n,
    input  wire [31:0] base,
    input  wire        begins,     // for a clock: read the line `row`
    input  wire [9:0]  row,

    input  wire [9:0]  column,     // of the pixel that is wanted, one clock before `colour`
    output wire [15:0] colour,

    output reg  [28:0] address,    // of words
    output wire [7:0]  burstcount,
    output reg         read,
    input  wire        ready,
    input  wire        readdatavalid,
    input  wire [63:0] readdata
);
    localparam [7:0] BURST = 8'd32, WORDS = 8'd160;  // of a burst, of a line

    reg [63:0] words [0:255];
    reg [63:0] word;
    reg [7:0]  asked, got;
    reg [1:0]  place;

    assign burstcount = BURST;
    assign colour = word[16 * place +: 16];

    always @(posedge clk) begin
        word  <= words[column[9:2]];
        place <= column[1:0];
        if (readdatavalid) words[got] <= readdata;
    end

    always @(posedge clk)
        if (!rst_n) begin
            read <= 0;
            asked <= WORDS;
            got <= 0;
        end else begin
            if (readdatavalid) got <= got + 8'd1;
            if (begins && base != 0) begin
                address <= base[31:3] + row * WORDS;
                read <= 1;
                asked <= 0;
                got <= 0;
            end else if (read && ready) begin
                address <= address + BURST;
                asked <= asked + BURST;
                read <= asked != WORDS - BURST;
            end
        end
endmodule

// metronome.v - a component of one's own: counts beats, shows them on LEDs, interrupts at each
//
//   +0 period   clocks between two beats; 0 stops it
//   +4 beats    how many there have been; a write sets them
//   +8 status   bit 0: there has been a beat; a write of 1 to it takes the interrupt back
module metronome (
    input  wire        clk,
    input  wire        reset,
    input  wire [1:0]  address,
    input  wire        write,
    input  wire [31:0] writedata,
    input  wire        read,
    output reg  [31:0] readdata,
    output wire        irq,
    output wire [9:0]  lamps
);
    reg [31:0] period, left, beats;
    reg        beaten;

    assign irq   = beaten;
    assign lamps = beats[9:0];

    always @* case (address)
        2'd0:    readdata = period;
        2'd1:    readdata = beats;
        default: readdata = {31'd0, beaten};
    endcase

    always @(posedge clk) begin
        if (period != 32'd0) left <= left - 32'd1;
        if (period != 32'd0 && left == 32'd1) begin
            left   <= period;
            beats  <= beats + 32'd1;
            beaten <= 1'b1;
        end
        if (write) case (address)
            2'd0: begin
                period <= writedata;
                left   <= writedata;
            end
            2'd1:    beats <= writedata;
            default: if (writedata[0]) beaten <= 1'b0;
        endcase
        if (reset) begin
            period <= 32'd0;
            beats  <= 32'd0;
            beaten <= 1'b0;
        end
    end
endmodule

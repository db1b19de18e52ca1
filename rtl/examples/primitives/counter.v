// counter.v - counts clocks up to a limit, and interrupts there
//
//   0 count   1 limit   2 control: bit 0 it counts, bit 1 it interrupts
//   3 status: bit 0 it has been at the limit; writing 1 clears that
//   4 digits: what HEX3 to HEX0 show

module counter (
    input  wire        clk,
    input  wire        rst_n,
    input  wire        write,
    input  wire [2:0]  number,
    input  wire [31:0] data,
    output reg  [31:0] read,
    output wire        irq,
    output reg  [15:0] digits
);
    reg [31:0] count, limit;
    reg [1:0]  control;
    reg        status;

    assign irq = status && control[1];

    always @(posedge clk)
        if (!rst_n) begin
            count <= 0;
            limit <= 0;
            control <= 0;
            status <= 0;
            digits <= 0;
        end else begin
            if (write && number == 3 && data[0]) status <= 0;
            if (control[0]) begin
                count <= count + 1;
                if (count == limit) begin
                    count <= 0;
                    status <= 1;
                end
            end
            if (write)
                case (number)
                    0: count <= data;
                    1: limit <= data;
                    2: control <= data[1:0];
                    4: digits <= data[15:0];
                    default: ;
                endcase
        end

    always @*
        case (number)
            0:       read = count;
            1:       read = limit;
            2:       read = control;
            3:       read = status;
            4:       read = digits;
            default: read = 0;
        endcase
endmodule

// altera_avalon_mailbox.v - the mailbox before altera_avalon_mailbox_simple: two mutexes, for those
// who write and those who read messages in a memory
//
//   0, 1  mutex and reset of the first, as of altera_avalon_mutex; 2, 3  of the second
//
// Source: Embedded Peripherals IP User Guide, Mailbox Core with Avalon Interface.

`default_nettype none

module altera_avalon_mailbox (
    input  wire        clk,
    input  wire        reset_n,
    input  wire [1:0]  address,
    input  wire        chipselect,
    input  wire        read,
    input  wire        write,
    input  wire [31:0] data_from_cpu,
    output wire [31:0] data_to_cpu
);
    wire [31:0] data0, data1;
    assign data_to_cpu = data0 | data1;

    altera_avalon_mutex mutex0 (
        .clk(clk), .reset_n(reset_n), .address(address[0]), .chipselect(chipselect && !address[1]),
        .read(read), .write(write), .data_from_cpu(data_from_cpu), .data_to_cpu(data0));
    altera_avalon_mutex mutex1 (
        .clk(clk), .reset_n(reset_n), .address(address[0]), .chipselect(chipselect && address[1]),
        .read(read), .write(write), .data_from_cpu(data_from_cpu), .data_to_cpu(data1));
endmodule

`default_nettype wire

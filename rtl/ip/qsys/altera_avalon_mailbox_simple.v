// altera_avalon_mailbox_simple.v - Platform Designer's mailbox: one message of two words
//
//   0 command    its sender's write makes it a message, its receiver's read takes that
//   1 pointer    the other word, for the sender to write before, and the receiver to read before
//   2 status     0 a message is there, 1 there is no space for another
//   3 interrupt  0 of the receiver: while a message is there; 1 of the sender: while there is space
//
// Sender and receiver have these words each.  The receiver cannot write command and pointer, and a
// command that is written while there is no space is lost.
//
// Source: Embedded Peripherals IP User Guide, Mailbox Core; Linux' driver.

`default_nettype none

module altera_avalon_mailbox_simple (
    input  wire        clk,
    input  wire        rst_n,

    input  wire [1:0]  snd_address,
    input  wire        snd_read,
    input  wire        snd_write,
    input  wire [31:0] snd_writedata,
    output reg  [31:0] snd_readdata,
    output wire        space_irq,

    input  wire [1:0]  rcv_address,
    input  wire        rcv_read,
    input  wire        rcv_write,
    // verilator lint_off UNUSED
    input  wire [31:0] rcv_writedata,  // of which bit 0 counts
    // verilator lint_on UNUSED
    output reg  [31:0] rcv_readdata,
    output wire        message_irq
);
    localparam [1:0] COMMAND = 2'd0, POINTER = 2'd1, STATUS = 2'd2, INTERRUPT = 2'd3;

    reg  [31:0] command_q, pointer_q;
    reg         full_q, space_q, message_q;
    wire        puts  = snd_write && snd_address == COMMAND;
    wire        takes = rcv_read && rcv_address == COMMAND;
    assign space_irq       = space_q && !full_q;
    assign message_irq     = message_q && full_q;

    always @* begin
        snd_readdata = 32'd0;
        rcv_readdata = 32'd0;
        if (snd_read)
            case (snd_address)
                COMMAND: snd_readdata = command_q;
                POINTER: snd_readdata = pointer_q;
                STATUS:  snd_readdata = {30'd0, full_q, full_q};
                default: snd_readdata = {30'd0, space_q, 1'b0};
            endcase
        if (rcv_read)
            case (rcv_address)
                COMMAND: rcv_readdata = command_q;
                POINTER: rcv_readdata = pointer_q;
                STATUS:  rcv_readdata = {30'd0, full_q, full_q};
                default: rcv_readdata = {31'd0, message_q};
            endcase
    end

    always @(posedge clk) begin
        if (puts && !full_q) command_q <= snd_writedata;
        if (snd_write && snd_address == POINTER) pointer_q <= snd_writedata;
        if (snd_write && snd_address == INTERRUPT) space_q <= snd_writedata[1];
        if (rcv_write && rcv_address == INTERRUPT) message_q <= rcv_writedata[0];
        full_q <= full_q ? !takes : puts;
        if (!rst_n) begin
            {full_q, space_q, message_q} <= 3'd0;
            {command_q, pointer_q} <= 64'd0;
        end
    end
endmodule

`default_nettype wire

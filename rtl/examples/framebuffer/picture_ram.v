// picture_ram.v - two ports, two clocks, 160 x 120 words of 3 bits, as Quartus' wizard makes it

module picture_ram (
    data,
    rdaddress,
    rdclock,
    wraddress,
    wrclock,
    wren,
    q);

    input  [2:0]  data;
    input  [14:0] rdaddress;
    input         rdclock;
    input  [14:0] wraddress;
    input         wrclock;
    input         wren;
    output [2:0]  q;
    tri1          wrclock;
    tri0          wren;

    wire [2:0] words;
    assign q = words;

    altsyncram memory (
        .address_a (wraddress),
        .clock0 (wrclock),
        .data_a (data),
        .wren_a (wren),
        .address_b (rdaddress),
        .clock1 (rdclock),
        .q_b (words));
    defparam
        memory.address_reg_b = "CLOCK1",
        memory.init_file = "house.mif",
        memory.intended_device_family = "Cyclone V",
        memory.lpm_type = "altsyncram",
        memory.numwords_a = 19200,
        memory.numwords_b = 19200,
        memory.operation_mode = "DUAL_PORT",
        memory.outdata_reg_b = "CLOCK1",
        memory.power_up_uninitialized = "FALSE",
        memory.widthad_a = 15,
        memory.widthad_b = 15,
        memory.width_a = 3,
        memory.width_b = 3,
        memory.width_byteena_a = 1;
endmodule

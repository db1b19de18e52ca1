// de1sim_number.vh - a parameter that is a number, or a text of decimal digits, as a number
//
// To be included in a module.  Quartus takes lpm_svalue = "12" as well as lpm_svalue = 12.

function [127:0] de1sim_number(input [8*40-1:0] text);
    integer i;
    reg digits;
    begin
        de1sim_number = 0;
        digits = text[7:0] >= "0" && text[7:0] <= "9";
        for (i = 39; i >= 0; i = i - 1)
            if (text[8*i +: 8] >= "0" && text[8*i +: 8] <= "9")
                de1sim_number = de1sim_number * 10 + {120'd0, text[8*i +: 8] - "0"};
            else if (text[8*i +: 8] != 0) digits = 0;
        if (!digits) de1sim_number = text[127:0];
    end
endfunction

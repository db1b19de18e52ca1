// de1sim_line.vh - "CLOCK2", "ACLR0" and the like as numbers, for the parameters of multipliers
//
// To be included in a module.

// The clock or clear: 0 to 3, or 4 for none ("UNREGISTERED", "NONE").
function [2:0] de1sim_line(input [8*20-1:0] name);
    de1sim_line = name[7:0] >= "0" && name[7:0] <= "3" ? {1'b0, name[1:0]} : 3'd4;
endfunction

// Where an operand comes from: 0 from its port, 1 from the operand before, 2 as sourcea says.
function [1:0] de1sim_source(input [8*20-1:0] name);
    de1sim_source = name[8*5-1:0] == "SCANA" || name[8*5-1:0] == "SCANB" ? 2'd1
                  : name[8*8-1:0] == "VARIABLE" ? 2'd2 : 2'd0;
endfunction

// de1sim_init.sv - how a design's own memories get the words of files at run time.
//
// What a project writes as $readmemh("x.hex", m) and (* ram_init_file = "x.mif" *) is made into calls
// of these; the C++ side is sim/project/init_file.h.

package de1sim_init;

// As in rtl/ip/de1sim_init.vh.
import "DPI-C" function int de1sim_init_file(input string file, input string memory,
                                             input int width, input int words);
import "DPI-C" function int de1sim_init_part(input int word, input int part);
// Where a file is; its name again, if it is nowhere.
import "DPI-C" function string de1sim_init_path(input string file);

endpackage

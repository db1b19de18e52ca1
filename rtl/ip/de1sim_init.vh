// de1sim_init.vh - the functions that fill a memory from its MIF or Intel HEX file at run time.
//
// To be included in a module, where all files of a project may be read as Verilog-2005.  The C++
// side is sim/project/init_file.h.
`begin_keywords "1800-2017"

// 1 if there is a file, which is then read; 0 for "", "UNUSED" and a file that is nowhere.  A file
// that is nowhere is told, unless its name has a "?" after it.
import "DPI-C" function int de1sim_init_file(input string file, input string memory,
                                             input int width, input int words);
// Bits 32 * part to 32 * part + 31 of a word of the file read last.
import "DPI-C" function int de1sim_init_part(input int word, input int part);

`end_keywords

// streams.h - what is between a source and a sink of a stream
#pragma once

#include "sim/project/qsys/assembly.h"
#include "sim/project/qsys/verilog_text.h"

namespace sim::project::qsys {

// Joins them.  Where they differ, it inserts the adapter that Platform Designer would:
// rtl/ip/qsys/de1sim_st_adapter.v.  ProjectError: one has packets alone; their data cannot be
// divided into the same symbols.
//
// Not handled: bits of errors by their descriptors.
void write_stream(const Assembly& assembly, VerilogText& text, const End& source, const End& sink);

}  // namespace sim::project::qsys

// tools.h - Verilator and the compiler, and the files that de1sim brings for them.
#pragma once

#include "sim/verilog/run_tool.h"
#include <filesystem>
#include <optional>
#include <string>

namespace sim::project {

struct Verilator;

// `share` of an installation, or of the build tree.
std::filesystem::path data_folder();
// The model of a module of Intel's IP; nothing: there is none.
std::optional<std::filesystem::path> model_of(const std::string& module);

// A library of it.
std::filesystem::path library(const char* name);

// A symbolic link to a folder: a name without blanks, over which Verilator stumbles.
void link_to(const std::filesystem::path& folder, const std::filesystem::path& link);

// The name of another folder in `folder`: ".." or "../.." where it lies in the other one, else the
// link `link`.  A link to what `folder` lies in would be an endless path for a program that copies
// or searches it.
std::string seen_from(const std::filesystem::path& folder, const std::filesystem::path& other,
                      const std::string& link);

bool is_writable(const std::filesystem::path& folder);

// Whether a model of Verilator 5.006 computes nothing between an edge and what happens at it, as
// most do (verilated/evaluate.h): of its eval_act(), if it is in this file, there are only the
// lines that each model has.
bool has_empty_act(const std::filesystem::path& source, const std::string& model);

// Verilator's output in `objects`, with runtime/design.cpp: objects/chip.so.  `folder` has
// de1sim_facts.h.  ProjectError.
void compile_library(const std::filesystem::path& folder, const std::filesystem::path& objects,
                     bool trace, const Verilator& verilator, const TimeLimit& limit);

}  // namespace sim::project

// evaluate.h - one evaluation of a model of Verilator 5.006, by its steps
//
// For a model with an empty eval_act(): nothing is computed between an edge and what happens at it,
// as in most designs.  The model's own eval() looks for edges once more before it goes on, and also
// serves waveforms, several threads and objects of classes.
#pragma once

#include "sim/verilated/triggers.h"
#if VERILATOR_VERSION_INTEGER == 5006000

#include <type_traits>

namespace sim::verilated {

// What hangs on inputs without a register, if anything does.
template <auto EVAL_ICO, class Root>
auto eval_inputs(Root& root, int) -> decltype(void(root.__VicoTriggered)) {
    static_assert(std::is_same_v<decltype(root.__VicoTriggered), VlTriggerVec<1>>);
    root.__VicoTriggered.at(0) = 1;
    EVAL_ICO(&root);
}
template <auto, class Root>
void eval_inputs(Root&, long) {}

// The arguments are the model's functions of these names, which none of its headers has.
template <auto EVAL_ICO, auto EVAL_TRIGGERS_ACT, auto EVAL_NBA, auto EVAL, class Root>
void evaluate(Root& root) {
    constexpr unsigned MOST_ROUNDS = 100;  // as there
    eval_inputs<EVAL_ICO>(root, 0);
    for (unsigned round = 0; round <= MOST_ROUNDS; ++round) {
        EVAL_TRIGGERS_ACT(&root);
        if (!root.__VactTriggered.any()) return;
        root.__VnbaTriggered = root.__VactTriggered;
        EVAL_NBA(&root);
    }
    EVAL(&root);  // says that it has no end
}

}  // namespace sim::verilated

#endif

#include "sim/project/safe_tcl.h"

#include <algorithm>
#include <deque>
#include <exception>
#include <stdexcept>
#include <utility>

#include <tcl.h>

namespace sim::project {

namespace fs = std::filesystem;

namespace {

constexpr int MOST_COMMANDS = 1'000'000, MOST_SECONDS = 2;

// Tcl 8.6 has these in its init.tcl, which a safe interpreter does not read.
constexpr const char* FUNCTIONS = R"(
foreach {name order} {max > min <} {
    proc ::tcl::mathfunc::$name {first args} [string map [list ORDER $order] {
        foreach value $args { if {$value ORDER $first} { set first $value } }
        return $first
    }]
}
)";

std::string path_joined(const SafeTcl::Words& words, std::size_t first) {
    std::string path;
    for (std::size_t i = first; i < words.size(); ++i) {
        if (words[i].empty()) continue;
        if (words[i][0] == '/' || path.empty())
            path = words[i];
        else
            path += (path.back() == '/' ? "" : "/") + words[i];
    }
    return path;
}

}  // namespace

struct SafeTcl::Impl {
    struct ForInterp {
        void operator()(Tcl_Interp* interpreter) const { Tcl_DeleteInterp(interpreter); }
    };
    struct Added {
        Impl* impl;
        Command command;
    };
    std::unique_ptr<Tcl_Interp, ForInterp> parent;
    Tcl_Interp* interp = nullptr;  // the parent's
    std::deque<Added> added;
    std::exception_ptr thrown;  // by a command of ours

    static int call(ClientData data, Tcl_Interp* interp, int count, Tcl_Obj* const values[]) {
        const Added& added = *static_cast<Added*>(data);
        try {
            Words words;
            for (int i = 0; i < count; ++i) words.emplace_back(Tcl_GetString(values[i]));
            words[0].erase(0, words[0].find_first_not_of(':'));  // of the name space
            const std::string result = added.command(words);
            Tcl_SetObjResult(interp,
                             Tcl_NewStringObj(result.data(), static_cast<int>(result.size())));
            return TCL_OK;
        } catch (const std::exception& error) {  // must not pass through Tcl
            added.impl->thrown = std::current_exception();
            Tcl_SetObjResult(interp, Tcl_NewStringObj(error.what(), -1));
            return TCL_ERROR;
        }
    }

    [[noreturn]] void fail() {
        if (thrown) std::rethrow_exception(std::exchange(thrown, nullptr));
        std::string why = Tcl_GetStringResult(interp);
        std::replace_if(
            why.begin(), why.end(), [](unsigned char c) { return c < ' '; }, ' ');
        throw std::runtime_error{why};
    }
};

SafeTcl::SafeTcl() : impl_{std::make_unique<Impl>()} {
    Tcl_FindExecutable(nullptr);
    impl_->parent.reset(Tcl_CreateInterp());
    Tcl_Interp* const interp = impl_->interp = Tcl_CreateSlave(impl_->parent.get(), "script", 1);
    for (const char* name : {"after", "vwait", "update", "interp", "close", "puts", "gets", "read",
                             "fileevent", "chan", "package"})
        Tcl_DeleteCommand(interp, name);
    Tcl_Eval(interp, FUNCTIONS);
    Tcl_LimitSetCommands(interp, MOST_COMMANDS);
    Tcl_LimitTypeSet(interp, TCL_LIMIT_COMMANDS);
    Tcl_Time end;
    Tcl_GetTime(&end);
    end.sec += MOST_SECONDS;
    Tcl_LimitSetTime(interp, &end);
    Tcl_LimitTypeSet(interp, TCL_LIMIT_TIME);
}

SafeTcl::~SafeTcl() = default;

void SafeTcl::add(const std::string& name, Command command) {
    impl_->added.push_back({impl_.get(), std::move(command)});
    Tcl_CreateObjCommand(impl_->interp, name.c_str(), &Impl::call, &impl_->added.back(), nullptr);
}

void SafeTcl::set(const std::string& array, const std::string& index, const std::string& value) {
    Tcl_SetVar2(impl_->interp, array.c_str(), index.c_str(), value.c_str(), TCL_GLOBAL_ONLY);
}

std::string SafeTcl::run(const std::string& script) {
    impl_->thrown = nullptr;
    if (Tcl_EvalEx(impl_->interp, script.data(), static_cast<int>(script.size()),
                   TCL_EVAL_GLOBAL) == TCL_ERROR)
        impl_->fail();
    return Tcl_GetStringResult(impl_->interp);
}

SafeTcl::Extent SafeTcl::next_command(const std::string& text, std::size_t from) {
    Tcl_Parse parse;
    const char* const at = text.data() + from;
    if (Tcl_ParseCommand(impl_->interp, at, static_cast<int>(text.size() - from), 0, &parse) !=
        TCL_OK)
        impl_->fail();
    const std::size_t begin = static_cast<std::size_t>(parse.commandStart - text.data());
    const Extent extent{begin, begin + static_cast<std::size_t>(parse.commandSize),
                        parse.numWords == 0};
    Tcl_FreeParse(&parse);
    return extent;
}

std::optional<std::string> file_result(const SafeTcl::Words& words, const fs::path& folder) {
    const std::string& what = words[1];
    const fs::path path{words[2]};
    if (what == "join") return path_joined(words, 2);
    if (what == "dirname") return path.has_parent_path() ? path.parent_path().string() : ".";
    if (what == "tail") return path.filename().string();
    if (what == "extension") return path.extension().string();
    if (what == "rootname") return fs::path{path}.replace_extension().string();
    if (what == "normalize") return (folder / path).lexically_normal().string();
    if (what == "nativename") return words[2];
    std::error_code error;
    if (what == "exists" || what == "isfile")
        return fs::is_regular_file(folder / path, error) ? "1" : "0";
    if (what == "isdirectory") return fs::is_directory(folder / path, error) ? "1" : "0";
    return std::nullopt;
}

std::vector<std::string> words_of_list(const std::string& list) {
    int count = 0;
    const char** words = nullptr;
    if (Tcl_SplitList(nullptr, list.c_str(), &count, &words) != TCL_OK)
        throw std::runtime_error{"this is no list: " + list};
    const std::vector<std::string> all{words, words + count};
    Tcl_Free(reinterpret_cast<char*>(words));
    return all;
}

}  // namespace sim::project

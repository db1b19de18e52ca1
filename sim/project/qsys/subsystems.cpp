#include "sim/project/qsys/subsystems.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "sim/project/settings.h"
#include "sim/text/printable.h"

namespace sim::project::qsys {

namespace {

namespace fs = std::filesystem;

class Flattener {
public:
    explicit Flattener(const FindSystem& find) : find_{find} {}

    System run(const System& system) {
        inside_.push_back(system.file);
        System flat{system.file, system.name, {}, {}, {}};
        std::map<std::string, std::string> exported;  // "vga.clk": "vga_clk_0.clk_in"
        std::set<std::string> subsystems;
        for (const Instance& instance : system.instances) {
            const auto file = find_(instance.kind);
            if (!file) {
                flat.instances.push_back(instance);
                continue;
            }
            if (std::find(inside_.begin(), inside_.end(), *file) != inside_.end())
                fail(system, fmt::format("{} contains itself", file->filename().string()));
            subsystems.insert(instance.name);
            const System inner = run(read_system(*file));
            const std::string prefix = instance.name + "_";
            for (Instance one : inner.instances) {
                one.name = prefix + one.name;
                flat.instances.push_back(std::move(one));
            }
            for (Connection c : inner.connections) {
                c.start = prefix + c.start;
                c.end = prefix + c.end;
                flat.connections.push_back(std::move(c));
            }
            for (const Export& x : inner.exports)
                exported[instance.name + "." + x.name] = prefix + x.internal;
        }
        if (flat.instances.size() > MOST_INSTANCES)
            fail(system, fmt::format("more than {} modules, with its subsystems", MOST_INSTANCES));
        // A subsystem is asked for what it exports.  Nothing: what that was is disabled in it.
        const auto inner = [&](const std::string& name) {
            const auto found = exported.find(name);
            return found == exported.end() ? subsystems.count(instance_of(name)) ? "" : name
                                           : found->second;
        };
        for (Connection c : system.connections) {
            c.start = inner(c.start);
            c.end = inner(c.end);
            if (!c.start.empty() && !c.end.empty()) flat.connections.push_back(std::move(c));
        }
        for (const Export& x : system.exports)
            if (const std::string internal = inner(x.internal); !internal.empty())
                flat.exports.push_back({x.name, internal, x.type, x.is_start});
        inside_.pop_back();
        return flat;
    }

private:
    [[noreturn]] static void fail(const System& system, const std::string& what) {
        throw ProjectError{printable(system.file.filename().string() + ": " + what)};
    }

    const FindSystem& find_;
    std::vector<fs::path> inside_;  // the systems around the present one, and itself
};

}  // namespace

System with_subsystems(const System& system, const FindSystem& find) {
    return Flattener{find}.run(system);
}

}  // namespace sim::project::qsys

#include "sim/project/qsys/streams.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace sim::project::qsys {

namespace {

constexpr unsigned SYMBOL_BITS = 8;  // bits, by default
constexpr const char* STREAM_ROLES[] = {"valid",       "ready", "data",    "startofpacket",
                                        "endofpacket", "empty", "channel", "error"};

unsigned width_of(const End& e, const std::string& role) {
    const Port* port = e.interface->port(role);
    return port ? port->width : 0;
}

unsigned latency_of(const End& e) {
    return width_of(e, "ready") ? e.interface->number("readyLatency", 0) : 0;
}

// Whether the sink's greatest channel is known to be less than the source's.
bool is_beyond(const End& source, const End& sink) {
    const unsigned most = sink.interface->number("maxChannel", 0);
    return most != 0 && source.interface->number("maxChannel", 0) > most;
}

bool differ(const End& source, const End& sink) {
    return latency_of(source) != latency_of(sink) || is_beyond(source, sink) ||
           std::any_of(std::begin(STREAM_ROLES), std::end(STREAM_ROLES), [&](const char* role) {
               return width_of(source, role) != width_of(sink, role);
           });
}

// Bits of a symbol where the widths differ; else all.
unsigned symbol_of(const Assembly& assembly, const End& source, const End& sink) {
    const unsigned from = width_of(source, "data"), to = width_of(sink, "data");
    if (from == to) return std::max(from, 1u);
    const auto declared = [](const End& e) { return e.interface->number("dataBitsPerSymbol", 0); };
    const unsigned a = declared(source), b = declared(sink);
    const unsigned symbol = a ? a : b ? b : SYMBOL_BITS;
    if (from == 0 || to == 0 || (b && b != symbol) || from % symbol || to % symbol)
        assembly.fail(
            fmt::format("{} has {} bits of data in symbols of {}, {} has {} in symbols "
                        "of {}: no adapter fits",
                        source.name(), from, symbol, sink.name(), to, b ? b : symbol));
    return symbol;
}

}  // namespace

void write_stream(const Assembly& assembly, VerilogText& text, const End& source, const End& sink) {
    if (!width_of(source, "startofpacket") != !width_of(sink, "startofpacket"))
        assembly.fail(
            fmt::format("{} has a startofpacket signal, but {} does not: no adapter adds packets",
                        width_of(source, "startofpacket") ? source.name() : sink.name(),
                        width_of(source, "startofpacket") ? sink.name() : source.name()));
    if (!differ(source, sink)) {
        for (const Port& port : source.interface->ports) {
            const Port* other = sink.interface->port(port.role);
            if (!other || port.width == 0) continue;
            const bool from = port.direction == Port::Direction::OUTPUT;
            text.line(fmt::format("assign {} = {};", from ? sink.wire(*other) : source.wire(port),
                                  from ? source.wire(port) : sink.wire(*other)));
        }
        return;
    }
    const unsigned symbol = symbol_of(assembly, source, sink);
    const auto symbols = [&](const End& e) { return std::max(width_of(e, "data") / symbol, 1u); };
    std::string ports;
    for (const auto& [e, side] : {std::pair{&source, "in"}, std::pair{&sink, "out"}})
        for (const char* role : STREAM_ROLES)
            if (width_of(*e, role))
                ports += fmt::format(",\n        .{}_{}({})", side, role, e->wire(role));
    std::string most = "-1";
    if (width_of(source, "channel") && !width_of(sink, "channel"))
        most = "0";
    else if (is_beyond(source, sink))
        most = sink.interface->property("maxChannel");
    text.line(fmt::format(
        "de1sim_st_adapter #(\n"
        "        .SYMBOL({}), .IN_SYMBOLS({}), .OUT_SYMBOLS({}), .IN_EMPTY({}), .OUT_EMPTY({}),\n"
        "        .IN_CHANNEL({}), .OUT_CHANNEL({}), .MAX_CHANNEL({}), .IN_ERROR({}), "
        ".OUT_ERROR({}),\n"
        "        .IN_VALID({}), .IN_READY({}), .IN_LATENCY({}), .OUT_READY({}), "
        ".OUT_LATENCY({})\n    ) {}__{}__adapter (\n        .clk({}), .reset({}){}\n    );",
        symbol, symbols(source), symbols(sink), width_of(source, "empty"), width_of(sink, "empty"),
        width_of(source, "channel"), width_of(sink, "channel"), most, width_of(source, "error"),
        width_of(sink, "error"), width_of(source, "valid"), width_of(source, "ready"),
        latency_of(source), width_of(sink, "ready"), latency_of(sink), source.instance->name,
        source.interface->name, assembly.clock_of(sink).wire, assembly.reset_of(sink), ports));
}

}  // namespace sim::project::qsys

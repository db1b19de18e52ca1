// self_test_report.cpp - the keys of the simulation's report.json that a board can fill
#include "self_test_report.h"

#include <cstdio>

namespace linux_target {

namespace {

std::string quoted(const char* text) {
    std::string out = "\"";
    for (; *text; ++text) {
        if (*text == '"' || *text == '\\') out += '\\';
        out += *text;
    }
    return out + '"';
}

}  // namespace

void SelfTestReport::decided(const char* name, bool met, const char* detail) {
    checks_ += checks_.empty() ? "" : ",\n";
    checks_ += "    {\"name\": " + quoted(name) + ", \"met\": " + (met ? "true" : "false") +
               ", \"detail\": " + quoted(detail) + "}";
}

bool SelfTestReport::write(const std::string& file, bool passed) const {
    const std::string part = file + ".part";
    std::FILE* const out = std::fopen(part.c_str(), "w");
    if (!out) return false;
    const bool printed = std::fprintf(out,
                                      "{\n  \"scenario\": \"check-board\",\n  \"cpu\": \"board\",\n"
                                      "  \"passed\": %s,\n  \"checks\": [\n%s\n  ]\n}\n",
                                      passed ? "true" : "false", checks_.c_str()) > 0;
    const bool closed = std::fclose(out) == 0;
    return printed && closed && std::rename(part.c_str(), file.c_str()) == 0;
}

}  // namespace linux_target

#include "sim/suite/classroom.h"

#include <nlohmann/json.hpp>

#include "sim/page/html.h"

namespace sim::suite {

std::string to_classroom(const Results& results) {
    using Json = nlohmann::ordered_json;
    Json tests = Json::array();
    unsigned most = 0;
    for (const Result& result : results.all) {
        most += result.points;
        Json message;
        if (!result.passed()) message = first_failure(result);
        tests.push_back({{"name", result.name},
                         {"status", result.passed() ? "pass" : "fail"},
                         {"score", result.passed() ? result.points : 0},
                         {"message", message}});
    }
    for (const std::string& name : results.missing)
        tests.push_back(
            {{"name", name}, {"status", "error"}, {"score", 0}, {"message", "has no result"}});
    const bool passed = results.exit_code() == 0;
    const Json json = {{"version", 1},
                       {"status", passed ? "pass" : "fail"},
                       {"max_score", most},
                       {"tests", tests}};
    return page::base64(json.dump(-1, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace sim::suite

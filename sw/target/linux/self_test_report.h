// self_test_report.h - the self-test's result as report.json, for `de1sim compare`.
#pragma once

#include <string>

#include "selftest/self_test.h"

namespace linux_target {

class SelfTestReport : public selftest::Listener {
public:
    void decided(const char* name, bool met, const char* detail) override;

    // Writes FILE.part and renames it, so that FILE is either complete or unchanged.  False, with
    // errno, on failure.
    bool write(const std::string& file, bool passed) const;

private:
    std::string checks_;
};

}  // namespace linux_target

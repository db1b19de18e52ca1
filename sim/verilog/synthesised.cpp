#include "sim/verilog/synthesised.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

#include "sim/text/lower.h"

namespace sim::project {

namespace {

bool in_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

}  // namespace

std::string order_in(std::string_view comment) {
    static const std::set<std::string> SPEAKERS{"synthesis", "synopsys", "pragma",
                                                "altera",    "exemplar", "ambit"};
    std::istringstream words{lower(std::string{comment})};
    std::string speaker, what, how;
    words >> speaker >> what >> how;
    if (!SPEAKERS.count(speaker)) return {};
    while (!what.empty() && !in_word(what.back())) what.pop_back();
    if (what == "synthesis_off" || what == "synthesis_on") return "translate" + what.substr(9);
    return what == "read_comments_as_hdl" ? what + " " + how.substr(0, how.find('*')) : what;
}

namespace {

class SynthesisedText {
public:
    SynthesisedText(std::string_view text, const std::vector<std::string>& macros)
        : text_{text}, result_{text}, macros_{"ALTERA_RESERVED_QIS"} {
        for (const std::string& macro : macros) macros_.insert(macro.substr(0, macro.find('=')));
    }

    std::string run() {
        while (at_ < text_.size()) {
            const std::size_t begin = at_;
            if (is("//"))
                comment(2, "\n");
            else if (is("/*"))
                comment(2, "*/");
            else if (is("/``*"))
                comment_of_macro();
            else if (off_)
                blank(at_++);
            else if (text_[at_] == '"')
                string();
            else if (text_[at_] == '`')
                directive();
            else
                ++at_;
            if (at_ == begin) ++at_;
        }
        return std::move(result_);
    }

private:
    struct Condition {
        bool is_read, was_read, around;  // this branch; one of it; what it stands in
    };

    bool is(std::string_view what) const { return text_.compare(at_, what.size(), what) == 0; }
    void blank(std::size_t i) {
        if (result_[i] != '\n') result_[i] = ' ';
    }
    bool is_read() const { return conditions_.empty() || conditions_.back().is_read; }

    void comment(std::size_t open, std::string_view end) {
        const std::size_t begin = at_, inside = at_ + open, found = text_.find(end, inside);
        const std::size_t close = std::min(found, text_.size());
        at_ = found == std::string_view::npos ? text_.size() : found + (end == "\n" ? 0 : 2);
        const std::string order = order_in(text_.substr(inside, close - inside));
        if (is_read() && !order.empty()) {
            if (order == "translate_off") off_ = true;
            if (order == "translate_on") off_ = false;
            if (order == "read_comments_as_hdl on") comments_are_read_ = true;
            if (order == "read_comments_as_hdl off") comments_are_read_ = false;
        } else if (off_) {
            for (std::size_t i = begin; i < at_; ++i) blank(i);
        } else if (comments_are_read_) {
            for (std::size_t i = 0; i < open; ++i) blank(begin + i);
            for (std::size_t i = close; i < at_; ++i) blank(i);
        }
    }

    // A comment that a macro would paste together; Verilator knows none that begins with a speaker.
    void comment_of_macro() {
        const std::size_t found = text_.find("*``/", at_);
        const std::size_t end = found == std::string_view::npos ? text_.size() : found + 4;
        while (at_ < end) blank(at_++);
    }

    void string() {
        for (++at_; at_ < text_.size() && text_[at_] != '"' && text_[at_] != '\n'; ++at_)
            at_ += text_[at_] == '\\' && at_ + 1 < text_.size();
        ++at_;
    }

    std::string word() {
        const std::size_t begin = at_;
        while (at_ < text_.size() && in_word(text_[at_])) ++at_;
        return std::string{text_.substr(begin, at_ - begin)};
    }
    std::string name_behind() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
        return word();
    }

    void directive() {
        ++at_;
        const std::string what = word();
        if (what == "ifdef" || what == "ifndef") {
            const bool holds = (macros_.count(name_behind()) > 0) == (what == "ifdef");
            conditions_.push_back({is_read() && holds, holds, is_read()});
        } else if (what == "elsif" && !conditions_.empty()) {
            Condition& c = conditions_.back();
            const bool holds = macros_.count(name_behind()) > 0 && !c.was_read;
            c = {c.around && holds, c.was_read || holds, c.around};
        } else if (what == "else" && !conditions_.empty()) {
            Condition& c = conditions_.back();
            c = {c.around && !c.was_read, true, c.around};
        } else if (what == "endif" && !conditions_.empty()) {
            conditions_.pop_back();
        } else if (what == "define" && is_read()) {
            macros_.insert(name_behind());
        } else if (what == "undef" && is_read()) {
            macros_.erase(name_behind());
        }
    }

    const std::string_view text_;
    std::string result_;
    std::set<std::string> macros_;
    std::vector<Condition> conditions_;
    std::size_t at_ = 0;
    bool off_ = false, comments_are_read_ = false;
};

}  // namespace

std::string as_synthesised(std::string_view text, const std::vector<std::string>& macros) {
    return SynthesisedText{text, macros}.run();
}

}  // namespace sim::project

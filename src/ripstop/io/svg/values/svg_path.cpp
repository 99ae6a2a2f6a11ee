#include "ripstop/io/svg/values/svg_path.h"

#include <algorithm>
#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr double largest_number = 1e9;
constexpr std::string_view blanks = " \t\r\n\f\v";

void skip_blanks(std::string_view& rest) {
    while (!rest.empty() && std::string_view(" \t\r\n\f,").find(rest.front()) != std::string_view::npos)
        rest.remove_prefix(1);
}

std::size_t digits(std::string_view text, std::size_t from) {
    std::size_t end = from;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    return end;
}

class PathReader {
  public:
    PathReader(std::string_view d, const std::string& place) : rest_(d), place_(place) {}

    std::vector<SvgRun> read() {
        char command = 0;
        for (skip_blanks(rest_); !rest_.empty(); skip_blanks(rest_)) {
            const char c = rest_.front();
            if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) {
                command = c;
                rest_.remove_prefix(1);
            } else if (command == 0 || command == 'Z' || command == 'z') {
                refuse("expected a command such as M or L");
            }
            if (runs_.empty() && command != 'M' && command != 'm') refuse("expected M at its start");
            step(command);
            if (command == 'M') command = 'L';
            if (command == 'm') command = 'l';
        }
        std::erase_if(runs_, [](const SvgRun& run) { return run.segments.empty() && !run.is_closed; });
        return std::move(runs_);
    }

  private:
    [[noreturn]] void refuse(const std::string& expected) const {
        throw InputError(place_ + ": a path with " + shown(rest_) + ", " + expected + "; export it again");
    }

    double number() {
        double value = 0;
        if (!next_svg_number(rest_, value, place_)) refuse("expected a number");
        return value;
    }
    /// Reads a flag: one digit, which needs no separator after it.
    bool flag() {
        skip_blanks(rest_);
        if (rest_.empty() || (rest_.front() != '0' && rest_.front() != '1'))
            refuse("expected 0 or 1, a flag of an arc");
        const bool is_set = rest_.front() == '1';
        rest_.remove_prefix(1);
        return is_set;
    }
    Vec2 point() {
        const double x = number(), y = number();
        return is_relative_ ? Vec2(here_ + Vec2(x, y)) : Vec2(x, y);
    }

    void go(const SvgSegment& segment) {
        if (runs_.back().is_closed) {  // after Z the next run begins where the last one began
            runs_.push_back({here_, {}, false});
            start_ = here_;
        }
        runs_.back().segments.push_back(segment);
        here_ = segment.to;
    }

    void step(char command) {
        is_relative_ = command >= 'a';
        const char kind = is_relative_ ? static_cast<char>(command - 'a' + 'A') : command;
        const Vec2 mirrored = 2 * here_ - control_;
        const bool after_cubic = was_cubic_, after_quadratic = was_quadratic_;
        was_cubic_ = kind == 'C' || kind == 'S';
        was_quadratic_ = kind == 'Q' || kind == 'T';
        switch (kind) {
            case 'M':
                here_ = start_ = point();
                runs_.push_back({here_, {}, false});
                break;
            case 'L':
                go(svg_line(point()));
                break;
            case 'H':
                go(svg_line(Vec2(number() + (is_relative_ ? here_.x() : 0), here_.y())));
                break;
            case 'V':
                go(svg_line(Vec2(here_.x(), number() + (is_relative_ ? here_.y() : 0))));
                break;
            case 'C':
                cubic(point());
                break;
            case 'S':
                cubic(after_cubic ? mirrored : here_);
                break;
            case 'Q':
                quadratic(point());
                break;
            case 'T':
                quadratic(after_quadratic ? mirrored : here_);
                break;
            case 'A':
                arc();
                break;
            case 'Z':
                runs_.back().is_closed = true;
                here_ = start_;
                break;
            default:
                refuse("expected M, L, H, V, C, S, Q, T, A or Z");
        }
    }

    void cubic(const Vec2& first_control) {
        control_ = point();
        go(svg_cubic(first_control, control_, point()));
    }

    void quadratic(const Vec2& control) {
        control_ = control;
        const Vec2 from = here_, to = point();
        go(svg_cubic(from + 2.0 / 3 * (control - from), to + 2.0 / 3 * (control - to), to));
    }

    void arc() {
        const double x = number(), y = number(), turn = number();
        const bool is_large = flag(), is_positive = flag();
        go(svg_arc(here_, Vec2(x, y), turn * degree, is_large, is_positive, point()));
    }

    std::string_view rest_;
    const std::string& place_;
    std::vector<SvgRun> runs_;
    Vec2 here_ = Vec2::Zero(), start_ = Vec2::Zero(), control_ = Vec2::Zero();
    bool is_relative_ = false, was_cubic_ = false, was_quadratic_ = false;
};

}  // namespace

std::size_t svg_number_end(std::string_view text) {
    std::size_t end = !text.empty() && (text[0] == '-' || text[0] == '+') ? 1 : 0;
    end = digits(text, end);
    if (end < text.size() && text[end] == '.') end = digits(text, end + 1);
    if (end < text.size() && (text[end] == 'e' || text[end] == 'E')) {
        const std::size_t sign = end + 1 < text.size() && (text[end + 1] == '-' || text[end + 1] == '+') ? 2 : 1;
        const std::size_t after = digits(text, end + sign);
        if (after > end + sign) end = after;
    }
    return end;
}

bool next_svg_number(std::string_view& rest, double& number, const std::string& place) {
    skip_blanks(rest);
    if (rest.empty()) return false;
    const std::size_t end = svg_number_end(rest);
    const std::optional<double> value = parse_double(rest.substr(0, end));
    if (!value || std::abs(*value) > largest_number)
        throw InputError(place + ": " + shown(rest) + ", expected a number within 1e9; export it again");
    number = *value;
    rest.remove_prefix(end);
    return true;
}

std::vector<double> svg_numbers(std::string_view text, const std::string& place) {
    std::vector<double> numbers;
    double number = 0;
    while (next_svg_number(text, number, place)) numbers.push_back(number);
    return numbers;
}

std::vector<SvgRun> svg_path(std::string_view d, const std::string& place) {
    return PathReader(d, place).read();
}

std::string_view svg_trimmed(std::string_view text) {
    const std::size_t start = text.find_first_not_of(blanks);
    if (start == std::string_view::npos) return {};
    return text.substr(start, text.find_last_not_of(blanks) - start + 1);
}

std::string_view svg_next_word(std::string_view& rest) {
    rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(blanks)));
    const std::string_view word = rest.substr(0, rest.find_first_of(blanks));
    rest.remove_prefix(word.size());
    return word;
}

}  // namespace ripstop

#include "ripstop/io/svg_path.h"

#include <cmath>

#include "ripstop/base/error.h"
#include "ripstop/base/number_text.h"
#include "ripstop/io/text.h"

namespace ripstop {
namespace {

constexpr double largest = 1e9;
constexpr int chords = 16;  // of a curve

void skip_blanks(std::string_view& rest) {
    while (!rest.empty() && std::string_view(" \t\r\n\f,").find(rest.front()) != std::string_view::npos)
        rest.remove_prefix(1);
}

std::size_t digits(std::string_view text, std::size_t from) {
    std::size_t end = from;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
    return end;
}

/// Where a number ends that begins at the start: `1.5.5` is two, `1-2` too.
std::size_t number_end(std::string_view text) {
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

class PathReader {
  public:
    PathReader(std::string_view d, const std::string& place) : rest_(d), place_(place) {}

    SvgPath read() {
        char command = 0;
        for (skip_blanks(rest_); !rest_.empty(); skip_blanks(rest_)) {
            const char c = rest_.front();
            if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) {
                command = c;
                rest_.remove_prefix(1);
            } else if (command == 0 || command == 'Z' || command == 'z') {
                refuse("expected a command such as M or L");
            }
            if (path_.runs.empty() && command != 'M' && command != 'm') refuse("expected M at its start");
            step(command);
            if (command == 'M') command = 'L';
            if (command == 'm') command = 'l';
        }
        std::erase_if(path_.runs, [](const SvgRun& run) { return run.points.size() < 2 && !run.is_closed; });
        return std::move(path_);
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
    Vec2 point(bool relative) {
        const double x = number(), y = number();
        return relative ? Vec2(here_ + Vec2(x, y)) : Vec2(x, y);
    }

    void go(const Vec2& to) {
        if (path_.runs.back().is_closed) {  // after Z the next run begins where the last one did
            path_.runs.push_back({{here_}, false});
            start_ = here_;
        }
        path_.runs.back().points.push_back(to);
        here_ = to;
    }

    void curve(const Vec2& a, const Vec2& b, const Vec2& to) {
        const Vec2 from = here_;
        for (int i = 1; i < chords; ++i) {
            const double t = static_cast<double>(i) / chords, s = 1 - t;
            go(s * s * s * from + 3 * s * s * t * a + 3 * s * t * t * b + t * t * t * to);
        }
        go(to);
    }

    void step(char command) {
        const bool relative = command >= 'a';
        const char kind = relative ? static_cast<char>(command - 'a' + 'A') : command;
        Vec2 control = here_;
        bool is_cubic = false, is_quadratic = false;
        switch (kind) {
            case 'M':
                here_ = start_ = point(relative);
                path_.runs.push_back({{here_}, false});
                break;
            case 'L':
                go(point(relative));
                break;
            case 'H':
                go(Vec2(number() + (relative ? here_.x() : 0), here_.y()));
                break;
            case 'V':
                go(Vec2(here_.x(), number() + (relative ? here_.y() : 0)));
                break;
            case 'C':
            case 'S': {
                const Vec2 a = kind == 'C' ? point(relative) : was_cubic_ ? Vec2(2 * here_ - control_) : here_;
                control = point(relative);
                is_cubic = true;
                curve(a, control, point(relative));
                break;
            }
            case 'Q':
            case 'T': {
                control = kind == 'Q' ? point(relative) : was_quadratic_ ? Vec2(2 * here_ - control_) : here_;
                is_quadratic = true;
                const Vec2 from = here_, to = point(relative);
                curve(from + 2.0 / 3 * (control - from), to + 2.0 / 3 * (control - to), to);
                break;
            }
            case 'A':
                for (int i = 0; i < 5; ++i) number();
                path_.has_arcs = true;
                go(point(relative));
                break;
            case 'Z':
                path_.runs.back().is_closed = true;
                here_ = start_;
                break;
            default:
                refuse("expected M, L, H, V, C, S, Q, T, A or Z");
        }
        was_cubic_ = is_cubic;
        was_quadratic_ = is_quadratic;
        control_ = control;
    }

    std::string_view rest_;
    const std::string& place_;
    SvgPath path_;
    Vec2 here_ = Vec2::Zero(), start_ = Vec2::Zero(), control_ = Vec2::Zero();
    bool was_cubic_ = false, was_quadratic_ = false;
};

}  // namespace

bool next_svg_number(std::string_view& rest, double& number, const std::string& place) {
    skip_blanks(rest);
    if (rest.empty()) return false;
    const std::size_t end = number_end(rest);
    const std::optional<double> value = parse_double(rest.substr(0, end));
    if (!value || std::abs(*value) > largest)
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

SvgPath svg_path(std::string_view d, const std::string& place) {
    return PathReader(d, place).read();
}

}  // namespace ripstop

#include "ripstop/pattern/piece/annotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ripstop/base/text/utf8.h"

namespace ripstop {
namespace {

constexpr double readable_height = 0.003;
constexpr double smallest_height = 0.001;
constexpr double upright = std::numbers::pi / 2;

/// Lines of writing below each other, in units of the first line's height. A letter is as wide as high: plotter
/// fonts are, screen fonts are narrower.
struct Writing {
    std::vector<std::string> lines;
    static double scale(std::size_t line) { return line == 0 ? 1 : 0.6; }
    /// The distance from the middle of the first line down to that of another.
    static double drop(std::size_t line) { return line == 0 ? 0 : 1.3 + 0.9 * static_cast<double>(line - 1); }

    double width() const {
        double widest = 0;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            widest = std::max(widest, static_cast<double>(letters_in(lines[i])) * scale(i));
        }
        return widest;
    }
    double bottom() const { return drop(lines.size() - 1) + scale(lines.size() - 1) / 2; }

    Box box(const Vec2& middle, double height, double turn) const {
        constexpr double air = 0.25;
        return {middle, height * Vec2(width() / 2 + air, (0.5 + bottom()) / 2 + air), turn};
    }
    LabelPlace at(const Vec2& middle, double height, double turn) const {
        LabelPlace place{{}, box(middle, height, turn)};
        const Vec2 down(std::sin(turn), -std::cos(turn));
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const double below_middle = drop(i) - (bottom() - 0.5) / 2;
            place.labels.push_back({lines[i], middle + below_middle * height * down, scale(i) * height, turn});
        }
        return place;
    }
};

struct Fit {
    Vec2 middle = Vec2::Zero();
    double height = 0;
    double turn = 0;
};

/// The largest height in [least, most] at which the writing fits at `middle`; 0 if there is none.
double fitting_height(const Points2& outline, const Writing& writing, const Fit& place, double least, double most) {
    const auto fits = [&](double height) { return contains(outline, writing.box(place.middle, height, place.turn)); };
    if (least > most || !fits(least)) return 0;
    if (fits(most)) return most;
    for (int step = 0; step < 10; ++step) {
        const double middle = (least + most) / 2;
        (fits(middle) ? least : most) = middle;
    }
    return least;
}

/// Candidate places: the pole of inaccessibility, then a grid over the piece from the pole outward.
std::vector<Vec2> places(const Points2& outline, const Vec2& pole) {
    const Vec2 lower = outline.colwise().minCoeff();
    const Vec2 size = Vec2(outline.colwise().maxCoeff()) - lower;
    constexpr int n = 12;
    std::vector<Vec2> result{pole};
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const Vec2 place = lower + size.cwiseProduct(Vec2((i + 0.5) / n, (j + 0.5) / n));
            if (contains(outline, place)) result.push_back(place);
        }
    std::stable_sort(result.begin(), result.end(), [&pole](const Vec2& a, const Vec2& b) {
        return (a - pole).squaredNorm() < (b - pole).squaredNorm();
    });
    return result;
}

Fit best_fit(const Points2& outline, const std::vector<Vec2>& middles, const Writing& writing, double least,
             double most) {
    Fit best;
    for (const double turn : {0.0, upright}) {
        // Level text is easier to read, so upright text must be half as high again to be preferred. Text away from
        // the pole must be a fifth higher.
        double needed = std::max(least, (turn == 0 ? 1 : 1.5) * best.height);
        for (const Vec2& middle : middles) {
            const double height = fitting_height(outline, writing, {middle, 0, turn}, needed, most);
            if (height == 0) continue;
            best = {middle, height, turn};
            if (height == most) return best;
            needed = 1.2 * height;
        }
    }
    return best;
}

bool overlaps(const Box& box, const Box& other) {
    const auto reach = [](const Box& b) { return b.turn == 0 ? b.half : Vec2(b.half.y(), b.half.x()); };
    const Vec2 apart = (box.centre - other.centre).cwiseAbs();
    return (apart.array() < (reach(box) + reach(other)).array()).all();
}

/// The parts of a chord that do not meet the label.
std::vector<std::array<double, 2>> clear_of(const std::array<double, 2>& chord, double y, const Box& label) {
    const Vec2 reach = label.turn == 0 ? label.half : Vec2(label.half.y(), label.half.x());
    if (std::abs(y - label.centre.y()) >= reach.y()) return {chord};
    const double left = label.centre.x() - reach.x(), right = label.centre.x() + reach.x();
    if (right <= chord[0] || left >= chord[1]) return {chord};
    std::vector<std::array<double, 2>> parts;
    if (left > chord[0]) parts.push_back({chord[0], left});
    if (right < chord[1]) parts.push_back({right, chord[1]});
    return parts;
}

struct Arrow {
    Vec2 middle = Vec2::Zero();
    double length = 0;
};

/// The longest arrow on a part of a chord, as near to the pole as possible, with head and barbs inside the outline
/// and off the label; its length is 0 if none is longer than `least`.
Arrow longest_arrow(const Points2& outline, const std::array<double, 2>& part, double y, const Vec2& pole, double least,
                    const Box& label) {
    const double width = part[1] - part[0];
    for (double length = 0.6 * width; length > std::max(least, 0.1 * width); length *= 0.8) {
        const double room = length / 2 + 0.05 * width;
        const Vec2 middle(std::clamp(pole.x(), part[0] + room, part[1] - room), y);
        const Box box{middle, {length / 2, 1.5 * arrow_half_width(length)}, 0};
        if (!overlaps(box, label) && contains(outline, box)) return {middle, length};
    }
    return {};
}

}  // namespace

LabelPlace place_label(const Points2& outline, const Circle& room, const std::string& name,
                       const std::vector<std::string>& notes, double largest) {
    const std::vector<Vec2> middles = places(outline, room.centre);
    Writing with_all{{name}}, with_first{{name}};
    const Writing alone{{name}};
    with_all.lines.insert(with_all.lines.end(), notes.begin(), notes.end());
    if (!notes.empty()) with_first.lines.push_back(notes.front());
    const struct {
        const Writing& writing;
        double least;
    } attempts[] = {{with_all, readable_height / Writing::scale(1)},
                    {with_first, readable_height},
                    {alone, readable_height},
                    {alone, smallest_height}};
    for (const auto& attempt : attempts) {
        const Fit fit = best_fit(outline, middles, attempt.writing, attempt.least, std::max(largest, attempt.least));
        if (fit.height > 0) return attempt.writing.at(fit.middle, fit.height, fit.turn);
    }
    return alone.at(room.centre, smallest_height, 0);
}

Points2 place_grain_line(const Points2& outline, const Circle& room, const Box& label) {
    const double bottom = outline.col(1).minCoeff(), top = outline.col(1).maxCoeff();
    constexpr int rows = 48;
    Arrow best;
    double best_score = 0;
    for (int row = 0; row < rows; ++row) {
        const double y = bottom + (top - bottom) * (row + 0.5) / rows;
        const double liking = 1 - 0.5 * std::abs(y - room.centre.y()) / (top - bottom);
        for (const auto& chord : horizontal_chords(outline, y))
            for (const auto& part : clear_of(chord, y, label)) {
                const Arrow arrow = longest_arrow(outline, part, y, room.centre, best_score / liking, label);
                if (arrow.length * liking <= best_score) continue;
                best_score = arrow.length * liking;
                best = arrow;
            }
    }
    if (best.length == 0) return Points2(0, 2);
    Points2 line(2, 2);
    line << best.middle.x() - best.length / 2, best.middle.y(), best.middle.x() + best.length / 2, best.middle.y();
    return line;
}

}  // namespace ripstop

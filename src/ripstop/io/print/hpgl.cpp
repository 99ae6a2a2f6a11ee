#include "ripstop/io/print/hpgl.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <string>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/geometry/clip.h"
#include "ripstop/io/print/letters.h"
#include "ripstop/io/text/sheet.h"

namespace ripstop {
namespace {

constexpr double unit = 0.025 * millimetre;
constexpr long largest_unit = (1L << 23) - 1;  // of HP-GL/2
constexpr long largest_in_frame = 32767;       // of HP-GL
constexpr std::size_t points_a_command = 16;   // plotters have small buffers
constexpr double shortest_frame = 0.1;         // [m]

enum class Pen { draw = 1, cut = 2, notch = 3 };

struct PlotterPlace {
    long x = 0, y = 0;
    bool operator==(const PlotterPlace&) const = default;
};

std::string in_metres(double length) {
    return format_fixed(length, 2) + " m";
}

/// A stream might group digits, so this does not use one.
std::string in_units(double length) {
    return std::to_string(std::lround(std::ceil(length / unit - 1e-6)));
}

/// A section of the sheet along x, and how far the plotter counts from the origin.
struct Frame {
    Vec2 origin = Vec2::Zero();
    double left = -std::numeric_limits<double>::infinity(), right = std::numeric_limits<double>::infinity();
    long reach = largest_unit;
};

class Plotter {
  public:
    Plotter(std::ostream& out, const Frame& frame) : out_(out), frame_(frame) {}

    void take(Pen pen) { wanted_ = pen; }
    bool sees(double left, double right) const { return left <= frame_.right && right >= frame_.left; }

    void line(const Points2& points, const Vec2& shift) {
        Points2 there = points;
        there.rowwise() += shift.transpose();
        constexpr double any = std::numeric_limits<double>::infinity();
        for (const LinePart& part : clip_to_box(there, {frame_.left, -any}, {frame_.right, any})) stroke(part.points);
    }

  private:
    PlotterPlace place(const Vec2& p) const {
        const Vec2 units = (p - frame_.origin) / unit;
        if (!(units.cwiseAbs().maxCoeff() <= static_cast<double>(frame_.reach)))
            throw InputError(
                "the drawing extends beyond the " + in_metres(static_cast<double>(frame_.reach) * unit) +
                " that HPGL counts" +
                (frame_.reach == largest_unit
                     ? "; use the separate files of the pieces"
                     : " on either side of a frame's middle; leave the frames out for a plotter that takes HP-GL/2"));
        return {std::lround(units.x()), std::lround(units.y())};
    }
    void stroke(const Points2& points) {
        std::vector<PlotterPlace> places;
        for (Eigen::Index i = 0; i < points.rows(); ++i) {
            const PlotterPlace next = place(points.row(i));
            if (places.empty() || next != places.back()) places.push_back(next);
        }
        if (places.size() < 2) return;
        if (held_ != wanted_) out_ << "PU;SP" << static_cast<int>(wanted_) << ";\n";
        held_ = wanted_;
        if (places.front() != at_) out_ << "PU" << text(places.front()) << ";\n";
        for (std::size_t i = 1; i < places.size(); ++i) {
            const bool begins = (i - 1) % points_a_command == 0;
            if (begins && i > 1) out_ << ";\n";
            out_ << (begins ? "PD" : ",") << text(places[i]);
        }
        out_ << ";\nPU;\n";
        at_ = places.back();
    }
    static std::string text(const PlotterPlace& place) {
        return std::to_string(place.x) + "," + std::to_string(place.y);
    }

    std::ostream& out_;
    Frame frame_;
    Pen wanted_ = Pen::draw;
    Pen held_ = static_cast<Pen>(0);
    PlotterPlace at_ = {std::numeric_limits<long>::max(), 0};
};

/// Draws before it cuts, so that no piece moves under the pen.
void plot(Plotter& plotter, const PatternPiece& piece, const Vec2& shift) {
    if (piece.sew_line.rows() == 0 || !plotter.sees(piece.lower().x() + shift.x(), piece.upper().x() + shift.x()))
        return;
    plotter.take(Pen::draw);
    if (piece.cut_line.rows() > 0) plotter.line(closed_line(piece.sew_line), shift);
    for (const DrawnLine& line : piece.lines) plotter.line(line.points, shift);
    const Points2 arrow = grain_arrow(piece);
    if (arrow.rows() == 4) {
        Points2 head(3, 2);
        head << arrow.row(2), arrow.row(1), arrow.row(3);
        plotter.line(arrow.topRows(2), shift);
        plotter.line(head, shift);
    }
    for (const Label& label : piece.labels)
        for (const Points2& outline : letter_outlines(label)) plotter.line(outline, shift);
    plotter.take(Pen::notch);
    for (const PieceNotch& notch : piece.notches)
        for (const auto& [from, to] : notch.slits()) {
            Points2 slit(2, 2);
            slit << from.transpose(), to.transpose();
            plotter.line(slit, shift);
        }
    plotter.take(Pen::cut);
    plotter.line(closed_line(piece.outline()), shift);
}

/// Draws the square last: it is right of the pieces, which a plotter that feeds its paper reaches last.
void plot_all(Plotter& plotter, const std::vector<PatternPiece>& pieces, const Sheet& sheet) {
    for (std::size_t i = 0; i < pieces.size(); ++i) plot(plotter, pieces[i], sheet.shifts[i]);
    constexpr double side = Sheet::square_side;
    Points2 square(4, 2);
    square << 0, 0, side, 0, side, side, 0, side;
    plotter.take(Pen::draw);
    plotter.line(closed_line(square), sheet.square);
    for (const Points2& outline : letter_outlines({"100 mm", Vec2(side / 2, side / 2), 0.01, 0}))
        plotter.line(outline, sheet.square);
}

void plot_frames(std::ostream& out, const std::vector<PatternPiece>& pieces, const Sheet& sheet, double frame) {
    const double longest = 2 * static_cast<double>(largest_in_frame) * unit;
    if (!(frame >= shortest_frame && frame <= longest))
        throw InputError("a frame of " + in_metres(frame) + "; give " + in_metres(shortest_frame) + " to " +
                         in_metres(longest));
    const auto frames = static_cast<int>(std::ceil((sheet.upper - sheet.lower).x() / frame - 1e-9));
    for (int i = 0; i < std::max(1, frames); ++i) {
        const double left = sheet.lower.x() + i * frame, right = sheet.lower.x() + (i + 1) * frame;
        if (i > 0) out << "PU;FR;\n";
        const Vec2 middle((left + right) / 2, (sheet.lower.y() + sheet.upper.y()) / 2);
        Plotter plotter(out, {middle, left, right, largest_in_frame});
        plot_all(plotter, pieces, sheet);
    }
}

}  // namespace

void write_hpgl(std::ostream& out, const std::vector<PatternPiece>& pieces, const std::vector<Vec2>& shifts,
                const HpglOptions& options) {
    const Sheet sheet = make_sheet(pieces, shifts);
    const Vec2 size = sheet.upper - sheet.lower;
    out << "IN;\n";
    if (options.frame != 0) {
        plot_frames(out, pieces, sheet, options.frame);
    } else {
        out << "PS" << in_units(size.x()) << "," << in_units(size.y()) << ";\n";
        Plotter plotter(out, {sheet.lower});
        plot_all(plotter, pieces, sheet);
    }
    out << "PU;SP0;\n";
}

}  // namespace ripstop

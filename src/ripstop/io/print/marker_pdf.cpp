#include "ripstop/io/print/marker_pdf.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "ripstop/base/text/number_text.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/io/print/paper.h"
#include "ripstop/io/print/pdf_canvas.h"

namespace ripstop {
namespace {

const Vec2 page_size(0.297, 0.210);  // A4, landscape
constexpr int strips_a_page = 4;
constexpr double title_height = 0.008;
constexpr double metres_height = 0.007;  // space below each strip for the ticks and their labels
constexpr double letters = 0.0022;
const Ink roll_ink{{0.5, 0.5, 0.5}, 0.0002};
const Ink cut_ink{{1, 0, 0}, 0.0002};
const Ink grain_ink{{0, 0, 1}, 0.00015};

/// The smallest of 1, 2, 2.5, 4, 5 and 7.5 times a power of ten that is not below `least`.
double round_scale(double least) {
    double power = std::pow(10, std::floor(std::log10(least)));
    for (;; power *= 10)
        for (const double step : {1.0, 2.0, 2.5, 4.0, 5.0, 7.5})
            if (step * power >= least * (1 - 1e-9)) return step * power;
}

/// A section of the roll on a page.
struct PageStrip {
    double start, end;  ///< on the roll [m]
    Vec2 lower;         ///< its lower left corner on the page [m]
    double scale;       ///< metres of cloth per metre of paper

    Vec2 at(const Vec2& p) const { return lower + (p - Vec2(start, 0)) / scale; }
    Points2 at(const Points2& points) const {
        return (points.rowwise() - Eigen::RowVector2d(start, 0)) / scale +
               lower.transpose().replicate(points.rows(), 1);
    }
};

Points2 closed(const Points2& outline) {
    Points2 line(outline.rows() + 1, 2);
    line << outline, outline.row(0);
    return line;
}

/// Draws the outline, and the grain with the name below it where there is most room.
void draw_piece(PdfCanvas& canvas, const PageStrip& strip, const PatternPiece& piece) {
    canvas.line(strip.at(closed(piece.outline())), cut_ink);
    const Circle room = largest_circle_inside(piece.outline(), 0.01);
    const Vec2 middle = strip.at(room.centre);
    const double radius = room.radius / strip.scale, height = std::min(letters, radius / 2);
    canvas.text({piece.name, middle - Vec2(0, 0.9 * height), height}, black, Align::middle, 1.8 * radius);
    if (piece.grain_line.rows() != 2) return;
    const Vec2 along = Vec2(piece.grain_line.row(1) - piece.grain_line.row(0)).normalized();
    const Vec2 across(-along.y(), along.x());
    const Vec2 centre = middle + Vec2(0, 0.9 * height), head = centre + 0.6 * radius * along;
    canvas.line(centre - 0.6 * radius * along, head, grain_ink);
    for (const double side : {0.4, -0.4}) canvas.line(head, head - 0.5 * height * (along + side * across), grain_ink);
}

void draw_strip(PdfCanvas& canvas, const PageStrip& strip, const Marker& marker,
                const std::vector<PatternPiece>& pieces) {
    const Vec2 upper = strip.at(Vec2(strip.end, marker.roll_width));
    canvas.rectangle(strip.lower, upper, roll_ink);
    canvas.begin_clip(strip.lower - Vec2::Constant(0.0002), upper + Vec2::Constant(0.0002));
    for (const PatternPiece& piece : pieces)
        if (piece.upper().x() > strip.start && piece.lower().x() < strip.end) draw_piece(canvas, strip, piece);
    for (const RollPart& part : marker.parts)
        if (part.start > strip.start)
            canvas.line(strip.at(Vec2(part.start, 0)), strip.at(Vec2(part.start, marker.roll_width)), {black, 0.0006});
    canvas.end_clip();
    for (double metre = std::ceil(strip.start); metre <= strip.end; ++metre) {
        const Vec2 foot = strip.at(Vec2(metre, 0));
        canvas.line(foot, foot - Vec2(0, 0.0015), roll_ink);
        canvas.text({format_fixed(metre, 0) + " m", foot - Vec2(0, 0.0032), 0.0018}, black);
    }
}

}  // namespace

void write_marker_pdf(std::ostream& out, const Marker& marker, const std::vector<PatternPiece>& pieces,
                      const std::string& title) {
    constexpr double margin = Paper::margin;
    const double pitch = (page_size.y() - 2 * margin - title_height) / strips_a_page;
    const double scale = round_scale(marker.roll_width / (pitch - metres_height));
    const double reach = (page_size.x() - 2 * margin) * scale;  // length of a strip, on the roll
    const int strips = std::max(1, static_cast<int>(std::ceil(marker.length / reach - 1e-9)));
    const int pages = (strips + strips_a_page - 1) / strips_a_page;
    PdfCanvas canvas(title);
    for (int i = 0; i < strips; ++i) {
        const int page = i / strips_a_page, place = i % strips_a_page;
        if (place == 0) {
            canvas.begin_page(page_size, std::to_string(page + 1));
            const Vec2 head(margin, page_size.y() - margin - title_height / 2);
            const std::string text = title + ", 1:" + format_shortest(scale) + ", page " + std::to_string(page + 1) +
                                     " of " + std::to_string(pages);
            canvas.text({text, head, 0.003}, black, Align::left, page_size.x() - 2 * margin);
        }
        const double top = page_size.y() - margin - title_height - place * pitch;
        const PageStrip strip{i * reach, std::min(marker.length, (i + 1) * reach),
                              Vec2(margin, top - marker.roll_width / scale), scale};
        draw_strip(canvas, strip, marker, pieces);
    }
    const std::string bytes = canvas.finish();
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace ripstop

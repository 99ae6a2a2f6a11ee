#include "ripstop/io/print/pdf_canvas.h"

#include <cairo-pdf.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ripstop/io/print/letters.h"
#include "ripstop/io/text/cairo.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

constexpr double point = 0.0254 / 72;  // [m]

/// cairo cannot request printing without scaling. So this appends the catalogue once more, with that request in
/// it, as an incremental update of PDF 1.4. The key is from PDF 1.6, and the catalogue states that version.
std::string with_true_size(std::string pdf) {
    const auto after = [&pdf](const std::string& text, std::size_t from) {
        const std::size_t at = pdf.find(text, from);
        if (at == std::string::npos) throw std::runtime_error("cairo's PDF has no " + text);
        return at + text.size();
    };
    const auto number_at = [&pdf](std::size_t at) {
        at = pdf.find_first_not_of(" \n", at);
        return pdf.substr(at, pdf.find_first_not_of("0123456789", at) - at);
    };
    const std::size_t trailer = pdf.rfind("trailer");
    if (trailer == std::string::npos) throw std::runtime_error("cairo's PDF has no trailer");
    const std::string root = number_at(after("/Root", trailer)), size = number_at(after("/Size", trailer));
    const std::string info = number_at(after("/Info", trailer)), before = number_at(after("startxref", trailer));
    const std::size_t first = after("\n" + root + " 0 obj", 0);
    const std::string object = pdf.substr(first, pdf.find("endobj", first) - first);
    const std::size_t dictionary = object.find("<<");
    if (dictionary == std::string::npos) throw std::runtime_error("cairo's PDF has no catalogue");

    if (pdf.back() != '\n') pdf += '\n';
    const std::string at = std::to_string(pdf.size());
    pdf += root + " 0 obj\n<< /ViewerPreferences << /PrintScaling /None >> /Version /1.6" +
           object.substr(dictionary + 2) + "endobj\n";
    const std::size_t table = pdf.size();
    pdf += "xref\n" + root + " 1\n" + std::string(10 - at.size(), '0') + at + " 00000 n \ntrailer\n<< /Size " + size +
           " /Root " + root + " 0 R /Info " + info + " 0 R /Prev " + before + " >>\nstartxref\n" +
           std::to_string(table) + "\n%%EOF\n";
    return pdf;
}

}  // namespace

struct PdfCanvas::Cairo {
    std::string bytes;
    cairo_surface_t* surface = nullptr;
    cairo_t* context = nullptr;
    double page_height = 0;  // [points]
    int pages = 0;

    void go(const Vec2& p) const { cairo_move_to(context, p.x() / point, page_height - p.y() / point); }
    void draw(const Vec2& p) const { cairo_line_to(context, p.x() / point, page_height - p.y() / point); }
    void stroke(const Ink& ink, double dashed = 0) const {
        std::vector<double> dashes;
        for (const double length : ink.dashes) dashes.push_back(length / point);
        cairo_set_dash(context, dashes.data(), static_cast<int>(dashes.size()), dashed / point);
        cairo_set_source_rgb(context, ink.colour[0], ink.colour[1], ink.colour[2]);
        cairo_set_line_width(context, ink.width / point);
        cairo_stroke(context);
    }
};

PdfCanvas::PdfCanvas(const std::string& title, const std::string& date) : cairo_(std::make_unique<Cairo>()) {
    cairo_->surface = cairo_pdf_surface_create_for_stream(append_to_text, &cairo_->bytes, 1, 1);
    cairo_pdf_surface_restrict_to_version(cairo_->surface, CAIRO_PDF_VERSION_1_4);
    cairo_pdf_surface_set_metadata(cairo_->surface, CAIRO_PDF_METADATA_TITLE, readable_name(title).c_str());
    cairo_pdf_surface_set_metadata(cairo_->surface, CAIRO_PDF_METADATA_CREATOR, "Ripstop");
    // Empty means no date; cairo would write today's.
    const std::string noon = date.empty() ? "" : date + "T12:00:00Z";
    cairo_pdf_surface_set_metadata(cairo_->surface, CAIRO_PDF_METADATA_CREATE_DATE, noon.c_str());
    cairo_->context = cairo_create(cairo_->surface);
    cairo_set_line_join(cairo_->context, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(cairo_->context, CAIRO_LINE_CAP_BUTT);
    choose_letters(cairo_->context);
}

PdfCanvas::~PdfCanvas() {
    cairo_destroy(cairo_->context);
    cairo_surface_destroy(cairo_->surface);
}

void PdfCanvas::begin_page(const Vec2& size, const std::string& name) {
    if (cairo_->pages++ > 0) cairo_show_page(cairo_->context);
    cairo_->page_height = size.y() / point;
    cairo_pdf_surface_set_size(cairo_->surface, size.x() / point, cairo_->page_height);
    cairo_pdf_surface_set_page_label(cairo_->surface, readable_name(name).c_str());
}

void PdfCanvas::add_bookmark(const std::string& text) {
    const std::string here = "page=" + std::to_string(cairo_->pages);
    cairo_pdf_surface_add_outline(cairo_->surface, CAIRO_PDF_OUTLINE_ROOT, readable_name(text).c_str(), here.c_str(),
                                  static_cast<cairo_pdf_outline_flags_t>(0));
}

void PdfCanvas::begin_clip(const Vec2& lower, const Vec2& upper) {
    cairo_save(cairo_->context);
    const Vec2 size = (upper - lower) / point;
    cairo_rectangle(cairo_->context, lower.x() / point, cairo_->page_height - upper.y() / point, size.x(), size.y());
    cairo_clip(cairo_->context);
}

void PdfCanvas::end_clip() {
    cairo_restore(cairo_->context);
}

void PdfCanvas::line(const Points2& points, const Ink& ink, double dashed) {
    for (Eigen::Index i = 0; i < points.rows(); ++i) i == 0 ? cairo_->go(points.row(i)) : cairo_->draw(points.row(i));
    cairo_->stroke(ink, dashed);
}

void PdfCanvas::line(const Vec2& from, const Vec2& to, const Ink& ink) {
    cairo_->go(from);
    cairo_->draw(to);
    cairo_->stroke(ink);
}

void PdfCanvas::rectangle(const Vec2& lower, const Vec2& upper, const Ink& ink) {
    cairo_->go(lower);
    cairo_->draw({upper.x(), lower.y()});
    cairo_->draw(upper);
    cairo_->draw({lower.x(), upper.y()});
    cairo_close_path(cairo_->context);
    cairo_->stroke(ink);
}

void PdfCanvas::circle(const Vec2& centre, double radius, const Ink& ink) {
    constexpr double whole = 6.283185307179586;
    cairo_new_path(cairo_->context);
    cairo_arc(cairo_->context, centre.x() / point, cairo_->page_height - centre.y() / point, radius / point, 0, whole);
    cairo_->stroke(ink);
}

void PdfCanvas::text(const Label& label, const Colour& colour, Align align, double longest) {
    cairo_t* context = cairo_->context;
    set_letter_height(context, label.height / point);
    const std::string text = writable(context, label.text);
    cairo_text_extents_t extents;
    cairo_text_extents(context, text.c_str(), &extents);
    const double shrunk = std::min(1.0, longest / point / std::max(extents.x_advance, 1e-9));
    if (shrunk < 1) set_letter_height(context, shrunk * label.height / point);
    const double before = align == Align::left ? 0 : align == Align::middle ? 0.5 : 1;
    cairo_save(context);
    cairo_translate(context, label.middle.x() / point, cairo_->page_height - label.middle.y() / point);
    cairo_rotate(context, -label.turn);
    cairo_move_to(context, -before * shrunk * extents.x_advance, shrunk * label.height / point / 2);
    cairo_set_source_rgb(context, colour[0], colour[1], colour[2]);
    cairo_show_text(context, text.c_str());
    cairo_restore(context);
    cairo_new_path(context);
}

std::string PdfCanvas::finish() {
    if (cairo_->pages > 0) cairo_show_page(cairo_->context);
    const cairo_status_t drawn = cairo_status(cairo_->context);
    cairo_surface_finish(cairo_->surface);
    const cairo_status_t written = cairo_surface_status(cairo_->surface);
    const cairo_status_t status = drawn != CAIRO_STATUS_SUCCESS ? drawn : written;
    if (status != CAIRO_STATUS_SUCCESS)
        throw std::runtime_error(std::string("the PDF could not be made: ") + cairo_status_to_string(status));
    return with_true_size(cairo_->bytes);
}

}  // namespace ripstop

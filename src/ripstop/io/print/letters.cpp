#include "ripstop/io/print/letters.h"

#include <cairo.h>

#include <cmath>
#include <memory>

#include "ripstop/io/text/cairo.h"
#include "ripstop/io/text/escape.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

Points2 rows_of(const std::vector<Vec2>& points) {
    Points2 rows(static_cast<Eigen::Index>(points.size()), 2);
    for (std::size_t i = 0; i < points.size(); ++i) rows.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
    return rows;
}

/// The polylines of a flattened path, y down.
std::vector<std::vector<Vec2>> runs_of(const cairo_path_t& path) {
    std::vector<std::vector<Vec2>> runs;
    for (int i = 0; i < path.num_data; i += path.data[i].header.length) {
        const cairo_path_data_t* data = path.data + i;
        if (data->header.type == CAIRO_PATH_MOVE_TO) runs.emplace_back();
        if (data->header.type == CAIRO_PATH_CLOSE_PATH)
            runs.back().push_back(runs.back().front());
        else
            runs.back().emplace_back(data[1].point.x, data[1].point.y);
    }
    return runs;
}

}  // namespace

void choose_letters(cairo_t* context) {
    cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_font_options_t* options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_set_font_options(context, options);
    cairo_font_options_destroy(options);
}

std::string writable(cairo_t* context, const std::string& text) {
    const bool is_own_font = cairo_scaled_font_get_type(cairo_get_scaled_font(context)) == CAIRO_FONT_TYPE_USER;
    return is_own_font ? ascii_text(text) : readable_name(text);
}

void set_letter_height(cairo_t* context, double height) {
    constexpr double em = 1000;
    cairo_set_font_size(context, em);
    cairo_text_extents_t capital;
    cairo_text_extents(context, "H", &capital);
    cairo_set_font_size(context, height * em / (capital.height > 0 ? capital.height : em));
}

std::vector<Points2> letter_outlines(const Label& label) {
    constexpr double height = 200;  // height of capitals while they are flattened, to a tolerance of 1
    const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1), cairo_surface_destroy);
    const CairoContext context(cairo_create(surface.get()), cairo_destroy);
    choose_letters(context.get());
    set_letter_height(context.get(), height);
    cairo_set_tolerance(context.get(), 1);
    const std::string text = writable(context.get(), label.text);
    cairo_text_extents_t extents;
    cairo_text_extents(context.get(), text.c_str(), &extents);
    cairo_move_to(context.get(), 0, 0);
    cairo_text_path(context.get(), text.c_str());
    const CairoPath path(cairo_copy_path_flat(context.get()), cairo_path_destroy);

    const double scale = label.height / height;
    const Vec2 along(std::cos(label.turn), std::sin(label.turn)), up(-along.y(), along.x());
    std::vector<Points2> outlines;
    for (std::vector<Vec2>& run : runs_of(*path)) {
        if (run.size() < 3) continue;
        for (Vec2& point : run)
            point =
                label.middle + scale * ((point.x() - extents.x_advance / 2) * along - (point.y() + height / 2) * up);
        outlines.push_back(rows_of(run));
    }
    return outlines;
}

}  // namespace ripstop

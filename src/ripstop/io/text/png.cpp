#include "ripstop/io/text/png.h"

#include <cairo.h>
#include <librsvg/rsvg.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "ripstop/io/text/cairo.h"

namespace ripstop {
namespace {

struct Unref {
    void operator()(gpointer object) const { g_object_unref(object); }
};

[[noreturn]] void fail(const std::string& why) {
    throw std::runtime_error("a picture could not be made: " + why);
}

void require(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS) fail(cairo_status_to_string(status));
}

void paint(cairo_t* context, const PlacedPixels& placed) {
    const Pixels& pixels = placed.pixels;
    const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels.width, pixels.height),
                               cairo_surface_destroy);
    require(cairo_surface_status(surface.get()));
    const auto width = static_cast<std::size_t>(pixels.width);
    const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get())) / sizeof(std::uint32_t);
    auto* const rows = reinterpret_cast<std::uint32_t*>(cairo_image_surface_get_data(surface.get()));
    for (std::size_t y = 0; y < static_cast<std::size_t>(pixels.height); ++y)
        std::copy_n(pixels.colours.begin() + static_cast<std::ptrdiff_t>(y * width), width, rows + y * stride);
    cairo_surface_mark_dirty(surface.get());
    cairo_save(context);
    cairo_translate(context, placed.at.x(), placed.at.y());
    cairo_scale(context, 1 / placed.per_unit, 1 / placed.per_unit);
    cairo_set_source_surface(context, surface.get(), 0, 0);
    cairo_pattern_set_filter(cairo_get_source(context), CAIRO_FILTER_GOOD);
    cairo_paint(context);
    cairo_restore(context);
}

using Drawing = std::unique_ptr<RsvgHandle, Unref>;

[[noreturn]] void fail_with(GError* error) {
    const std::string why = error ? error->message : "librsvg gives no reason";
    g_clear_error(&error);
    fail(why);
}

Drawing read(const std::string& svg) {
    GError* error = nullptr;
    const std::unique_ptr<GInputStream, Unref> stream(
        g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr));
    // Unlimited, because the outlines of a large envelope are one path of many megabytes.
    Drawing drawing(
        rsvg_handle_new_from_stream_sync(stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error));
    if (!drawing) fail_with(error);
    return drawing;
}

Vec2 size_of(RsvgHandle* drawing) {
    Vec2 size;
    if (!rsvg_handle_get_intrinsic_size_in_pixels(drawing, &size.x(), &size.y())) fail("the drawing states no size");
    return size;
}

void draw(cairo_t* context, RsvgHandle* drawing) {
    GError* error = nullptr;
    const Vec2 size = size_of(drawing);
    const RsvgRectangle page{0, 0, size.x(), size.y()};
    if (!rsvg_handle_render_document(drawing, context, &page, &error)) fail_with(error);
}

}  // namespace

std::string png_picture(const std::string& svg, const std::vector<PlacedPixels>& beneath) {
    const Drawing drawing = read(svg);
    const Eigen::Vector2i size = size_of(drawing.get()).array().ceil().cast<int>();
    const CairoSurface page(cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.x(), size.y()), cairo_surface_destroy);
    const CairoContext context(cairo_create(page.get()), cairo_destroy);
    cairo_set_source_rgb(context.get(), 1, 1, 1);
    cairo_paint(context.get());
    for (const PlacedPixels& pixels : beneath) paint(context.get(), pixels);
    draw(context.get(), drawing.get());
    require(cairo_status(context.get()));
    std::string bytes;
    require(cairo_surface_write_to_png_stream(page.get(), append_to_text, &bytes));
    return bytes;
}

}  // namespace ripstop

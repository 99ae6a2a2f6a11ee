#pragma once

#include <cairo.h>

#include <memory>
#include <string>

namespace ripstop {

/// What cairo makes, released by itself.
using CairoSurface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using CairoContext = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
using CairoPath = std::unique_ptr<cairo_path_t, decltype(&cairo_path_destroy)>;

/// Appends what cairo writes to a text; `text` is a std::string. A cairo_write_func_t.
inline cairo_status_t append_to_text(void* text, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

}  // namespace ripstop

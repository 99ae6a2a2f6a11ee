#include "ripstop/io/dxf/dxf_dialect.h"

#include <array>

#include "ripstop/base/error.h"

namespace ripstop {
namespace {

using NotchMark = DxfDialect::NotchMark;
constexpr const char* d6673 = "ASTM/D13Proposal 1 Version: D 6673-04";

}  // namespace

std::span<const DxfDialect> dxf_dialects() {
    static const std::array dialects{
        DxfDialect{.name = "cam",
                   .description = "contours on layers CUT, SEW, NOTCH, …: cutters, lasers, Rhino, AutoCAD",
                   .blocks = false,
                   .states_insunits = true,
                   .notch = NotchMark::line},
        DxfDialect{.name = "aama",
                   .description = "ANSI/AAMA-292, one block per piece: Lectra, Optitex, GRAFIS, other garment CAD",
                   .closed_contours = false},
        DxfDialect{.name = "astm",
                   .description = "the layers of ASTM D6673-10, notches with their depth, mirrored pieces counted",
                   .closed_contours = false,
                   .counts_mirrored = true,
                   .standard = d6673,
                   .packs_author = true,
                   .notch = NotchMark::sized_point},
        DxfDialect{.name = "gerber",
                   .description = "ASTM as Gerber AccuMark takes it: empty header, no tables, nothing but pieces",
                   .closed_contours = false,
                   .release = {},
                   .tables = false,
                   .copies_grain = true,
                   .counts_mirrored = true,
                   .standard = d6673,
                   .packs_author = true,
                   .notch = NotchMark::sized_point,
                   .depth_sign = -1,
                   .notch_width = 0.003},
        DxfDialect{.name = "clo",
                   .description = "CLO and Marvelous Designer: Release 10, closed contours, grain along +y",
                   .release = "AC1006",
                   .tables = false,
                   .grain_up = true,
                   .upper_case_keys = true,
                   .day_first = true},
        DxfDialect{.name = "et",
                   .description = "ET and other old CAD: numbers only, nothing on layer 0, notches as short lines",
                   .comment = "ANSI/AAMA",
                   .block_layer = "1",
                   .notch = NotchMark::line},
    };
    return dialects;
}

const DxfDialect& dxf_dialect_named(const std::string& name) {
    std::string known;
    for (const DxfDialect& dialect : dxf_dialects()) {
        if (dialect.name == name) return dialect;
        known += (known.empty() ? "" : ", ") + dialect.name;
    }
    throw InputError("no DXF dialect \"" + name + "\"; known: " + known);
}

}  // namespace ripstop

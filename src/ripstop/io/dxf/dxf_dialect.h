#pragma once

#include <span>
#include <string>

namespace ripstop {

/// A habit of writing patterns as DXF, as constants. All are ASCII, millimetres, CR LF, four decimals.
///
/// `cam` draws contours on layers with names, for cutters and CAD. The others put each piece in a BLOCK, on the
/// numbered layers of ANSI/AAMA-292 and of the (withdrawn) ASTM D6673-10, for garment CAD; docs/dialects.md says for
/// which.
struct DxfDialect {
    enum class NotchMark {
        line,         ///< a LINE from the cut line inwards, a slit
        point,        ///< a POINT on the cut line with the angle inwards (50)
        sized_point,  ///< the same with depth (30) and width (39)
    };

    std::string name;
    std::string description;         ///< a line for --help
    bool blocks = true;              ///< a BLOCK a piece on numbered layers; else contours on named layers
    bool closed_contours = true;     ///< a closed POLYLINE a contour; else an open one an edge, each beginning where
                                     ///< the one before ends
    std::string release = "AC1009";  ///< $ACADVER; none: the header is empty
    bool tables = true;              ///< a TABLES section: line type, layers, text style
    bool states_insunits = false;    ///< $INSUNITS and $MEASUREMENT stand in the header
    std::string comment = {};        ///< of the first line (999)
    const char* block_layer = "0";   ///< of BLOCK and ENDBLK themselves
    bool grain_up = false;           ///< the grain runs along +y: everything is turned by a quarter
    bool copies_grain = false;       ///< on layer 5 too
    bool upper_case_keys = false;    ///< `PIECE NAME:` for `Piece Name:`
    bool day_first = false;          ///< DD-MM-YYYY, else MM-DD-YYYY
    bool counts_mirrored = false;    ///< `Quantity: 2,1`: as drawn, mirrored; else their sum
    std::string standard = {};       ///< a text of its own that names it
    bool packs_author = false;       ///< `vendor ; product ; version` in one text
    NotchMark notch = NotchMark::point;
    double depth_sign = 1;   ///< of a sized notch's depth
    double notch_width = 0;  ///< of a sized notch; 0: not stated, for ezdxf 0.18 cannot move a POINT of width 0 [m]
};

/// Every dialect; the command line, the tests and the documentation walk it.
std::span<const DxfDialect> dxf_dialects();

/// Throws InputError that names the known ones.
const DxfDialect& dxf_dialect_named(const std::string& name);

}  // namespace ripstop

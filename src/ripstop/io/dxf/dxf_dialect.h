#pragma once

#include <span>
#include <string>

namespace ripstop {

/// A convention for patterns in DXF, as constants. Every dialect is ASCII, in millimetres, with CR LF and four
/// decimals.
///
/// `cam` draws contours on named layers, for cutters and CAD. The others put each piece in a BLOCK on the numbered
/// layers of ANSI/AAMA-292 and of ASTM D6673-10 (withdrawn), for garment CAD; docs/dialects.md lists the programs.
struct DxfDialect {
    enum class NotchMark {
        line,         ///< a LINE from the cut line inwards, a slit
        point,        ///< a POINT on the cut line; its angle (50) points inwards
        sized_point,  ///< the same with depth (30) and width (39)
    };

    std::string name;
    std::string description;         ///< one line for --help
    bool blocks = true;              ///< each piece is a BLOCK on numbered layers; else contours on named layers
    bool closed_contours = true;     ///< a closed POLYLINE for each contour; else an open one for each edge, end
                                     ///< to start
    std::string release = "AC1009";  ///< $ACADVER; empty: the header is empty
    bool tables = true;              ///< write a TABLES section: line type, layers, text style
    bool states_insunits = false;    ///< write $INSUNITS and $MEASUREMENT in the header
    std::string comment = {};        ///< in the first line (999)
    const char* block_layer = "0";   ///< of BLOCK and ENDBLK themselves
    bool grain_up = false;           ///< the grain runs along +y, so the drawing is turned by 90 degrees
    bool copies_grain = false;       ///< draw the grain on layer 5 too
    bool upper_case_keys = false;    ///< `PIECE NAME:` instead of `Piece Name:`
    bool day_first = false;          ///< DD-MM-YYYY, else MM-DD-YYYY
    bool counts_mirrored = false;    ///< `Quantity: 2,1`: as drawn, mirrored; else one sum
    std::string standard = {};       ///< text that names the standard; empty: none
    bool packs_author = false;       ///< write `vendor ; product ; version` as one text
    NotchMark notch = NotchMark::point;
    double depth_sign = 1;   ///< sign of a sized notch's depth
    double notch_width = 0;  ///< of a sized notch [m]; 0: not written (ezdxf 0.18 cannot move a POINT of width 0)
};

/// The table of dialects, which the command line, the tests and the documentation iterate.
std::span<const DxfDialect> dxf_dialects();

/// The dialect with this name. Throws InputError that lists the known ones.
const DxfDialect& dxf_dialect_named(const std::string& name);

}  // namespace ripstop

#pragma once

#include <optional>
#include <string_view>

#include "ripstop/base/text/units.h"

/// The units that drawings state; nothing where the value states none.
namespace ripstop {

/// The number of $INSUNITS: 1 inch, 2 foot, 4 mm, 5 cm, 6 m.
std::optional<LengthUnit> unit_of_insunits(std::string_view value);

/// A text `Units: METRIC` (millimetres), `ENGLISH` (inches) or of a unit itself, in any case of letters.
std::optional<LengthUnit> unit_of_text(std::string_view text);

/// A length such as `210mm`, `8.5in` or `100`: its number; the unit is none for a bare number or px.
struct StatedLength {
    double number = 0;
    std::optional<LengthUnit> unit;
};
std::optional<StatedLength> stated_length(std::string_view text);

}  // namespace ripstop

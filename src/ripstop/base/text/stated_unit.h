#pragma once

#include <optional>
#include <string_view>

#include "ripstop/base/text/units.h"

// The unit that a drawing states; empty if the value states none.
namespace ripstop {

/// The unit of an $INSUNITS number: 1 inch, 2 foot, 4 mm, 5 cm, 6 m.
std::optional<LengthUnit> unit_of_insunits(std::string_view value);

/// The unit of a text `Units: METRIC` (millimetres), `ENGLISH` (inches) or of a unit's own name; case does not
/// matter.
std::optional<LengthUnit> unit_of_text(std::string_view text);

/// A parsed length such as `210mm`, `8.5in` or `100`. The unit is empty for a bare number or px.
struct StatedLength {
    double number = 0;
    std::optional<LengthUnit> unit;
};
std::optional<StatedLength> stated_length(std::string_view text);

}  // namespace ripstop

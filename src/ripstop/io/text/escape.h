#pragma once

#include <string>
#include <string_view>

namespace ripstop {

/// UTF-8 text in 7-bit ASCII, for R12 files and file names: Latin letters lose their accents, Greek and Cyrillic ones
/// are spelled in Latin, control characters become spaces, bytes that are no UTF-8 `?`, all else its code, so that two
/// names stay two. "Bílý dráček" gives "Bily dracek", "Straße" "Strasse", "Шар" "Shar", "日本" "U65E5U672C".
std::string ascii_text(std::string_view utf8);

/// UTF-8 text for XML content and attribute values: & < > " ' escaped; what XML cannot hold (control characters, bytes
/// that are no UTF-8) becomes U+FFFD.
std::string xml_text(std::string_view utf8);

}  // namespace ripstop

#pragma once

#include <string>
#include <string_view>

namespace ripstop {

/// UTF-8 text in 7-bit ASCII, for R12 files and file names. Latin letters lose their accents, Greek and Cyrillic
/// letters are transliterated, control characters become spaces, invalid bytes become `?`. Every other character
/// becomes its code, so that different names stay different. "Bílý dráček" gives "Bily dracek", "Straße"
/// "Strasse", "Шар" "Shar", "日本" "U65E5U672C".
std::string ascii_text(std::string_view utf8);

/// UTF-8 text for XML content and attribute values. Escapes & < > " '; characters that XML cannot hold (control
/// characters, invalid bytes) become U+FFFD.
std::string xml_text(std::string_view utf8);

}  // namespace ripstop

#pragma once

#include <string>
#include <string_view>

namespace ripstop {

/// UTF-8 text in 7-bit ASCII, for R12 files and file names: Latin letters lose their accents, control characters become
/// spaces, all else becomes `?`. "Bílý dráček" gives "Bily dracek".
std::string ascii_text(std::string_view utf8);

/// UTF-8 text for XML content and attribute values: & < > " ' escaped; what XML cannot hold (control characters, bytes that
/// are no UTF-8) becomes U+FFFD.
std::string xml_text(std::string_view utf8);

}  // namespace ripstop

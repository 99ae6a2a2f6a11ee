#include <gtest/gtest.h>

#include <cstdlib>

#include "ripstop/io/dxf/dxf_dialect.h"
#include "ripstop/version.h"
#include "support/dxf_pieces.h"
#include "support/outside.h"

/// Compares the files of tests/data/golden byte for byte, so that no dialect changes unnoticed. If a change is
/// intended, read the difference after
///
///     RIPSTOP_RENEW_GOLDEN=1 build/release/ripstop-tests --gtest_filter='GoldenDxf.*' && git diff tests/data/golden
namespace ripstop {
namespace dxf_golden_test {

/// Removes our version, the only thing in them that changes by itself.
std::string without_version(std::string text) {
    const std::string stated = version;
    for (std::size_t at; (at = text.find(stated + "\r\n")) != std::string::npos;)
        text.replace(at, stated.size(), "X.Y.Z");
    return text;
}

TEST(GoldenDxf, IsWhatIsWritten) {
    DxfOptions options;
    options.style = std::string("balloon.obj");
    options.revision = "B";
    options.date = std::string("2026-11-02");
    const std::vector<PatternPiece> all = testing::sample_pieces();
    for (const DxfDialect& dialect : dxf_dialects()) {
        const std::string file = RIPSTOP_SOURCE_DIR "/tests/data/golden/" + dialect.name + ".dxf";
        const std::string text = without_version(testing::dxf_of({all[0], all[2]}, dialect.name, options));
        if (std::getenv("RIPSTOP_RENEW_GOLDEN")) testing::write_text(file, text);
        EXPECT_EQ(testing::content(file), text) << file;
    }
}

}  // namespace dxf_golden_test
}  // namespace ripstop

#include "support/dxf_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "ripstop/pattern/cut/cut_line.h"
#include "support/flat_tiles.h"

namespace ripstop::testing {
namespace {

Points2 rectangle(const Vec2& lower, const Vec2& size) {
    Points2 corners(4, 2);
    corners << 0, 0, size.x(), 0, size.x(), size.y(), 0, size.y();
    corners.rowwise() += lower.transpose();
    return corners;
}

PatternPiece disk(const std::string& name, const Vec2& centre, double radius) {
    PatternPiece piece;
    piece.name = name;
    piece.sew_line.resize(90, 2);
    for (int i = 0; i < 90; ++i) {
        const double angle = 2 * std::numbers::pi * i / 90;
        piece.sew_line.row(i) = (centre + radius * Vec2(std::cos(angle), std::sin(angle))).transpose();
    }
    piece.edges = {{0, 2 * std::numbers::pi * radius}};
    piece.cut_line = piece.sew_line;
    return piece;
}

}  // namespace

PatternPiece sample_piece(const std::string& name, const Vec2& at, const Vec2& size) {
    PatternPiece piece;
    piece.name = name;
    piece.sew_line = rectangle(at, size);
    for (int i = 0; i < 4; ++i) piece.edges.push_back({i, i % 2 == 0 ? size.x() : size.y(), 0.01, "flat-felled"});
    piece.cut_line = rectangle(at - Vec2(0.01, 0.01), size + Vec2(0.02, 0.02));
    for (const int count : {1, 2}) {
        PieceNotch notch;
        notch.edge = 1;
        notch.seam = "S001";
        notch.on_sew = at + Vec2(size.x(), size.y() * count / 3);
        notch.reach = 0.01;
        notch.depth = 0.004;
        notch.count = count;
        piece.notches.push_back(notch);
    }
    piece.grain_line.resize(2, 2);
    piece.grain_line << at.x() + 0.25 * size.x(), at.y() + 0.6 * size.y(), at.x() + 0.75 * size.x(),
        at.y() + 0.6 * size.y();
    piece.lines.push_back({"tape", rectangle(at + 0.1 * size, 0.2 * size).topRows(3)});
    piece.labels = {{name, at + Vec2(0.5 * size.x(), 0.3 * size.y()), 0.02, 0},
                    {"G02P01", at + Vec2(0.95 * size.x(), 0.5 * size.y()), 0.008, std::numbers::pi / 2}};
    piece.quantity = 2;
    piece.quantity_mirrored = 1;
    piece.row = "03";
    piece.fabric = "nylon";
    return piece;
}

std::vector<PatternPiece> sample_pieces() {
    FlatTile tile = sinusoidal_gore("gore");
    tile.flattening.positions.col(1).array() += 1;  // above the others
    const PatternPiece gore = piece_of(tile);
    return {sample_piece("G01P03"), disk("crown", Vec2(0.7, 0.12), 0.1),
            sample_piece("narrow", Vec2(0.02, 0.4), Vec2(0.9, 0.03)), gore};
}

std::string dxf_of(const std::vector<PatternPiece>& pieces, const std::string& dialect, DxfOptions options) {
    options.dialect = dialect;
    std::ostringstream out;
    write_dxf(out, pieces, {}, options);
    return out.str();
}

DxfPairs dxf_pairs(const std::string& text) {
    DxfPairs result;
    std::istringstream in(text);
    std::string code, value;
    while (std::getline(in, code) && std::getline(in, value)) {
        EXPECT_EQ(code.back(), '\r');
        EXPECT_EQ(value.back(), '\r');
        result.emplace_back(std::stoi(code), value.substr(0, value.size() - 1));
    }
    return result;
}

std::vector<DxfPairs> dxf_entities(const DxfPairs& pairs, const std::string& kind) {
    std::vector<DxfPairs> entities;
    bool is_taken = false;
    for (const auto& [code, value] : pairs) {
        if (code == 0) {
            is_taken = kind.empty() || value == kind;
            if (is_taken) entities.emplace_back();
        }
        if (is_taken) entities.back().emplace_back(code, value);
    }
    return entities;
}

std::string value_of(const DxfPairs& entity, int code) {
    for (const auto& [found, value] : entity)
        if (found == code) return value;
    return "";
}

}  // namespace ripstop::testing

#include <gmock/gmock.h>

#include <algorithm>
#include <clocale>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <locale>
#include <sstream>

#include "ripstop/base/error.h"
#include "ripstop/io/mesh/mesh_file.h"
#include "support/refusal.h"
#include "support/sanitized.h"
#include "support/shapes.h"
#include "support/shared_data.h"

namespace ripstop {

void PrintTo(const MeshFormat& format, std::ostream* out) {
    *out << format.extension;
}

namespace every_format_test {

#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

/// Processor time of this process, so that other load on the machine does not count.
double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Properties of every format that can be written. The table states what a format does not preserve.
class EveryFormat : public ::testing::TestWithParam<MeshFormat> {
  protected:
    static std::string written(const std::vector<NamedMesh>& surfaces) {
        std::ostringstream out;
        GetParam().write(out, surfaces);
        return out.str();
    }
    static std::vector<NamedMesh> read(const std::string& bytes, double metres_per_unit = 1) {
        std::istringstream in(bytes);
        return in_metres(GetParam().read(in, "tiles" + std::string(GetParam().extension)), metres_per_unit).surfaces;
    }
};

/// Coordinates with many digits and of very different sizes, and a surface with drawn positions beside one
/// without.
std::vector<NamedMesh> some_surfaces() {
    std::vector<NamedMesh> surfaces;
    surfaces.push_back({"G01P01", testing::moved(testing::octant(3)), std::nullopt});
    const TriangleMesh saddle = testing::moved(testing::saddle(1.0 / 3, 0.7, 3));
    surfaces.push_back({"G01P02 crown", saddle, Points2(saddle.positions.leftCols<2>() * 0.1)});
    surfaces.push_back({"H\xC3\xBClle", testing::scaled(testing::cap(0.4, 2), 1.23456789e-7), std::nullopt});
    surfaces.back().mesh.positions(0, 0) = -0.0;
    return surfaces;
}

/// #F x 9: the corners of each triangle, which every format keeps.
Eigen::MatrixXd corners(const TriangleMesh& mesh) {
    Eigen::MatrixXd all(mesh.triangle_count(), 9);
    for (int t = 0; t < mesh.triangle_count(); ++t)
        all.row(t) << mesh.corner(t, 0).transpose(), mesh.corner(t, 1).transpose(), mesh.corner(t, 2).transpose();
    return all;
}

void expect_equal(const std::vector<NamedMesh>& a, const std::vector<NamedMesh>& b, const MeshKept& kept) {
    ASSERT_EQ(a.size(), b.size());
    const auto has_drawn = [](const NamedMesh& surface) { return surface.drawn.has_value(); };
    const bool drawn = kept.some_drawn || (kept.drawn && std::all_of(b.begin(), b.end(), has_drawn));
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (kept.names) {
            EXPECT_EQ(a[i].name, b[i].name);
        }
        EXPECT_EQ(corners(a[i].mesh), corners(b[i].mesh)) << b[i].name;
        if (kept.vertices) {
            EXPECT_EQ(a[i].mesh.positions, b[i].mesh.positions) << b[i].name;
            EXPECT_EQ(a[i].mesh.triangles, b[i].mesh.triangles) << b[i].name;
        }
        if (drawn) {
            EXPECT_EQ(a[i].drawn, b[i].drawn) << b[i].name;
        }
        if (kept.warp) {
            EXPECT_EQ(a[i].warp, b[i].warp) << b[i].name;
        }
    }
}

void expect_sound(const std::vector<NamedMesh>& surfaces) {
    ASSERT_FALSE(surfaces.empty());
    for (const NamedMesh& surface : surfaces) {
        EXPECT_FALSE(surface.name.empty());
        ASSERT_GT(surface.mesh.triangle_count(), 0);
        EXPECT_TRUE(surface.mesh.positions.allFinite());
        EXPECT_GE(surface.mesh.triangles.minCoeff(), 0);
        EXPECT_LT(surface.mesh.triangles.maxCoeff(), surface.mesh.vertex_count());
        if (surface.drawn) {
            EXPECT_EQ(surface.drawn->rows(), surface.mesh.positions.rows());
        }
    }
}

TEST_P(EveryFormat, GivesBackExactlyWhatItKeeps) {
    std::vector<NamedMesh> surfaces = some_surfaces();
    expect_equal(read(written(surfaces)), surfaces, GetParam().kept);
    EXPECT_EQ(written(read(written(surfaces))), written(surfaces));
    for (NamedMesh& surface : surfaces) surface.drawn = Points2(surface.mesh.positions.leftCols<2>() / 3);
    surfaces[1].warp = Points3::Random(surfaces[1].mesh.triangle_count(), 3);
    expect_equal(read(written(surfaces)), surfaces, GetParam().kept);
    EXPECT_EQ(written(read(written(surfaces))), written(surfaces));
}

TEST_P(EveryFormat, ScalesWhatItReadsToMetres) {
    std::vector<NamedMesh> surfaces = some_surfaces();
    for (NamedMesh& surface : surfaces) surface.drawn = Points2(surface.mesh.positions.leftCols<2>() / 3);
    const std::vector<NamedMesh> scaled = read(written(surfaces), 0.0254);
    EXPECT_EQ(corners(scaled[1].mesh), corners(surfaces[1].mesh) * 0.0254);
    if (GetParam().kept.drawn) {
        EXPECT_EQ(*scaled[1].drawn, *surfaces[1].drawn * 0.0254);
    }
}

TEST_P(EveryFormat, CutShortAnywhereIsASurfaceOrARefusal) {
    const TriangleMesh mesh = testing::octant(1);
    const std::string bytes = written({{"a", mesh, Points2(mesh.positions.leftCols<2>())}, {"b", mesh, std::nullopt}});
    int read_all_the_same = 0;
    for (std::size_t length = 0; length < bytes.size(); ++length) try {
            expect_sound(read(bytes.substr(0, length)));
            ++read_all_the_same;
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), ::testing::StartsWith("tiles" + std::string(GetParam().extension) + ":"));
        }
    EXPECT_LT(read_all_the_same, static_cast<int>(bytes.size()) / 2);
}

TEST_P(EveryFormat, DoesNotCareHowLinesEnd) {
    const std::string text = written(some_surfaces());
    if (text.find('\0') != std::string::npos) GTEST_SKIP() << "written in binary";
    std::string bytes;
    for (const char c : text) {
        if (c == '\n') bytes += '\r';
        bytes += c;
    }
    expect_equal(read(bytes), some_surfaces(), GetParam().kept);
}

/// Decimal comma and grouped thousands, as in much of the world.
struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST_P(EveryFormat, DoesNotCareForTheLocale) {
    const std::string expected = written(some_surfaces());
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    std::setlocale(LC_NUMERIC, "de_DE.UTF-8");  // for code that does not use streams, if the system has the locale
    const std::string bytes = written(some_surfaces());
    const std::vector<NamedMesh> again = read(expected);
    std::setlocale(LC_NUMERIC, "C");
    std::locale::global(before);
    EXPECT_EQ(bytes, expected);
    expect_equal(again, some_surfaces(), GetParam().kept);
}

TEST_P(EveryFormat, ReadsAMillionTrianglesInASecond) {
    RIPSTOP_TOO_LONG_SANITIZED();
    const int side = sanitized ? 100 : 708;  // 2 x 708² = 1,002,528 triangles
    const TriangleMesh mesh = testing::saddle(1, 3, side);
    const std::string bytes = written({{"large", mesh, std::nullopt}});
    const double start = processor_seconds();
    const std::vector<NamedMesh> surfaces = read(bytes);
    const double seconds = processor_seconds() - start;
    EXPECT_EQ(surfaces[0].mesh.triangle_count(), mesh.triangle_count());
    EXPECT_EQ(surfaces[0].mesh.vertex_count(), mesh.vertex_count());
    RecordProperty("milliseconds", static_cast<int>(1000 * seconds));
#ifdef NDEBUG
    EXPECT_LT(seconds, 3.0) << "a second on an idle machine; three leave room for a busy one";
#endif
}

TEST_P(EveryFormat, ReadsManySmallSurfacesAsFastAsOneLarge) {
    const int count = sanitized ? 2000 : 100000;
    std::vector<NamedMesh> surfaces;
    for (int i = 0; i < count; ++i) surfaces.push_back({std::to_string(i), testing::octant(1), std::nullopt});
    const std::string bytes = written(surfaces);
    const double start = processor_seconds();
    EXPECT_EQ(read(bytes).size(), surfaces.size());
    EXPECT_LT(processor_seconds() - start, 3.0) << "quadratic would take minutes";
}

/// Formats that are only read have their own tests: rhino_3dm_test.cpp.
std::vector<MeshFormat> written_formats() {
    std::vector<MeshFormat> formats(mesh_formats().begin(), mesh_formats().end());
    std::erase_if(formats, [](const MeshFormat& format) { return format.write == nullptr; });
    return formats;
}

INSTANTIATE_TEST_SUITE_P(, EveryFormat, ::testing::ValuesIn(written_formats()),
                         [](const auto& format) { return std::string(format.param.extension + 1); });

std::string refusal(const std::filesystem::path& path) {
    return testing::refusal([&] { read_model(path); });
}

TEST(MeshFile, RefusesWhatItCannotOpenOrDoesNotKnow) {
    EXPECT_THAT(refusal("no/such/tile.obj"), ::testing::StartsWith("no/such/tile.obj: the file cannot be opened"));
    EXPECT_THAT(refusal("tile.xyz"),
                ::testing::HasSubstr("no format with the extension \".xyz\", expected one of: .obj"));
    EXPECT_THAT(refusal("tile.Blend"),
                ::testing::HasSubstr("tile.Blend: a file of Blender, which is not read, expected one of: .obj"));
    EXPECT_THAT(refusal("tile.glb"), ::testing::HasSubstr("a file of binary glTF, which is not read, expected one of"));
    EXPECT_THAT(refusal("tile"), ::testing::HasSubstr("expected one of: .obj"));
    const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "ripstop_folder.obj";
    std::filesystem::create_directory(folder);
    EXPECT_THAT(refusal(folder), ::testing::HasSubstr("is a folder"));
    EXPECT_THROW(sha256_of_file(folder), InputError);
}

TEST(MeshFile, ReadsAndHashesAFileOfAnyCase) {
    const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / "ripstop_tile.OBJ";
    std::ofstream(path) << "abc";
    EXPECT_EQ(sha256_of_file(path), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_EQ(read_model(path).surfaces.at(0).name, "ripstop_tile");
}

std::string in_lower_case(std::string text) {
    for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

std::vector<std::filesystem::path> shared_files(const std::string& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code absent;
    const std::filesystem::path root = std::filesystem::path(RIPSTOP_SHARED_DATA) / folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root, absent))
        for (const MeshFormat& format : mesh_formats())
            if (in_lower_case(entry.path().extension().string()) == format.extension) files.push_back(entry.path());
    return files;
}

TEST(FilesOfOthers, NastyOnesAreAMeshOrASentenceThatNamesThem) {
    const auto files = shared_files("nasty");
    if (files.empty()) GTEST_SKIP() << "no files in " << RIPSTOP_SHARED_DATA << "/nasty";
    for (const auto& file : files) try {
            expect_sound(read_model(file).surfaces);
        } catch (const InputError& error) {
            EXPECT_THAT(error.what(), ::testing::StartsWith(file.string() + ":"));
        }
}

/// The area and the number of triangles of a whole file.
std::pair<double, int> measured(const std::filesystem::path& file) {
    std::pair<double, int> sum;
    for (const NamedMesh& surface : read_model(file).surfaces) {
        sum.first += surface_area(surface.mesh);
        sum.second += surface.mesh.triangle_count();
    }
    return sum;
}

TEST(FilesOfOthers, SameShapeInTwoFormatsIsReadAlike) {
    RIPSTOP_REQUIRE_SHARED(folder, "nasty/assimp");
    const auto spider = measured(folder / "STL__Spider_binary.stl");
    EXPECT_EQ(measured(folder / "STL__Spider_ascii.stl").second, spider.second);
    EXPECT_NEAR(measured(folder / "STL__Spider_ascii.stl").first, spider.first, 1e-6 * spider.first)
        << "single precision";
    const auto boar = measured(folder / "OFF__Wuson.off");
    for (const char* other : {"OBJ__WusonOBJ.obj", "STL__Wuson.stl"}) {
        EXPECT_EQ(measured(folder / other).second, boar.second) << other;
        EXPECT_NEAR(measured(folder / other).first, boar.first, 1e-5 * boar.first) << other << ": six digits";
    }
    for (const char* cube : {"PLY__cube_binary.ply", "PLY__cube_binary_header_with_RN_newline.ply"})
        EXPECT_EQ(measured(folder / cube), measured(folder / "PLY__cube.ply")) << cube;
}

TEST(FilesOfOthers, SoundOnesAreReadInFull) {
    for (const char* folder : {"uv_fixtures", "dress", "skirt"}) {
        const auto files = shared_files(folder);
        if (files.empty()) GTEST_SKIP() << "no files in " << RIPSTOP_SHARED_DATA << "/" << folder;
        for (const auto& file : files) EXPECT_NO_THROW(expect_sound(read_model(file).surfaces)) << file;
    }
    const auto dress = read_model(RIPSTOP_SHARED_DATA "/dress/dress_knife_drape_3d.obj").surfaces;
    ASSERT_EQ(dress.size(), 14U);
    EXPECT_EQ(dress[0].name, "panel_00");
    EXPECT_TRUE(dress[0].drawn);
    const auto skirt = read_model(RIPSTOP_SHARED_DATA "/skirt/skirt__skirt_3D_0.obj").surfaces;
    EXPECT_EQ(skirt.at(0).mesh.vertex_count(), 817) << "welding would sew the darts shut";
    EXPECT_EQ(skirt.at(0).mesh.triangle_count(), 1472);
}

}  // namespace every_format_test
}  // namespace ripstop

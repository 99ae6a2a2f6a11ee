/// Designs a hot-air balloon of the natural shape, which has no hoop tension, and writes its tiles as OBJ.
#include <cmath>
#include <cstdio>
#include <fstream>

#include "ripstop/base/error.h"
#include "ripstop/base/text/units.h"
#include "ripstop/design/natural/design_summary.h"
#include "ripstop/design/natural/gores.h"
#include "ripstop/io/mesh/mesh_file.h"

int main(int count, char** arguments) try {
    using namespace ripstop;
    if (count != 2) return std::fputs("usage: design FILE.obj\n", stderr), 2;
    EnvelopeDesign design;
    design.gores = 12;
    design.panel_height = parse_length("1300mm", "the height of a panel");  // less than the roll is wide
    design.volume = 600;
    design.edge_length = 0.3;
    const std::vector<NamedMesh> tiles = design_natural(design);

    const DesignSummary summary = measure_design(design, tiles);
    std::printf("%d tiles, %d panels a gore, %d triangles\n", summary.tiles, summary.panels, summary.triangles);
    std::printf("%.2f m high, %.2f m in diameter, %.1f m2 of cloth, %.1f m3; carries %.0f N\n", summary.height,
                summary.diameter, summary.area, summary.volume, summary.shape.load);
    std::printf("panels %.3f m high, up to %.3f m wide\n", summary.panel_height, summary.panel_width);

    std::ofstream file(arguments[1], std::ios::binary);
    write_model(file, arguments[1], tiles);
    file.close();
    const bool is_whole = read_model(arguments[1]).surfaces.size() == tiles.size();
    const bool is_sphere = summary.euler + summary.openings == 2;
    return is_whole && is_sphere && std::abs(summary.volume / design.volume - 1) < 0.05 ? 0 : 1;
} catch (const ripstop::InputError& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 3;
}

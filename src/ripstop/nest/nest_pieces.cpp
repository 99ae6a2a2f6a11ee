#include "ripstop/nest/nest_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "ripstop/base/error.h"
#include "ripstop/base/index.h"
#include "ripstop/base/parallel.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/base/text/units.h"
#include "ripstop/geometry/polygon.h"
#include "ripstop/nest/contact_table.h"
#include "ripstop/nest/own_pieces.h"
#include "ripstop/nest/roll_strip.h"
#include "ripstop/nest/search_order.h"
#include "ripstop/nest/slide_together.h"

namespace ripstop {
namespace {

constexpr int rows_across = 200;
constexpr int profile_rows = 2;       // per row
constexpr int fine_profile_rows = 8;  // per row, if there are few shapes
constexpr int few_shapes = 80;
constexpr int fine = 24;          // fine rows per row, in the final slide
constexpr int most_shapes = 600;  // per batch; their contact table takes about 300 MB
constexpr double most_copies = 50000;
constexpr double length_rounding = 1e-9;  // [m]

std::string in_millimetres(double length) {
    return format_fixed(length / millimetre, 0) + " mm";
}

/// A piece or its mirror image, and the number of copies to lay.
struct Kind {
    std::size_t piece;
    bool mirrored;
    int copies;
    bool half_turned = false;  ///< for pieces that were flattened the other way round
};

class Nester {
  public:
    Nester(const PieceSet& set, const OwnPieces& own, const NestOptions& options, double width, StepCounter& counter)
        : set_(set), own_(own), options_(options), counter_(counter), width_(width), row_height_(width / rows_across) {}

    /// Lays the pieces of one fabric and colour.
    Marker lay(const std::vector<Kind>& kinds, std::vector<Refusal>& refusals) {
        Marker marker;
        marker.roll_width = width_;
        const std::size_t ways = turns().size() * (options_.may_flip ? 2 : 1);
        profile_rows_ = kinds.size() * ways <= few_shapes ? fine_profile_rows : profile_rows;
        strip_ = new_strip(0);
        for (const Kind& kind : kinds) {
            const std::size_t before = strip_.shapes.size();
            add_shapes(kind, refusals);
            if (strip_.shapes.size() == before) continue;
            strip_.first_shape.push_back(static_cast<int>(strip_.shapes.size()));
            kinds_.push_back(kind);
            if (strip_.shapes.size() >= most_shapes) lay_batch(marker);
        }
        lay_batch(marker);
        number_copies(marker);
        own_.lay(options_.may_turn, marker);
        measure_parts(marker);
        return marker;
    }

  private:
    Strip new_strip(double start) const {
        Strip strip;
        strip.start = start;
        strip.gap = options_.gap;
        strip.joins.lengths = options_.part_lengths;
        strip.first_shape = {0};
        return strip;
    }

    std::vector<double> turns() const {
        std::vector<double> turns{0};
        if (options_.grain_tolerance > 0) turns = {0, options_.grain_tolerance, -options_.grain_tolerance};
        if (options_.may_turn)
            for (std::size_t i = 0, count = turns.size(); i < count; ++i) turns.push_back(std::numbers::pi + turns[i]);
        return turns;
    }

    std::vector<double> turns_of(const Kind& kind) const {
        std::vector<double> all = turns();
        if (kind.half_turned)
            for (double& turn : all) turn += std::numbers::pi;
        return all;
    }

    /// The height at which the rows of all shapes start, below all their points.
    double base() const { return -2 * (options_.gap / 2 + millimetre); }

    LaidShape make_shape(const Kind& kind, double turn, bool face_down) const {
        const Placement placement{kind.piece, 1, kind.mirrored, face_down, turn, Vec2::Zero()};
        Points2 outline = placement.placed(set_.pieces[kind.piece].outline());
        LaidShape shape{static_cast<int>(kinds_.size()), turn, face_down};
        shape.corner = outline.colwise().minCoeff();
        outline.rowwise() -= shape.corner.transpose();
        shape.size = outline.colwise().maxCoeff();
        shape.area = std::abs(signed_area(outline));
        shape.last_row = static_cast<int>(std::floor((width_ - shape.size.y() + length_rounding) / row_height_));
        shape.grown = std::move(outline);  // not offset yet; see `add_shape`
        return shape;
    }

    void add_shape(LaidShape shape) {
        shape.grown = grown_outline(shape.grown, options_.gap / 2);
        shape.profile = make_row_profile(shape.grown, base(), row_height_ / profile_rows_);
        strip_.shapes.push_back(shape);
        // The same, aligned with the upper edge of the cloth, where whole rows would leave up to a row unused.
        const double profile_row = row_height_ / profile_rows_;
        const double rest = width_ - shape.size.y() - shape.last_row * row_height_;
        shape.lift = std::floor(rest / profile_row) * profile_row;
        if (profile_rows_ < fine_profile_rows || shape.lift <= 0) return;
        shape.grown.col(1).array() += shape.lift;
        shape.profile = make_row_profile(shape.grown, base(), profile_row);
        strip_.shapes.push_back(std::move(shape));
    }

    void add_shapes(const Kind& kind, std::vector<Refusal>& refusals) {
        double narrowest = std::numeric_limits<double>::infinity(), shortest = narrowest;
        for (const double turn : turns_of(kind))
            for (int face_down = 0; face_down <= (options_.may_flip ? 1 : 0); ++face_down) {
                LaidShape shape = make_shape(kind, turn, face_down == 1);
                narrowest = std::min(narrowest, shape.size.y());
                shortest = std::min(shortest, shape.size.x());
                if (shape.last_row >= 0 && shape.size.x() <= longest()) add_shape(std::move(shape));
            }
        if (narrowest > width_ + length_rounding)
            refuse(kind,
                   "is " + in_millimetres(narrowest) + " wide across the warp, the roll is " + in_millimetres(width_) +
                       "; divide it, turn its grain or take a wider roll",
                   refusals);
        else if (shortest > longest())
            refuse(kind, "is " + in_millimetres(shortest) + too_long_for(shortest), refusals);
    }

    std::string too_long_for(double length) const {
        const std::vector<double>& parts = options_.part_lengths;
        const double most = *std::max_element(parts.begin(), parts.end());
        if (length > most)
            return " long, the cloth without a join is " + in_millimetres(most) + "; divide it or take a longer roll";
        return " long; it fits lengths of " + in_millimetres(most) + ", which run out, but not the last length of " +
               in_millimetres(parts.back()) + ", which repeats; lay it on a roll of its own, or divide it";
    }

    void refuse(const Kind& kind, std::string reason, std::vector<Refusal>& refusals) const {
        const std::string& name = set_.pieces[kind.piece].name;
        if (!refusals.empty() && refusals.back().piece == name)  // the kinds of a piece are adjacent
            refusals.back().quantity += kind.copies;
        else
            refusals.push_back({name, std::move(reason), kind.copies});
    }

    /// Only the last part length repeats; earlier ones may be full when a piece's turn comes.
    double longest() const {
        return options_.part_lengths.empty() ? std::numeric_limits<double>::infinity() : options_.part_lengths.back();
    }

    void lay_batch(Marker& marker) {
        if (kinds_.empty()) return;
        std::vector<int> copies;
        double height = 0;
        for (std::size_t k = 0; k < kinds_.size(); ++k) {
            copies.insert(copies.end(), static_cast<std::size_t>(kinds_[k].copies), static_cast<int>(k));
            height += kinds_[k].copies * strip_.shapes[at(strip_.first_shape[k])].size.y();
        }
        if (!copies.empty()) {
            const double lanes = width_ * static_cast<double>(copies.size()) / height;
            strip_.reach = std::clamp(static_cast<int>(std::ceil(4 * lanes)), 12, 60);
            add_best(copies, marker);
        }
        kinds_.clear();
        strip_ = new_strip(marker.length > 0 ? marker.length + options_.gap : 0);
    }

    void add_best(const std::vector<int>& copies, Marker& marker) {
        const ContactTable contacts(strip_.shapes, profile_rows_, options_.threads);
        std::vector<std::vector<Placement>> found(static_cast<std::size_t>(options_.starts));
        std::vector<double> lengths(found.size());
        parallel_for(options_.starts, options_.threads, [&](int start) {
            const auto s = static_cast<std::size_t>(start);
            const auto count = [&] { counter_.done("a marker", static_cast<double>(copies.size())); };
            std::vector<PlacedItem> items =
                search_order(strip_, contacts, copies, {options_.rounds, static_cast<std::uint32_t>(start + 1), count});
            slide_together(strip_, {base(), row_height_ / fine, fine}, items);
            for (const PlacedItem& item : items) lengths[s] = std::max(lengths[s], strip_.end(item));
            found[s] = placements_of(items);
        });
        const auto best = static_cast<std::size_t>(std::min_element(lengths.begin(), lengths.end()) - lengths.begin());
        marker.length = lengths[best];
        const std::vector<Placement>& placements = found[best];
        marker.placements.insert(marker.placements.end(), placements.begin(), placements.end());
        for (const int kind : copies) marker.net_area += strip_.shapes[at(strip_.first_shape[at(kind)])].area;
    }

    std::vector<Placement> placements_of(const std::vector<PlacedItem>& items) const {
        std::vector<Placement> placements;
        for (const PlacedItem& item : items) {
            const LaidShape& shape = strip_.shape(item);
            const Kind& kind = kinds_[at(shape.kind)];
            placements.push_back({kind.piece, 1, kind.mirrored, shape.face_down, shape.turn,
                                  Vec2(item.x, item.row * row_height_ + shape.lift) - shape.corner});
        }
        return placements;
    }

    /// Numbers copies from the start of the roll.
    void number_copies(Marker& marker) const {
        const auto begins = [this](const Placement& placement) {
            return placement.placed(set_.pieces[placement.piece].outline()).col(0).minCoeff();
        };
        std::vector<std::pair<double, Placement>> in_order;
        for (const Placement& placement : marker.placements) in_order.emplace_back(begins(placement), placement);
        std::stable_sort(in_order.begin(), in_order.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        std::map<std::size_t, int> copies;
        for (std::size_t i = 0; i < in_order.size(); ++i) {
            marker.placements[i] = in_order[i].second;
            marker.placements[i].copy = ++copies[marker.placements[i].piece];
        }
    }

    void measure_parts(Marker& marker) const {
        const Joins joins{options_.part_lengths};
        for (double start = 0; start < marker.length;) {
            const double end = joins.after(start);
            RollPart part{start, std::isfinite(end) ? end - start : marker.length - start, 0};
            for (const Placement& placement : marker.placements) {
                const double last = placement.placed(set_.pieces[placement.piece].outline()).col(0).maxCoeff();
                if (last <= end + length_rounding) part.used = std::max(part.used, last - start);
            }
            marker.parts.push_back(part);
            start = end;
        }
    }

    const PieceSet& set_;
    const OwnPieces& own_;
    const NestOptions& options_;
    StepCounter& counter_;  ///< counts items once per round of a search
    double width_, row_height_;
    int profile_rows_ = 1;     ///< per row
    std::vector<Kind> kinds_;  ///< of the current batch
    Strip strip_;              ///< of the current batch
};

/// Adds a piece with its number of copies. If pieces may not be turned, copies that stand for pieces lying the
/// other way round form a kind of their own.
void add_kinds(const PieceSet& set, const OwnPieces& own, std::size_t piece, bool may_turn, std::vector<Kind>& kinds) {
    for (const bool mirrored : {false, true}) {
        const int copies = mirrored ? set.pieces[piece].quantity_mirrored : set.pieces[piece].quantity;
        const int turned = may_turn ? 0 : own.half_turned(piece, mirrored);
        if (copies > turned) kinds.push_back({piece, mirrored, copies - turned});
        if (turned > 0) kinds.push_back({piece, mirrored, turned, true});
    }
}

void require_sound(const NestOptions& options) {
    const auto is_length = [](double value) { return std::isfinite(value) && value > 0 && value < 1e6; };
    if (options.roll_width && !is_length(*options.roll_width))
        throw InputError("the roll is " + format_shortest(*options.roll_width) +
                         " m wide, expected a length above 0, such as 1500mm");
    if (!(options.gap >= 0) || options.gap > 1)
        throw InputError("the gap between pieces is " + format_shortest(options.gap) +
                         " m, expected 0 to 1 m, such as 5mm");
    if (!(options.grain_tolerance >= 0) || options.grain_tolerance > 0.5)
        throw InputError("the grain tolerance is not within 0 to 28 degrees; beyond that the grain means nothing");
    for (const double length : options.part_lengths)
        if (!is_length(length))
            throw InputError("a roll is " + format_shortest(length) +
                             " m long, expected a length above 0, such as 100m");
}

}  // namespace

Markers nest_pieces(const PieceSet& set, const NestOptions& options) {
    require_sound(options);
    std::map<std::pair<std::string, std::string>, std::vector<Kind>> cloths;
    const OwnPieces own(set);
    double copies = 0;
    for (const PatternPiece& piece : set.pieces) copies += double(piece.quantity) + piece.quantity_mirrored;
    if (copies > most_copies)
        throw InputError("the quantities of the pieces add up to " + format_fixed(copies, 0) +
                         ", expected no more than " + format_fixed(most_copies, 0) + "; lay them in several plans");
    for (std::size_t i = 0; i < set.pieces.size(); ++i) {
        const PatternPiece& piece = set.pieces[i];
        if (piece.outline().rows() < 3) continue;
        add_kinds(set, own, i, options.may_turn, cloths[{piece.fabric, piece.colour}]);
    }
    StepCounter counter(copies * options.rounds * options.starts, options.progress);
    Markers result;
    for (const auto& [cloth, kinds] : cloths) {
        const double width = options.roll_width.value_or(set.fabric(cloth.first).roll_width);
        Marker marker = Nester(set, own, options, width, counter).lay(kinds, result.refusals);
        if (marker.placements.empty()) continue;
        marker.fabric = cloth.first;
        marker.colour = cloth.second;
        result.markers.push_back(std::move(marker));
    }
    if (options.progress) options.progress(1, "a marker");  // pieces that do not fit take no time
    return result;
}

}  // namespace ripstop

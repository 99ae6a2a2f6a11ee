#include "ripstop/nest/search_order.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace ripstop {
namespace {

constexpr int window = 24;          // items that a change may affect
constexpr int judged = 50;          // items by whose places a change is judged
constexpr int tries = 60;           // for each position of the window
constexpr int tried_rows = 4;       // when an item is placed again
constexpr double first_heat = 0.4;  // relative to the mean moment that a shift by a metre gives an item

class Search {
  public:
    Search(const Strip& strip, const ContactTable& contacts, std::uint32_t seed)
        : strip_(strip), contacts_(contacts), random_(seed) {}

    std::vector<PlacedItem> run(std::vector<int> kinds, int rounds, const std::function<void()>& after_round) {
        shuffle(kinds);
        begin(kinds);
        std::vector<PlacedItem> best = placed();
        double shortest = length(best);
        for (int round = 0; round < rounds; ++round) {
            heat_ = first_heat * mean_area() * (1 - double(round) / rounds);
            for (int at = 0; at < count(); ++at) anneal(at);
            lay(items_, places_, 0, count());
            if (after_round) after_round();
            std::vector<PlacedItem> found = placed();
            if (length(found) >= shortest) continue;
            shortest = length(found);
            best = std::move(found);
        }
        return best;
    }

  private:
    struct Places {
        std::vector<double> x;      ///< for each item
        std::vector<double> clear;  ///< for each item: the end of all items that are out of its reach
    };

    int count() const { return static_cast<int>(items_.size()); }
    int below(int count) { return static_cast<int>(random_() % static_cast<std::uint32_t>(count)); }
    void shuffle(std::vector<int>& kinds) {
        for (int i = static_cast<int>(kinds.size()) - 1; i > 0; --i)
            std::swap(kinds[static_cast<std::size_t>(i)], kinds[static_cast<std::size_t>(below(i + 1))]);
    }
    double mean_area() const {
        double sum = 0;
        for (const LaidItem& item : items_) sum += strip_.shape(item).area;
        return sum / count();
    }
    std::vector<PlacedItem> placed() const {
        std::vector<PlacedItem> result;
        for (std::size_t i = 0; i < items_.size(); ++i) result.push_back({items_[i], places_.x[i]});
        return result;
    }
    double length(const std::vector<PlacedItem>& items) const {
        double longest = 0;
        for (const PlacedItem& item : items) longest = std::max(longest, strip_.end(item));
        return longest;
    }

    double clear_before(const std::vector<LaidItem>& items, const Places& places, int index) const {
        const auto i = static_cast<std::size_t>(index), reach = static_cast<std::size_t>(strip_.reach);
        const double before = i > 0 ? places.clear[i - 1] : strip_.start;
        if (i <= reach) return before;
        const std::size_t old = i - reach - 1;
        return std::max(before, strip_.end({items[old], places.x[old]}) + strip_.gap);
    }

    double first_place(const std::vector<LaidItem>& items, const Places& places, int index, const LaidItem& item,
                       double clear) {
        taken_.clear();
        for (int k = std::max(0, index - strip_.reach); k < index; ++k) {
            const LaidItem& other = items[static_cast<std::size_t>(k)];
            const double x = places.x[static_cast<std::size_t>(k)];
            contacts_.each(other.shape, item.shape, item.row - other.row, [&](double lower, double upper) {
                if (x + upper <= clear) return;
                taken_.push_back({x + lower, x + upper});
                for (std::size_t p = taken_.size() - 1; p > 0 && taken_[p - 1].lower > taken_[p].lower; --p)
                    std::swap(taken_[p - 1], taken_[p]);
            });
        }
        return strip_.first_free(taken_, clear, strip_.shape(item).size.x());
    }

    /// Lays the items in [from, end) and returns their moment.
    double lay(const std::vector<LaidItem>& items, Places& places, int from, int end) {
        double moment = 0;
        for (int index = from; index < end; ++index) {
            const auto i = static_cast<std::size_t>(index);
            places.clear[i] = clear_before(items, places, index);
            places.x[i] = first_place(items, places, index, items[i], places.clear[i]);
            const LaidShape& shape = strip_.shape(items[i]);
            moment += shape.area * (places.x[i] + shape.size.x() / 2);
        }
        return moment;
    }

    void begin(const std::vector<int>& kinds) {
        places_ = trial_places_ = {std::vector<double>(kinds.size()), std::vector<double>(kinds.size())};
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            const auto kind = static_cast<std::size_t>(kinds[i]);
            const int index = static_cast<int>(i);
            const double clear = clear_before(items_, places_, index);
            LaidItem best{strip_.first_shape[kind], 0};
            double nearest = std::numeric_limits<double>::infinity();
            for (LaidItem item = best; item.shape < strip_.first_shape[kind + 1]; ++item.shape)
                for (item.row = 0; item.row <= strip_.shape(item).last_row; ++item.row) {
                    const double x = first_place(items_, places_, index, item, clear);
                    if (x >= nearest) continue;
                    nearest = x;
                    best = item;
                }
            items_.push_back(best);
            places_.clear[i] = clear;
            places_.x[i] = nearest;
        }
    }

    void lay_anew(int from, int at, int start) {
        LaidItem item = trial_[static_cast<std::size_t>(from)];
        change_shape(item);
        trial_.erase(trial_.begin() + from);
        trial_.insert(trial_.begin() + at, item);
        lay(trial_, trial_places_, start, at);
        const double clear = clear_before(trial_, trial_places_, at);
        double nearest = std::numeric_limits<double>::infinity();
        for (int k = 0; k < tried_rows; ++k) {
            item.row = below(strip_.shape(item).last_row + 1);
            const double x = first_place(trial_, trial_places_, at, item, clear);
            if (x >= nearest) continue;
            nearest = x;
            trial_[static_cast<std::size_t>(at)].row = item.row;
        }
    }

    void change_shape(LaidItem& item) {
        const auto kind = static_cast<std::size_t>(strip_.shape(item).kind);
        item.shape = strip_.first_shape[kind] + below(strip_.first_shape[kind + 1] - strip_.first_shape[kind]);
    }

    /// Makes a random change of the trial among the items from `start` to `end`.
    void change(int start, int end) {
        const int one = start + below(end - start), two = start + below(end - start);
        LaidItem &a = trial_[static_cast<std::size_t>(one)], &b = trial_[static_cast<std::size_t>(two)];
        switch (below(6)) {
            case 0:
                change_shape(a);
                break;
            case 1:
                std::swap(a, b);
                break;
            case 2:
                std::swap(a.shape, b.shape);
                break;
            case 3:
                a.row += below(41) - 20;
                break;
            case 4:
                lay_anew(one, two, start);
                break;
            default:
                a.row = below(2) == 0 ? 0 : std::numeric_limits<int>::max();
                break;
        }
        for (int i = start; i < end; ++i) {
            LaidItem& item = trial_[static_cast<std::size_t>(i)];
            item.row = std::clamp(item.row, 0, strip_.shape(item).last_row);
        }
    }

    void anneal(int start) {
        const int end = std::min(count(), start + window), last = std::min(count(), start + judged);
        double moment = lay(items_, places_, start, last);
        trial_ = items_;
        trial_places_ = places_;
        for (int k = 0; k < tries; ++k) {
            change(start, end);
            const double other = lay(trial_, trial_places_, start, last);
            const bool is_kept = other <= moment || chance() < std::exp((moment - other) / std::max(heat_, 1e-9));
            if (is_kept) {
                std::copy(trial_.begin() + start, trial_.begin() + end, items_.begin() + start);
                moment = other;
            } else {
                std::copy(items_.begin() + start, items_.begin() + end, trial_.begin() + start);
            }
        }
        lay(items_, places_, start, last);
    }
    double chance() { return static_cast<double>(random_()) / 4294967296.0; }

    const Strip& strip_;
    const ContactTable& contacts_;
    std::mt19937 random_;
    double heat_ = 0;
    std::vector<LaidItem> items_, trial_;
    Places places_, trial_places_;
    std::vector<Interval> taken_;
};

}  // namespace

std::vector<PlacedItem> search_order(const Strip& strip, const ContactTable& contacts, std::vector<int> kinds,
                                     const OrderSearch& search) {
    return Search(strip, contacts, search.seed).run(std::move(kinds), search.rounds, search.after_round);
}

}  // namespace ripstop

#pragma once

#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// A place in a JSON file that `flatten` wrote, and the value there. Every fault is an InputError that says where
/// it is, what is expected, and to flatten again, because nobody writes such a file by hand.
class PlanReader {
  public:
    /// `value` must outlive the reader. Throws InputError unless it is an object.
    PlanReader(const nlohmann::json& value, std::string place);

    [[noreturn]] void refuse(const std::string& what) const;

    bool has(const char* key) const { return value_.contains(key); }
    double number(const char* key, double most = std::numeric_limits<double>::infinity()) const;  ///< in [-most, most]
    int whole(const char* key, double least, double most) const;
    bool flag(const char* key) const;
    std::string text(const char* key) const;          ///< required
    std::string text_or_none(const char* key) const;  ///< empty if absent
    Vec3 point(const char* key) const;
    const nlohmann::json& list(const char* key) const;
    std::vector<double> numbers(const char* key) const;
    std::vector<int> wholes(const char* key, double least, double most) const;

    PlanReader at(const char* key) const;                 ///< the object under a key
    PlanReader in(const char* key, std::size_t i) const;  ///< the object at index i of a list
    /// Applies `read` to every object of a list.
    template <class Item, class Read>
    std::vector<Item> each(const char* key, Read&& read) const {
        std::vector<Item> items;
        for (std::size_t i = 0; i < list(key).size(); ++i) items.push_back(read(in(key, i)));
        return items;
    }

    const nlohmann::json& value() const { return value_; }
    const std::string& place() const { return place_; }

  private:
    int whole(double value, const char* key, double least, double most) const;

    const nlohmann::json& value_;
    std::string place_;
};

}  // namespace ripstop

#include "ripstop/mesh/adjacency.h"

#include <algorithm>
#include <tuple>

#include "ripstop/base/index.h"

namespace ripstop {

Adjacency::Adjacency(const Triangles& triangles, int vertex_count)
    : triangles_(triangles), twin_(static_cast<std::size_t>(3 * triangles.rows()), -1) {
    const int count = half_edge_count();
    std::vector<std::tuple<int, int, int>> keys;  // low vertex, high vertex, half-edge
    keys.reserve(twin_.size());
    for (int h = 0; h < count; ++h) keys.emplace_back(std::min(from(h), to(h)), std::max(from(h), to(h)), h);
    std::sort(keys.begin(), keys.end());
    for (std::size_t i = 0; i < keys.size();) {
        std::size_t end = i + 1;
        while (end < keys.size() && std::get<0>(keys[end]) == std::get<0>(keys[i]) &&
               std::get<1>(keys[end]) == std::get<1>(keys[i]))
            ++end;
        const int first = std::get<2>(keys[i]);
        if (end - i == 2 && from(first) == to(std::get<2>(keys[i + 1])) && from(first) != to(first)) {
            const int second = std::get<2>(keys[i + 1]);
            twin_[at(first)] = second;
            twin_[at(second)] = first;
        } else if (end - i > 1 || from(first) == to(first)) {
            irregular_.push_back({from(first), to(first)});
        }
        i = end;
    }
    for (int h = 0; h < count; ++h)
        if (is_boundary(h) || h < twin(h)) edges_.push_back(h);

    outgoing_start_.assign(static_cast<std::size_t>(vertex_count) + 1, 0);
    for (int h = 0; h < count; ++h) ++outgoing_start_[static_cast<std::size_t>(from(h)) + 1];
    for (std::size_t v = 1; v < outgoing_start_.size(); ++v) outgoing_start_[v] += outgoing_start_[v - 1];
    outgoing_.resize(static_cast<std::size_t>(count));
    std::vector<int> fill(outgoing_start_.begin(), outgoing_start_.end() - 1);
    for (int h = 0; h < count; ++h) outgoing_[at(fill[at(from(h))]++)] = h;
}

std::vector<int> Adjacency::outgoing(int vertex) const {
    const auto begin = outgoing_.begin() + outgoing_start_[at(vertex)];
    const auto end = outgoing_.begin() + outgoing_start_[static_cast<std::size_t>(vertex) + 1];
    return {begin, end};
}

}  // namespace ripstop

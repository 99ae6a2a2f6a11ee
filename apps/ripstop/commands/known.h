#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <vector>

#include "options/guess.h"
#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"

namespace ripstop::cli {

/// Accepts texts for which `look_up` does not throw; its message becomes the usage error. `words`: suggestions for
/// mistyped texts and for shells.
template <class LookUp>
CLI::Validator known(LookUp look_up, const std::vector<std::string>& words = {}) {
    return CLI::Validator(
        [look_up, words](const std::string& text) {
            try {
                look_up(text);
                return std::string();
            } catch (const InputError& error) {
                return error.what() + guess(text, words);
            }
        },
        words.empty() ? "" : fmt::format("{{{}}}", fmt::join(words, ",")));
}

/// Accepts only these words.
inline CLI::Validator one_of(const std::vector<std::string>& words) {
    const auto look_up = [words](const std::string& text) {
        if (std::find(words.begin(), words.end(), text) == words.end())
            throw InputError(fmt::format("no \"{}\"; known: {}", text, fmt::join(words, ", ")));
    };
    return known(look_up, words);
}

/// Accepts whole numbers, or any numbers with `Number` = double, from `least` to `most`.
template <class Number>
CLI::Validator within(Number least, Number most) {
    const std::string range = fmt::format("{} to {}", least, most);
    return CLI::Validator(
        [=](const std::string& text) {
            const std::optional<double> value = parse_double(text);
            const bool is_whole = std::is_floating_point_v<Number> || text.find_first_of(".eE") == std::string::npos;
            if (value && is_whole && *value >= least && *value <= most) return std::string();
            return fmt::format("\"{}\" is not a {}number from {}", text,
                               std::is_floating_point_v<Number> ? "" : "whole ", range);
        },
        range);
}

}  // namespace ripstop::cli

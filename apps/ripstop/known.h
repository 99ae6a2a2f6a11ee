#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "ripstop/base/error.h"

namespace ripstop::cli {

/// Takes texts that `look_up` takes; else its message is the usage error.
template <class LookUp>
CLI::Validator known(LookUp look_up) {
    return CLI::Validator(
        [look_up](const std::string& text) {
            try {
                look_up(text);
                return std::string();
            } catch (const InputError& error) {
                return std::string(error.what());
            }
        },
        "");
}

}  // namespace ripstop::cli

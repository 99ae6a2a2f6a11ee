#pragma once

#include <string>

#include "ripstop/base/error.h"

namespace ripstop::testing {

/// What an InputError says that `action` throws; `accepted` if it throws none.
template <class Action>
std::string refusal(Action&& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace ripstop::testing

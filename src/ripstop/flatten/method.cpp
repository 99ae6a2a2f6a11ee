#include "ripstop/flatten/method.h"

#include "ripstop/base/error.h"

namespace ripstop {

std::span<const Method> methods() {
    return {};
}

const Method& method_named(const std::string& name) {
    std::string known;
    for (const Method& method : methods()) {
        if (name == method.name) return method;
        known += (known.empty() ? "" : ", ") + std::string(method.name);
    }
    throw InputError("no method \"" + name + "\"; known: " + known);
}

}  // namespace ripstop

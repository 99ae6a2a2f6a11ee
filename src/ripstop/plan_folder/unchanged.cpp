#include "ripstop/plan_folder/unchanged.h"

#include <fstream>
#include <utility>

#include "ripstop/base/error.h"
#include "ripstop/base/sha256.h"

namespace ripstop {
namespace {

std::string sum_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return in ? sha256(in) : std::string();
}

}  // namespace

Unchanged::Unchanged(std::vector<std::filesystem::path> files) : files_(std::move(files)) {
    for (const std::filesystem::path& file : files_) sums_.push_back(sum_of(file));
}

void Unchanged::require() const {
    for (std::size_t i = 0; i < files_.size(); ++i)
        if (sum_of(files_[i]) != sums_[i])
            throw InputError(files_[i].string() +
                             ": another run has changed it in the meantime; nothing is written, run the command again");
}

}  // namespace ripstop

#include "ripstop/io/mesh/ply_source.h"

#include <cmath>

namespace ripstop {

PlyText::PlyText(std::string_view bytes, const PlyHeader& header, const MeshRecords& file)
    : lines_(bytes.substr(header.size)), before_(header.lines), size_(bytes.size() - header.size), file_(file) {}

std::size_t PlyText::most(const PlyElement& element) const {
    const std::size_t least = 2 * element.properties.size();  // each value needs at least a digit and a blank
    return static_cast<std::size_t>(std::min<std::uint64_t>(element.count, (size_ + 1) / least));
}

void PlyText::begin_row(const PlyElement& element) {
    do {
        if (!lines_.next())
            file_.refuse(place(), "the file ends here, expected " + std::to_string(element.count) + " lines of " +
                                      shown(element.name) + "; it is cut short, export it again");
        rest_ = trimmed(lines_.line());
    } while (rest_.empty());
}

std::string_view PlyText::word() {
    const std::string_view found = next_word(rest_);
    if (found.empty())
        file_.refuse(place(),
                     "the line is too short, expected a number for every property in the header; export the file "
                     "again");
    return found;
}

std::size_t PlyText::length(const PlyProperty& list) {
    const double count = value(*list.count);
    if (!(count >= 0) || count > static_cast<double>(rest_.size()) || count != std::floor(count))
        file_.refuse(place(),
                     "a list of " + format_shortest(count) + " numbers, more than the line has; export the file again");
    return static_cast<std::size_t>(count);
}

double PlyText::value(PlyType) {
    return file_.coordinate(word(), place());
}

void PlyText::skip(PlyType, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) word();
}

void PlyText::end_row() {
    if (const std::string_view more = next_word(rest_); !more.empty())
        file_.refuse(place(), "found " + shown(more) +
                                  " after the last property, expected the end of the line; export the file again");
}

void PlyText::finish() {
    while (lines_.next())
        if (const std::string_view more = trimmed(lines_.line()); !more.empty())
            file_.refuse(place(), "found " + shown(more) +
                                      " after the last element, expected the end of the file; export it again");
}

}  // namespace ripstop

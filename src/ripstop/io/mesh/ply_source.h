#pragma once

#include <algorithm>
#include <string_view>

#include "ripstop/base/text/number_text.h"
#include "ripstop/io/mesh/binary.h"
#include "ripstop/io/mesh/mesh_records.h"
#include "ripstop/io/mesh/ply_header.h"
#include "ripstop/io/text/text.h"

namespace ripstop {

/// Reads the values in the body of an ascii PLY, one element per line. Skips blank lines.
class PlyText {
  public:
    /// `bytes` is the whole file. All arguments must outlive this object.
    PlyText(std::string_view bytes, const PlyHeader& header, const MeshRecords& file);

    long place() const { return before_ + lines_.number(); }
    std::size_t most(const PlyElement& element) const;  ///< how many rows of this element the rest of the file can hold
    void begin_row(const PlyElement& element);
    std::size_t length(const PlyProperty& list);
    double value(PlyType type);
    void skip(PlyType type, std::size_t count);
    void end_row();  ///< refuses a line with more values than the header declares
    void finish();   ///< refuses anything after the last element

  private:
    std::string_view word();

    Lines lines_;
    std::string_view rest_;
    long before_;  ///< number of header lines
    std::size_t size_;
    const MeshRecords& file_;
};

/// Reads the values in the body of a binary PLY.
template <std::endian order>
class PlyBytes {
  public:
    PlyBytes(std::string_view bytes, const PlyHeader& header, const MeshRecords& file)
        : bytes_(bytes), at_(header.size), file_(file) {}

    long place() const { return static_cast<long>(at_); }

    std::size_t most(const PlyElement& element) const {
        std::size_t least = 0;
        for (const PlyProperty& property : element.properties) least += size_of(property.count.value_or(property.type));
        return static_cast<std::size_t>(std::min<std::uint64_t>(element.count, (bytes_.size() - at_) / least));
    }

    void begin_row(const PlyElement&) {}

    std::size_t length(const PlyProperty& list) {
        const long start = place();
        const double count = value(*list.count);
        if (count < 0 || count * static_cast<double>(size_of(list.type)) > static_cast<double>(bytes_.size() - at_))
            file_.refuse(start, "a list of " + format_shortest(count) + " numbers, but " +
                                    std::to_string(bytes_.size() - at_) +
                                    " bytes are left; the file is cut short or damaged, export it again");
        return static_cast<std::size_t>(count);
    }

    double value(PlyType type) {
        const char* const at = take(size_of(type));
        switch (type) {
            case PlyType::int8:
                return load<std::int8_t>(at, order);
            case PlyType::uint8:
                return load<std::uint8_t>(at, order);
            case PlyType::int16:
                return load<std::int16_t>(at, order);
            case PlyType::uint16:
                return load<std::uint16_t>(at, order);
            case PlyType::int32:
                return load<std::int32_t>(at, order);
            case PlyType::uint32:
                return load<std::uint32_t>(at, order);
            case PlyType::float32:
                return static_cast<double>(load<float>(at, order));
            case PlyType::float64:
                break;
        }
        return load<double>(at, order);
    }

    void skip(PlyType type, std::size_t count) { take(size_of(type) * count); }
    void end_row() {}
    void finish() {}

  private:
    const char* take(std::size_t size) {
        if (bytes_.size() - at_ < size)
            file_.refuse(place(),
                         "the file ends before all the elements that its header announces; it is cut short, "
                         "export it again");
        at_ += size;
        return bytes_.data() + at_ - size;
    }

    std::string_view bytes_;
    std::size_t at_;
    const MeshRecords& file_;
};

}  // namespace ripstop

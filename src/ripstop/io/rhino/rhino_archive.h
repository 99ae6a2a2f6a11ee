#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The bytes of a Rhino archive (openNURBS, `.3dm`). Chunks inside chunks: a type code of 4 bytes, a length (4 bytes
/// below version 50, 8 from there), that many bytes, the last four of them a checksum where the code says so.
struct RhinoArchive {
    std::string name;   ///< begins every message
    std::string bytes;  ///< the whole file
    int version = 0;    ///< 1 to 4, then 50, 60, 70, 80: ten times Rhino's
};

/// Reads a stream to its end and looks at the first 32 bytes. Throws InputError where they are no header of an archive,
/// and for an archive newer than Rhino 8.
RhinoArchive read_rhino_archive(std::istream& in, const std::string& name);

using RhinoId = std::array<std::uint8_t, 16>;  ///< a UUID as it stands in the file

/// The bytes of "4ED7D4E4-E947-11d3-BFE5-0010830122F0": the first three numbers with their last byte first.
consteval RhinoId rhino_id(std::string_view text) {
    constexpr std::array<std::size_t, 16> order = {3, 2, 1, 0, 5, 4, 7, 6, 8, 9, 10, 11, 12, 13, 14, 15};
    RhinoId id{};
    std::size_t digits = 0;
    for (const char c : text) {
        if (c == '-') continue;
        const int value = c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10;
        std::uint8_t& byte = id[order[digits++ / 2]];
        byte = static_cast<std::uint8_t>(byte * 16 + value);
    }
    return id;
}

struct RhinoChunk;

/// Bytes of an archive, read from the front. Whatever would reach over the end throws InputError `NAME: byte N: …`, so
/// nothing is read that is not there, and nothing allocated that the file has no bytes for.
class RhinoBytes {
  public:
    explicit RhinoBytes(const RhinoArchive& archive);  ///< what follows the header

    bool empty() const { return at_ == end_; }
    std::size_t left() const { return end_ - at_; }
    std::size_t position() const { return at_; }  ///< in the file
    int version() const { return archive_->version; }
    const std::string& name() const { return archive_->name; }

    std::uint8_t byte();
    bool flag() { return byte() != 0; }
    std::int32_t integer();
    std::uint32_t natural();
    double real();
    Vec3 point();
    RhinoId id();
    std::string text();                   ///< UTF-16 in the file, UTF-8 here; control characters become `_`
    std::size_t count(std::size_t each);  ///< of elements of `each` bytes, which must be there
    RhinoBytes take(std::size_t size);    ///< the next bytes on their own
    void skip(std::size_t size) { take(size); }
    std::string_view view() const;  ///< what is left
    RhinoChunk chunk();             ///< the next one, without its checksum

    /// A block of `size` bytes that may be deflated, checked against its checksum; `skip_buffer` steps over one of any
    /// size.
    std::string buffer(std::size_t size);
    void skip_buffer();

    /// The version in front of a class's data: one byte, and two integers in an anonymous chunk, which is opened.
    struct Version {
        int major = 0, minor = 0;
    };
    Version packed_version();
    RhinoBytes anonymous(std::uint32_t code = 0x40008000);

    [[noreturn]] void refuse(const std::string& found) const;

  private:
    RhinoBytes(const RhinoArchive& archive, std::size_t from, std::size_t to);
    template <class T>
    T number();

    const RhinoArchive* archive_;
    std::size_t at_, end_;
};

struct RhinoChunk {
    std::uint32_t code = 0;
    std::int64_t value = 0;  ///< of a chunk without bytes (the code's highest bit), else its length
    RhinoBytes body;
};

}  // namespace ripstop

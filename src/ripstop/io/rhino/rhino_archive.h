#pragma once

#include <array>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

#include "ripstop/geometry/types.h"

namespace ripstop {

/// The bytes of a Rhino archive (openNURBS, `.3dm`). It consists of nested chunks. A chunk is a type code of 4
/// bytes, a length (4 bytes below version 50, else 8) and that many bytes, the last four of which are a checksum
/// if the code says so.
struct RhinoArchive {
    std::string name;   ///< every message begins with it
    std::string bytes;  ///< the whole file
    int version = 0;    ///< 1 to 4, then 50, 60, 70, 80: ten times Rhino's version
};

/// Reads a stream to its end and checks the first 32 bytes. Throws InputError if they are not the header of an
/// archive, or if the archive is newer than Rhino 8.
RhinoArchive read_rhino_archive(std::istream& in, const std::string& name);

using RhinoId = std::array<std::uint8_t, 16>;  ///< a UUID in the byte order of the file

/// The bytes of a UUID such as "4ED7D4E4-E947-11d3-BFE5-0010830122F0". Its first three numbers are stored least
/// significant byte first.
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

/// Reads bytes of an archive from the front. A read beyond the end throws InputError `NAME: byte N: …`. Memory is
/// allocated only for as many elements as the file has bytes for.
class RhinoBytes {
  public:
    explicit RhinoBytes(const RhinoArchive& archive);  ///< starts after the header

    bool empty() const { return at_ == end_; }
    std::size_t left() const { return end_ - at_; }
    std::size_t position() const { return at_; }  ///< offset in the file
    int version() const { return archive_->version; }
    const std::string& name() const { return archive_->name; }

    std::uint8_t byte();
    bool flag() { return byte() != 0; }
    std::int32_t integer();
    std::uint32_t natural();
    double real();
    Vec3 point();
    RhinoId id();
    std::string text();                   ///< converts the file's UTF-16 to UTF-8; control characters become `_`
    std::size_t count(std::size_t each);  ///< reads a count of elements of `each` bytes and checks that they fit
    RhinoBytes take(std::size_t size);    ///< the next `size` bytes
    void skip(std::size_t size) { take(size); }
    std::string_view view() const;  ///< the bytes that are left
    RhinoChunk chunk();             ///< the next one, without its checksum

    /// Reads a block of `size` bytes, deflated or not, and verifies its checksum. `skip_buffer` skips a block of
    /// any size.
    std::string buffer(std::size_t size);
    void skip_buffer();

    /// The version before the data of a class. `packed_version` reads it from one byte; `anonymous` opens an
    /// anonymous chunk, which begins with it as two integers.
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
    std::int64_t value = 0;  ///< the value of a chunk without bytes (highest bit of the code set), else the length
    RhinoBytes body;
};

}  // namespace ripstop

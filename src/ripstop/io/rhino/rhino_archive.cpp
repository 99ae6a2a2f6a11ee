#include "ripstop/io/rhino/rhino_archive.h"

#include <zlib.h>

#include <bit>
#include <cstring>
#include <istream>

#include "ripstop/base/error.h"
#include "ripstop/base/text/number_text.h"
#include "ripstop/io/text/text.h"

namespace ripstop {
namespace {

static_assert(std::endian::native == std::endian::little, "an archive is little-endian, and so is read as it stands");

constexpr std::string_view magic = "3D Geometry File Format ";
constexpr std::size_t header_bytes = 32;
constexpr int first_with_long_chunks = 50;
constexpr int newest = 89;
constexpr std::uint32_t no_bytes = 0x80000000, has_checksum = 0x8000;
constexpr std::size_t most_bytes = std::size_t{2} << 30;
constexpr std::size_t deflate_ratio = 1100;  // deflate compresses at most 1032 to 1

std::string all_bytes(std::istream& in, const std::string& name) {
    std::string bytes;
    std::string part(1 << 16, '\0');
    while (in.read(part.data(), static_cast<std::streamsize>(part.size())) || in.gcount() > 0) {
        bytes.append(part, 0, static_cast<std::size_t>(in.gcount()));
        if (bytes.size() > most_bytes)
            throw InputError(name + ": byte 0: more than 2 GiB, expected less; export the tiles alone");
    }
    if (in.bad()) throw InputError(name + ": byte 0: the file cannot be read to its end; check the disk it is on");
    return bytes;
}

void add_utf8(std::string& text, std::uint32_t c) {
    const auto put = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
    if (c < 0x80) {
        put(c);
    } else if (c < 0x800) {
        put(0xC0 | c >> 6);
        put(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
        put(0xE0 | c >> 12);
        put(0x80 | (c >> 6 & 0x3F));
        put(0x80 | (c & 0x3F));
    } else {
        put(0xF0 | c >> 18);
        put(0x80 | (c >> 12 & 0x3F));
        put(0x80 | (c >> 6 & 0x3F));
        put(0x80 | (c & 0x3F));
    }
}

/// An unpaired surrogate is no character; U+FFFD replaces it.
std::string utf8_of(std::string_view utf16) {
    const auto unit = [&utf16](std::size_t i) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(utf16[i])) |
               static_cast<std::uint32_t>(static_cast<unsigned char>(utf16[i + 1])) << 8;
    };
    std::string text;
    for (std::size_t i = 0; i + 1 < utf16.size(); i += 2) {
        std::uint32_t c = unit(i);
        if (c == 0) break;
        if (c >= 0xD800 && c < 0xE000) {
            const std::uint32_t low = i + 3 < utf16.size() ? unit(i + 2) : 0;
            const bool pair = c < 0xDC00 && low >= 0xDC00 && low < 0xE000;
            c = pair ? 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00) : 0xFFFD;
            if (pair) i += 2;
        }
        add_utf8(text, c);
    }
    return text;
}

}  // namespace

RhinoArchive read_rhino_archive(std::istream& in, const std::string& name) {
    RhinoArchive archive{name, all_bytes(in, name)};
    if (archive.bytes.size() < header_bytes || archive.bytes.compare(0, magic.size(), magic) != 0)
        throw InputError(name + ": byte 0: not the beginning of a Rhino file, expected \"3D Geometry File Format\"; " +
                         "save the model in Rhino as .3dm");
    const std::string_view digits =
        trimmed(std::string_view(archive.bytes).substr(magic.size(), header_bytes - magic.size()));
    const std::optional<double> version = parse_double(digits);
    if (!version || *version < 1 || *version > 999 || *version != static_cast<int>(*version))
        throw InputError(name + ": byte 24: " + shown(digits) + " where the version belongs, expected 1 to 80; " +
                         "save the model again in Rhino");
    archive.version = static_cast<int>(*version);
    if (archive.version > newest)
        throw InputError(name + ": byte 24: written by Rhino " + std::to_string(archive.version / 10) +
                         ", expected Rhino 8 or older; save it as Rhino 8 (File, Save As, Save as type)");
    return archive;
}

RhinoBytes::RhinoBytes(const RhinoArchive& archive) : RhinoBytes(archive, header_bytes, archive.bytes.size()) {}

RhinoBytes::RhinoBytes(const RhinoArchive& archive, std::size_t from, std::size_t to)
    : archive_(&archive), at_(from), end_(to) {}

void RhinoBytes::refuse(const std::string& found) const {
    throw InputError(name() + ": byte " + std::to_string(at_) + ": " + found +
                     "; the file is damaged or cut short, save it again in Rhino");
}

template <class T>
T RhinoBytes::number() {
    const RhinoBytes there = take(sizeof(T));
    T value;
    std::memcpy(&value, archive_->bytes.data() + there.at_, sizeof(T));
    return value;
}

std::uint8_t RhinoBytes::byte() {
    return number<std::uint8_t>();
}
std::int32_t RhinoBytes::integer() {
    return number<std::int32_t>();
}
std::uint32_t RhinoBytes::natural() {
    return number<std::uint32_t>();
}
double RhinoBytes::real() {
    return number<double>();
}
RhinoId RhinoBytes::id() {
    return number<RhinoId>();
}

Vec3 RhinoBytes::point() {
    const double x = real(), y = real(), z = real();
    return {x, y, z};
}

std::string RhinoBytes::text() {
    return readable_name(utf8_of(take(2 * count(2)).view()));
}

std::size_t RhinoBytes::count(std::size_t each) {
    const std::uint32_t found = natural();
    if (found > left() / each)
        refuse(std::to_string(found) + " elements of " + std::to_string(each) + " bytes, but only " +
               std::to_string(left()) + " bytes are left");
    return found;
}

RhinoBytes RhinoBytes::take(std::size_t size) {
    if (size > left()) refuse(std::to_string(size) + " bytes expected, only " + std::to_string(left()) + " are left");
    at_ += size;
    return {*archive_, at_ - size, at_};
}

std::string_view RhinoBytes::view() const {
    return std::string_view(archive_->bytes).substr(at_, left());
}

RhinoChunk RhinoBytes::chunk() {
    const std::uint32_t code = natural();
    const std::int64_t value = version() < first_with_long_chunks ? integer() : number<std::int64_t>();
    if (code & no_bytes) return {code, value, take(0)};
    if (value < 0 || static_cast<std::uint64_t>(value) > left())
        refuse("a part of " + std::to_string(value) + " bytes, but only " + std::to_string(left()) + " are left");
    RhinoBytes body = take(static_cast<std::size_t>(value));
    if (code & has_checksum) {
        if (body.left() < 4) body.refuse("a part of " + std::to_string(value) + " bytes, expected its checksum");
        body.end_ -= 4;
    }
    return {code, value, body};
}

std::string RhinoBytes::buffer(std::size_t size) {
    const std::size_t start = at_;
    const std::uint32_t found = natural();
    if (found != size) refuse("a block of " + std::to_string(found) + " bytes, expected " + std::to_string(size));
    if (size == 0) return "";
    const std::uint32_t checksum = natural();
    const std::uint8_t method = byte();
    std::string bytes;
    if (method == 0) {
        bytes = take(size).view();
    } else if (method == 1) {
        const RhinoChunk deflated = chunk();
        const std::string_view from = deflated.body.view();
        if (size / deflate_ratio > from.size())
            refuse(std::to_string(size) + " bytes supposedly packed into " + std::to_string(from.size()));
        bytes.resize(size);
        auto length = static_cast<uLongf>(size);
        const int result = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &length,
                                      reinterpret_cast<const Bytef*>(from.data()), static_cast<uLong>(from.size()));
        if (result != Z_OK || length != size) refuse("a packed block that cannot be unpacked");
    } else {
        refuse("a block with the compression method " + std::to_string(method) + ", expected 0 or 1");
    }
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(size));
    if (sum != checksum) {
        at_ = start;
        refuse("a block that does not match its checksum");
    }
    return bytes;
}

void RhinoBytes::skip_buffer() {
    const std::uint32_t size = natural();
    if (size == 0) return;
    natural();
    const std::uint8_t method = byte();
    if (method == 0)
        skip(size);
    else if (method == 1)
        chunk();
    else
        refuse("a block with the compression method " + std::to_string(method) + ", expected 0 or 1");
}

RhinoBytes::Version RhinoBytes::packed_version() {
    const int packed = byte();
    return {packed >> 4, packed & 15};
}

RhinoBytes RhinoBytes::anonymous(std::uint32_t code) {
    RhinoChunk part = chunk();
    if (part.code != code) refuse("a part of an unexpected kind");
    part.body.skip(2 * sizeof(std::int32_t));
    return part.body;
}

}  // namespace ripstop

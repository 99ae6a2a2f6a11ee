#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

namespace ripstop {

/// The whole content of a file, read at once. Throws InputError if the stream cannot be read or holds more than 2
/// GiB.
std::string read_bytes(std::istream& in, const std::string& name);

/// The bytes as text, without the UTF-8 byte order mark. Throws InputError if they are not text: UTF-16, or a zero
/// byte.
std::string text_of(std::string bytes, const std::string& name);

/// The whole content of a text file, read at once, without the UTF-8 byte order mark. Throws InputError if the
/// stream cannot be read, holds more than 2 GiB, or is no text: UTF-16, or a zero byte.
std::string read_text(std::istream& in, const std::string& name);

/// Iterates over the lines of a text, which must outlive it. A line ends with LF or CR LF, or with CR if the text
/// has no LF at all; the last line needs no end.
class Lines {
  public:
    explicit Lines(std::string_view text);

    /// Moves to the next line; false after the last.
    bool next();
    std::string_view line() const { return line_; }
    long number() const { return number_; }  ///< of the line, from 1; for a continued line, of its first part

    /// The line joined with those it continues on, by backslashes at line ends; `next` moves past them. Valid
    /// until the next call.
    std::string_view joined();

  private:
    std::string_view take();

    std::string_view rest_;
    char end_;
    std::string_view line_;
    std::string joined_;
    long number_ = 0;
    long taken_ = 0;
};

/// The next word of `rest`, separated by blanks (space, tab, CR, form feed, vertical tab); empty at the end.
/// Removes it from `rest`.
std::string_view next_word(std::string_view& rest);

/// The text without surrounding blanks.
std::string_view trimmed(std::string_view text);

/// A name as UTF-8: bytes that are not UTF-8 are read as Latin-1, control characters become `_`.
std::string readable_name(std::string_view bytes);

/// The found text in quotes, for a message: at most 40 characters, always UTF-8.
std::string shown(std::string_view found);

}  // namespace ripstop

#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

namespace ripstop {

/// The whole of a file, read in one go. Throws InputError where the stream cannot be read or holds more than 2 GiB.
std::string read_bytes(std::istream& in, const std::string& name);

/// The same as text: without the byte order mark of UTF-8. Throws InputError for what is no text: UTF-16, or a zero
/// byte.
std::string text_of(std::string bytes, const std::string& name);

/// The whole of a text file, read in one go. A byte order mark of UTF-8 is dropped. Throws InputError where the stream
/// cannot be read, holds more than 2 GiB, or is no text: UTF-16, or a zero byte in it.
std::string read_text(std::istream& in, const std::string& name);

/// Walks the lines of a text, which must outlive it. A line ends with LF, CR LF, or, where the text has no LF at all,
/// with CR; the last line needs no end.
class Lines {
  public:
    explicit Lines(std::string_view text);

    /// Goes to the next line; false after the last.
    bool next();
    std::string_view line() const { return line_; }
    long number() const { return number_; }  ///< of the line, from 1; of its first part where it is continued

    /// The line together with the ones it is continued on by a backslash at its end; `next` goes on after them. Valid
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

/// The next word of `rest`, between blanks (space, tab, CR, form feed, vertical tab); empty at the end. `rest` moves
/// on.
std::string_view next_word(std::string_view& rest);

/// Without the blanks at both ends.
std::string_view trimmed(std::string_view text);

/// A name as UTF-8: bytes that are not UTF-8 are taken as Latin-1, control characters become `_`.
std::string readable_name(std::string_view bytes);

/// What was found, in quotes, for a message: at most 40 characters, always UTF-8.
std::string shown(std::string_view found);

}  // namespace ripstop

#include "help/help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>

#include "commands/command_tree.h"
#include "help/colour.h"

namespace ripstop::cli {
namespace {

constexpr std::size_t indent = 26;  ///< column at which descriptions begin

std::size_t page_width() {
    constexpr std::size_t most = 100, least = 60;
    winsize size{};
    if (!isatty(STDOUT_FILENO) || ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return most;
    return std::clamp<std::size_t>(size.ws_col, least, most);
}

/// The indent of continuation lines, for a list line such as `cam    contours on layers …`.
std::size_t hang_of(const std::string& line) {
    const std::size_t gap = line.find(' ');
    const std::size_t next = line.find_first_not_of(' ', gap);
    return gap < 10 && next != std::string::npos && (next > gap + 1 || gap > 4) ? next : 0;
}

/// Wraps the words of `text` at `width`, starting in column `from`; keeps its line breaks.
std::string wrapped(const std::string& text, std::size_t from, std::size_t width) {
    std::string result;
    for (std::size_t at = 0, line = 0; at <= text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        std::string rest = text.substr(at, end - at);
        const std::size_t hang = line == 0 ? 0 : hang_of(rest);
        if (line > 0) result += "\n" + std::string(from, ' ');
        for (std::size_t room = width - from; rest.size() > room; room = width - from - hang) {
            std::size_t blank = rest.rfind(' ', room);
            if (blank == std::string::npos || blank < hang) blank = rest.find(' ', room);
            if (blank == std::string::npos) break;
            result += rest.substr(0, blank) + "\n" + std::string(from + hang, ' ');
            rest = rest.substr(blank + 1);
        }
        result += rest;
        at = end + 1;
    }
    return result;
}

std::string entry(const std::string& name, const std::string& description, std::size_t width) {
    const std::string head = "  " + name;
    const bool fits = head.size() + 2 <= indent;
    return head + (fits ? std::string(indent - head.size(), ' ') : "\n" + std::string(indent, ' ')) +
           wrapped(description, indent, width) + "\n";
}

std::string option_entry(const OptionText& option, std::size_t width) {
    std::string name = fmt::format("{}", fmt::join(option.names, ", "));
    if (!option.is_positional && !option.value.empty()) name += " " + option.shown_value();
    return entry(name, option.description, width);
}

class Pages : public CLI::Formatter {
  public:
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode) const override {
        const std::size_t width = page_width();
        CommandText command = command_text(*app);
        command.path = name;
        std::string page =
            wrapped(command.description, 0, width) + ".\n\n" + heading("Usage:") + " " + command.usage() + "\n";
        std::vector<std::string> groups;
        for (const OptionText& option : command.options)
            if (std::find(groups.begin(), groups.end(), option.group) == groups.end()) groups.push_back(option.group);
        for (const bool is_positional : {true, false})
            for (const std::string& group : groups) page += group_of(command, group, is_positional, width);
        if (!command.commands.empty()) page += "\n" + heading("Commands:") + "\n";
        for (const CommandText& each : command.commands)
            page += entry(each.path.substr(each.path.rfind(' ') + 1), each.description, width);
        return page + (command.footer.empty() ? "" : "\n" + footer(command.footer) + "\n");
    }

  private:
    static std::string heading(const std::string& text) {
        return has_colours(stdout) ? coloured(text, Colour::bold) : text;
    }
    static std::string group_of(const CommandText& command, const std::string& group, bool is_positional,
                                std::size_t width) {
        std::string text;
        for (const OptionText& option : command.options)
            if (option.group == group && option.is_positional == is_positional) text += option_entry(option, width);
        return text.empty() ? text : "\n" + heading((is_positional ? "Arguments" : group) + ":") + "\n" + text;
    }
    static std::string footer(const std::string& text) {
        for (const char* title : {"Examples:", "Exit codes:"})
            if (const std::size_t at = text.find(title); at != std::string::npos)
                return footer(text.substr(0, at)) + heading(title) +
                       footer(text.substr(at + std::string_view(title).size()));
        return text;
    }
};

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_pages() {
    return std::make_shared<Pages>();
}

}  // namespace ripstop::cli

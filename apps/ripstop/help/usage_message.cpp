#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "commands/command_tree.h"
#include "help/help.h"
#include "options/guess.h"

namespace ripstop::cli {
namespace {

std::vector<std::string> commands_of(const CommandText& command) {
    std::vector<std::string> names;
    for (const CommandText& each : command.commands) names.push_back(each.path.substr(each.path.rfind(' ') + 1));
    return names;
}

/// The first word that nothing accepts: at the place of a command that word, else an option in preference to other
/// words, because its value may be among them.
std::string stranger(const CLI::App& app, bool has_commands) {
    const std::vector<std::string> words = app.remaining();
    if (has_commands && !words.empty() && !words.front().starts_with('-')) return words.front();
    const auto option =
        std::find_if(words.begin(), words.end(), [](const auto& word) { return word.starts_with('-'); });
    return words.empty() ? "" : option != words.end() ? *option : words.front();
}

std::string about_stranger(const CommandText& command, std::string word) {
    const std::string all = fmt::format("{}", fmt::join(commands_of(command), ", "));
    if (word.starts_with('-')) {
        word = word.substr(0, word.find('='));
        std::vector<std::string> options;
        for (const OptionText& option : command.options)
            if (!option.is_positional) options.insert(options.end(), option.names.begin(), option.names.end());
        return fmt::format("no option \"{}\"{}", word, guess(word, options));
    }
    if (command.commands.empty()) return fmt::format("\"{}\" is one word too many; expected {}", word, command.usage());
    const std::string near = guess(word, commands_of(command));
    return fmt::format("no command \"{}\"{}", word, near.empty() ? "; known commands: " + all : near);
}

/// Rewrites CLI11's message about existing options, and adds what it omits.
std::string about_options(const CommandText& command, const CLI::Error& error) {
    const std::string text = error.what();
    for (const OptionText& option : command.options) {
        const std::string& name = option.names.back();
        const std::string described = option.description.substr(0, option.description.find_first_of(";:\n("));
        if (text == name + " is required")
            return fmt::format("{}: {}{}", text, char(std::tolower(described[0])), described.substr(1));
        if (text.starts_with("Could not convert: " + name + " = "))
            return fmt::format("{}: \"{}\" is not a {}number", name, text.substr(text.find(" = ") + 3),
                               option.value == "N" ? "whole " : "");
        if (text.starts_with(name + ": 1 required ")) return fmt::format("{} needs its value, {}", name, option.value);
    }
    return text + (text.find(" excludes ") == std::string::npos ? "" : "; give one of the two");
}

}  // namespace

std::string usage_message(const CLI::App* app, const CLI::Error& error) {
    std::string path = app->get_name();
    while (!app->get_subcommands().empty()) {
        app = app->get_subcommands().front();
        path += " " + app->get_name();
    }
    CommandText command = command_text(*app);
    command.path = path;
    const std::string word = stranger(*app, !command.commands.empty());
    const std::string text = !word.empty() ? about_stranger(command, word)
                             : !command.commands.empty()
                                 ? fmt::format("a command is missing; known: {}", fmt::join(commands_of(command), ", "))
                                 : about_options(command, error);
    return fmt::format("ripstop: {}\n`{} --help` tells more\n", text, path);
}

}  // namespace ripstop::cli

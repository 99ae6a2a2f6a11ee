#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace ripstop::cli {

/// An option of a command, as shown by --help, the shells and the manual.
struct OptionText {
    std::vector<std::string> names;    ///< `-o`, `--output`; for an argument without dashes its name in capitals
    std::string value;                 ///< placeholder of its value: `LENGTH`, `FILE`; empty: a flag
    std::vector<std::string> choices;  ///< the allowed or the usual words
    std::string description;           ///< with range and default; the first line ends in a colon before a list
    std::string group;
    bool is_positional = false, is_required = false, is_repeated = false;
    bool is_list = false;  ///< several choices may be given, separated by commas

    /// `auto|all|none` if that is short and only one may be given, else `value`.
    std::string shown_value() const;
};

/// A command as declared: the one source of --help, completions and the manual.
struct CommandText {
    std::string path;  ///< `ripstop design natural`
    std::string description, footer;
    std::vector<OptionText> options;
    std::vector<CommandText> commands;

    /// `ripstop flatten INPUT --output DIR [OPTIONS]`.
    std::string usage() const;
};

CommandText command_text(const CLI::App& app, const std::string& parent = {});

}  // namespace ripstop::cli

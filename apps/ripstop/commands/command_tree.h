#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace ripstop::cli {

/// An option of a command as --help, the shells and the manual show it.
struct OptionText {
    std::vector<std::string> names;    ///< `-o`, `--output`; the name in capitals of what has no dashes
    std::string value;                 ///< what follows it: `LENGTH`, `FILE`; empty: a flag
    std::vector<std::string> choices;  ///< where only some words are allowed, or usual
    std::string description;           ///< with the range and the default; its first line ends in a colon before a list
    std::string group;
    bool is_positional = false, is_required = false, is_repeated = false;
    bool is_list = false;  ///< several of the choices may be given with commas

    /// `auto|all|none` where that is short and only one may be given, else `value`.
    std::string shown_value() const;
};

/// A command as it was declared, so that --help, completions and the manual cannot say anything else.
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

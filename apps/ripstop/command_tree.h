#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace ripstop::cli {

/// An option of a command as the shell and the manual show it.
struct OptionText {
    std::vector<std::string> names;    ///< `-o`, `--output`; the name in capitals of what has no dashes
    std::string value;                 ///< what follows it: `TEXT`, `INT`; empty: a flag
    std::vector<std::string> choices;  ///< where only some words are allowed
    std::string description;
    bool is_positional = false, is_required = false;
};

/// A command as it was declared, so that completions and the manual cannot say anything else.
struct CommandText {
    std::string path;  ///< `ripstop design natural`
    std::string description, footer;
    std::vector<OptionText> options;
    std::vector<CommandText> commands;
};

CommandText command_text(const CLI::App& app, const std::string& parent = {});

}  // namespace ripstop::cli

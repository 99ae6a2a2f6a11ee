/// ripstop completion: what makes a shell complete commands, options and their words.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command_tree.h"
#include "commands.h"

namespace ripstop::cli {
namespace {

std::vector<std::string> words_after(const CommandText& command) {
    std::vector<std::string> words;
    for (const CommandText& each : command.commands) words.push_back(each.path.substr(each.path.rfind(' ') + 1));
    for (const OptionText& option : command.options)
        if (!option.is_positional) words.insert(words.end(), option.names.begin(), option.names.end());
    return words;
}

/// All commands, the program itself first.
void list(const CommandText& command, std::vector<const CommandText*>& all) {
    all.push_back(&command);
    for (const CommandText& each : command.commands) list(each, all);
}

/// `natural` of `ripstop design natural`; empty for the program.
std::string words_of(const CommandText& command) {
    const std::size_t blank = command.path.find(' ');
    return blank == std::string::npos ? "" : command.path.substr(blank + 1);
}

std::string bash(const CommandText& program) {
    std::vector<const CommandText*> all;
    list(program, all);
    std::string words, choices;
    for (const CommandText* command : all) {
        words +=
            fmt::format("        \"{}\") words=\"{}\" ;;\n", words_of(*command), fmt::join(words_after(*command), " "));
        for (const OptionText& option : command->options)
            if (!option.choices.empty() && !option.is_positional)
                choices += fmt::format("        \"{} {}\") words=\"{}\" ;;\n", words_of(*command),
                                       fmt::join(option.names, fmt::format("\"|\"{} ", words_of(*command))),
                                       fmt::join(option.choices, " "));
    }
    return fmt::format(R"(# Completion of ripstop for bash, made by `ripstop completion bash`.
_ripstop() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} command="" word words="" i
    for ((i = 1; i < COMP_CWORD; ++i)); do
        word=${{COMP_WORDS[i]}}
        case "$command$word" in
        {}) command="$command$word " ;;
        esac
    done
    command=${{command% }}
    case "$command ${{COMP_WORDS[COMP_CWORD-1]}}" in
{}    esac
    if [ -z "$words" ]; then
        case "$command" in
{}        esac
        case "$command:$current" in
        :* | design:* | *:-*) ;;
        *) COMPREPLY=($(compgen -f -- "$current")); return ;;
        esac
    fi
    COMPREPLY=($(compgen -W "$words" -- "$current"))
}}
complete -o filenames -F _ripstop ripstop
)",
                       [&all] {
                           std::vector<std::string> known;
                           for (const CommandText* command : all) {
                               std::string path = words_of(*command);
                               if (path.empty()) continue;
                               known.push_back("\"" + path + "\"");
                           }
                           return fmt::format("{}", fmt::join(known, " | "));
                       }(),
                       choices, words);
}

std::string zsh(const CommandText& program) {
    return "#compdef ripstop\nautoload -U +X bashcompinit && bashcompinit\n" + bash(program);
}

/// In single quotes.
std::string quoted(std::string text) {
    for (std::size_t at = 0; (at = text.find_first_of("'\\", at)) != std::string::npos; at += 2) text.insert(at, "\\");
    return "'" + text.substr(0, text.find('\n')) + "'";
}

std::string fish(const CommandText& program) {
    std::string script = "# Completion of ripstop for fish, made by `ripstop completion fish`.\n";
    for (const CommandText& command : program.commands) {
        const std::string name = words_of(command);
        script += fmt::format("complete -c ripstop -n __fish_use_subcommand -a {} -d {}\n", name,
                              quoted(command.description));
        for (const OptionText& option : command.options) {
            if (option.is_positional) continue;
            script += fmt::format("complete -c ripstop -n '__fish_seen_subcommand_from {}'", name);
            for (const std::string& word : option.names)
                script += word.starts_with("--") ? " -l " + word.substr(2) : " -s " + word.substr(1);
            if (!option.choices.empty())
                script += fmt::format(" -x -a '{}'", fmt::join(option.choices, " "));
            else if (!option.value.empty())
                script += " -r";
            script += " -d " + quoted(option.description) + "\n";
        }
        for (const CommandText& each : command.commands)
            script += fmt::format("complete -c ripstop -n '__fish_seen_subcommand_from {}' -a {} -d {}\n", name,
                                  each.path.substr(each.path.rfind(' ') + 1), quoted(each.description));
    }
    return script;
}

}  // namespace

void add_completion(CLI::App& app) {
    auto shell = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("completion", "Prints what makes a shell complete commands and options");
    command->add_option("SHELL", *shell, "bash, zsh or fish")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
    command->footer(
        "Examples: source <(ripstop completion bash)\n"
        "          ripstop completion fish > ~/.config/fish/completions/ripstop.fish\n"
        "`make install` puts them where the shells look.");
    command->callback([&app, shell] {
        const CommandText program = command_text(app);
        fmt::print("{}", *shell == "bash" ? bash(program) : *shell == "zsh" ? zsh(program) : fish(program));
    });
}

}  // namespace ripstop::cli

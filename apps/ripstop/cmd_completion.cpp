/// ripstop completion: what makes a shell complete commands, options and their words.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "command_tree.h"
#include "commands.h"
#include "known.h"

namespace ripstop::cli {
namespace {

/// What a shell offers where a command goes on: its commands and options, and the words that its arguments may be.
std::vector<std::string> words_after(const CommandText& command) {
    std::vector<std::string> words;
    for (const CommandText& each : command.commands) words.push_back(each.path.substr(each.path.rfind(' ') + 1));
    for (const OptionText& option : command.options) {
        const std::vector<std::string>& more = option.is_positional ? option.choices : option.names;
        words.insert(words.end(), more.begin(), more.end());
    }
    return words;
}

bool is_file(const OptionText& option) {
    return option.value == "FILE" || option.value == "DIR";
}

bool takes_files(const CommandText& command) {
    return std::any_of(command.options.begin(), command.options.end(),
                       [](const OptionText& option) { return option.is_positional && is_file(option); });
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

/// Lines of the shell's `case` for what follows each option of a command: words, a file, or what nobody can guess.
std::string after_options(const CommandText& command) {
    std::string lines;
    for (const OptionText& option : command.options) {
        if (option.is_positional || option.value.empty()) continue;
        std::vector<std::string> patterns;
        for (const std::string& name : option.names)
            patterns.push_back(fmt::format("\"{} {}\"", words_of(command), name));
        const std::string offered = !option.choices.empty()
                                        ? fmt::format("offered=\"{}\"; ", fmt::join(option.choices, " "))
                                    : is_file(option) ? "files=yes; "
                                                      : "";
        lines += fmt::format("    {}) {}return ;;\n", fmt::join(patterns, " | "), offered);
    }
    return lines;
}

/// The function of bash and zsh that sets `offered` to the words, and `files` to yes where files, may come after its
/// arguments.
std::string offering(const CommandText& program) {
    std::vector<const CommandText*> all;
    list(program, all);
    std::string after_command, after_option;
    std::vector<std::string> known;
    for (const CommandText* command : all) {
        after_command += fmt::format("    \"{}\") offered=\"{}\"{} ;;\n", words_of(*command),
                                     fmt::join(words_after(*command), " "), takes_files(*command) ? " files=yes" : "");
        after_option += after_options(*command);
        if (!words_of(*command).empty()) known.push_back("\"" + words_of(*command) + "\"");
    }
    return fmt::format(R"(_ripstop_words() {{
    local command="" word="" last=""
    offered="" files=""
    for word in "$@"; do
        case "$command$word" in
        {}) command="$command$word " ;;
        esac
        last=$word
    done
    command=${{command% }}
    case "$command $last" in
{}    esac
    case "$command" in
{}    esac
}}
)",
                       fmt::join(known, " | "), after_option, after_command);
}

std::string bash(const CommandText& program) {
    return "# Completion of ripstop for bash, made by `ripstop completion bash`.\n" + offering(program) +
           R"(_ripstop() {
    local offered files current=${COMP_WORDS[COMP_CWORD]}
    _ripstop_words "${COMP_WORDS[@]:1:COMP_CWORD-1}"
    if [[ -n $files && $current != -* ]]; then
        local IFS=$'\n'
        COMPREPLY=($(compgen -f -- "$current"))
    else
        COMPREPLY=($(compgen -W "$offered" -- "$current"))
    fi
}
complete -o filenames -F _ripstop ripstop
)";
}

/// Loaded by name, the file is itself what zsh calls the first time.
std::string zsh(const CommandText& program) {
    return "#compdef ripstop\n# Completion of ripstop for zsh, made by `ripstop completion zsh`.\n" +
           offering(program) +
           R"(_ripstop() {
    local offered files
    _ripstop_words "${(@)words[2,CURRENT-1]}"
    if [[ -n $files && $PREFIX != -* ]]; then
        _files
    else
        compadd -- ${=offered}
    fi
}
if [ "${funcstack[1]}" = _ripstop ]; then _ripstop "$@"; else compdef _ripstop ripstop; fi
)";
}

/// In single quotes.
std::string quoted(std::string text) {
    for (std::size_t at = 0; (at = text.find_first_of("'\\", at)) != std::string::npos; at += 2) text.insert(at, "\\");
    return "'" + text.substr(0, text.find('\n')) + "'";
}

std::string fish_option(const std::string& here, const OptionText& option) {
    const std::string words =
        option.choices.empty() ? std::string() : fmt::format(" -a '{}'", fmt::join(option.choices, " "));
    if (option.is_positional) return words.empty() ? words : here + words + "\n";
    std::string line = here;
    for (const std::string& word : option.names)
        line += word.starts_with("--") ? " -l " + word.substr(2) : " -s " + word.substr(1);
    if (!option.value.empty()) line += is_file(option) ? " -r" : " -x" + words;
    return line + " -d " + quoted(option.description) + "\n";
}

std::string fish(const CommandText& program) {
    std::string script =
        "# Completion of ripstop for fish, made by `ripstop completion fish`.\n"
        "complete -c ripstop -n __fish_use_subcommand -f\n";
    for (const CommandText& command : program.commands) {
        const std::string name = words_of(command);
        const std::string here = fmt::format("complete -c ripstop -n '__fish_seen_subcommand_from {}'", name);
        script += fmt::format("complete -c ripstop -n __fish_use_subcommand -a {} -d {}\n", name,
                              quoted(command.description));
        if (!takes_files(command)) script += here + " -f\n";
        for (const CommandText& each : command.commands)
            script += fmt::format("{} -a {} -d {}\n", here, each.path.substr(each.path.rfind(' ') + 1),
                                  quoted(each.description));
        std::vector<const CommandText*> all;  // fish knows no command of a command: its options are offered at once
        list(command, all);
        for (const CommandText* each : all)
            for (const OptionText& option : each->options) script += fish_option(here, option);
    }
    return script;
}

}  // namespace

void add_completion(CLI::App& app) {
    auto shell = std::make_shared<std::string>();
    CLI::App* command =
        app.add_subcommand("completion", "Print what makes a shell complete commands, options and their words");
    command->add_option("SHELL", *shell, "bash, zsh or fish")
        ->required()
        ->type_name("WORD")
        ->check(one_of({"bash", "zsh", "fish"}));
    command->footer(
        "Examples:\n"
        "  source <(ripstop completion bash)            in this shell; in ~/.bashrc for all\n"
        "  ripstop completion fish > ~/.config/fish/completions/ripstop.fish\n"
        "`make install` puts them where the shells look.");
    command->callback([&app, shell] {
        const CommandText program = command_text(app);
        fmt::print("{}", *shell == "bash" ? bash(program) : *shell == "zsh" ? zsh(program) : fish(program));
    });
}

}  // namespace ripstop::cli

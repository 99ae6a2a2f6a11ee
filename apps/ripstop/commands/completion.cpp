/// ripstop completion: prints the script with which a shell completes commands, options and their words.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "commands/command_tree.h"
#include "commands/commands.h"
#include "commands/known.h"
#include "help/tell.h"

namespace ripstop::cli {
namespace {

/// The words that a shell offers after a command: its commands, its options, and the words of its arguments.
std::vector<std::string> words_after(const CommandText& command) {
    std::vector<std::string> words;
    for (const CommandText& each : command.commands) words.push_back(each.path.substr(each.path.rfind(' ') + 1));
    for (const OptionText& option : command.options) {
        const std::vector<std::string>& more = option.is_positional ? option.choices : option.names;
        words.insert(words.end(), more.begin(), more.end());
    }
    return words;
}

/// The files that may follow: `yes`, `dir` for folders only, `.json` for those files and folders; empty: none.
std::string files_of(const OptionText& option) {
    if (option.value == "DIR") return "dir";
    if (!option.value.starts_with("FILE")) return "";
    return option.value == "FILE" ? "yes" : option.value.substr(4);
}

/// The files for all arguments of the command together, because a shell does not count arguments.
std::string files_of(const CommandText& command) {
    std::string files;
    for (const OptionText& option : command.options)
        if (option.is_positional && files != "yes" && !files_of(option).empty()) files = files_of(option);
    return files;
}

/// Lists all commands, the program itself first.
void list(const CommandText& command, std::vector<const CommandText*>& all) {
    all.push_back(&command);
    for (const CommandText& each : command.commands) list(each, all);
}

/// `natural` of `ripstop design natural`; empty for the program.
std::string words_of(const CommandText& command) {
    const std::size_t blank = command.path.find(' ');
    return blank == std::string::npos ? "" : command.path.substr(blank + 1);
}

/// The `case` branches for the values of each option of a command: words, files, or nothing.
std::string after_options(const CommandText& command) {
    std::string lines;
    for (const OptionText& option : command.options) {
        if (option.is_positional || option.value.empty()) continue;
        std::vector<std::string> patterns;
        for (const std::string& name : option.names)
            patterns.push_back(fmt::format("\"{} {}\"", words_of(command), name));
        std::string offered;
        if (!option.choices.empty()) offered += fmt::format("offered=\"{}\"; ", fmt::join(option.choices, " "));
        if (!files_of(option).empty()) offered += fmt::format("files={}; ", files_of(option));
        if (option.is_list) offered += "lists=yes; ";
        lines += fmt::format("    {}) {}return ;;\n", fmt::join(patterns, " | "), offered);
    }
    return lines;
}

/// The function for bash and zsh that finds what may follow its arguments. It sets `offered` to the words, `files` as
/// `files_of` does, and `lists` if several words may be given, separated by commas.
std::string offering(const CommandText& program) {
    std::vector<const CommandText*> all;
    list(program, all);
    std::string after_command, after_option;
    std::vector<std::string> known;
    for (const CommandText* command : all) {
        after_command += fmt::format("    \"{}\") offered=\"{}\" files={} ;;\n", words_of(*command),
                                     fmt::join(words_after(*command), " "), files_of(*command));
        after_option += after_options(*command);
        if (!words_of(*command).empty()) known.push_back("\"" + words_of(*command) + "\"");
    }
    return fmt::format(R"(_ripstop_words() {{
    local command="" word="" last=""
    offered="" files="" lists=""
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
    local offered files lists before="" word current=${COMP_WORDS[COMP_CWORD]} words=()
    for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
        [[ $word == "=" ]] || words+=("$word")
    done
    if [[ $current == "=" ]]; then
        current=""
    elif [[ $current == --*=* ]]; then
        words+=("${current%%=*}")
        before=${current%%=*}= current=${current#*=}
    fi
    _ripstop_words "${words[@]}"
    if [[ -n $lists && $current == *,* ]]; then
        before+=${current%,*},
        current=${current##*,}
    fi
    COMPREPLY=()
    for word in $offered; do
        [[ $word != "$current"* || (-n $files && $word == -* && $current != -*) ]] || COMPREPLY+=("$before$word")
    done
    [[ -n $files && $current != -* ]] || return 0
    local IFS=$'\n'
    case $files in
    yes) COMPREPLY+=($(compgen -P "$before" -f -- "$current")) ;;
    dir) COMPREPLY+=($(compgen -P "$before" -d -- "$current")) ;;
    *) COMPREPLY+=($(compgen -P "$before" -d -- "$current") $(compgen -P "$before" -f -X "!*$files" -- "$current")) ;;
    esac
}
complete -o filenames -F _ripstop ripstop
)";
}

/// The file is both sourced and autoloaded: when loaded by name, it is itself the function that zsh calls first.
std::string zsh(const CommandText& program) {
    return "#compdef ripstop\n# Completion of ripstop for zsh, made by `ripstop completion zsh`.\n" +
           offering(program) +
           R"(_ripstop() {
    local offered files lists
    if [[ $PREFIX == --*=* ]]; then
        _ripstop_words "${(@)words[2,CURRENT-1]}" "${PREFIX%%=*}"
        compset -P '*='
    else
        _ripstop_words "${(@)words[2,CURRENT-1]}"
    fi
    [[ -z $lists ]] || compset -P '*,'
    local may_come=(${=offered})
    [[ -z $files || $PREFIX == -* ]] || may_come=(${may_come:#-*})
    compadd -- $may_come
    [[ $PREFIX == -* ]] && return
    case $files in
    yes) _files ;;
    dir) _files -/ ;;
    .*) _files -g "*$files" ;;
    esac
}
if [ "${funcstack[1]}" = _ripstop ]; then _ripstop "$@"; else compdef _ripstop ripstop; fi
)";
}

/// Puts a text in single quotes.
std::string quoted(std::string text) {
    for (std::size_t at = 0; (at = text.find_first_of("'\\", at)) != std::string::npos; at += 2) text.insert(at, "\\");
    return "'" + text.substr(0, text.find('\n')) + "'";
}

std::string fish_option(const std::string& here, const OptionText& option) {
    std::string offered = fmt::format("{}", fmt::join(option.choices, " "));
    if (option.is_list) offered = "(__fish_append , " + offered + ")";
    const std::string files = files_of(option);
    if (files == "dir") offered += "(__fish_complete_directories)";
    if (files.starts_with('.'))
        offered +=
            " (__fish_complete_suffix " + files + " | string match -er \"([.]" + files.substr(1) + "|/)(\\t|\\$)\")";
    const std::string words = offered.empty() ? "" : " -a '" + offered + "'";
    if (option.is_positional) return option.choices.empty() ? "" : here + words + "\n";
    std::string line = here;
    for (const std::string& word : option.names)
        line += word.starts_with("--") ? " -l " + word.substr(2) : " -s " + word.substr(1);
    if (!option.value.empty()) line += files == "yes" ? " -r" : " -x" + words;
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
        if (files_of(command).empty()) script += here + " -f\n";
        if (files_of(command) == "dir") script += here + " -f -a '(__fish_complete_directories)'\n";
        for (const CommandText& each : command.commands)
            script += fmt::format("{} -a {} -d {}\n", here, each.path.substr(each.path.rfind(' ') + 1),
                                  quoted(each.description));
        std::vector<const CommandText*> all;  // fish has no nested commands: their options are offered at once
        list(command, all);
        for (const CommandText* each : all)
            for (const OptionText& option : each->options) script += fish_option(here, option);
    }
    return script;
}

}  // namespace

void add_completion(CLI::App& app) {
    auto shell = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand(
        "completion", "Print a script with which a shell completes commands, options and their values");
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
        print("{}", *shell == "bash" ? bash(program) : *shell == "zsh" ? zsh(program) : fish(program));
    });
}

}  // namespace ripstop::cli

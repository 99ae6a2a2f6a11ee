#include "command_tree.h"

namespace ripstop::cli {
namespace {

/// The words of `TEXT:{auto,all,none}`.
std::vector<std::string> choices_of(const std::string& type) {
    const std::size_t open = type.find('{'), close = type.rfind('}');
    std::vector<std::string> words;
    if (open == std::string::npos || close == std::string::npos) return words;
    std::string word;
    for (const char c : type.substr(open + 1, close - open - 1)) {
        if (c != ',') {
            word += c;
            continue;
        }
        words.push_back(word);
        word.clear();
    }
    words.push_back(word);
    return words;
}

OptionText option_text(const CLI::Option& option) {
    OptionText text;
    for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
    text.is_positional = text.names.empty();
    if (text.is_positional) text.names.push_back(option.get_single_name());
    text.is_required = option.get_required();
    text.description = option.get_description();
    if (option.get_items_expected_max() > 0) {
        text.choices = choices_of(option.get_type_name());
        text.value = text.choices.empty() ? option.get_type_name() : "WORD";
    }
    return text;
}

}  // namespace

CommandText command_text(const CLI::App& app, const std::string& parent) {
    CommandText text{parent.empty() ? app.get_name() : parent + " " + app.get_name(),
                     app.get_description(),
                     app.get_footer(),
                     {},
                     {}};
    for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; }))
        text.options.push_back(option_text(*option));
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        text.commands.push_back(command_text(*command, text.path));
    return text;
}

}  // namespace ripstop::cli

#include "commands/command_tree.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ripstop::cli {
namespace {

/// Splits `{auto,all,none}` into words.
std::vector<std::string> words_of(const std::string& braces) {
    std::vector<std::string> words(1);
    for (const char c : braces.substr(1, braces.size() - 2)) {
        if (c == ',')
            words.emplace_back();
        else
            words.back() += c;
    }
    return words;
}

/// Inserts a remark in brackets after the first line of a description, before a colon that opens a list.
void add_remark(std::string& description, const std::string& remark) {
    const std::size_t end = std::min(description.find('\n'), description.size());
    const bool is_list = end < description.size() && end > 0 && description[end - 1] == ':';
    description.insert(is_list ? end - 1 : end, " (" + remark + ")");
}

OptionText option_text(const CLI::Option& option) {
    OptionText text;
    for (const std::string& name : option.get_snames()) text.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) text.names.push_back("--" + name);
    text.is_positional = text.names.empty();
    if (text.is_positional) text.names.push_back(option.get_single_name());
    text.is_required = option.get_required();
    text.is_repeated = option.get_items_expected_max() > 1;
    text.is_list = option.get_delimiter() != '\0';
    text.description = option.get_description();
    text.group = option.get_group();
    if (option.get_items_expected_max() == 0) return text;
    const std::string type = option.get_type_name();  // INT:0 to 1024, WORD:{auto,all,none}
    const std::size_t colon = type.find(':');
    text.value = type.substr(0, colon);
    const std::string allowed = colon == std::string::npos ? "" : type.substr(colon + 1);
    if (allowed.starts_with('{')) text.choices = words_of(allowed);
    std::string remark = text.choices.empty() ? allowed : "";
    if (!option.get_default_str().empty())
        remark += (remark.empty() ? "default " : "; default ") + option.get_default_str();
    if (!remark.empty()) add_remark(text.description, remark);
    return text;
}

}  // namespace

std::string OptionText::shown_value() const {
    constexpr std::size_t most = 24;
    const std::string all = fmt::format("{}", fmt::join(choices, "|"));
    return choices.empty() || is_repeated || all.size() > most ? value : all;
}

std::string CommandText::usage() const {
    std::string text = path;
    bool has_options = false;
    for (const OptionText& option : options) {
        if (option.is_positional) text += " " + option.names.back();
        has_options = has_options || (!option.is_positional && !option.is_required);
    }
    for (const OptionText& option : options)
        if (!option.is_positional && option.is_required)
            text += fmt::format(" {} {}", option.names.front(), option.shown_value());
    return text + (commands.empty() ? "" : " COMMAND") + (has_options ? " [OPTIONS]" : "");
}

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

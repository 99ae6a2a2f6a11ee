/// ripstop help: prints the same text as --help.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "commands/command_tree.h"
#include "commands/commands.h"
#include "help/tell.h"
#include "options/guess.h"

namespace ripstop::cli {
namespace {

std::vector<std::string> names_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* each : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(each->get_name());
    return names;
}

/// Throws a usage error if a word is not a subcommand of the words before it.
std::string page_of(const CLI::App& program, const std::vector<std::string>& words) {
    const CLI::App* command = &program;
    std::string path = program.get_name();
    for (const std::string& word : words) {
        const auto is_it = [&word](const CLI::App* each) { return each->get_name() == word; };
        const std::vector<const CLI::App*> found = command->get_subcommands(is_it);
        if (found.empty())
            throw CLI::ValidationError(
                fmt::format("no command \"{}\" of {}{}", word, path, guess(word, names_of(*command))));
        command = found.front();
        path += " " + word;
    }
    return command->get_formatter()->make_help(command, path, CLI::AppFormatMode::Normal);
}

}  // namespace

void add_help(CLI::App& app) {
    auto words = std::make_shared<std::vector<std::string>>();
    CLI::App* command = app.add_subcommand("help", "Print the help of a command, like its --help");
    command->add_option("COMMAND", *words, "The command; none: the program")
        ->type_name("WORD:{" + fmt::format("{}", fmt::join(names_of(app), ",")) + "}");
    command->footer(
        "Examples:\n"
        "  ripstop help flatten\n"
        "  ripstop help design natural");
    command->callback([&app, words] { print("{}", page_of(app, *words)); });
}

}  // namespace ripstop::cli

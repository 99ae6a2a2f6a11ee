/// ripstop manual: prints the manual page, from the same declarations as --help.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "commands/command_tree.h"
#include "commands/commands.h"
#include "help/tell.h"
#include "ripstop/version.h"

namespace ripstop::cli {
namespace {

/// Escapes a text for roff: literal dashes, no line that begins with a dot, non-ASCII letters by number.
std::string roff(const std::string& text) {
    std::string result;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char c = text[at];
        if (const auto lead = static_cast<unsigned char>(c); lead >= 0xC0) {
            const int more = lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : 1;
            unsigned code = lead & (0x3FU >> more);
            for (int i = 0; i < more && at + 1 < text.size(); ++i)
                code = code << 6U | (static_cast<unsigned char>(text[++at]) & 0x3FU);
            result += fmt::format("\\[u{:04X}]", code);
        } else if (c == '-')
            result += "\\-";
        else if (c == '\\')
            result += "\\e";
        else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n'))
            result += std::string("\\&") + c;
        else
            result += c;
    }
    return result;
}

/// Keeps the line breaks of the text. In a list, which a colon opens, each word precedes its explanation.
std::string lines(const std::string& text, bool is_required) {
    const std::size_t first = std::min(text.find('\n'), text.size());
    const bool is_list = first > 0 && first < text.size() && text[first - 1] == ':';
    std::string result = roff(text.substr(0, first)) + (is_required ? " (required)" : "");
    for (std::size_t at = first + 1; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        const std::size_t gap = line.find(' '), next = line.find_first_not_of(' ', gap);
        if (is_list && next != std::string::npos)
            result += "\n.TP 9\n\\fB" + roff(line.substr(0, gap)) + "\\fR\n" + roff(line.substr(next));
        else
            result += "\n.br\n" + roff(line);
        at = end + 1;
    }
    if (!is_list) return result + "\n";
    return result.insert(result.find('\n'), "\n.RS") + "\n.RE\n";
}

std::string option_page(const OptionText& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.names)
        names.push_back(option.is_positional ? "\\fI" + roff(name) + "\\fR" : "\\fB" + roff(name) + "\\fR");
    const std::string value = option.shown_value();
    std::string page = fmt::format(".TP\n{}", fmt::join(names, ", "));
    if (!option.is_positional && !value.empty()) page += " \\fI" + roff(value) + "\\fR";
    return page + "\n" + lines(option.description, option.is_required);
}

/// Prints the arguments first, then the options by group, like --help.
std::string options_page(const CommandText& command) {
    std::string page;
    std::vector<std::string> groups;
    for (const OptionText& option : command.options) {
        if (option.is_positional)
            page += option_page(option);
        else if (std::find(groups.begin(), groups.end(), option.group) == groups.end())
            groups.push_back(option.group);
    }
    for (const std::string& group : groups) {
        page += ".PP\n.B " + roff(group) + "\n";
        for (const OptionText& option : command.options)
            if (!option.is_positional && option.group == group) page += option_page(option);
    }
    return page;
}

std::string verbatim(const std::string& text) {
    return text.empty() ? "" : ".PP\n.nf\n" + roff(text) + "\n.fi\n";
}

std::string command_page(const CommandText& command) {
    std::string page =
        fmt::format(".SS {}\n{}.\n.PP\n.B {}\n", roff(command.path), roff(command.description), roff(command.usage()));
    page += options_page(command);
    page += verbatim(command.footer);
    for (const CommandText& each : command.commands) page += command_page(each);
    return page;
}

std::string manual(const CommandText& program) {
    std::string page = fmt::format(
        ".TH RIPSTOP 1 \"\" \"ripstop {}\" \"User commands\"\n.SH NAME\nripstop \\- flat cut patterns of curved "
        "envelopes\n"
        ".SH SYNOPSIS\n.B ripstop\n.I COMMAND\n[\\fIOPTION\\fR]... [\\fIFILE\\fR]...\n.SH DESCRIPTION\n{}\n.SH "
        "COMMANDS\n",
        version, roff(program.description) + ".");
    for (const CommandText& command : program.commands) page += command_page(command);
    return page +
           ".SH EXIT STATUS\n.TP\n0\nEvery tile and seam can be made.\n.TP\n1\nSome cannot; all files are written all "
           "the same.\n.TP\n2\nThe command line is wrong.\n.TP\n3\nThe input cannot be used; the message says which "
           "file and object, what was expected and what to do.\n.TP\n4\nA fault of the program.\n"
           ".SH ENVIRONMENT\n.TP\nNO_COLOR\nNever colours.\n.TP\nCLICOLOR_FORCE\nColours even if "
           "the output is not a terminal.\n.TP\n"
           "SOURCE_DATE_EPOCH\nThe date that is written in PDF files and in DXF files of "
           "garment CAD, in seconds since 1970.\n.TP\nRIPSTOP_CAD\nThe program that reads STEP, IGES and BREP, "
           "if it is not the ripstop\\-cad beside ripstop.\n";
}

}  // namespace

void add_manual(CLI::App& app) {
    CLI::App* command = app.add_subcommand("manual", "Print the manual page");
    command->footer("Example:\n  ripstop manual | man -l -\n`make install` puts it where `man ripstop` finds it.");
    command->callback([&app] { print("{}", manual(command_text(app))); });
}

}  // namespace ripstop::cli

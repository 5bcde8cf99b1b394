#include "common/CommandLine.h"

#include <algorithm>
#include <iostream>
#include <sstream>

#include <boost/program_options.hpp>

#include "common/CommandLineError.h"

namespace mpsDem {

namespace options = boost::program_options;

namespace {

/// OpenFOAM's style: long names behind one dash, `-case dir` and no `-case=dir`, no abbreviations.
int constexpr style =
    (options::command_line_style::unix_style & ~options::command_line_style::allow_guessing & ~options::command_line_style::allow_sticky) |
    options::command_line_style::allow_long_disguise;

/// Name under which the parser keeps arguments; not an option for users.
char constexpr withoutDash[] = "arguments";

std::vector<CommandOption> allOptions(ApplicationDescription const& description)
{
    std::vector<CommandOption> all = description.options;
    if (description.usesCase) all.push_back({"case", "dir", "folder of the case, instead of the present one"});
    all.push_back({"help", "", "print this and stop"});
    all.push_back({"help-full", "", "the same"});
    std::sort(all.begin(), all.end(), [](CommandOption const& a, CommandOption const& b) { return a.name < b.name; });
    return all;
}

/// "--case" and "-case" as the user knows it: "-case".
std::string dashed(std::string const& name) { return "-" + name.substr(std::min(name.find_first_not_of('-'), name.size())); }

bool isOptionWord(std::string const& word)
{
    return word.size() > 1 && word[0] == '-' && (std::isalpha(static_cast<unsigned char>(word[1])) || word[1] == '-');
}

options::options_description knownOptions(ApplicationDescription const& description)
{
    options::options_description known;
    for (CommandOption const& option : allOptions(description))
    {
        if (option.argument.empty())
            known.add_options()(option.name.c_str(), option.help.c_str());
        else
            known.add_options()(option.name.c_str(), options::value<std::string>(), option.help.c_str());
    }
    known.add_options()(withoutDash, options::value<std::vector<std::string>>(), "");
    return known;
}

/// What to do instead of an option that OpenFOAM's applications have and this one has not; empty for others.
std::string insteadOf(std::string const& option, std::string const& application)
{
    if (option == "-parallel" || option == "-decomposeParDict") return "this version runs on one rank; start it without the option";
    if (application != "mpsDemFoam") return {};
    if (option == "-time" || option == "-latestTime" || option == "-noZero" || option == "-constant")
        return "startFrom and startTime of system/controlDict choose the state that a run goes on from; latestTime is their default";
    if (option == "-postProcess")
        return "function objects work while a run goes: name them in system/controlDict and run again; postGauges draws what was written";
    return {};
}

/// @throw CommandLineError for an unknown option and one without its value.
options::parsed_options parse(std::vector<std::string> const& words, options::options_description const& known,
                              std::string const& application)
{
    options::positional_options_description anywhere;
    anywhere.add(withoutDash, -1);
    try
    {
        return options::command_line_parser(words).options(known).positional(anywhere).style(style).run();
    }
    catch (options::unknown_option const& error)
    {
        std::string const option = dashed(error.get_option_name()), instead = insteadOf(option, application);
        throw CommandLineError("Invalid option: " + option + (instead.empty() ? "" : "\n    " + instead));
    }
    catch (options::error_with_option_name const& error)
    {
        std::string const name = error.get_option_name();
        bool const missing = dynamic_cast<options::invalid_command_line_syntax const*>(&error) != nullptr;
        throw CommandLineError(missing ? "Option " + dashed(name) + " needs a value or has one that it does not take" : error.what());
    }
}

} // namespace

CommandLine::CommandLine(ApplicationDescription description, int argc, char const* const* argv) : description_(std::move(description))
{
    std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
    command_ = description_.name;
    for (std::string const& word : words) command_ += " " + word;

    options::options_description const known = knownOptions(description_);
    options::parsed_options const parsed = parse(words, known, description_.name);
    for (auto const& option : parsed.options)
    {
        if (option.position_key >= 0)
        {
            for (std::string const& word : option.value)
            {
                if (isOptionWord(word)) throw CommandLineError("Invalid option: " + dashed(word));
                arguments_.push_back(word);
            }
            continue;
        }
        if (option.string_key == withoutDash) throw CommandLineError("Invalid option: " + dashed(option.string_key));
        std::string const value = option.value.empty() ? "" : option.value.front();
        if (isOptionWord(value)) throw CommandLineError("Option " + dashed(option.string_key) + " needs a value before " + value);
        if (!values_.emplace(option.string_key, value).second)
            throw CommandLineError("Option " + dashed(option.string_key) + " is given twice");
    }
    bool const help = found("help") || found("help-full");
    if (!help && description_.arguments.empty() && !arguments_.empty())
        throw CommandLineError("Unexpected argument: " + arguments_.front());
}

std::optional<std::string> CommandLine::value(std::string const& option) const
{
    auto const found = values_.find(option);
    if (found == values_.end()) return std::nullopt;
    return found->second;
}

std::string CommandLine::valueOr(std::string const& option, std::string const& fallback) const { return value(option).value_or(fallback); }

std::filesystem::path CommandLine::caseRoot() const { return valueOr("case", "."); }

std::string CommandLine::help() const
{
    std::ostringstream out;
    out << "\nUsage: " << description_.name << " [OPTIONS]" << (description_.arguments.empty() ? "" : " ") << description_.arguments
        << "\noptions:\n";
    for (CommandOption const& option : allOptions(description_))
    {
        std::string const left = "  -" + option.name + (option.argument.empty() ? "" : " <" + option.argument + ">");
        out << left << std::string(left.size() < 20 ? 20 - left.size() : 1, ' ') << option.help << '\n';
    }
    out << '\n' << description_.purpose << "\n\nUsing: mpsDem " MPSDEM_VERSION "\n\n";
    return out.str();
}

} // namespace mpsDem

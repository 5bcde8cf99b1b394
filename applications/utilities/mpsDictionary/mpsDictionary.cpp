#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <boost/program_options.hpp>

#include "core/Dictionary.h"

// mpsDictionary: prints what was read from a dictionary, as OpenFOAM's foamDictionary does.

namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;
using mpsDem::CaseError;
using mpsDem::ExitCode;

constexpr char const* usage = "See 'mpsDictionary -help' for usage";

po::options_description options()
{
    constexpr unsigned width = 140;
    po::options_description all("options", width);
    auto add = all.add_options();
    add("case", po::value<std::string>()->value_name("<dir>"), "folder that includes may not leave, instead of the case around the file");
    add("entry", po::value<std::string>()->value_name("<name>"), "print one entry, scoped with / or .");
    add("expand", "accepted for OpenFOAM's sake: includes and macros are always expanded");
    add("help", "print this and stop");
    add("keywords", "print the keywords of the dictionary or of the entry");
    add("strict", "read as the solver does: duplicates and code are errors");
    add("value", "print the value of the entry without its keyword");
    return all;
}

/// Options with a single dash, as OpenFOAM's.
void printHelp()
{
    std::ostringstream text;
    text << options();
    std::string help = text.str();
    for (std::size_t at = help.find(" --"); at != std::string::npos; at = help.find(" --", at)) help.replace(at, 3, " -");
    std::cout << "\nUsage: mpsDictionary [OPTIONS] <dictionary file>\n"
              << help << "\nPrints what was read from a dictionary, as foamDictionary does.\n\nUsing: mpsDem " MPSDEM_VERSION "\n\n";
}

/// Nearest folder around the file that holds `system`, else the folder of the file.
fs::path caseOf(fs::path const& file)
{
    std::error_code error;
    fs::path const folder = fs::absolute(file).lexically_normal().parent_path();
    for (fs::path around = folder; around.has_relative_path(); around = around.parent_path())
        if (fs::is_directory(around / "system", error)) return around;
    return folder;
}

/// Refuses what Boost would take for a value: the name of another option.
void requireValue(po::variables_map const& given, std::string const& option)
{
    bool const swallowed = given.count(option) != 0 && given[option].as<std::string>().starts_with("-");
    if (swallowed) throw po::error("Option -" + option + " needs a value, not " + given[option].as<std::string>());
}

po::variables_map parse(int argc, char** argv)
{
    namespace style = po::command_line_style;
    po::options_description all = options();
    all.add_options()("file", po::value<std::vector<std::string>>());
    po::positional_options_description positional;
    positional.add("file", -1);
    int const form = (style::unix_style & ~style::allow_guessing & ~style::allow_sticky) | style::allow_long_disguise;
    po::variables_map given;
    po::store(po::command_line_parser(argc, argv).options(all).positional(positional).style(form).run(), given);
    requireValue(given, "case");
    requireValue(given, "entry");
    if (given.count("help") != 0) return given;
    if (given.count("file") == 0 || given["file"].as<std::vector<std::string>>().size() != 1)
        throw po::error("One dictionary file is needed");
    return given;
}

void print(po::variables_map const& given)
{
    fs::path const file = given["file"].as<std::vector<std::string>>().front();
    // Named as the user named it: messages about the content name it relative to its case.
    if (!fs::exists(fs::status(file))) throw CaseError(ExitCode::BadInput, file.string() + ": the file is not there");
    fs::path const root = given.count("case") != 0 ? fs::path(given["case"].as<std::string>()) : caseOf(file);
    std::vector<std::string> warnings;
    auto const dictionary =
        given.count("strict") != 0 ? mpsDem::Dictionary::fromFile(file, root) : mpsDem::Dictionary::fromFileLeniently(file, root, warnings);
    for (std::string const& text : warnings) std::cerr << "--> FOAM Warning : " << text << '\n';
    std::string const entry = given.count("entry") != 0 ? given["entry"].as<std::string>() : std::string();
    if (given.count("keywords") != 0)
        for (std::string const& key : dictionary.entryKeywords(entry)) std::cout << key << '\n';
    else if (entry.empty())
        std::cout << dictionary.str();
    else if (given.count("value") == 0)
        std::cout << dictionary.entryStatement(entry);
    else
    {
        std::string const value = dictionary.entryText(entry);
        std::cout << (value.starts_with("{") ? "\n" : "") << value << '\n';
    }
    std::cout.flush();
    if (!std::cout) throw CaseError(ExitCode::InputOutput, "standard output cannot be written");
}

int report(CaseError const& error)
{
    std::string text = error.what();
    mpsDem::Location const& where = error.where();
    std::string const place = where.str();
    if (!place.empty() && text.starts_with(place + ": ")) text.erase(0, place.size() + 2);
    std::cerr << "--> FOAM FATAL IO ERROR: \n" << text << "\n\n";
    if (!place.empty())
    {
        std::cerr << "file: " << where.file << (where.entry.empty() ? "" : "." + where.entry);
        if (where.line > 0) std::cerr << " at line " << where.line;
        std::cerr << ".\n";
    }
    return static_cast<int>(error.code());
}

} // namespace

int main(int argc, char** argv)
{
    try
    {
        po::variables_map const given = parse(argc, argv);
        if (given.count("help") != 0)
            printHelp();
        else
            print(given);
        return static_cast<int>(ExitCode::Done);
    }
    catch (po::unknown_option const& error)
    {
        std::string name = error.get_option_name();
        name.erase(0, std::min(name.find_first_not_of('-'), name.size()));
        std::cerr << "Invalid option: -" << name << '\n' << usage << '\n';
    }
    catch (po::error const& error)
    {
        std::string text = error.what();
        std::size_t const dashes = text.find("--");
        if (dashes != std::string::npos) text.erase(dashes, 1);
        std::cerr << text << '\n' << usage << '\n';
    }
    catch (CaseError const& error)
    {
        return report(error);
    }
    catch (std::bad_alloc const&)
    {
        std::cerr << "--> FOAM FATAL ERROR: \nthere is not enough memory\n";
        return static_cast<int>(ExitCode::Memory);
    }
    catch (std::exception const& error)
    {
        std::cerr << "--> FOAM FATAL ERROR: \n" << error.what() << '\n';
        return static_cast<int>(ExitCode::Internal);
    }
    return static_cast<int>(ExitCode::BadInput);
}

#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "common/CommandLine.h"
#include "common/CommandLineError.h"
#include "core/Dictionary.h"

// mpsDictionary: prints what was read from a dictionary, as OpenFOAM's foamDictionary does.

namespace {

namespace fs = std::filesystem;
using mpsDem::CaseError;
using mpsDem::CommandLine;
using mpsDem::Dictionary;
using mpsDem::ExitCode;

mpsDem::ApplicationDescription description()
{
    return {.name = "mpsDictionary",
            .purpose = "Prints what was read from a dictionary, as foamDictionary does.",
            .options = {{"case", "dir", "folder that includes may not leave, instead of the case around the file"},
                        {"entry", "name", "print one entry, scoped with / or ."},
                        {"expand", "", "accepted for OpenFOAM's sake: includes and macros are always expanded"},
                        {"keywords", "", "print the keywords of the dictionary or of the entry"},
                        {"strict", "", "read as the solver does: duplicates and code are errors"},
                        {"value", "", "print the value of the entry without its keyword"}},
            .arguments = "<dictionary file>",
            .banner = false,
            .usesCase = false};
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

Dictionary read(CommandLine const& line)
{
    if (line.arguments().size() != 1) throw mpsDem::CommandLineError("One dictionary file is needed");
    fs::path const file = line.arguments().front();
    // Named as the user named it: messages about the content name it relative to its case.
    if (!fs::exists(fs::status(file))) throw CaseError(ExitCode::BadInput, file.string() + ": the file is not there");
    if (fs::is_directory(file)) throw CaseError(ExitCode::BadInput, file.string() + ": is a folder", "a dictionary in it");
    fs::path const root = line.found("case") ? fs::path(*line.value("case")) : caseOf(file);
    if (line.found("strict")) return Dictionary::fromFile(file, root);
    std::vector<std::string> warnings;
    Dictionary const dictionary = Dictionary::fromFileLeniently(file, root, warnings);
    for (std::string const& text : warnings) std::cerr << "--> FOAM Warning : " << text << '\n';
    return dictionary;
}

int print(CommandLine const& line)
{
    Dictionary const dictionary = read(line);
    std::string const entry = line.valueOr("entry", "");
    if (line.found("keywords"))
        for (std::string const& key : dictionary.entryKeywords(entry)) std::cout << key << '\n';
    else if (entry.empty())
        std::cout << dictionary.str();
    else if (!line.found("value"))
        std::cout << dictionary.entryStatement(entry);
    else
    {
        std::string const value = dictionary.entryText(entry);
        std::cout << (value.starts_with("{") ? "\n" : "") << value << '\n';
    }
    return static_cast<int>(ExitCode::Done);
}

} // namespace

int main(int argc, char** argv) { return mpsDem::runApplication(description(), argc, argv, print); }

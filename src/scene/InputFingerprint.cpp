#include "scene/InputFingerprint.h"

#include <algorithm>

#include "core/Errors.h"
#include "core/Log.h"
#include "io/Crc32c.h"

namespace mpsDem {

namespace {

std::string const separator = "; ";
std::string const absent = "-";

/// Values with all their digits, which the printed form has not.
void appendTokens(std::string& text, Dictionary const& dict)
{
    for (std::string const& key : dict.keys())
    {
        if (key.starts_with('"')) continue; // a pattern: no key to ask for
        text += key + '\n';
        if (dict.isDict(key))
            appendTokens(text, dict.subDict(key));
        else
            for (std::string const& token : dict.entryTokens(key)) text += token + '\n';
    }
}

std::string checksum(CaseFolder const& caseFolder, std::filesystem::path const& file)
{
    std::filesystem::path const path = file.is_absolute() ? file : caseFolder.root() / file;
    if (!std::filesystem::exists(path)) return absent;
    Dictionary const dict = Dictionary::fromFile(path, caseFolder.root());
    std::string text = dict.str();
    appendTokens(text, dict);
    return crcText(crc32c(text));
}

bool isChecksum(std::string const& text)
{
    return text == absent || (text.size() == 8 && text.find_first_not_of("0123456789abcdef") == std::string::npos);
}

/// The same today? A file that cannot be read today is another one.
bool unchanged(CaseFolder const& caseFolder, std::string const& file, std::string const& before)
{
    try
    {
        return checksum(caseFolder, file) == before;
    }
    catch (CaseError const&)
    {
        return false;
    }
}

} // namespace

std::string fingerprintOf(CaseFolder const& caseFolder, std::vector<std::filesystem::path> const& files)
{
    std::string text;
    for (std::filesystem::path const& file : files)
        text += (text.empty() ? "" : separator) + file.generic_string() + ' ' + checksum(caseFolder, file);
    return text;
}

std::vector<std::filesystem::path> const& runInput()
{
    static std::vector<std::filesystem::path> const files{"system/controlDict",
                                                          "system/mpsSchemes",
                                                          "system/mpsSolution",
                                                          "constant/particleProperties",
                                                          "constant/g",
                                                          "constant/transportProperties",
                                                          "constant/rigidBodyProperties",
                                                          "constant/contactProperties"};
    return files;
}

std::vector<std::string> changedSince(CaseFolder const& caseFolder, std::string const& fingerprint)
{
    std::vector<std::string> changed;
    for (std::size_t begin = 0; begin < fingerprint.size();)
    {
        std::size_t const end = std::min(fingerprint.find(separator, begin), fingerprint.size());
        std::string const entry = fingerprint.substr(begin, end - begin);
        begin = end + separator.size();
        std::size_t const blank = entry.rfind(' ');
        if (blank == std::string::npos || !isChecksum(entry.substr(blank + 1))) return {};
        std::string const file = entry.substr(0, blank);
        if (!unchanged(caseFolder, file, entry.substr(blank + 1))) changed.push_back(file);
    }
    return changed;
}

void logChangedInput(CaseFolder const& caseFolder, std::string const& fingerprint, std::string const& remedy)
{
    std::string list;
    for (std::string const& file : changedSince(caseFolder, fingerprint)) list += (list.empty() ? "" : ", ") + file;
    if (list.empty()) return;
    std::string const text = "Changed since this state was saved: " + list;
    if (!remedy.empty())
        warn(text + "\n    " + remedy);
    else
        info() << text << '\n' << std::endl;
}

} // namespace mpsDem

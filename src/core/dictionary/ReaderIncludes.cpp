#include <algorithm>
#include <cstdlib>
#include <fstream>

#include <dlfcn.h>

#include "core/dictionary/Reader.h"

#ifndef MPSDEM_ETC
#define MPSDEM_ETC ""
#endif

namespace mpsDem::dictionary {

namespace fs = std::filesystem;

namespace {

bool isBeneath(fs::path const& file, fs::path const& folder)
{
    if (folder.empty()) return false;
    fs::path const relative = file.lexically_relative(folder);
    return !relative.empty() && *relative.begin() != "..";
}

fs::path resolved(fs::path const& path)
{
    // Made absolute first: weakly_canonical leaves a relative path whose first part is not there relative.
    std::error_code error;
    fs::path const whole = path.empty() ? path : fs::absolute(path, error);
    fs::path const result = fs::weakly_canonical(whole, error);
    return error ? whole.lexically_normal() : result;
}

std::string chain(std::vector<fs::path> const& files, fs::path const& last)
{
    std::string text;
    for (fs::path const& file : files) text += file.filename().string() + " -> ";
    return text + last.filename().string();
}

} // namespace

fs::path etcFolder()
{
    char const* const set = std::getenv("MPSDEM_ETC");
    if (set && *set != '\0') return set;
    Dl_info self{};
    std::error_code error;
    if (dladdr(reinterpret_cast<void const*>(&etcFolder), &self) != 0 && self.dli_fname)
    {
        fs::path const library = fs::canonical(self.dli_fname, error);
        fs::path const installed = library.parent_path().parent_path() / "share" / "mpsDem" / "etc";
        if (!error && fs::is_directory(installed / "caseDicts", error)) return installed;
    }
    return MPSDEM_ETC;
}

/// The file as the user would name it: relative to the case where it lies beneath it.
std::string Reader::nameOf(fs::path const& path) const
{
    if (options_.caseRoot.empty()) return path.string();
    fs::path const root = resolved(options_.caseRoot);
    fs::path const file = resolved(path);
    return isBeneath(file, root) ? file.lexically_relative(root).string() : path.string();
}

std::string Reader::load(fs::path const& path, Location const& where)
{
    std::error_code error;
    std::string const name = where.file.empty() ? nameOf(path) : path.string();
    auto const refuse = [&](std::string const& what) { throw CaseError(ExitCode::InputOutput, where, name + ": " + what); };
    fs::file_status const status = fs::status(path, error);
    require(fs::exists(status), where, name + ": the file is not there");
    if (!fs::is_regular_file(status)) refuse("is no ordinary file");
    auto const size = fs::file_size(path, error);
    if (error) refuse("the file cannot be read: " + error.message());
    constexpr std::size_t perFile = 4096;
    budget_.chargeBytes(static_cast<std::size_t>(size) + perFile, where.file.empty() ? Location{name, 0, {}} : where);
    std::ifstream file(path, std::ios::binary);
    if (!file) refuse("the file cannot be opened for reading");
    std::string text(static_cast<std::size_t>(size), '\0');
    file.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (file.bad() || file.gcount() != static_cast<std::streamsize>(text.size())) refuse("reading the file failed");
    return text;
}

NodePointer Reader::readFile(fs::path const& path)
{
    std::string text = load(path, {});
    Lexer lexer(std::move(text), nameOf(path), options_.lenient);
    auto root = std::make_shared<Dictionary::Node>();
    root->file = lexer.name();
    root->line = 1;
    path_ = {root};
    folder_ = path.parent_path();
    includes_ = {resolved(path)};
    readEntries(lexer, 0);
    return root;
}

/// Replaces <case>, <constant>, <system>, <etc>, $FOAM_CASE and macros in the name of a file.
std::string Reader::expandedPath(std::string const& text, Location const& where) const
{
    std::string out = text;
    std::string const root = options_.caseRoot.string();
    std::pair<char const*, std::string> const folders[] = {
        {"<case>", root}, {"<constant>", root + "/constant"}, {"<system>", root + "/system"}, {"<etc>", etcFolder().string()}};
    for (auto const& [tag, folder] : folders)
        if (out.starts_with(tag)) out = folder + out.substr(std::string(tag).size());
    for (std::size_t begin = out.find('$'); begin != std::string::npos; begin = out.find('$', begin))
    {
        bool const braced = out.compare(begin, 2, "${") == 0;
        std::size_t const nameBegin = begin + (braced ? 2 : 1);
        std::size_t const nameEnd = std::min(out.find_first_of(braced ? "}" : "/.$-", nameBegin), out.size());
        std::string const name = out.substr(nameBegin, nameEnd - nameBegin);
        bool const closed = !name.empty() && (!braced || nameEnd < out.size());
        require(closed, where, "the file name \"" + shown(text) + "\" holds a $ without a name");
        std::string value = root;
        if (name != "FOAM_CASE")
        {
            Entry const& entry = macro(name, Dictionary::Node::Match::Exact, where);
            bool const word = !entry.dict && entry.tokens.size() == 1 && entry.tokens[0].isName();
            require(word, where, "the macro $" + shown(name) + " in a file name must stand for one word");
            value = entry.tokens[0].text;
        }
        out.replace(begin, nameEnd + (braced ? 1 : 0) - begin, value);
        begin += value.size();
        require(out.size() <= maxWordLength, where, "the file name \"" + shown(text) + "\" is longer than 1024 characters");
    }
    return out;
}

bool Reader::maySee(fs::path const& file) const
{
    fs::path const etc = etcFolder();
    return isBeneath(file, resolved(options_.caseRoot)) || (!etc.empty() && isBeneath(file, resolved(etc / "caseDicts")));
}

/// The file that an include names, or empty where there is none. One outside the case is refused before anybody looks whether it is there.
fs::path Reader::resolvedInclude(std::string const& name, bool fromEtc, Lexer const& lexer, int line) const
{
    Location const where = lexer.where(line);
    require(!options_.caseRoot.empty(), where, "#include needs a case, and this text belongs to none");
    fs::path path = expandedPath(name, where);
    if (fromEtc)
    {
        require(!etcFolder().empty(), where, "#includeEtc needs the folder etc of the installation", "set MPSDEM_ETC");
        path = etcFolder() / path;
    }
    else if (path.is_relative())
        path = folder_ / path;
    fs::path const file = resolved(path);
    require(maySee(file), where, "the include \"" + shown(name) + "\" leaves the case", "files beneath the case or beneath etc/caseDicts");
    std::error_code error;
    return fs::exists(file, error) ? file : fs::path();
}

/// @param into  Entry whose tokens take the file's tokens; null where the file's entries belong here.
void Reader::include(Lexer& lexer, Token const& directive, Entry* into)
{
    Token const token = lexer.next();
    Location const where = lexer.where(directive.line);
    require(token.isName(), where, "#" + directive.text + " needs the name of a file", "#include \"file\"");
    bool const optional = directive.text == "sinclude" || directive.text == "includeIfPresent" || directive.text == "sincludeEtc";
    bool const fromEtc = directive.text.ends_with("Etc");
    std::string name = token.text;
    while (token.kind == TokenKind::Word && lexer.peek().glued && (lexer.peek().isPunctuation('/') || lexer.peek().isName()))
        name += lexer.next().text;
    fs::path const file = resolvedInclude(name, fromEtc, lexer, directive.line);
    if (file.empty() && optional) return;
    require(!file.empty(), where, "the include \"" + shown(name) + "\" is not there");
    bool const cycle = std::find(includes_.begin(), includes_.end(), file) != includes_.end();
    require(!cycle, where, "files include each other in a cycle: " + chain(includes_, file));
    require(includes_.size() <= static_cast<std::size_t>(maxIncludeDepth), where, "includes are nested more than 16 deep");
    Lexer inner(load(file, where), nameOf(file), options_.lenient);
    fs::path const outerFolder = folder_;
    folder_ = file.parent_path();
    includes_.push_back(file);
    if (into)
    {
        for (Token next = inner.next(); next.kind != TokenKind::End; next = inner.next())
        {
            budget_.chargeTokens(1, inner.where(next.line));
            bool const plain = next.kind != TokenKind::Directive && !next.isPunctuation(';');
            if (next.kind == TokenKind::Variable)
                appendMacro(next, inner.where(next.line), into->tokens);
            else if (plain)
                into->tokens.push_back(std::move(next));
            else if (next.kind == TokenKind::Directive)
                appendDirective(inner, next, *into);
            else
                break;
        }
    }
    else
        readEntries(inner, 0);
    includes_.pop_back();
    folder_ = outerFolder;
}

} // namespace mpsDem::dictionary

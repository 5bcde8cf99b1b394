#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/dictionary/Evaluator.h"
#include "core/dictionary/Lexer.h"
#include "core/dictionary/Limits.h"
#include "core/dictionary/Node.h"

namespace mpsDem::dictionary {

struct ReadOptions
{
    std::filesystem::path caseRoot;               ///< #include stays beneath it; empty: no #include at all.
    bool lenient = false;                         ///< Accepts what OpenFOAM accepts: of duplicates the last counts.
    std::vector<std::string>* warnings = nullptr; ///< Takes what `lenient` let pass; may be null.
};

/// Folder of the installation that holds caseDicts, for #includeEtc: the environment's MPSDEM_ETC, else ../share/mpsDem/etc seen from the
/// folder of this library (an installed prefix, wherever it lies), else that of the source tree; may be empty.
std::filesystem::path etcFolder();

/// Reads one case file with its includes into a tree of entries: the parser, the directives (#...) and the macros ($...).
///
/// The grammar is that of OpenFOAM v1912. On purpose it departs from it in this: an undefined macro is an error everywhere; macros never
/// stand for variables of the environment (but $FOAM_CASE in the name of an include); #eval inserts macros with all their digits and knows
/// scalars only; #calc, #codeStream and #includeFunc are refused; lists without a keyword (mesh files) are no dictionaries; includes stay
/// beneath the case or etc/caseDicts. A FoamFile header of an included file is dropped, as there.
class Reader
{
public:
    explicit Reader(ReadOptions options) : options_(std::move(options)) {}

    NodePointer readFile(std::filesystem::path const& path);
    NodePointer readText(std::string const& text, std::string const& name);

private:
    /// What happens to a keyword that is there already.
    enum class InputMode
    {
        Default,
        Merge,
        Overwrite,
        Protect,
        Warn,
        Error
    };
    /// An #if whose branch is being read.
    struct OpenIf
    {
        int line;
        bool sawElse;
    };
    using Ifs = std::vector<OpenIf>;

    // Parser (Reader.cpp)
    void readEntries(Lexer& lexer, int braceLine);
    void readEntry(Lexer& lexer, Token const& key);
    void readTokens(Lexer& lexer, Entry& entry);
    void readDict(Lexer& lexer, Entry& entry);
    void add(Entry entry);
    void replace(Entry& old, Entry entry);
    void checkForbidden(Entry const& entry) const;
    void checkLists(Entry const& entry) const;

    // Directives (ReaderDirectives.cpp, ReaderIncludes.cpp)
    void runDirective(Lexer& lexer, Token const& directive, Ifs& ifs);
    void runConditional(Lexer& lexer, Token const& directive, Ifs& ifs);
    void setInputMode(Lexer& lexer, Token const& directive);
    void removeEntries(Lexer& lexer, Token const& directive);
    void include(Lexer& lexer, Token const& directive, Entry* into);
    void appendDirective(Lexer& lexer, Token const& directive, Entry& entry);
    [[nodiscard]] bool condition(Lexer& lexer, Token const& directive);
    [[nodiscard]] Tokens conditionValue(Lexer& lexer, Token const& directive);
    void skipBranch(Lexer& lexer, int line, Ifs& ifs);
    [[nodiscard]] Token evaluate(Lexer& lexer, Token const& directive);
    [[nodiscard]] std::string expandedPath(std::string const& text, Location const& where) const;
    [[nodiscard]] std::filesystem::path resolvedInclude(std::string const& name, bool fromEtc, Lexer const& lexer, int line) const;
    [[nodiscard]] bool maySee(std::filesystem::path const& file) const;
    [[nodiscard]] std::string nameOf(std::filesystem::path const& path) const;
    std::string load(std::filesystem::path const& path, Location const& where);
    [[noreturn]] void refuseDirective(Lexer const& lexer, Token const& directive) const;

    // Macros (ReaderMacros.cpp)
    [[nodiscard]] Entry const* findMacro(std::string const& name, Dictionary::Node::Match match) const;
    [[nodiscard]] Entry const& macro(std::string const& name, Dictionary::Node::Match match, Location const& where) const;
    [[nodiscard]] std::vector<std::string> visibleNames() const;
    [[nodiscard]] Tokens const& macroTokens(std::string const& name, Location const& where);
    void appendMacro(Token const& variable, Location const& where, Tokens& tokens);
    void mergeMacro(Token const& variable, Location const& where);
    void mergeNode(Dictionary::Node& target, Dictionary::Node const& source, std::size_t depth, bool asDefaults, Location const& where);
    Entry copied(Entry const& source, Dictionary::Node const& parent, std::size_t depth, bool asDefaults, Location const& where);
    void settle(Dictionary::Node const& node, Entry& old, Entry entry);

    [[nodiscard]] Dictionary::Node& here() const { return *path_.back(); }
    void warn(Location const& where, std::string const& text) const;

    ReadOptions options_;
    Budget budget_;
    Evaluator evaluator_;
    InputMode mode_ = InputMode::Default;
    std::vector<NodePointer> path_;               ///< Dictionaries from the root to the one being read.
    std::vector<std::filesystem::path> includes_; ///< Files being read, outermost first.
    std::filesystem::path folder_;                ///< Of the file being read.
    Tokens scratch_;
};

/// Appends the tokens of a dictionary's entries, as `$dict` amid other tokens gives them.
void flatten(Dictionary::Node const& node, Tokens& tokens);

/// The dictionaries of a list `( name {...} {...} )`. @throw CaseError where an item is no dictionary.
DictItems dictItems(Entry const& entry, std::string const& scopedName);

} // namespace mpsDem::dictionary

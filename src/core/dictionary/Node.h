#pragma once

#include <list>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/Dictionary.h"
#include "core/dictionary/Token.h"

namespace mpsDem::dictionary {

/// Regular expression of a quoted keyword: POSIX extended, as OpenFOAM's, (?i) in front for any case; the whole keyword must match.
class Pattern
{
public:
    /// @throw CaseError where the text is no regular expression or one whose size explodes.
    Pattern(std::string const& text, Location const& where);

    [[nodiscard]] bool matches(std::string const& word) const;

private:
    std::shared_ptr<void> compiled_;
};

using NodePointer = std::shared_ptr<Dictionary::Node>;
using DictItems = std::vector<std::pair<std::string, NodePointer>>;

/// One keyword and what stands behind it: tokens or a dictionary.
struct Entry
{
    std::string key;
    bool quoted = false;            ///< The keyword stood in quotes.
    bool inherited = false;         ///< Came through $dict; and is thus a default that a later statement may replace.
    std::unique_ptr<Pattern> match; ///< Only where the quoted keyword holds characters of a regular expression.
    NodePointer dict;               ///< Null for a plain entry.
    Tokens tokens;
    int line = 0;
    mutable bool taken = false; ///< A macro took its value, or one from below it: it may be a variable of the file.
    int includeDepth = 0;       ///< Files around the one that states it; a statement further out may replace it.
    std::shared_ptr<std::string const> file;
    DictItems items; ///< Dictionaries of a list, made when they are asked for.
    bool itemsMade = false;
};

} // namespace mpsDem::dictionary

namespace mpsDem {

/// Entries of one dictionary and the record of what was asked of it.
struct Dictionary::Node
{
    /// Whether a quoted keyword stands for all that it matches or for itself alone.
    enum class Match
    {
        Exact,
        Pattern
    };
    using Entries = std::list<dictionary::Entry>;

    std::string scopedName;
    std::shared_ptr<std::string const> file;
    int line = 0;
    Entries entries;                                ///< In the order of the file.
    std::map<std::string, Entries::iterator> exact; ///< By keyword, patterns by their text.
    std::vector<Entries::iterator> patterns;        ///< In the order of the file.
    std::set<std::string> asked;
    std::set<std::string> ignored;

    /// The entry of exactly this keyword, or null.
    [[nodiscard]] dictionary::Entry* findExact(std::string const& key) const;
    /// The entry of exactly this keyword, else the last whose pattern matches, else null.
    [[nodiscard]] dictionary::Entry* find(std::string const& key) const;
    /// The same through dictionaries of dictionaries, separated by `separator`; keywords may hold the separator; the last part
    /// may match a pattern. Null where absent.
    [[nodiscard]] dictionary::Entry* findScoped(std::string const& path, char separator, Match match) const;

    /// Appends an entry whose keyword must be new.
    dictionary::Entry& append(dictionary::Entry entry);
    void remove(std::string const& key);

    [[nodiscard]] std::string scoped(std::string const& key) const { return scopedName.empty() ? key : scopedName + "." + key; }
    [[nodiscard]] Location where(dictionary::Entry const& entry) const { return {*entry.file, entry.line, scoped(entry.key)}; }
    [[nodiscard]] Location where() const { return {file ? *file : std::string(), line, scopedName}; }
    [[nodiscard]] std::vector<std::string> keys() const;
};

} // namespace mpsDem

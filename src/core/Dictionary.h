#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/Errors.h"
#include "core/Types.h"

namespace mpsDem {

/// A dictionary in OpenFOAM's grammar, read from a file of the case.
///
/// Values are parsed when they are asked for, with the type asked for; excess tokens are an error. Every `get`, `find` and
/// `subDict` records the keyword asked for, so the set of keywords that the program knows is the set that it asked for:
/// `requireAllRead()` refuses every entry that nobody asked for and names the nearest one that somebody did.
/// Cheap to copy: copies share the entries and the record of what was asked.
///
/// T in get<T>: bool, int, std::int64_t, Real, std::string (word or quoted string), Vector, Tensor (9 numbers), and
/// std::vector of Real, int, std::string, Vector, std::vector<int>.
class Dictionary
{
public:
    /// An empty dictionary without a file.
    Dictionary();

    /// Reads a case file. @param path file. @param caseRoot folder that #include may not leave (with etc/caseDicts); messages name the file relative to it.
    /// @throw CaseError BadInput with file:line for what the grammar does not allow, or where it is not there; InputOutput where it can't be read.
    static Dictionary fromFile(std::filesystem::path const& path, std::filesystem::path const& caseRoot);

    /// The same, but as careless as OpenFOAM's own reader where that harms nothing: of duplicate entries the last counts, `0x10` are two
    /// tokens, and libs, coded types and systemCall pass as plain data. Each place with duplicates or such names goes to `warnings`. For tools
    /// that only show dictionaries.
    static Dictionary fromFileLeniently(std::filesystem::path const& path, std::filesystem::path const& caseRoot,
                                        std::vector<std::string>& warnings);

    /// The same as fromFile from text without includes; `name` stands for the file in messages. For tests.
    static Dictionary fromText(std::string const& text, std::string const& name = "text");

    /// Refuses a file whose FoamFile header is missing or names another class than `dictionary` (or the one given).
    void requireHeader(std::string const& expectedClass = "dictionary") const;

    /// Whether there is an entry for the keyword, exact or by a pattern; records the keyword as known.
    [[nodiscard]] bool found(std::string const& key) const;
    /// Whether the entry is a dictionary; false where it is absent.
    [[nodiscard]] bool isDict(std::string const& key) const;

    template <class T>
    [[nodiscard]] T get(std::string const& key) const;

    template <class T>
    [[nodiscard]] T getOr(std::string const& key, T const& fallback) const
    {
        return found(key) ? get<T>(key) : fallback;
    }

    /// As get<Real>, but accepts `1e-6`, `[0 2 -1 0 0 0 0] 1e-6` and `nu [0 2 -1 0 0 0 0] 1e-6`; given dimensions must equal `dimensions` (mass length time ... : 7 exponents).
    [[nodiscard]] Real getDimensioned(std::string const& key, std::vector<int> const& dimensions) const;
    /// The same for a vector, as in constant/g.
    [[nodiscard]] Vector getDimensionedVector(std::string const& key, std::vector<int> const& dimensions) const;

    /// A number that must lie in [lowest, highest] (checked, with the range in the message).
    [[nodiscard]] Real getInRange(std::string const& key, Real lowest, Real highest) const;
    [[nodiscard]] Real getInRangeOr(std::string const& key, Real fallback, Real lowest, Real highest) const;

    /// A word that must be one of `known`; an unknown one is refused with the known ones and the nearest. `plural` names them in the message.
    [[nodiscard]] std::string getWord(std::string const& key, std::vector<std::string> const& known, std::string const& plural) const;
    [[nodiscard]] std::string getWordOr(std::string const& key, std::string const& fallback, std::vector<std::string> const& known,
                                        std::string const& plural) const;

    /// @throw CaseError where it is missing or no dictionary.
    [[nodiscard]] Dictionary subDict(std::string const& key) const;
    /// The sub-dictionary, or an empty one that still records what is asked of it.
    [[nodiscard]] Dictionary subDictOrEmpty(std::string const& key) const;

    /// A list of dictionaries or of `name { ... }` items, as setParticlesDict's `regions ( boxToParticle {...} ... )`:
    /// name (may be empty) and dictionary of each item, in order.
    [[nodiscard]] std::vector<std::pair<std::string, Dictionary>> getDictList(std::string const& key) const;

    /// Keywords in the order of the file (quoted patterns included), without FoamFile.
    [[nodiscard]] std::vector<std::string> keys() const;
    /// Keywords whose entry is a dictionary, in the order of the file.
    [[nodiscard]] std::vector<std::string> dictKeys() const;

    /// Marks a keyword as known without reading it (an entry of an effect that is off).
    void ignore(std::string const& key) const;

    /// Refuses the first entry that looks like a misspelling of one of the keywords, none of which is there: before a message that one of several
    /// entries is needed.
    void refuseMisspelt(std::vector<std::string> const& keys) const;

    /// Place of an entry, or of the dictionary itself for an empty or absent key.
    [[nodiscard]] Location where(std::string const& key = {}) const;
    /// Name of this dictionary as scoped keyword, e.g. "solvers.p".
    [[nodiscard]] std::string const& name() const;

    /// Throws for the first entry, here or below, that nobody asked for. An entry that a macro (`$name`, also in #eval) took, and a dictionary
    /// that holds one, may be there as variables of the file.
    void requireAllRead() const;

    /// OpenFOAM's own output form, as `foamDictionary` of v1912 prints it with all macros and includes expanded: 4 blanks of indentation, values in
    /// column 16, lists in one line with single blanks `( 1 2 3 )`, numbers with up to 6 significant digits, a blank line between entries.
    [[nodiscard]] std::string str() const;
    /// One entry's value as printed by `foamDictionary -entry a/b -value`; scoped with / or . ; @throw CaseError where absent.
    [[nodiscard]] std::string entryText(std::string const& scopedKey) const;

    /// The whole entry as printed by `foamDictionary -entry a/b`.
    [[nodiscard]] std::string entryStatement(std::string const& scopedKey) const;
    /// Keywords of this dictionary (empty key) or of a scoped one as printed by `foamDictionary -keywords`: patterns in quotes, FoamFile included.
    [[nodiscard]] std::vector<std::string> entryKeywords(std::string const& scopedKey = {}) const;

    /// Words, numbers and brackets of a plain entry, each as its own text, numbers with all digits. For entries whose form is free, as
    /// `box (0 0 0) (2 1 0);`. @throw CaseError where it is missing or a dictionary.
    [[nodiscard]] std::vector<std::string> entryTokens(std::string const& key) const;

    struct Node;

private:
    explicit Dictionary(std::shared_ptr<Node> node);

    std::shared_ptr<Node> node_;
};

} // namespace mpsDem

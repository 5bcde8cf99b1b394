#pragma once

#include <stdexcept>
#include <string>

namespace mpsDem {

/// Exit codes of every application (README, section "Exit codes").
enum class ExitCode : int
{
    Done = 0,
    BadInput = 2,
    Stopped = 3,
    Locked = 4,
    InputOutput = 5,
    NotFinite = 6,
    Solver = 7,
    Memory = 8,
    Internal = 9
};

/// Place in a file of the case: what a message points at.
struct Location
{
    std::string file;  ///< Path as the user would name it, relative to the case where possible.
    int line = 0;      ///< First line is 1; 0 where no line is known.
    std::string entry; ///< Scoped keyword, e.g. "solvers.p.tolerance"; may be empty.

    /// "constant/contactProperties:14" or the file alone; empty without a file.
    [[nodiscard]] std::string str() const;
};

/// What went wrong, where, and what is allowed or to be done. Thrown for everything that a user can mend; caught once, in `runApplication`.
class CaseError : public std::runtime_error
{
public:
    CaseError(ExitCode code, Location where, std::string const& what, std::string const& allowed = {});
    CaseError(ExitCode code, std::string const& what, std::string const& allowed = {});

    [[nodiscard]] ExitCode code() const { return code_; }
    [[nodiscard]] Location const& where() const { return where_; }

private:
    ExitCode code_;
    Location where_;
};

/// Throws a CaseError (BadInput) unless the condition holds: for what a user did.
inline void require(bool condition, Location const& where, std::string const& what, std::string const& allowed = {})
{
    if (!condition) throw CaseError(ExitCode::BadInput, where, what, allowed);
}

/// Throws std::logic_error unless the condition holds: for what we did. Not for use inside sweeps.
inline void expect(bool condition, char const* what)
{
    if (!condition) throw std::logic_error(what);
}

/// A number for a message: up to so many significant digits, no more than it needs ("0.02", "1e-06").
std::string shortNumber(double value, int digits = 6);

/// The word of `known` nearest to `word`, or empty where none is near (wordDistance above 1 + length/3).
template <class Range>
std::string nearestWord(std::string const& word, Range const& known);

/// Number of single-character edits (insert, delete, replace, swap of neighbours) from a to b.
int editDistance(std::string const& a, std::string const& b);

/// How far a word is from one that it may be meant for: their edit distance with capitals as small letters, 1 at least where they differ; 2 at
/// most where one of them begins with the other (three characters or more).
int wordDistance(std::string const& a, std::string const& b);

/// Formats "known <plural>: a, b, c   (did you mean b?)" for the second line of a message.
template <class Range>
std::string knownWords(std::string const& plural, std::string const& word, Range const& known)
{
    std::string text = "known " + plural + ":";
    char const* separator = " ";
    for (auto const& name : known)
    {
        text += separator + std::string(name);
        separator = ", ";
    }
    std::string const near = nearestWord(word, known);
    if (!near.empty()) text += "   (did you mean " + near + "?)";
    return text;
}

template <class Range>
std::string nearestWord(std::string const& word, Range const& known)
{
    std::string best;
    if (word.empty()) return best;
    int bestDistance = 2 + static_cast<int>(word.size()) / 3;
    for (auto const& name : known)
    {
        int const distance = wordDistance(word, name);
        if (distance < bestDistance)
        {
            bestDistance = distance;
            best = name;
        }
    }
    return best;
}

} // namespace mpsDem

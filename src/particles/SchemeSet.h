#pragma once

#include "core/Dictionary.h"

namespace mpsDem {

/// Which defaults the entries of system/mpsSchemes start from; every entry can be set on its own.
enum class SchemeSet
{
    Standard, ///< Hybrid corrected gradient, relaxation time, shifting, cone surface test.
    Waves,    ///< Standard, with sources, damping and collisions for waves and the slides that make them.
    Paper     ///< The paper's own equations read literally.
};

[[nodiscard]] inline char const* nameOf(SchemeSet set)
{
    return set == SchemeSet::Paper ? "paper" : set == SchemeSet::Waves ? "waves" : "standard";
}

/// Reads `schemeSet standard|waves|paper;` (default standard).
inline SchemeSet readSchemeSet(Dictionary const& mpsSchemes)
{
    std::string const word = mpsSchemes.getWordOr("schemeSet", "standard", {"standard", "waves", "paper"}, "scheme sets");
    return word == "paper" ? SchemeSet::Paper : word == "waves" ? SchemeSet::Waves : SchemeSet::Standard;
}

} // namespace mpsDem

#pragma once

#include "core/Dictionary.h"

namespace mpsDem {

/// Which defaults the entries of system/mpsSchemes start from; every entry can be set on its own.
enum class SchemeSet
{
    Standard, ///< Hybrid corrected gradient, relaxation time, shifting, cone surface test.
    Paper     ///< The paper's own equations read literally.
};

/// Reads `schemeSet standard|paper;` (default standard).
inline SchemeSet readSchemeSet(Dictionary const& mpsSchemes)
{
    std::string const word = mpsSchemes.getWordOr("schemeSet", "standard", {"standard", "paper"}, "scheme sets");
    return word == "paper" ? SchemeSet::Paper : SchemeSet::Standard;
}

} // namespace mpsDem

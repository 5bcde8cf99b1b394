#include "core/dictionary/Missing.h"

#include <algorithm>

namespace mpsDem::dictionary {

Entry const* misspelt(Dictionary::Node const& node, std::string const& key)
{
    constexpr std::size_t longest = 100;
    Entry const* best = nullptr;
    int bestDistance = static_cast<int>(key.size());
    for (Entry const& entry : node.entries)
    {
        bool const free = !entry.match && node.asked.count(entry.key) == 0 && node.ignored.count(entry.key) == 0;
        if (!free || entry.key == "FoamFile" || std::max(entry.key.size(), key.size()) > longest) continue;
        auto const length = static_cast<int>(std::min(entry.key.size(), key.size()));
        int const edits = editDistance(entry.key, key);
        bool const near = (edits == 1 && length >= 3) || 4 * edits <= length;
        if (!near || edits >= bestDistance) continue;
        best = &entry;
        bestDistance = edits;
    }
    return best;
}

void refuseMissing(Dictionary::Node const& node, std::string const& key, std::string const& what, std::string const& allowed)
{
    std::string const missing = "the " + what + " \"" + key + "\" is missing";
    if (Entry const* const entry = misspelt(node, key))
        throw CaseError(ExitCode::BadInput, node.where(*entry), "\"" + entry->key + "\" looks like a misspelling: " + missing,
                        "did you mean " + key + "?");
    Location place = node.where();
    place.entry = node.scoped(key);
    throw CaseError(ExitCode::BadInput, place, missing, allowed);
}

} // namespace mpsDem::dictionary

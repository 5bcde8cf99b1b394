#include <algorithm>

#include "core/dictionary/Reader.h"

namespace mpsDem::dictionary {

namespace {

Token punctuation(char const* text, int line)
{
    Token token;
    token.kind = TokenKind::Punctuation;
    token.text = text;
    token.line = line;
    return token;
}

} // namespace

void flatten(Dictionary::Node const& node, Tokens& tokens)
{
    for (Entry const& entry : node.entries)
    {
        Token key;
        key.kind = entry.quoted ? TokenKind::Text : TokenKind::Word;
        key.text = entry.key;
        key.line = entry.line;
        tokens.push_back(std::move(key));
        if (entry.dict)
        {
            tokens.push_back(punctuation("{", entry.line));
            flatten(*entry.dict, tokens);
            tokens.push_back(punctuation("}", entry.line));
        }
        else
        {
            tokens.insert(tokens.end(), entry.tokens.begin(), entry.tokens.end());
            tokens.push_back(punctuation(";", entry.line));
        }
    }
}

/// `name` is sought here and then further out; `:a.b` and `/a/b` begin at the root, `.x` here, each further dot one level out;
/// `a.b` and `a/b` go down, `../a` goes up. As in OpenFOAM, patterns count for merged dictionaries only, not for values.
Entry const* Reader::findMacro(std::string const& name, Dictionary::Node::Match match) const
{
    char const separator = name.find('/') == std::string::npos ? '.' : '/';
    if (name[0] == ':' || name[0] == '^' || name[0] == '/') return path_.front()->findScoped(name.substr(1), separator, match);
    std::size_t level = path_.size() - 1;
    std::string rest = name;
    if (separator == '/' && name.starts_with(".."))
    {
        while (rest.starts_with("../"))
        {
            if (level-- == 0) return nullptr;
            rest.erase(0, 3);
        }
        return path_[level]->findScoped(rest, separator, match);
    }
    if (name[0] == '.')
    {
        std::size_t const dots = std::min(name.find_first_not_of('.'), name.size());
        if (dots > path_.size()) return nullptr;
        return path_[level - (dots - 1)]->findScoped(name.substr(dots), '.', match);
    }
    for (auto node = path_.rbegin(); node != path_.rend(); ++node)
        if (Entry const* const entry = (*node)->findScoped(name, separator, match)) return entry;
    return nullptr;
}

std::vector<std::string> Reader::visibleNames() const
{
    std::vector<std::string> names;
    for (auto const& node : path_)
    {
        if (node->entries.size() > maxWordLength) continue;
        for (Entry const& entry : node->entries) names.push_back(entry.key);
    }
    return names;
}

Entry const& Reader::macro(std::string const& name, Dictionary::Node::Match match, Location const& where) const
{
    Entry const* const entry = findMacro(name, match);
    if (entry)
    {
        entry->taken = true;
        return *entry;
    }
    std::string allowed = "macros stand for entries further up in the same file";
    std::string const near = nearestName(name, visibleNames());
    if (!near.empty()) allowed += "   (did you mean $" + near + "?)";
    throw CaseError(ExitCode::BadInput, where, "the macro $" + shown(name) + " stands for no entry", allowed);
}

Tokens const& Reader::macroTokens(std::string const& name, Location const& where)
{
    Entry const& entry = macro(name, Dictionary::Node::Match::Exact, where);
    if (!entry.dict) return entry.tokens;
    scratch_.clear();
    flatten(*entry.dict, scratch_);
    return scratch_;
}

void Reader::appendMacro(Token const& variable, Location const& where, Tokens& tokens)
{
    Tokens const& found = macroTokens(variable.text, where);
    std::size_t bytes = 0;
    for (Token const& token : found) bytes += token.text.size() + sizeof(Real);
    budget_.chargeTokens(found.size(), where);
    budget_.chargeBytes(bytes, where);
    for (Token const& token : found)
    {
        tokens.push_back(token);
        tokens.back().line = variable.line;
        tokens.back().glued = false;
    }
}

void Reader::mergeMacro(Token const& variable, Location const& where)
{
    Entry const& entry = macro(variable.text, Dictionary::Node::Match::Pattern, where);
    require(entry.dict != nullptr, where,
            "the macro $" + shown(variable.text) + " stands where a keyword is expected, but is no dictionary",
            "`$dict;` merges a dictionary, `key $name;` takes a value");
    NodePointer const source = entry.dict;
    mergeNode(here(), *source, path_.size(), true, where);
}

/// @param depth  Level of the target: 1 for the root. @param asDefaults  What comes in may be replaced by later statements.
void Reader::mergeNode(Dictionary::Node& target, Dictionary::Node const& source, std::size_t depth, bool asDefaults, Location const& where)
{
    for (Entry const& entry : source.entries)
    {
        Entry* const old = target.findExact(entry.key);
        bool const kept = old && (mode_ == InputMode::Protect || mode_ == InputMode::Warn);
        if (kept) continue;
        if (old && old->dict && entry.dict && mode_ != InputMode::Overwrite)
            mergeNode(*old->dict, *entry.dict, depth + 1, asDefaults, where);
        else if (old && mode_ == InputMode::Overwrite)
            replace(*old, copied(entry, target, depth, asDefaults, where));
        else if (old)
            settle(target, *old, copied(entry, target, depth, asDefaults, where));
        else
            target.append(copied(entry, target, depth, asDefaults, where));
    }
}

Entry Reader::copied(Entry const& source, Dictionary::Node const& parent, std::size_t depth, bool asDefaults, Location const& where)
{
    require(depth <= static_cast<std::size_t>(maxNesting), where, "macros nest dictionaries more than 64 deep");
    budget_.chargeEntry(where);
    budget_.chargeTokens(source.tokens.size() + 1, where);
    std::size_t bytes = source.key.size() + 1;
    for (Token const& token : source.tokens) bytes += token.text.size() + sizeof(Real);
    budget_.chargeBytes(bytes, where);
    Entry copy;
    copy.key = source.key;
    copy.quoted = source.quoted;
    copy.inherited = asDefaults || source.inherited;
    copy.includeDepth = source.includeDepth;
    copy.line = source.line;
    copy.file = source.file;
    copy.tokens = source.tokens;
    if (source.match) copy.match = std::make_unique<Pattern>(*source.match);
    if (source.dict)
    {
        copy.dict = std::make_shared<Dictionary::Node>();
        copy.dict->scopedName = parent.scoped(source.key);
        copy.dict->file = source.dict->file;
        copy.dict->line = source.dict->line;
        mergeNode(*copy.dict, *source.dict, depth + 1, asDefaults, where);
    }
    return copy;
}

} // namespace mpsDem::dictionary

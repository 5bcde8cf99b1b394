#include "core/dictionary/Reader.h"

#include <algorithm>

#include "core/dictionary/Printer.h"

namespace mpsDem::dictionary {

namespace {

NodePointer emptyNode(std::string scopedName, std::shared_ptr<std::string const> file, int line)
{
    auto node = std::make_shared<Dictionary::Node>();
    node->scopedName = std::move(scopedName);
    node->file = std::move(file);
    node->line = line;
    return node;
}

/// Brackets that are open while the tokens of an entry are read.
class Brackets
{
public:
    void follow(Token const& token, Lexer const& lexer)
    {
        if (token.opens())
        {
            open_.push_back(token);
            require(open_.size() <= static_cast<std::size_t>(maxNesting), lexer.where(token.line), "lists are nested more than 64 deep");
        }
        if (!token.closes()) return;
        require(!open_.empty(), lexer.where(token.line), "'" + token.text + "' closes nothing: is a ';' missing before it?");
        bool const partner = open_.back().isPunctuation('(') == token.isPunctuation(')');
        require(partner, lexer.where(token.line),
                "'" + token.text + "' cannot close the '" + open_.back().text + "' of line " + std::to_string(open_.back().line));
        open_.pop_back();
    }

    [[nodiscard]] bool empty() const { return open_.empty(); }
    [[nodiscard]] Token const& innermost() const { return open_.back(); }

private:
    Tokens open_;
};

/// Refuses an entry that runs into the end of its dictionary or of the file.
void refuseEarlyEnd(Token const& token, Entry const& entry, Brackets const& brackets, Location const& where)
{
    bool const fileEnds = token.kind == TokenKind::End;
    bool const dictEnds = token.isPunctuation('}') && brackets.empty();
    if (!fileEnds && !dictEnds) return;
    std::string const key = "\"" + shown(entry.key) + "\"";
    if (!brackets.empty())
    {
        Token const& open = brackets.innermost();
        require(false, {where.file, open.line, where.entry}, "the '" + open.text + "' that begins here is not closed (entry " + key + ")");
    }
    std::string const before = dictEnds ? " before the '}' of line " + std::to_string(token.line) : std::string();
    require(false, where, "the entry " + key + " that begins here has no ';'" + before);
}

} // namespace

NodePointer Reader::readText(std::string const& text, std::string const& name)
{
    budget_.chargeBytes(text.size(), {name, 0, {}});
    Lexer lexer(text, name, options_.lenient);
    path_ = {emptyNode({}, lexer.name(), 1)};
    readEntries(lexer, 0);
    return path_.front();
}

/// Reads to the end of the file (braceLine 0) or to the brace that closes the one of line `braceLine`.
void Reader::readEntries(Lexer& lexer, int braceLine)
{
    Ifs ifs;
    for (;;)
    {
        Token const token = lexer.next();
        budget_.chargeTokens(1, lexer.where(token.line));
        bool const ends = token.kind == TokenKind::End || token.isPunctuation('}');
        if (ends)
        {
            require(ifs.empty(), lexer.where(ifs.empty() ? 0 : ifs.back().line), "the #if that begins here has no #endif");
            bool const fits = (token.kind == TokenKind::End) == (braceLine == 0);
            if (fits) return;
            require(braceLine != 0, lexer.where(token.line), "'}' closes nothing");
            require(false, lexer.where(braceLine), "the '{' that begins here is not closed by '}'");
        }
        else if (token.kind == TokenKind::Directive)
            runDirective(lexer, token, ifs);
        else if (token.kind == TokenKind::Variable)
            mergeMacro(token, lexer.where(token.line));
        else if (token.isName())
            readEntry(lexer, token);
        else if (!token.isPunctuation(';'))
        {
            std::string const text = tokensText({token});
            require(false, lexer.where(token.line), "a keyword is expected, not " + shown(text), "is a ';' or a '{' misplaced before it?");
        }
    }
}

void Reader::readEntry(Lexer& lexer, Token const& key)
{
    Entry entry;
    entry.key = key.text;
    entry.quoted = key.kind == TokenKind::Text;
    entry.line = key.line;
    entry.file = lexer.name();
    Location const where = lexer.where(key.line);
    budget_.chargeEntry(where);
    require(key.text.size() <= maxWordLength, where, "the keyword \"" + shown(key.text) + "\" is longer than 1024 characters");
    bool const pattern = entry.quoted && key.text.find_first_of(".*+?|()[]{}^$\\") != std::string::npos;
    if (pattern)
    {
        budget_.chargePattern(where);
        entry.match = std::make_unique<Pattern>(entry.key, where);
    }
    if (lexer.peek().isPunctuation('{'))
        readDict(lexer, entry);
    else
        readTokens(lexer, entry);
    checkForbidden(entry);
    bool const headerOfInclude = includes_.size() > 1 && entry.key == "FoamFile" && entry.dict;
    if (!headerOfInclude) add(std::move(entry));
}

void Reader::readDict(Lexer& lexer, Entry& entry)
{
    int const line = lexer.next().line;
    require(path_.size() < static_cast<std::size_t>(maxNesting), lexer.where(line), "dictionaries are nested more than 64 deep");
    entry.dict = emptyNode(here().scoped(entry.key), lexer.name(), entry.line);
    path_.push_back(entry.dict);
    readEntries(lexer, line);
    path_.pop_back();
}

void Reader::readTokens(Lexer& lexer, Entry& entry)
{
    Location where{*lexer.name(), entry.line, here().scoped(entry.key)};
    Brackets brackets;
    for (;;)
    {
        Token token = lexer.next();
        budget_.chargeTokens(1, where);
        if (token.isPunctuation(';') && brackets.empty()) break;
        refuseEarlyEnd(token, entry, brackets, where);
        brackets.follow(token, lexer);
        bool const counts = token.kind == TokenKind::Integer && lexer.peek().glued && lexer.peek().opens();
        bool const plausible = !counts || lexer.peek().isPunctuation('{') || token.number <= static_cast<Real>(lexer.bytesLeft());
        require(plausible, lexer.where(token.line), "a list of " + numberText(token) + " values is longer than the file");
        if (token.kind == TokenKind::Variable)
            appendMacro(token, lexer.where(token.line), entry.tokens);
        else if (token.kind == TokenKind::Directive)
            appendDirective(lexer, token, entry);
        else
            entry.tokens.push_back(std::move(token));
    }
    checkLists(entry);
}

void Reader::add(Entry entry)
{
    Dictionary::Node& node = here();
    entry.includeDepth = static_cast<int>(includes_.size());
    Entry* const old = node.findExact(entry.key);
    if (!old)
    {
        node.append(std::move(entry));
        return;
    }
    Location const where = node.where(entry);
    std::string const twice = "the entry \"" + shown(entry.key) + "\" is there already (" + node.where(*old).str() + ")";
    switch (mode_)
    {
    case InputMode::Protect:
        return;
    case InputMode::Warn:
        warn(where, twice + "; the first one counts");
        return;
    case InputMode::Error:
        require(false, where, twice);
        return;
    case InputMode::Overwrite:
        replace(*old, std::move(entry));
        return;
    case InputMode::Merge:
    case InputMode::Default:
        break;
    }
    if (old->dict && entry.dict)
        mergeNode(*old->dict, *entry.dict, path_.size() + 1, false, where);
    else
        settle(node, *old, std::move(entry));
}

/// Decides between two plain entries of one keyword: the later one counts where that is surely meant, else both are refused.
void Reader::settle(Dictionary::Node const& node, Entry& old, Entry entry)
{
    bool const meant = mode_ == InputMode::Merge || old.inherited || old.includeDepth > entry.includeDepth;
    Location const where = node.where(entry);
    std::string const twice = "the entry \"" + shown(entry.key) + "\" is there already (" + node.where(old).str() + ")";
    require(meant || options_.lenient, where, twice, "one of each; or #inputMode merge before the second");
    if (!meant) warn(where, twice + "; the last one counts");
    replace(old, std::move(entry));
}

/// The new entry takes the old one's place in the order, as in OpenFOAM.
void Reader::replace(Entry& old, Entry entry)
{
    old.dict = std::move(entry.dict);
    old.tokens = std::move(entry.tokens);
    old.line = entry.line;
    old.file = std::move(entry.file);
    old.inherited = entry.inherited;
    old.includeDepth = entry.includeDepth;
    old.quoted = entry.quoted;
}

void Reader::checkForbidden(Entry const& entry) const
{
    std::string what;
    if (entry.key == "libs") what = "libs";
    bool const type = (entry.key == "type" || entry.key == "functionObjectType") && !entry.tokens.empty() && entry.tokens[0].isName();
    if (type)
    {
        std::string const& word = entry.tokens[0].text;
        if (word.starts_with("coded") || word == "systemCall") what = "type " + shown(word);
    }
    if (what.empty()) return;
    Location const where = here().where(entry);
    require(options_.lenient, where, what + " is not supported by design: a case is data, never code");
    warn(where, what + " is shown as data; in a case it is refused, for it would run code");
}

/// Counts the values of every `List<type> N(...)`.
void Reader::checkLists(Entry const& entry) const
{
    Tokens const& tokens = entry.tokens;
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i)
    {
        bool const counted = isListType(tokens[i]) && tokens[i + 1].kind == TokenKind::Integer && tokens[i + 2].isPunctuation('(');
        if (!counted) continue;
        std::int64_t count = 0;
        int depth = 1;
        for (std::size_t k = i + 3; k < tokens.size() && depth > 0; ++k)
        {
            if (tokens[k].closes()) --depth;
            if (depth == 1 && !tokens[k].opens()) ++count;
            if (tokens[k].opens()) ++depth;
        }
        require(count == tokens[i + 1].integer, {*entry.file, tokens[i + 1].line, here().scoped(entry.key)},
                "the list holds " + std::to_string(count) + " values, not " + std::to_string(tokens[i + 1].integer));
    }
}

void Reader::warn(Location const& where, std::string const& text) const
{
    if (options_.warnings) options_.warnings->push_back(where.str() + ": " + text);
}

} // namespace mpsDem::dictionary

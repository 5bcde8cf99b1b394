#include <algorithm>
#include <array>

#include "core/dictionary/Reader.h"

namespace mpsDem::dictionary {

namespace {

std::vector<std::string> const& knownDirectives()
{
    static std::vector<std::string> const known = {"else",      "endif",   "eval",       "if",
                                                   "ifeq",      "include", "includeEtc", "includeIfPresent",
                                                   "inputMode", "remove",  "sinclude",   "sincludeEtc"};
    return known;
}

bool isInclude(std::string const& word)
{
    return word == "include" || word == "includeEtc" || word == "includeIfPresent" || word == "sinclude" || word == "sincludeEtc";
}

bool sameToken(Token const& a, Token const& b)
{
    if (a.isNumber() && b.isNumber()) return a.number == b.number;
    if (a.isNumber() != b.isNumber()) return false;
    return a.text == b.text;
}

} // namespace

void Reader::refuseDirective(Lexer const& lexer, Token const& directive) const
{
    std::string const& word = directive.text;
    bool const code = word == "calc" || word == "codeStream";
    Location const where = lexer.where(directive.line);
    require(!code, where, "#" + word + " is not supported by design: a case is data, never code", "#eval{ ... } does plain arithmetic");
    throw CaseError(ExitCode::BadInput, where, "the directive #" + shown(word) + " is not known or not allowed here",
                    knownWords("directives", shown(word), knownDirectives()));
}

/// A directive that stands where a keyword may.
void Reader::runDirective(Lexer& lexer, Token const& directive, Ifs& ifs)
{
    std::string const& word = directive.text;
    if (isInclude(word))
        include(lexer, directive, nullptr);
    else if (word == "inputMode")
        setInputMode(lexer, directive);
    else if (word == "remove")
        removeEntries(lexer, directive);
    else if (word == "if" || word == "ifeq" || word == "else" || word == "endif")
        runConditional(lexer, directive, ifs);
    else
        refuseDirective(lexer, directive);
}

/// A directive amid the tokens of an entry: #eval and includes.
void Reader::appendDirective(Lexer& lexer, Token const& directive, Entry& entry)
{
    if (directive.text == "eval")
        entry.tokens.push_back(evaluate(lexer, directive));
    else if (isInclude(directive.text))
        include(lexer, directive, &entry);
    else
        refuseDirective(lexer, directive);
}

void Reader::setInputMode(Lexer& lexer, Token const& directive)
{
    Token const token = lexer.next();
    constexpr std::array<std::pair<char const*, InputMode>, 6> modes = {{{"default", InputMode::Default},
                                                                         {"merge", InputMode::Merge},
                                                                         {"overwrite", InputMode::Overwrite},
                                                                         {"protect", InputMode::Protect},
                                                                         {"warn", InputMode::Warn},
                                                                         {"error", InputMode::Error}}};
    auto const found = std::find_if(modes.begin(), modes.end(), [&](auto const& mode) { return token.isWord(mode.first); });
    require(found != modes.end(), lexer.where(directive.line), "#inputMode does not know \"" + shown(token.text) + "\"",
            "known modes: default, merge, overwrite, protect, warn, error");
    mode_ = found->second;
}

/// #remove name; #remove "pattern"; #remove ( name "pattern" )
void Reader::removeEntries(Lexer& lexer, Token const& directive)
{
    Location const where = lexer.where(directive.line);
    Token token = lexer.next();
    bool const list = token.isPunctuation('(');
    if (list) token = lexer.next();
    do {
        if (list && token.isPunctuation(')')) return;
        require(token.isName(), where, "#remove needs a keyword, a quoted pattern or a list of them");
        here().remove(token.text);
        if (token.kind == TokenKind::Text)
        {
            budget_.chargePattern(where);
            Pattern const pattern(token.text, where);
            for (std::string const& key : here().keys())
                if (pattern.matches(key)) here().remove(key);
        }
        if (list) token = lexer.next();
    } while (list);
}

void Reader::runConditional(Lexer& lexer, Token const& directive, Ifs& ifs)
{
    Location const where = lexer.where(directive.line);
    if (directive.text == "endif")
    {
        require(!ifs.empty(), where, "#endif without #if");
        ifs.pop_back();
    }
    else if (directive.text == "else")
    {
        require(!ifs.empty() && !ifs.back().sawElse, where, "#else without #if");
        ifs.back().sawElse = true;
        skipBranch(lexer, ifs.back().line, ifs);
    }
    else
    {
        ifs.push_back({directive.line, false});
        if (!condition(lexer, directive)) skipBranch(lexer, directive.line, ifs);
    }
}

/// One value with macros expanded: a token, or a list up to its closing parenthesis.
Tokens Reader::conditionValue(Lexer& lexer, Token const& directive)
{
    Entry value;
    int depth = 0;
    do {
        Token token = lexer.next();
        budget_.chargeTokens(1, lexer.where(token.line));
        bool const misplaced = token.kind == TokenKind::End || token.isPunctuation(';') || token.isPunctuation('}');
        require(!misplaced, lexer.where(directive.line), "#" + directive.text + " lacks a value");
        if (token.opens()) ++depth;
        if (token.closes()) --depth;
        if (token.kind == TokenKind::Text && token.text.starts_with("$") && token.text.find_first_of(" ${}", 1) == std::string::npos)
        {
            token.kind = TokenKind::Variable;
            token.text.erase(0, 1);
        }
        if (token.kind == TokenKind::Variable)
            appendMacro(token, lexer.where(token.line), value.tokens);
        else if (token.kind == TokenKind::Directive)
            appendDirective(lexer, token, value);
        else
            value.tokens.push_back(std::move(token));
    } while (depth > 0);
    return std::move(value.tokens);
}

bool Reader::condition(Lexer& lexer, Token const& directive)
{
    Tokens const value = conditionValue(lexer, directive);
    if (directive.text == "ifeq")
    {
        Tokens const other = conditionValue(lexer, directive);
        return std::equal(value.begin(), value.end(), other.begin(), other.end(), sameToken);
    }
    if (value.size() == 1 && value[0].isNumber()) return value[0].number != 0;
    constexpr std::array words = {"true", "on", "yes", "false", "off", "no"};
    auto const matches = [&](char const* word) { return value.size() == 1 && value[0].isName() && value[0].text == word; };
    auto const found = std::find_if(words.begin(), words.end(), matches);
    require(found != words.end(), lexer.where(directive.line), "#if needs a switch or a number", "true on yes false off no, or 1 and 0");
    return found - words.begin() < 3;
}

/// Skips to the #else or #endif that belongs to the innermost #if.
void Reader::skipBranch(Lexer& lexer, int line, Ifs& ifs)
{
    int inner = 0;
    for (;;)
    {
        Token const token = lexer.next();
        require(token.kind != TokenKind::End, lexer.where(line), "the #if that begins here has no #endif");
        if (token.kind != TokenKind::Directive) continue;
        if (token.text == "if" || token.text == "ifeq")
            ++inner;
        else if (token.text == "else" && inner == 0)
        {
            require(!ifs.back().sawElse, lexer.where(token.line), "a second #else for the #if of line " + std::to_string(line));
            ifs.back().sawElse = true;
            return;
        }
        else if (token.text == "endif" && inner-- == 0)
        {
            ifs.pop_back();
            return;
        }
    }
}

/// #eval{ ... }, #eval "..." and #eval #{ ... #}.
Token Reader::evaluate(Lexer& lexer, Token const& directive)
{
    Location const where = lexer.where(directive.line);
    Token const begin = lexer.next();
    bool const braced = begin.isPunctuation('{');
    bool const text = begin.kind == TokenKind::Text || begin.kind == TokenKind::Verbatim;
    require(braced || text, where, "#eval needs an expression", "#eval{ 2*$x } or #eval \"2*$x\"");
    std::string const expression = braced ? lexer.readBraced(begin.line) : begin.text;
    auto const lookup = [&](std::string const& name) -> Tokens const& { return macroTokens(name, where); };
    budget_.chargeBytes(sizeof(Token) + expression.size(), where);
    Token value;
    value.kind = TokenKind::Number;
    value.line = directive.line;
    value.computed = true;
    value.number = evaluator_.evaluate(expression, lookup, where);
    return value;
}

} // namespace mpsDem::dictionary

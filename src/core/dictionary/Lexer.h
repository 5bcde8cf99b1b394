#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "core/Errors.h"
#include "core/dictionary/Token.h"

namespace mpsDem::dictionary {

/// Cuts the text of one file into tokens.
///
/// The grammar is OpenFOAM's: words end at a blank or at one of " ' / ; { } and may hold balanced parentheses; numbers begin with a
/// digit, or with - or . before a digit. Comments are `//` to the end of the line and the block form.
/// What OpenFOAM reads by accident is an error here: unclosed comments, strings and parentheses, control characters, numbers out of
/// range, and (unless `lenient`) a number that runs into a word, such as 0x10 or 1.5f.
class Lexer
{
public:
    /// @param text  Content of the file; a byte order mark is skipped, CR LF becomes LF.
    /// @param name  Stands for the file in messages.
    Lexer(std::string text, std::string name, bool lenient);

    /// The next token. @throw CaseError BadInput with file:line.
    Token next();
    /// The next token stays there for next(). The reference ends with the next call.
    Token const& peek();

    [[nodiscard]] std::size_t bytesLeft() const { return text_.size() - position_; }
    [[nodiscard]] std::shared_ptr<std::string const> const& name() const { return name_; }
    [[nodiscard]] Location where(int line) const { return {*name_, line, {}}; }
    [[nodiscard]] int line() const { return line_; }

    /// Text from an opening brace, already read, to its partner, which is read as well. @param line  Where the brace stands.
    std::string readBraced(int line);

private:
    Token read();
    bool skipBlanks();
    void skipComment();
    void readText(Token& token);
    void readVerbatim(Token& token);
    void readVariable(Token& token);
    void readNumber(Token& token);
    std::string readWord(char const* kind);
    [[nodiscard]] bool startsNumber() const;
    [[nodiscard]] char ahead(std::size_t offset) const { return position_ + offset < text_.size() ? text_[position_ + offset] : '\0'; }

    std::string text_;
    std::shared_ptr<std::string const> name_;
    std::size_t position_ = 0;
    int line_ = 1;
    bool lenient_;
    bool hasPeeked_ = false;
    Token peeked_;
};

} // namespace mpsDem::dictionary

#include "core/dictionary/Evaluator.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include <muParser.h>

#include "core/dictionary/Limits.h"

namespace mpsDem::dictionary {

namespace {

double minimum(double const* values, int count) { return *std::min_element(values, values + count); }
double maximum(double const* values, int count) { return *std::max_element(values, values + count); }

struct Unary
{
    char const* name;
    double (*value)(double);
};

double sign(double x) { return x >= 0 ? 1 : -1; }
double pos(double x) { return x > 0 ? 1 : 0; }
double neg(double x) { return x < 0 ? 1 : 0; }
double pos0(double x) { return x >= 0 ? 1 : 0; }
double neg0(double x) { return x <= 0 ? 1 : 0; }
double truth(double x) { return x != 0 ? 1 : 0; }
double square(double x) { return x * x; }
double degToRad(double x) { return x * (std::numbers::pi / 180); }
double radToDeg(double x) { return x * (180 / std::numbers::pi); }
double pi() { return std::numbers::pi; }

constexpr Unary unaries[] = {{"sin", &std::sin},   {"cos", &std::cos},     {"tan", &std::tan},      {"asin", &std::asin},
                             {"acos", &std::acos}, {"atan", &std::atan},   {"sinh", &std::sinh},    {"cosh", &std::cosh},
                             {"tanh", &std::tanh}, {"exp", &std::exp},     {"log", &std::log},      {"log10", &std::log10},
                             {"sqrt", &std::sqrt}, {"cbrt", &std::cbrt},   {"sqr", &square},        {"magSqr", &square},
                             {"mag", &std::fabs},  {"floor", &std::floor}, {"ceil", &std::ceil},    {"round", &std::round},
                             {"sign", &sign},      {"pos", &pos},          {"neg", &neg},           {"pos0", &pos0},
                             {"neg0", &neg0},      {"bool", &truth},       {"degToRad", &degToRad}, {"radToDeg", &radToDeg}};

double power(double x, double y) { return std::pow(x, y); }
double arcTangent(double y, double x) { return std::atan2(y, x); }
double hypotenuse(double x, double y) { return std::hypot(x, y); }

void defineFunctions(mu::Parser& parser)
{
    for (auto const& [name, value] : unaries) parser.DefineFun(name, value);
    parser.DefineFun("pow", &power);
    parser.DefineFun("atan2", &arcTangent);
    parser.DefineFun("hypot", &hypotenuse);
    parser.DefineFun("pi", &pi);
    parser.DefineFun("min", &minimum);
    parser.DefineFun("max", &maximum);
}

bool isNameCharacter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Removes comments and line ends.
std::string oneLine(std::string const& text)
{
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        if (text.compare(i, 2, "//") == 0)
            i = std::min(text.find('\n', i), text.size() - 1);
        else if (text.compare(i, 2, "/*") == 0)
            i = std::min(text.find("*/", i + 2), text.size() - 2) + 1;
        else
            out += text[i];
        if (std::isspace(static_cast<unsigned char>(text[i])) != 0) out += ' ';
    }
    std::replace_if(
        out.begin(), out.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
    return out;
}

/// End of the macro's name that begins at `i`, just behind the $: letters, digits, _ and dots between them, after : or dots.
std::size_t nameEnd(std::string const& text, std::size_t i)
{
    while (i < text.size() && (text[i] == ':' || text[i] == '.')) ++i;
    auto const next = [&](std::size_t k) { return k < text.size() ? text[k] : ' '; };
    while (isNameCharacter(next(i)) || (next(i) == '.' && isNameCharacter(next(i + 1)))) ++i;
    return i;
}

/// A number in parentheses with all its digits, so that a minus sign keeps its meaning.
std::string numberOf(std::string const& name, Tokens const& tokens, Location const& where)
{
    bool const isTrue = tokens.size() == 1 && tokens[0].isWord("true");
    bool const isFalse = tokens.size() == 1 && tokens[0].isWord("false");
    bool const signedNumber = tokens.size() == 2 && tokens[1].isNumber() && (tokens[0].isPunctuation('-') || tokens[0].isPunctuation('+'));
    bool const number = tokens.size() == 1 && tokens[0].isNumber();
    require(number || signedNumber || isTrue || isFalse, where, "#eval needs a number, but $" + shown(name) + " is none");
    if (isTrue || isFalse) return isTrue ? "1" : "0";
    Real const value = (signedNumber && tokens[0].isPunctuation('-') ? -1 : 1) * tokens.back().number;
    std::array<char, 32> buffer{};
    auto const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    return "(" + std::string(buffer.data(), end.ptr) + ")";
}

std::string substitute(std::string const& text, Evaluator::Lookup const& lookup, Location const& where)
{
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i)
    {
        if (text[i] != '$')
        {
            out += text[i];
            continue;
        }
        bool const braced = i + 1 < text.size() && text[i + 1] == '{';
        std::size_t const begin = i + (braced ? 2 : 1);
        std::size_t const end = braced ? text.find('}', begin) : nameEnd(text, begin);
        require(end != std::string::npos && end > begin, where, "#eval holds a $ without a name");
        std::string const name = text.substr(begin, end - begin);
        out += numberOf(name, lookup(name), where);
        require(out.size() <= maxExpressionLength, where, "the expression of #eval is longer than 4096 characters");
        i = braced ? end : end - 1;
    }
    return out;
}

} // namespace

struct Evaluator::Implementation
{
    mu::Parser parser;

    [[nodiscard]] std::vector<std::string> functions() const
    {
        std::vector<std::string> names;
        for (auto const& [name, callback] : parser.GetFunDef()) names.push_back(name);
        return names;
    }

    [[noreturn]] void refuse(mu::ParserError const& error, std::string const& expression, Location const& where) const
    {
        if (error.GetCode() == mu::ecUNASSIGNABLE_TOKEN)
            throw CaseError(ExitCode::BadInput, where, "#eval does not know \"" + shown(error.GetToken()) + "\"",
                            knownWords("functions", shown(error.GetToken()), functions()));
        throw CaseError(ExitCode::BadInput, where, "#eval cannot read \"" + shown(expression) + "\": " + error.GetMsg());
    }
};

Evaluator::Evaluator() : implementation_(std::make_unique<Implementation>())
{
    mu::Parser& parser = implementation_->parser;
    parser.ClearConst();
    parser.ClearFun();
    parser.ClearPostfixOprt();
    defineFunctions(parser);
    parser.DefineConst("true", 1);
    parser.DefineConst("false", 0);
    parser.DefineInfixOprt(
        "!", +[](double x) { return x == 0 ? 1.0 : 0.0; });
    parser.DefineOprt(
        "%", +[](double x, double y) { return std::fmod(x, y); }, mu::prMUL_DIV);
}

Evaluator::~Evaluator() = default;

Real Evaluator::evaluate(std::string const& expression, Lookup const& lookup, Location const& where)
{
    require(expression.size() <= maxExpressionLength, where, "the expression of #eval is longer than 4096 characters");
    std::string const text = substitute(oneLine(expression), lookup, where);
    bool const blank = std::all_of(text.begin(), text.end(), [](char c) { return c == ' '; });
    require(!blank, where, "#eval has no expression");
    try
    {
        implementation_->parser.SetExpr(text);
        int count = 0;
        double const* const results = implementation_->parser.Eval(count);
        require(count == 1, where, "#eval gives " + std::to_string(count) + " values, only one number is allowed");
        require(std::isfinite(results[0]), where, "#eval of \"" + shown(expression) + "\" is not finite");
        return results[0];
    }
    catch (mu::ParserError const& error)
    {
        implementation_->refuse(error, expression, where);
    }
}

} // namespace mpsDem::dictionary

#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/Errors.h"
#include "core/dictionary/Token.h"

namespace mpsDem::dictionary {

/// Plain arithmetic in double precision for #eval: + - * / % ^, comparisons, && || !, c ? a : b, parentheses and OpenFOAM's names of
/// functions (sin cos tan asin acos atan atan2 sinh cosh tanh exp log log10 sqrt cbrt sqr pow mag magSqr floor ceil round sign pos neg pos0
/// neg0 hypot min max degToRad radToDeg pi). `^` is the power; OpenFOAM has none. Vectors and strings are refused.
class Evaluator
{
public:
    /// Finds the tokens behind a macro's name; throws where there are none.
    using Lookup = std::function<Tokens const&(std::string const& name)>;

    Evaluator();
    ~Evaluator();
    Evaluator(Evaluator const&) = delete;
    Evaluator& operator=(Evaluator const&) = delete;

    /// @throw CaseError for a syntax error, an unknown name, a macro that is no number, or a result that is not finite.
    Real evaluate(std::string const& expression, Lookup const& lookup, Location const& where);

private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

} // namespace mpsDem::dictionary

#pragma once

#include <stdexcept>

namespace mpsDem {

/// A command line that cannot be understood; the text is what the user reads.
class CommandLineError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

} // namespace mpsDem

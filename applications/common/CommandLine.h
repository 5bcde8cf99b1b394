#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace mpsDem {

/// One option of an application, without its dash.
struct CommandOption
{
    std::string name;     ///< "overwrite", used as -overwrite.
    std::string argument; ///< What follows it, as shown in the help ("dir"); empty for a switch.
    std::string help;
};

/// What an application is called, does and takes. Every application has -case, -help and -help-full beside its own options.
struct ApplicationDescription
{
    std::string name;
    std::string purpose; ///< One or two sentences.
    std::vector<CommandOption> options;
    std::string arguments = {}; ///< Arguments without a dash, as shown in the help ("<file>"); empty where there are none.
    bool banner = true;         ///< Prints the banner with time, host and case before the work.
    bool usesCase = true;       ///< Has the option -case.
};

/// Options and arguments as the user gave them, in OpenFOAM's style: `-case dir -overwrite`.
class CommandLine
{
public:
    /// @throw CommandLineError for an unknown option, one without its value, or too many arguments.
    CommandLine(ApplicationDescription description, int argc, char const* const* argv);

    [[nodiscard]] bool found(std::string const& option) const { return values_.count(option) != 0; }
    /// Value of an option; nothing where it was not given.
    [[nodiscard]] std::optional<std::string> value(std::string const& option) const;
    [[nodiscard]] std::string valueOr(std::string const& option, std::string const& fallback) const;
    [[nodiscard]] std::vector<std::string> const& arguments() const { return arguments_; }

    /// Folder of -case, else the present one.
    [[nodiscard]] std::filesystem::path caseRoot() const;

    [[nodiscard]] ApplicationDescription const& description() const { return description_; }
    /// Text of -help.
    [[nodiscard]] std::string help() const;
    /// The command as it was typed.
    [[nodiscard]] std::string const& command() const { return command_; }

private:
    ApplicationDescription description_;
    std::map<std::string, std::string> values_;
    std::vector<std::string> arguments_;
    std::string command_;
};

/// Runs an application and turns all that can go wrong into a message on standard error and an exit code (core/Errors.h).
///
///     int main(int argc, char** argv)
///     {
///         return mpsDem::runApplication({"setParticles", "Lays out particles.", {...}}, argc, argv, [](CommandLine const& line) { ... return 0; });
///     }
///
/// Parses the command line (-help prints the help and returns 0; a wrong option says "Invalid option: -foo" and returns 2), ignores SIGXFSZ
/// so that a file size limit is an error and not a kill, prints the banner and calls `work`. Its exit code is returned, except
/// - CaseError: "--> FOAM FATAL IO ERROR: " with the place of an entry ("file: F.entry at line N."), or "--> FOAM FATAL ERROR: "; its code;
/// - std::bad_alloc: ExitCode::Memory; any other exception: ExitCode::Internal.
int runApplication(ApplicationDescription const& description, int argc, char const* const* argv,
                   std::function<int(CommandLine const&)> const& work);

/// The banner of a log in OpenFOAM's form: Build Arch Exec Date Time Host PID I/O Case nProcs.
std::string banner(CommandLine const& line);

} // namespace mpsDem

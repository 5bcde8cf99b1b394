#include <csignal>
#include <ctime>
#include <iostream>
#include <new>
#include <sstream>

#include <sys/utsname.h>
#include <unistd.h>

#include "common/CommandLine.h"
#include "common/CommandLineError.h"
#include "core/Errors.h"

namespace mpsDem {

namespace {

int constexpr codeOf(ExitCode code) { return static_cast<int>(code); }

std::string formatted(std::tm const& now, char const* format)
{
    char text[32] = {};
    std::strftime(text, sizeof text, format, &now);
    return text;
}

/// The message without the place in front of it: the place stands below in OpenFOAM's words.
std::string withoutPlace(CaseError const& error)
{
    std::string text = error.what();
    std::string const place = error.where().str();
    if (!place.empty() && text.starts_with(place + ": ")) text.erase(0, place.size() + 2);
    return text;
}

void report(CaseError const& error, std::string const& name)
{
    Location const& where = error.where();
    bool const inFile = !where.file.empty();
    std::cerr << "\n\n--> FOAM FATAL " << (inFile ? "IO ERROR" : "ERROR") << ": \n" << withoutPlace(error) << "\n\n";
    if (inFile)
    {
        std::cerr << "file: " << where.file << (where.entry.empty() ? "" : "." + where.entry);
        if (where.line > 0) std::cerr << " at line " << where.line;
        std::cerr << ".\n\n";
    }
    std::cerr << "FOAM exiting: " << name << ", exit code " << codeOf(error.code()) << "\n\n";
}

void report(std::string const& what, std::string const& name, ExitCode code)
{
    std::cerr << "\n\n--> FOAM FATAL ERROR: \n" << what << "\n\nFOAM exiting: " << name << ", exit code " << codeOf(code) << "\n\n";
}

} // namespace

std::string banner(CommandLine const& line)
{
    std::time_t const seconds = std::time(nullptr);
    std::tm now{};
    localtime_r(&seconds, &now);
    utsname machine{};
    uname(&machine);
    std::error_code ignored;
    auto const folder = std::filesystem::weakly_canonical(std::filesystem::absolute(line.caseRoot(), ignored), ignored);

    std::ostringstream out;
    std::string const stars = "// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //\n";
    std::string const frame(75, '-');
    out << "/*" << frame << "*\\\n"
        << "  mpsDem " MPSDEM_VERSION "   resolved MPS-DEM for tsunamis of rigid landslides\n"
        << "\\*" << frame << "*/\n"
        << "Build  : " MPSDEM_VERSION "\n"
        << "Arch   : \"" << machine.sysname << ";" << machine.machine << ";label=32;scalar=64\"\n"
        << "Exec   : " << line.command() << "\n"
        << "Date   : " << formatted(now, "%b %d %Y") << "\n"
        << "Time   : " << formatted(now, "%H:%M:%S") << "\n"
        << "Host   : " << machine.nodename << "\n"
        << "PID    : " << getpid() << "\n"
        << "I/O    : uncollated\n"
        << "Case   : " << folder.string() << "\n"
        << "nProcs : 1\n\n"
        << stars;
    return out.str();
}

int runApplication(ApplicationDescription const& description, int argc, char const* const* argv,
                   std::function<int(CommandLine const&)> const& work)
{
    std::signal(SIGXFSZ, SIG_IGN);
    try
    {
        CommandLine const line(description, argc, argv);
        if (line.found("help") || line.found("help-full"))
        {
            std::cout << line.help() << std::flush;
            return codeOf(ExitCode::Done);
        }
        if (description.banner) std::cout << banner(line) << std::flush;
        int const code = work(line);
        std::cout << std::flush;
        if (!std::cout) throw CaseError(ExitCode::InputOutput, "standard output cannot be written", "room on the device of the log");
        return code;
    }
    catch (CommandLineError const& error)
    {
        std::cerr << error.what() << "\nSee '" << description.name << " -help' for usage\n";
        return codeOf(ExitCode::BadInput);
    }
    catch (CaseError const& error)
    {
        std::cout << std::flush;
        report(error, description.name);
        return codeOf(error.code());
    }
    catch (std::bad_alloc const&)
    {
        std::cout << std::flush;
        report("out of memory\n    fewer particles, or a machine with more memory", description.name, ExitCode::Memory);
        return codeOf(ExitCode::Memory);
    }
    catch (std::exception const& error)
    {
        std::cout << std::flush;
        report(std::string("internal error: ") + error.what() + "\n    please report it with the case", description.name,
               ExitCode::Internal);
        return codeOf(ExitCode::Internal);
    }
}

} // namespace mpsDem

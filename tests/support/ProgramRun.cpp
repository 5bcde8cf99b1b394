#include "support/ProgramRun.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/Checkpoint.h"
#include "support/CheckpointSample.h"

namespace mpsDem::test {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

void rest() { std::this_thread::sleep_for(std::chrono::milliseconds(2)); }

std::string const controlDict = "startTime 0;\n"
                                "endTime 0.3;\n"
                                "deltaT 0.001;\n"
                                "adjustTimeStep yes;\n"
                                "maxCo 0.25;\n"
                                "maxDeltaT 0.002;\n"
                                "writeInterval 0.05;\n"
                                "purgeWrite 0;\n";

std::string const functions =
    "functions\n"
    "{\n"
    "    slide { type sixDoFRigidBodyState; writeControl runTime; writeInterval 0.005; }\n"
    "    gauges { type interfaceHeight; locations ((1.2 0 0) (1.6 0 0)); writeControl runTime; writeInterval 0.01; }\n"
    "    energy { type energyBudget; writeControl runTime; writeInterval 0.01; }\n"
    "    momentum { type momentumBudget; writeControl runTime; writeInterval 0.01; }\n"
    "}\n";

} // namespace

RunningProgram::RunningProgram(std::string const& name, fs::path const& caseFolder, std::vector<std::string> const& options)
{
    std::string const program = std::string(MPSDEM_BIN_DIR) + "/" + name;
    std::vector<std::string> words = {program, "-case", caseFolder.string()};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::string const output = (logs_ / "output").string(), error = (logs_ / "error").string();
    process_ = ::fork();
    if (process_ < 0) throw std::runtime_error("fork failed");
    if (process_ > 0) return;
    int const out = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    int const err = ::open(error.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (out < 0 || err < 0 || ::dup2(out, STDOUT_FILENO) < 0 || ::dup2(err, STDERR_FILENO) < 0) ::_exit(126);
    ::execv(program.c_str(), arguments.data());
    ::_exit(127);
}

RunningProgram::~RunningProgram()
{
    if (ended()) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, &status_, 0);
}

bool RunningProgram::ended()
{
    if (!ended_) ended_ = ::waitpid(process_, &status_, WNOHANG) == process_;
    return ended_;
}

void RunningProgram::send(int signal) const { ::kill(process_, signal); }

bool RunningProgram::waitFor(std::string const& piece, int count, double seconds)
{
    Clock::time_point const begin = Clock::now();
    while (true)
    {
        bool const last = ended();
        std::string const text = contentOf(logs_ / "output");
        int found = 0;
        for (std::size_t at = text.find(piece); at != std::string::npos && found < count; at = text.find(piece, at + piece.size())) ++found;
        if (found >= count) return !last;
        if (last || secondsSince(begin) > seconds) return false;
        rest();
    }
}

ProgramResult RunningProgram::wait(double seconds)
{
    Clock::time_point const begin = Clock::now();
    while (!ended())
    {
        if (secondsSince(begin) > seconds) ::kill(process_, SIGKILL);
        rest();
    }
    ProgramResult result;
    if (WIFEXITED(status_)) result.exitCode = WEXITSTATUS(status_);
    if (WIFSIGNALED(status_)) result.signal = WTERMSIG(status_);
    result.output = contentOf(logs_ / "output");
    result.error = contentOf(logs_ / "error");
    return result;
}

ProgramResult runProgram(std::string const& name, fs::path const& caseFolder, std::vector<std::string> const& options)
{
    return RunningProgram(name, caseFolder, options).wait();
}

WedgeCase::WedgeCase()
{
    write("system/controlDict", controlDict + functions);
    write("system/mpsSchemes", "schemeSet standard;\n");
    write("system/mpsSolution", "solvers { p { solver auto; tolerance 1e-6; } }\ncoupling { type strong; contactFace dry; }\n");
    write("system/setParticlesDict", "geometry { bed { type polyline; points ((-0.4 1.4 0) (1 0 0) (1.8 0 0) (1.8 1.4 0)); } }\n"
                                     "regions ( boxToParticle { box (-0.4 0 0) (1.8 1 0); } );\n"
                                     "hydrostatic { surface 1; }\n");
    write("constant/particleProperties", "spacing 0.05;\nthickness 0.5;\n");
    write("constant/g", "dimensions [0 1 -2 0 0 0 0];\nvalue (0 -9.81 0);\n", "uniformDimensionedVectorField");
    write("constant/transportProperties", "nu 1e-6;\nrho 1000;\n");
    write("constant/rigidBodyProperties",
          "bodies { slide {\nshape { type polygon; points ((0.01 0.99 0) (0.51 0.49 0) (0.51 0.99 0)); }\nmass 140;\n} }\n");
    write("constant/contactProperties",
          "mu 0.01;\ne 0.2;\nstoppers { buffer { type latch; body slide; point (0.56 0.44 0); normal (-1 1 0); } }\n");
}

DryWedgeCase::DryWedgeCase()
{
    remove("constant/transportProperties");
    remove("system/mpsSchemes");
    remove("system/mpsSolution");
    write("system/controlDict",
          controlDict + "functions { slide { type sixDoFRigidBodyState; writeControl runTime; writeInterval 0.005; } }\n");
    write("system/setParticlesDict", "geometry { bed { type polyline; points ((-0.4 1.4 0) (1 0 0) (1.8 0 0) (1.8 1.4 0)); } }\n");
    write("constant/rigidBodyProperties",
          "bodies { slide {\nshape { type polygon; points ((0.4 0.61 0) (0.9 0.11 0) (0.9 0.61 0)); }\nmass 140;\n} }\n");
    write("constant/contactProperties", "mu 0.2;\ne 0.2;\n");
}

SpaceWedgeCase::SpaceWedgeCase()
{
    write("constant/particleProperties", "dimensions 3;\nspacing 0.1;\n");
    write("system/setParticlesDict",
          "geometry { bed { type polyline; points ((-0.4 1.4 0) (1 0 0) (1.8 0 0) (1.8 1.4 0)); zRange (0 0.4); sideWalls yes; } }\n"
          "regions ( boxToParticle { box (-0.4 0 0) (1.8 1 0.4); } );\n"
          "hydrostatic { surface 1; }\n");
    write("constant/rigidBodyProperties", "bodies { slide {\nshape { type polygon; points ((0.01 0.99 0) (0.51 0.49 0) (0.51 0.99 0)); "
                                          "zRange (0.05 0.3); }\ndensity 2036;\n} }\n");
}

void WedgeCase::write(std::string const& file, std::string const& content, std::string const& headerClass) const
{
    fs::create_directories((root() / file).parent_path());
    std::ofstream(root() / file) << "FoamFile { version 2.0; format ascii; class " << headerClass << "; object o; }\n" << content;
}

void WedgeCase::replace(std::string const& file, std::string const& before, std::string const& after) const
{
    std::string text = contentOf(root() / file);
    std::size_t const at = text.find(before);
    ASSERT_NE(at, std::string::npos) << before << " is not in " << file;
    std::ofstream(root() / file) << text.replace(at, before.size(), after);
}

void WedgeCase::append(std::string const& file, std::string const& text) const { std::ofstream(root() / file, std::ios::app) << text; }

void WedgeCase::remove(std::string const& file) const { fs::remove_all(root() / file); }

void WedgeCase::copyFrom(WedgeCase const& other) const
{
    fs::remove_all(root());
    fs::copy(other.root(), root(), fs::copy_options::recursive);
}

void WedgeCase::setEndTime(std::string const& value) const
{
    std::string const text = contentOf(root() / "system/controlDict");
    std::size_t const at = text.find("endTime ");
    replace("system/controlDict", text.substr(at, text.find(';', at) - at), "endTime " + value);
}

void WedgeCase::makeParticles() const
{
    ProgramResult const result = runProgram("setParticles", root());
    ASSERT_EQ(result.exitCode, 0) << result.error;
}

ProgramResult WedgeCase::run(std::vector<std::string> const& options) const { return runProgram("mpsDemFoam", root(), options); }

std::vector<int> WedgeCase::checkpoints() const
{
    std::vector<int> steps;
    if (!fs::exists(root() / "checkpoint")) return steps;
    for (auto const& entry : fs::directory_iterator(root() / "checkpoint"))
        if (fs::exists(entry.path() / "MANIFEST") && entry.path().extension().empty())
            steps.push_back(std::atoi(entry.path().filename().c_str()));
    std::sort(steps.begin(), steps.end());
    return steps;
}

std::string WedgeCase::stateBytes(int step) const { return contentOf(root() / "checkpoint" / std::to_string(step) / "state.0"); }

std::map<std::string, std::string> WedgeCase::results() const
{
    std::map<std::string, std::string> files;
    for (auto const& entry : fs::recursive_directory_iterator(root()))
    {
        std::string const name = fs::relative(entry.path(), root()).string();
        bool const given = name.starts_with("system/") || name.starts_with("constant/") || name == ".mpsDem.lock";
        if (entry.is_regular_file() && !given) files[name] = contentOf(entry.path());
    }
    return files;
}

std::string contentOf(fs::path const& file)
{
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::string differingBlocks(fs::path const& first, fs::path const& second)
{
    State const a = readCheckpoint(first).state, b = readCheckpoint(second).state;
    std::string names;
    for (auto const& [name, block] : a.blocks())
    {
        State one, other;
        one.setBlock(name, block);
        if (b.has(name)) other.setBlock(name, b.blocks().at(name));
        if (!sameBits(one, other)) names += " " + name;
    }
    for (auto const& [name, block] : b.blocks())
        if (!a.has(name)) names += " " + name;
    return names;
}

void expectSameState(WedgeCase const& first, WedgeCase const& second, int step)
{
    std::string const a = first.stateBytes(step), b = second.stateBytes(step);
    ASSERT_FALSE(a.empty()) << "no checkpoint " << step;
    ASSERT_FALSE(b.empty()) << "no checkpoint " << step;
    fs::path const name = fs::path("checkpoint") / std::to_string(step);
    EXPECT_TRUE(a == b) << "checkpoint " << step << " differs in" << differingBlocks(first.root() / name, second.root() / name);
}

} // namespace mpsDem::test

#pragma once

#include <csignal>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "support/TemporaryFolder.h"

namespace mpsDem::test {

/// How a program ended and what it said.
struct ProgramResult
{
    int exitCode = -1;         ///< -1 where a signal ended it.
    int signal = 0;            ///< That signal, or 0.
    std::string output, error; ///< Of standard output and standard error.
};

/// A program of build/bin as a child process in a case folder. What it says is kept outside of the case.
class RunningProgram
{
public:
    RunningProgram(std::string const& name, std::filesystem::path const& caseFolder, std::vector<std::string> const& options = {});
    ~RunningProgram(); ///< Kills it where it still runs.
    RunningProgram(RunningProgram const&) = delete;
    RunningProgram& operator=(RunningProgram const&) = delete;

    void send(int signal) const;
    /// Waits until the output holds the piece `count` times. @return False where the program ended or the time [s] was over before.
    [[nodiscard]] bool waitFor(std::string const& piece, int count = 1, double seconds = 60);
    /// Waits for the end. A program that is still running after the time [s] is killed.
    ProgramResult wait(double seconds = 120);

private:
    [[nodiscard]] bool ended();

    TemporaryFolder logs_;
    int process_ = -1;
    int status_ = 0;
    bool ended_ = false;
};

/// Runs a program to its end.
ProgramResult runProgram(std::string const& name, std::filesystem::path const& caseFolder, std::vector<std::string> const& options = {});

/// A small case in a temporary folder: the wedge of 140 kg slides under water on a ramp of 45 degrees until a latch stops it at about
/// 0.27 s; 450 fluid particles, 0.3 s of time, 150 steps, write times every 0.05 s, all checkpoints kept.
///
/// Files are made of lines; the first line is the header, so the first line of the content is line 2.
class WedgeCase
{
public:
    WedgeCase();

    [[nodiscard]] std::filesystem::path const& root() const { return folder_.path(); }

    /// Writes a dictionary with a header in front.
    void write(std::string const& file, std::string const& content, std::string const& headerClass = "dictionary") const;
    /// Replaces the first `before` in a file of the case; it must be there.
    void replace(std::string const& file, std::string const& before, std::string const& after) const;
    void append(std::string const& file, std::string const& text) const;
    void remove(std::string const& file) const;
    void copyFrom(WedgeCase const& other) const;

    void setEndTime(std::string const& value) const;

    /// Runs setParticles; a test failure where that fails.
    void makeParticles() const;
    /// Runs mpsDemFoam.
    [[nodiscard]] ProgramResult run(std::vector<std::string> const& options = {}) const;

    /// Names of the checkpoints as numbers, sorted.
    [[nodiscard]] std::vector<int> checkpoints() const;
    /// Bytes of the block file of a checkpoint.
    [[nodiscard]] std::string stateBytes(int step) const;

    /// Every file below the case by its relative path, with its content, the lock and the dictionaries not among them.
    [[nodiscard]] std::map<std::string, std::string> results() const;

private:
    TemporaryFolder folder_;
};

/// A dry one: no fluid, the wedge slides in air on the ramp, is no longer stopped by a latch and hits the floor with its edge at about
/// 0.23 s.
class DryWedgeCase : public WedgeCase
{
public:
    DryWedgeCase();
};

/// One in 3-D: the same wedge in a channel 0.4 m wide between side walls, narrower than it and free to turn, 700 particles of 0.1 m.
class SpaceWedgeCase : public WedgeCase
{
public:
    SpaceWedgeCase();
};

/// Content of a file; empty where there is none.
std::string contentOf(std::filesystem::path const& file);

/// Which blocks differ between two checkpoints, for a message; empty where none does.
std::string differingBlocks(std::filesystem::path const& first, std::filesystem::path const& second);

/// True where a checkpoint of two cases has the same bytes; names the blocks that differ where not.
void expectSameState(WedgeCase const& first, WedgeCase const& second, int step);

} // namespace mpsDem::test

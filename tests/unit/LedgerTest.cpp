#include <string>

#include <gtest/gtest.h>

#include "core/Errors.h"
#include "core/Ledger.h"

namespace mpsDem {
namespace {

State stateOf(Ledger const& ledger)
{
    State state;
    ledger.save(state);
    return state;
}

/// The state without one block.
State without(State const& state, std::string const& name)
{
    State rest;
    for (auto const& [block, values] : state.blocks())
        if (block != name) rest.setBlock(block, values);
    return rest;
}

/// What load() writes to the log.
std::string logOfLoading(Ledger& ledger, State const& state)
{
    testing::internal::CaptureStdout();
    ledger.load(state);
    return testing::internal::GetCapturedStdout();
}

TEST(Ledger, LoadsWhatItSaved)
{
    Ledger saved, loaded;
    saved.energy("energy/collision") = 0.1;
    saved.impulse("impulse/walls") = Vector(1, 2, 3);
    Real const& energy = loaded.energy("energy/collision");
    Vector const& impulse = loaded.impulse("impulse/walls");
    EXPECT_EQ(logOfLoading(loaded, stateOf(saved)), "");
    EXPECT_EQ(energy, 0.1);
    EXPECT_EQ(impulse, Vector(1, 2, 3));
}

TEST(Ledger, RefusesAStateWithoutAnEntryOfAStage)
{
    Ledger ledger;
    ledger.energy("energy/collision") = 0.1;
    ledger.impulse("impulse/contactAndSupport") = Vector(1, 0, 0);
    for (std::string const name : {"ledger/energy/collision", "ledger/impulse/contactAndSupport"}) try
        {
            ledger.load(without(stateOf(ledger), name));
            ADD_FAILURE() << name << " is missing and nothing was said";
        }
        catch (CaseError const& error)
        {
            EXPECT_EQ(error.code(), ExitCode::InputOutput);
            EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
        }
}

// An effect that was off has added nothing: its entry is in the state, and zero.
TEST(Ledger, KnowsThatAnEffectWasOff)
{
    Ledger saved, loaded;
    saved.energy("energy/contactStored") = 5;
    Real& collision = loaded.energy("energy/collision");
    collision = 7;
    EXPECT_EQ(logOfLoading(loaded, stateOf(saved)), "");
    EXPECT_EQ(collision, 0);
}

TEST(Ledger, BeginsTheEntryOfANewObserverAtZeroAndSaysSo)
{
    Ledger saved, loaded;
    Vector& walls = loaded.impulse("impulse/walls");
    walls = Vector(1, 1, 1);
    std::string const log = logOfLoading(loaded, stateOf(saved));
    EXPECT_EQ(walls, Vector(0, 0, 0));
    EXPECT_NE(log.find("impulse/walls"), std::string::npos) << log;
    EXPECT_NE(log.find("from now on"), std::string::npos) << log;
}

} // namespace
} // namespace mpsDem

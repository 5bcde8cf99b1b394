#include <gtest/gtest.h>

#include "core/Dictionary.h"

namespace mpsDem {

TEST(DictionaryVariables, AnEntryThatAMacroTakesNeedNobodyElseToReadIt)
{
    Dictionary const dictionary = Dictionary::fromText("depth 2; half #eval{ $depth / 2 }; level $half;");
    EXPECT_EQ(dictionary.get<Real>("level"), 1);
    EXPECT_NO_THROW(dictionary.requireAllRead());
}

TEST(DictionaryVariables, ADictionaryThatHoldsOneMayHoldOthersThatThisFileDoesNotUse)
{
    Dictionary const dictionary = Dictionary::fromText("wedge { depth 2; legLength 0.5; } level $:wedge.depth;");
    EXPECT_EQ(dictionary.get<Real>("level"), 2);
    EXPECT_NO_THROW(dictionary.requireAllRead());
}

TEST(DictionaryVariables, AMisspeltEntryBesideThemIsStillRefused)
{
    Dictionary const dictionary = Dictionary::fromText("depth 2; level $depth; levell 3;");
    EXPECT_EQ(dictionary.get<Real>("level"), 2);
    EXPECT_THROW(dictionary.requireAllRead(), CaseError);

    Dictionary const nested = Dictionary::fromText("solver { tolerance 1; tolerence 2; } other $:solver.tolerance;");
    EXPECT_EQ(nested.subDict("solver").get<Real>("tolerance"), 1);
    EXPECT_EQ(nested.get<Real>("other"), 1);
    EXPECT_THROW(nested.requireAllRead(), CaseError);
}

} // namespace mpsDem

#pragma once

#include <optional>

#include "core/Dictionary.h"
#include "scene/CaseConstants.h"

namespace mpsDem {

/// The dictionaries that mpsDemFoam reads; those of effects may be absent.
struct SceneDictionaries
{
    Dictionary control;
    std::optional<Dictionary> schemes, solution, transport, bodies, contact;
    Lattice lattice;

    explicit SceneDictionaries(CaseFolder const& caseFolder)
        : control(caseFolder.read("system/controlDict")),
          schemes(caseFolder.readIfPresent("system/mpsSchemes")),
          solution(caseFolder.readIfPresent("system/mpsSolution")),
          transport(caseFolder.readIfPresent("constant/transportProperties")),
          bodies(caseFolder.readIfPresent("constant/rigidBodyProperties")),
          contact(caseFolder.readIfPresent("constant/contactProperties")),
          lattice(readLattice(caseFolder.read("constant/particleProperties")))
    {}
};

} // namespace mpsDem

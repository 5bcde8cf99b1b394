#pragma once

#include <string>

#include "core/Dictionary.h"
#include "core/Types.h"

namespace mpsDem {

/// Properties of one pair of surfaces, read from constant/contactProperties.
///
/// Mixing rule: the entries at the top hold for every pair; an entry of `pairs { "slide:ramp" { ... } }` (either order of the names)
/// replaces them for that pair. Nothing is averaged.
///
/// | key             | meaning                                              | unit | default             | range        |
/// |-----------------|------------------------------------------------------|------|---------------------|--------------|
/// | law             | contact law                                          |      | linearSpringDashpot | see registry |
/// | mu              | coefficient of friction                              | -    | none, required      | 0 .. 10      |
/// | e               | coefficient of restitution                           | -    | 0.2                 | 0.01 .. 1    |
/// | youngsModulus   | of both sides                                        | Pa   | 7.2e10              | 1e3 .. 1e13  |
/// | poissonsRatio   | of both sides                                        | -    | 0.33                | 0 .. 0.499   |
/// | stiffness       | maxOverlap, fromModulus or constant                  |      | maxOverlap          |              |
/// | maxOverlap      | static overlap aimed at, as a part of the spacing    | -    | 1e-3                | 1e-7 .. 0.05 |
/// | impactSpeed     | at which one corner may sink in by 0.05 spacings     | m/s  | 1                   | 0 .. 1e3     |
/// | normalStiffness | per area of contact, for `stiffness constant`        | N/m3 | none                | 1 .. 1e20    |
///
/// The sub-step goes with 1/impactSpeed: a body that never hits anything with a corner (a latch stops it) needs fewer with impactSpeed 0.
struct ContactProperties
{
    std::string law = "linearSpringDashpot";
    Real mu = 0;
    Real e = 0.2;
    Real youngsModulus = 7.2e10;
    Real poissonsRatio = 0.33;
    std::string stiffness = "maxOverlap";
    Real maxOverlap = 1e-3;
    Real impactSpeed = 1;
    Real normalStiffness = 0;
    Location where;   ///< Where the law was named.
    Location modulus; ///< Where youngsModulus was given; no file where it was not.

    /// A youngsModulus that nothing asks for: neither the stiffness nor the law is made of it.
    [[nodiscard]] bool idleModulus() const;

    /// Reads the entries of one dictionary; what it doesn't give is taken from `common`.
    /// @throw CaseError BadInput for values out of range and unknown words.
    static ContactProperties read(Dictionary const& dict, ContactProperties const& common);

    /// The common part of contactProperties.
    static ContactProperties readCommon(Dictionary const& dict);
    /// Properties of the pair first:second, with its entry of `pairs` if there is one.
    static ContactProperties readPair(Dictionary const& dict, ContactProperties const& common, std::string const& first,
                                      std::string const& second);
};

/// Damping ratio zeta of a spring-dashpot contact that never pulls (F_n >= 0) for the coefficient of restitution e.
///
/// The contact ends when the force is zero, before the overlap is. With zeta = sin(phi) this gives
/// \f[ e = \exp(-(\pi - 2\varphi)\tan\varphi), \f] for zeta > 1, zeta = cosh(psi), e = exp(-2 psi coth(psi)).
/// The familiar zeta = -ln e / sqrt(pi^2 + ln^2 e) holds only where the dashpot may pull. The same relation holds for the Hertz
/// contact with a dashpot proportional to overlap^(1/4) (its equation of motion maps onto the linear one).
/// Source: T. Schwager, T. Poeschel, Granular Matter 9 (2007); D. Antypov, J. Elliott, EPL 94 (2011).
/// @param e  0.001 .. 1.
Real dampingRatio(Real e);

/// The inverse of dampingRatio. @param zeta  >= 0.
Real restitution(Real zeta);

} // namespace mpsDem

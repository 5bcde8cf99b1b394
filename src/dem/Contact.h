#pragma once

#include <cstddef>

#include "core/Types.h"

namespace mpsDem {

/// One touching pair of a contact point and a patch of a surface: its history, its geometry in this sub-step and its forces.
///
/// Signs: `normal` points from the surface to the body of the point; `overlap` is a positive length; `velocity` is that of the
/// point's body relative to the surface, so that `velocity . normal < 0` means approach. Forces act on the point's body.
struct Contact
{
    // Key of the history.
    int point = 0; ///< Index in the point set.
    int patch = 0; ///< Run of collinear segments (or corner) of the surface.

    // History: what a restart needs.
    Vector slip = Vector::Zero();   ///< Elastic tangential displacement delta^t of eq 12 [m].
    Vector normal = Vector::Zero(); ///< Unit vector.
    Real tangentialStiffness = 0;   ///< chi^t of the last sub-step [N/m].
    Real tangentialEnergy = 0;      ///< Energy of the tangential spring [J].

    // Geometry of this sub-step.
    bool fresh = true;                ///< First sub-step of this contact.
    Real overlap = 0;                 ///< delta^n of eq 11 [m].
    Vector position = Vector::Zero(); ///< Where the forces act: the middle of the overlap [m].
    Vector velocity = Vector::Zero(); ///< [m/s].
    Real area = 0;                    ///< Part of the body's surface that the point stands for [m2].
    Real radius = 0;                  ///< Effective radius of curvature 1/(1/R1 + 1/R2) [m].
    Real count = 1;                   ///< Equal spheres side by side across the thickness [-].
    Real mass = 0;                    ///< Share of the reduced mass that this contact stops [kg].
    bool held = false;                ///< Neither side can be moved: forces change no velocity and take no energy.

    // Result.
    Vector normalForce = Vector::Zero();     ///< Eq 11 [N].
    Vector tangentialForce = Vector::Zero(); ///< Eq 12 [N].
    Real normalEnergy = 0;                   ///< Energy of the normal spring [J].
};

/// What the dashpots and sliders turned into heat since the start [J].
struct ContactDissipation
{
    Real normal = 0;     ///< Normal dashpots.
    Real tangential = 0; ///< Sliders and tangential dashpots.
};

} // namespace mpsDem

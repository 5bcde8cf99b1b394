#include "scene/InitialReport.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <numbers>
#include <sstream>

#include "boundaries/SurfaceTree.h"
#include "core/Log.h"
#include "scene/BodyReader.h"
#include "scene/InitialChecks.h"
#include "scene/SizeEstimate.h"
#include "scene/WallChecks.h"

namespace mpsDem {

namespace {

constexpr Real degree = std::numbers::pi / 180;

std::ostream& line(std::ostream& out, std::string const& name) { return out << "    " << std::left << std::setw(20) << name; }

void putVector(std::ostream& out, Vector const& v) { out << "(" << v.x() << " " << v.y() << " " << v.z() << ")"; }

/// mu of a pair: its own entry in either order, else the common one; -1 without any.
Real frictionOf(std::optional<Dictionary> const& contact, std::string const& a, std::string const& b)
{
    if (!contact) return -1;
    Dictionary const pairs = contact->subDictOrEmpty("pairs");
    for (std::string const& name : {a + ":" + b, b + ":" + a})
        if (pairs.isDict(name) && pairs.subDict(name).found("mu")) return pairs.subDict(name).get<Real>("mu");
    return contact->getOr<Real>("mu", -1);
}

/// Least distance of a fluid particle from any other particle, in spacings, and how many have one nearer than half a spacing.
struct Crowding
{
    Real least = std::numeric_limits<Real>::infinity();
    int crowded = 0;
};

Crowding crowding(ParticleSet const& particles)
{
    Crowding result;
    Real const spacing = particles.lattice().spacing;
    for (Real const distance : nearestDistances(particles.r, particles.fluid(), 1.1 * spacing, particles.lattice().dimensions))
    {
        Real const nearest = distance / spacing;
        result.least = std::min(result.least, nearest);
        if (nearest < 0.5) ++result.crowded;
    }
    return result;
}

void reportParticles(std::ostream& out, SceneDefinition const& definition, InitialScene const& scene)
{
    ParticleSet const& particles = scene.particles;
    Lattice const& lattice = definition.lattice;
    out << "Particles\n";
    line(out, "spacing") << lattice.spacing << " m, ";
    if (lattice.dimensions == 2)
        out << "thickness " << lattice.thickness << " m\n";
    else
        out << "3-D\n";
    line(out, "fluid") << particles.fluid().size() << "\n";
    line(out, "wall") << particles.wall().size() << "\n";
    line(out, "ghost") << particles.ghost().size() << "\n";
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k)
    {
        auto const count = std::count(scene.wallOf.begin(), scene.wallOf.end(), static_cast<int>(k));
        line(out, "wall " + scene.surfaces[k].name()) << count << " wall and ghost particles\n";
    }
}

/// The volume that the regions cover, and a warning where they reach out of the tank.
void reportRegions(std::ostream& out, SceneDefinition const& definition, InitialScene const& scene)
{
    RegionVolume const volume = sampleRegions(definition.regions, SurfaceTree(scene.surfaces), definition.lattice);
    out.precision(3);
    line(out, "regions") << "about " << volume.all << " m3, of it " << volume.all - volume.free << " m3 behind walls\n";
    out.precision(6);
    if (volume.beyond < std::max(0.01 * volume.all, 4 * definition.lattice.particleVolume())) return;
    std::ostringstream text;
    text.precision(3);
    text << "the regions reach out of the walls: of about " << volume.all << " m3, " << volume.beyond
         << " m3 lie outside of the walls' extent and hold no fluid; " << scene.fluid.volume << " m3 are left";
    warn(text.str());
}

/// Warns where the level that `hydrostatic` gives lies far above all fluid: its pressure would blow the water apart.
void checkLevel(SceneDefinition const& definition, InitialScene const& scene)
{
    if (!definition.hydrostatic || !definition.hasSurfaceLevel || scene.particles.fluid().size() == 0) return;
    Vector const up = -definition.gravity.normalized();
    Real highest = -std::numeric_limits<Real>::infinity();
    for (int const i : scene.particles.fluid()) highest = std::max(highest, scene.particles.r[i].dot(up));
    if (definition.surfaceLevel < highest + 2 * definition.lattice.spacing) return;
    warn("hydrostatic/surface " + shortNumber(definition.surfaceLevel) + " m lies above all fluid, which reaches to " +
         shortNumber(highest + 0.5 * definition.lattice.spacing) +
         " m: the pressure of the start is too high by rho g times the difference");
}

void reportFluid(std::ostream& out, SceneDefinition const& definition, InitialScene const& scene)
{
    int const count = scene.particles.fluid().size();
    if (definition.regions.empty()) return;
    Real const volume = count * definition.lattice.particleVolume();
    Real const error = 100 * (volume / scene.fluid.volume - 1);
    Crowding const close = crowding(scene.particles);
    out << "Fluid\n";
    reportRegions(out, definition, scene);
    line(out, "volume") << volume << " m3, of the regions without solids " << scene.fluid.volume << " m3, error " << error << " %\n";
    line(out, "mass") << volume * definition.density << " kg at " << definition.density << " kg/m3\n";
    line(out, "nearest particles") << close.least << " spacings\n";
    std::ostringstream problem;
    if (std::abs(error) > 5)
        problem << "the volume of the fluid particles differs from that of the geometry by " << error << " %; a smaller spacing reduces it";
    if (!problem.str().empty()) warn(problem.str());
    checkLevel(definition, scene);
    for (std::string const& finding : doubtfulWalls(definition, scene)) warn(finding);
    if (close.crowded > 0) warn(std::to_string(close.crowded) + " fluid particles have another particle nearer than half a spacing");
}

/// The sentence about what the body will do, for the report and, where it cannot move, for a warning.
void reportOutlook(std::ostream& out, SceneDefinition const& definition, InitialScene const& scene, std::size_t k,
                   BodyOutlook const& outlook)
{
    RigidBody const& body = *definition.bodies[k];
    Real const weight = body.mass() * definition.gravity.norm();
    if (!(weight > 0)) return;
    line(out, "submerged weight") << outlook.submergedWeight << " N, (m - rho V) g, of " << weight << " N in air\n";
    if (definition.density > 0 && outlook.submergedWeight <= 0)
    {
        line(out, "outlook") << "floats where the fluid is deep enough: it is less dense\n";
        warn("body \"" + body.name() + "\" is less dense than the fluid: it floats where that is deep enough");
        return;
    }
    bool const supported = outlook.support.other >= 0 && outlook.support.distance < definition.lattice.spacing;
    if (!supported)
    {
        line(out, "outlook") << "falls: no wall supports it\n";
        return;
    }
    std::string const& wall = scene.surfaces[static_cast<std::size_t>(outlook.support.other)].name();
    line(out, "support") << wall << ", slope " << outlook.slope / degree << " degrees\n";
    line(out, "drive") << outlook.drive << " N, W' sin(slope)\n";
    if (outlook.friction < 0) return;
    line(out, "friction") << outlook.resistance << " N, mu W' cos(slope) with mu " << outlook.friction << "\n";
    bool const slides = outlook.drive > outlook.resistance;
    line(out, "outlook") << (slides ? "slides" : "stays: friction holds it") << "\n";
    if (!slides && outlook.slope > degree) warn("body \"" + body.name() + "\" cannot slide on \"" + wall + "\": friction holds it");
}

/// Below two spacings one row of wall particles stands for both sides: 20 to 40 % of the lift in still water are lost.
void warnOfThinBody(SceneDefinition const& definition, Surface const& outline)
{
    Real const thickness = leastWidth(outline) / definition.lattice.spacing;
    if (definition.regions.empty() || thickness > 2 - 1e-6) return;
    std::ostringstream text;
    text << "body \"" << outline.name() << "\" is " << thickness << " spacings thick: forces of the fluid on it are not resolved below 2";
    warn(text.str());
}

/// Gap to the nearest other body.
void reportNearestBody(std::ostream& out, SceneDefinition const& definition, InitialScene const& scene, std::size_t k)
{
    Gap least;
    least.distance = std::numeric_limits<Real>::infinity();
    std::string name;
    for (std::size_t other = 0; other < scene.placed.size(); ++other)
    {
        if (other == k || boxDistance(scene.placed[k], scene.placed[other]) > least.distance) continue;
        Gap const between = gapTo(scene.placed[k], {scene.placed[other]}, definition.lattice.spacing);
        if (!(between.distance < least.distance)) continue;
        least = between;
        name = scene.placed[other].name();
    }
    if (!name.empty()) line(out, "gap to body") << least.distance << " m from " << name << "\n";
}

void reportBody(std::ostream& out, SceneDefinition const& definition, InitialScene const& scene, std::size_t k,
                std::optional<Dictionary> const& contact)
{
    RigidBody const& body = *definition.bodies[k];
    MassProperties const& properties = body.massProperties();
    BodyOutlook const outlook = bodyOutlook(definition, scene, k, contact);
    out << "Body " << body.name() << "\n";
    line(out, "particles") << std::count(scene.particles.body.begin(), scene.particles.body.end(), static_cast<int>(k)) << "\n";
    line(out, "mass") << properties.mass << " kg\n";
    line(out, "volume") << properties.volume << " m3, density " << properties.mass / properties.volume << " kg/m3\n";
    line(out, "centre of mass");
    putVector(out, body.centre());
    out << " m\n";
    if (definition.lattice.dimensions == 2)
        line(out, "inertia Izz") << properties.inertia(2, 2) << " kg m2\n";
    else
        for (int d = 0; d < 3; ++d)
        {
            line(out, d == 0 ? "inertia" : "");
            Real const least = 1e-12 * properties.inertia.norm();
            putVector(out, properties.inertia.row(d).unaryExpr([&](Real x) { return std::abs(x) < least ? 0 : x; }));
            out << " kg m2\n";
        }
    warnOfThinBody(definition, scene.placed[k]);
    reportOutlook(out, definition, scene, k, outlook);
    Real const gap = std::abs(outlook.support.distance) < 1e-9 * definition.lattice.spacing ? 0 : outlook.support.distance;
    if (outlook.support.other >= 0)
        line(out, "gap to wall") << gap << " m from " << scene.surfaces[static_cast<std::size_t>(outlook.support.other)].name() << "\n";
    reportNearestBody(out, definition, scene, k);
}

} // namespace

BodyOutlook bodyOutlook(SceneDefinition const& definition, InitialScene const& scene, std::size_t body,
                        std::optional<Dictionary> const& contactProperties)
{
    BodyOutlook outlook;
    MassProperties const& properties = definition.bodies[body]->massProperties();
    Real const g = definition.gravity.norm();
    outlook.submergedWeight = (properties.mass - definition.density * properties.volume) * g;
    Vector const up = g > 0 ? Vector(-definition.gravity / g) : Vector(Vector::Zero());
    outlook.support = gapTo(scene.placed[body], scene.surfaces, definition.lattice.spacing, up);
    if (outlook.support.other < 0 || !(g > 0)) return outlook;
    outlook.slope = std::acos(std::clamp(outlook.support.normal.dot(up), Real(-1), Real(1)));
    outlook.drive = outlook.submergedWeight * std::sin(outlook.slope);
    auto const& wall = scene.surfaces[static_cast<std::size_t>(outlook.support.other)];
    outlook.friction = frictionOf(contactProperties, definition.bodies[body]->name(), wall.name());
    outlook.resistance = std::max(Real(0), outlook.friction * outlook.submergedWeight * std::cos(outlook.slope));
    return outlook;
}

std::string initialReport(SceneDefinition const& definition, InitialScene const& scene, std::optional<Dictionary> const& contactProperties)
{
    std::ostringstream out;
    reportParticles(out, definition, scene);
    reportFluid(out, definition, scene);
    for (std::size_t k = 0; k < definition.bodies.size(); ++k) reportBody(out, definition, scene, k, contactProperties);
    return out.str();
}

} // namespace mpsDem

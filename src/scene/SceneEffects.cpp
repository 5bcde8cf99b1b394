#include "core/Errors.h"
#include "core/Log.h"
#include "scene/Scene.h"

namespace mpsDem {

namespace {

/// What the entry `group { key ...; }` of system/mpsSchemes says, or that it is left to the set of schemes.
std::string entryOf(std::optional<Dictionary> const& schemes, std::string const& group, std::string const& key)
{
    Dictionary const all = schemes.value_or(Dictionary());
    Dictionary const dict = all.subDictOrEmpty(group);
    if (dict.found(key)) return "mpsSchemes/" + group + ": " + key + " " + dict.entryText(key);
    return std::string("default of schemeSet ") + nameOf(readSchemeSet(all));
}

/// Which entry decides on the relaxation of the density: a source without density has none, a gamma alone takes the place of the time.
std::string relaxationOf(std::optional<Dictionary> const& schemes)
{
    Dictionary const source = schemes.value_or(Dictionary()).subDictOrEmpty("sourceSchemes");
    bool const without = source.getOr<std::string>("type", "") == "divergence";
    bool const fixed = source.found("gamma") && !source.found("relaxationTime");
    return entryOf(schemes, "sourceSchemes", without ? "type" : fixed ? "gamma" : "relaxationTime");
}

/// "a, b, c".
template <class Range, class NameOf>
std::string listed(Range const& range, NameOf const& nameOf)
{
    std::string names;
    for (auto const& item : range) names += (names.empty() ? "" : ", ") + std::string(nameOf(item));
    return names;
}

std::string enabledOf(Dictionary const& functions)
{
    std::vector<std::string> names;
    for (std::string const& name : functions.dictKeys())
        if (functions.subDict(name).getOr<bool>("enabled", true)) names.push_back(name);
    return listed(names, [](std::string const& name) { return name; });
}

} // namespace

void Scene::listEffects()
{
    bool const heavy = !gravity_.isZero();
    std::string const g = shortNumber(gravity_.x()) + " " + shortNumber(gravity_.y()) + " " + shortNumber(gravity_.z());
    effects_.add("gravity", heavy, heavy ? "constant/g gives (" + g + ") m/s2" : "no constant/g, or zero");
    listFluidEffects();
    listBodyEffects();
    bool const on = guard_->active(), given = dicts_.control.subDictOrEmpty("redoSteps").found("active");
    effects_.add("redo of steps", guard_->redoes(),
                 on && !guard_->redoes() ? "adjustTimeStep no: steps are watched only"
                 : given                 ? std::string("controlDict/redoSteps: active ") + (on ? "yes" : "no")
                                         : std::string("default of controlDict/redoSteps") + (on ? "" : " with schemeSet paper"));
    bool const observed = observers_ && !observers_->empty();
    Dictionary const functions = dicts_.control.subDictOrEmpty("functions");
    effects_.add("function objects", observed,
                 observed     ? "controlDict/functions names " + enabledOf(functions)
                 : observers_ ? "none in controlDict/functions"
                              : "option -noFunctionObjects");
    effects_.print(info());
    if (!solids_ || !solids_->contacts()) return;
    std::vector<RigidBody*> pointers;
    for (auto const& body : bodies_) pointers.push_back(body.get());
    solids_->contacts()->report(info(), pointers);
    info() << std::endl;
}

void Scene::listFluidEffects()
{
    bool const on = fluid_ != nullptr;
    effects_.add("fluid", on,
                 on ? "constant/transportProperties gives rho " + shortNumber(fluid_->fluid().density()) + " kg/m3"
                    : "no constant/transportProperties");
    if (!on) return;
    Fluid const& fluid = fluid_->fluid();
    Dictionary const viscosity = dicts_.schemes.value_or(Dictionary()).subDictOrEmpty("viscositySchemes");
    effects_.add("viscosity", fluid.viscosity() != nullptr,
                 fluid.viscosity() ? std::string(fluid.viscosity()->name()) + " for nu " + shortNumber(fluid.nu()) + " m2/s, " +
                                         entryOf(dicts_.schemes, "viscositySchemes", "type")
                                   : Viscosity::whyAbsent(viscosity, dicts_.lattice, fluid.nu(), timeStep_->largest()));
    listSchemes();
}

void Scene::listSchemes()
{
    Fluid const& fluid = fluid_->fluid();
    PressureSource const& source = fluid_->source();
    Dictionary const all = dicts_.schemes.value_or(Dictionary());
    auto const add = [&](std::string const& name, bool on, std::string const& group, std::string const& key) {
        effects_.add(name, on, entryOf(dicts_.schemes, group, key));
    };
    if (fluid_->periodic()) effects_.add("periodic box", true, "mpsSchemes/cyclic");
    add("boundary labelling", !fluid_->labeller().needsAllWalls(), "boundarySchemes", "labelling");
    bool const corrected = GradientScheme::readName(all.subDictOrEmpty("gradSchemes"), readSchemeSet(all)) != "symmetric";
    add("corrected gradient", corrected, "gradSchemes", "grad(p)");
    add("corrected divergence", source.corrected(), "sourceSchemes", "divergence");
    add(source.balanced() ? "balanced density" : "smooth density", source.smooth(), "sourceSchemes", "density");
    bool const relaxes = source.relaxationTime() > 0;
    effects_.add("relaxation of density", relaxes,
                 (relaxes ? "within " + shortNumber(source.relaxationTime()) + " s, " : std::string()) + relaxationOf(dicts_.schemes));
    add("surface half a spacing off", fluid_->givesSurfacePressure(), "freeSurfaceSchemes", "pressure");
    add("damping of ripples", fluid.dampsSurface(), "freeSurfaceSchemes", "damping");
    add("velocity damping", fluid.velocityDamping() != nullptr, "velocityDamping", "type");
    add("collision", fluid.collision() != nullptr, "collisionSchemes", "type");
    if (fluid.collision()) add("collision along normals", fluid.collision()->alongNormal(), "collisionSchemes", "walls");
    add("shifting", fluid.shifting() != nullptr, "shiftingSchemes", "type");
    add("limit of displacements", fluid.limitsDisplacement(), "limiters", "displacement");
    add("clamp of pressures", fluid.negativePressure() != NegativePressure::Keep, "limiters", "negativePressure");
}

void Scene::listBodyEffects()
{
    bool const on = solids_ != nullptr;
    auto const nameOf = [](auto const& body) { return body->name(); };
    effects_.add("rigid bodies", on,
                 on ? "constant/rigidBodyProperties names " + listed(bodies_, nameOf) : "no constant/rigidBodyProperties");
    if (!on) return;
    bool const contact = solids_->contacts() != nullptr;
    effects_.add("contact", contact, contact ? "constant/contactProperties is there, and bodies" : "no constant/contactProperties");
    for (FluidBodyCoupling const& coupling : solids_->couplings())
        effects_.add("coupling of " + coupling.body().name(), true, std::string("fluid and body are there; ") + coupling.modeName());
}

} // namespace mpsDem

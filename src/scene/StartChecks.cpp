#include "scene/StartChecks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "bodies/RigidBody.h"
#include "boundaries/BoundaryRows.h"
#include "core/Errors.h"
#include "core/Log.h"
#include "scene/BodyReader.h"
#include "scene/GeometryReader.h"
#include "scene/InputFingerprint.h"
#include "scene/SavedGeometry.h"

namespace mpsDem {

namespace {

/// Share of a size by which lengths may differ, and of a value by which values may.
constexpr Real same = 1e-9;
char const* const radiusBlock = "walls/kernelRadius";

/// No step was taken from it: setParticles made it.
bool isInitial(State const& start) { return !start.has("time/lastDt"); }

std::string const& remedyFor(State const& start)
{
    static std::string const atStart = "what it was when setParticles was run, or run setParticles again";
    static std::string const later = "what it was when the run began, or a new run: setParticles -overwrite";
    return isInitial(start) ? atStart : later;
}

std::string text(Vector const& v)
{
    std::ostringstream out;
    out << '(' << v.x() << ' ' << v.y() << ' ' << v.z() << ')';
    return out.str();
}

Real sizeOf(std::vector<Vector> const& points)
{
    Real size = 0;
    for (Vector const& point : points) size = std::max(size, (point - points.front()).norm());
    return size;
}

/// What differs between two chains of corners; empty where nothing does.
std::string difference(std::vector<Vector> const& now, std::vector<Vector> const& saved)
{
    if (now.size() != saved.size())
        return "it has " + std::to_string(now.size()) + " corners, in the saved state " + std::to_string(saved.size());
    Real const allowed = same * sizeOf(saved);
    for (std::size_t k = 0; k < now.size(); ++k)
        if (!((now[k] - saved[k]).norm() <= allowed))
            return "corner " + std::to_string(k + 1) + " lies at " + text(now[k]) + " m, in the saved state at " + text(saved[k]) + " m";
    return {};
}

/// A body as the dictionary gives it today, beside what the state has.
class BodyCheck
{
public:
    BodyCheck(RigidBody const& body, BodyShape const& shape, Dictionary const& dict, State const& start)
        : body_(body),
          shape_(shape),
          dict_(dict),
          start_(start),
          root_("body/" + body.name() + "/")
    {
        body.save(now_);
        size_ = sizeOf(shape.outline.points());
    }

    void requireSame() const
    {
        requireSameShape();
        if (start_.has(root_ + "massProperties")) requireSameMass();
        if (isInitial(start_)) requireSameStart();
    }

private:
    void requireSameShape() const
    {
        BodyOutline const saved = loadOutline(start_, body_.name());
        std::string differs = difference(outlineInBodyAxes(shape_, body_).points(), saved.outline.points());
        if (differs.empty() && (shape_.radius > 0) != (saved.radius > 0)) differs = "a disc or ball is no polygon";
        require(differs.empty(), shape_.where,
                "body \"" + body_.name() + "\" has another shape or centre of mass than in the saved state: in body axes " + differs,
                remedyFor(start_));
        if (!start_.has(root_ + "referenceCentre")) return; // of an older version
        Vector const now = body_.massProperties().centreOfMass, then = start_.vector(root_ + "referenceCentre");
        require((now - then).norm() <= same * size_, shape_.where,
                "body \"" + body_.name() + "\" has its centre of mass at " + text(now) + " m, in the saved state it began at " +
                    text(then) + " m",
                remedyFor(start_));
    }

    void requireSameMass() const
    {
        State::Reals const now = now_.reals(root_ + "massProperties"), saved = start_.reals(root_ + "massProperties");
        Real off = 0, largest = 0; // of the inertia
        for (std::size_t k = 1; k < std::min(now.size(), saved.size()); ++k)
        {
            off = std::max(off, std::abs(now[k] - saved[k]));
            largest = std::max(largest, std::abs(saved[k]));
        }
        bool const sameMass = std::abs(now[0] - saved[0]) <= same * saved[0];
        if (now.size() == saved.size() && sameMass && off <= same * largest) return;
        std::string const what = sameMass ? "the moment of inertia of body \"" + body_.name() + "\" is not that of the saved state"
                                          : "the mass of body \"" + body_.name() + "\" is " + shortNumber(now[0]) +
                                                " kg, in the saved state " + shortNumber(saved[0]) + " kg";
        std::string const key = !sameMass ? (dict_.found("mass") ? "mass" : "density") : "momentOfInertia";
        require(!isInitial(start_), dict_.where(key), what, remedyFor(start_));
        warn(dict_.where(key).str() + ": " + what + "; the run goes on with that of the dictionary");
    }

    /// Pose and motion are read from the state alone: what the dictionary says about them must be what setParticles read.
    void requireSameStart() const
    {
        Real const turn = largestChange("orientation");
        require(largestChange("centre") <= same * size_ && turn <= same, dict_.where(turn > same ? "orientation" : "shape"),
                "body \"" + body_.name() + "\" stands at " + text(body_.centre()) + " m, in the saved state at " +
                    text(start_.vector(root_ + "centre")) + " m" + (turn > same ? ", or is turned" : ""),
                remedyFor(start_));
        std::string const key = dict_.found("velocity") ? "velocity" : dict_.found("angularVelocity") ? "angularVelocity" : "";
        bool const sameMotion = closeIn("motion") && closeIn("releaseVelocity");
        require(sameMotion, dict_.where(key), "body \"" + body_.name() + "\" begins with another velocity than in the saved state",
                remedyFor(start_));
        require(now_.integers(root_ + "releasedLocked") == start_.integers(root_ + "releasedLocked"), dict_.where("releaseTime"),
                "body \"" + body_.name() + "\" is held at the start and not in the saved state, or the other way round", remedyFor(start_));
    }

    [[nodiscard]] Real largestChange(std::string const& block) const
    {
        State::Reals const now = now_.reals(root_ + block), saved = start_.reals(root_ + block);
        if (now.size() != saved.size()) return std::numeric_limits<Real>::infinity();
        Real change = 0;
        for (std::size_t k = 0; k < now.size(); ++k) change = std::max(change, std::abs(now[k] - saved[k]));
        return change;
    }

    [[nodiscard]] bool closeIn(std::string const& block) const
    {
        Real largest = 0;
        for (Real const value : start_.reals(root_ + block)) largest = std::max(largest, std::abs(value));
        return largestChange(block) <= same * largest;
    }

    RigidBody const& body_;
    BodyShape const& shape_;
    Dictionary dict_;
    State const& start_;
    std::string root_;
    State now_;
    Real size_ = 0;
};

bool hasFluid(State const& start)
{
    if (!start.has("particles/type")) return false;
    auto const& types = start.integers("particles/type");
    return std::find(types.begin(), types.end(), static_cast<std::int64_t>(ParticleType::Fluid)) != types.end();
}

bool hasBodies(State const& start)
{
    return std::any_of(start.blocks().begin(), start.blocks().end(),
                       [](auto const& block) { return block.first.starts_with("body/") && block.first.ends_with("/index"); });
}

void requireFile(bool there, std::string const& file, std::string const& what, State const& start)
{
    require(there, Location{file, 0, {}}, "the file is missing, but the saved state has " + what, remedyFor(start));
}

/// The unit normal of the first piece: tells on which side the fluid lies.
Vector firstNormal(Surface const& surface)
{
    return surface.flat() ? surface.line().segments().front().normal : surface.triangles().triangles().front().normal;
}

void requireSameWall(WallDefinition const& wall, Surface const& saved)
{
    Surface const& now = wall.surface;
    std::string differs = difference(now.points(), saved.points());
    if (differs.empty() && now.closed() != saved.closed()) differs = "it is closed on one side only";
    if (differs.empty() && (firstNormal(now) - firstNormal(saved)).norm() > same) differs = "the fluid lies on its other side";
    require(differs.empty() && now.name() == saved.name(), wall.where,
            "wall \"" + now.name() + "\" is not that of the saved state" +
                (now.name() != saved.name() ? ", \"" + saved.name() + "\"" : ": " + differs),
            "what it was when setParticles was run, or run setParticles again");
}

} // namespace

void requireSameScene(Dictionary const* transport, Dictionary const* bodies, State const& start, GeometryContext const& context)
{
    if (!transport) requireFile(!hasFluid(start), "constant/transportProperties", "fluid", start);
    if (!bodies)
    {
        requireFile(!hasBodies(start), "constant/rigidBodyProperties", "rigid bodies", start);
        return;
    }
    std::vector<BodyShape> const shapes = readBodyShapes(*bodies, context);
    auto const made = readBodies(*bodies, start, context); // names and order are those of the state
    auto const fresh = readBodies(*bodies, context, start.real("time/value"));
    for (std::size_t k = 0; k < made.size(); ++k)
        BodyCheck(*fresh[k], shapes[k], bodies->subDict("bodies").subDict(shapes[k].name), start).requireSame();
}

void requireSameWalls(CaseFolder const& caseFolder, std::string const& fingerprint, State const& start, Lattice const& lattice)
{
    for (std::string const& file : changedSince(caseFolder, fingerprint))
    {
        bool const readByRun = std::find(runInput().begin(), runInput().end(), file) != runInput().end();
        auto const dict = readByRun ? std::nullopt : caseFolder.readIfPresent(file);
        if (!dict) continue;
        std::vector<WallDefinition> const walls = readWalls(*dict, {lattice, caseFolder.root()}, largestKernelRadius(caseFolder));
        std::vector<Surface> const saved = loadSurfaces(start);
        require(walls.size() == saved.size(), dict->where("geometry"),
                std::to_string(walls.size()) + " walls, but the saved state has " + std::to_string(saved.size()), remedyFor(start));
        for (std::size_t k = 0; k < walls.size(); ++k) requireSameWall(walls[k], saved[k]);
    }
}

void requireSameLattice(State const& start, Lattice const& now)
{
    std::optional<Lattice> const made = ParticleSet::savedLattice(start);
    auto const same = [&](bool equal, std::string const& key, std::string const& what) {
        require(equal, Location{"constant/particleProperties", 0, key}, what, remedyFor(start));
    };
    require(made.has_value(), Location{"constant/particleProperties", 0, {}},
            "the saved state does not tell its spacing, it is of an older version", "a new state: setParticles -overwrite");
    same(now.dimensions == made->dimensions, "dimensions", "the particles are those of a " + std::to_string(made->dimensions) + "-D case");
    same(now.spacing == made->spacing, "spacing",
         "spacing " + shortNumber(now.spacing) + " m does not fit the particles, made for " + shortNumber(made->spacing) + " m");
    same(now.dimensions == 3 || now.thickness == made->thickness, "thickness",
         "thickness " + shortNumber(now.thickness) + " m does not fit the particles, made for " + shortNumber(made->thickness) + " m");
}

void requireDeepWalls(Dictionary const* mpsSchemes, State const& start, Lattice const& lattice)
{
    std::optional<Real> const made = loadKernelRadius(start);
    if (!made || !mpsSchemes) return;
    Real const now = readRadii(*mpsSchemes, lattice.spacing).largest() / lattice.spacing;
    require(ghostRowsFor(now) <= ghostRowsFor(*made), mpsSchemes->where("kernel"),
            "the effective radius of " + shortNumber(now) + " spacings reaches through the rows of wall particles, made for " +
                shortNumber(*made),
            remedyFor(start));
}

void saveKernelRadius(State& state, std::optional<Real> overSpacing)
{
    if (overSpacing) state.set(radiusBlock, *overSpacing);
}

std::optional<Real> loadKernelRadius(State const& state)
{
    return state.has(radiusBlock) ? std::optional<Real>(state.real(radiusBlock)) : std::nullopt;
}

} // namespace mpsDem

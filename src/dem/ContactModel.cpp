#include "dem/ContactModel.h"

#include <algorithm>
#include <sstream>

#include "core/Log.h"
#include "core/OnceLog.h"
#include "dem/MeshSurface.h"
#include "dem/PolylineSurface.h"
#include "dem/SimpleSurfaces.h"

namespace mpsDem {

namespace {

constexpr Real refusedOverlap = 0.3;
constexpr Real noticedOverlap = 0.05;

std::shared_ptr<ContactSurface const> surfaceOf(ContactShape const& shape, Real spacing)
{
    if (shape.radius) return std::make_shared<DiscSurface>(*shape.radius);
    if (shape.skin) return std::make_shared<MeshSurface>(*shape.skin, spacing);
    return std::make_shared<PolylineSurface>(shape.outline, spacing);
}

std::size_t bodyNamed(Dictionary const& dict, std::span<RigidBody* const> bodies)
{
    auto const name = dict.get<std::string>("body");
    std::vector<std::string> names;
    for (std::size_t i = 0; i < bodies.size(); ++i)
    {
        if (bodies[i]->name() == name) return i;
        names.push_back(bodies[i]->name());
    }
    throw CaseError(ExitCode::BadInput, dict.where("body"), "body \"" + name + "\" is not known", knownWords("bodies", name, names));
}

} // namespace

std::vector<RestingSurface> restingSurfaces(std::vector<Polyline> const& lines, Real spacing)
{
    std::vector<RestingSurface> walls;
    for (Polyline const& line : lines) walls.push_back({line.name(), std::make_shared<PolylineSurface>(line, spacing, lines)});
    return walls;
}

std::vector<RestingSurface> restingSurfaces(std::vector<TriSurface> const& surfaces, Real spacing)
{
    std::vector<RestingSurface> walls;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        walls.push_back({surfaces[i].name(), std::make_shared<MeshSurface>(surfaces, i, spacing)});
    return walls;
}

ContactModel::ContactModel(Dictionary const& contactProperties, Real spacing, Real thickness, std::vector<Polyline> const& surfaces,
                           std::span<RigidBody* const> bodies, std::vector<ContactShape> const& shapes)
    : ContactModel(contactProperties, spacing, thickness, restingSurfaces(surfaces, spacing), bodies, shapes)
{}

ContactModel::ContactModel(Dictionary const& contactProperties, Real spacing, std::vector<TriSurface> const& surfaces,
                           std::span<RigidBody* const> bodies, std::vector<ContactShape> const& shapes)
    : ContactModel(contactProperties, spacing, spacing, restingSurfaces(surfaces, spacing), bodies, shapes)
{}

ContactModel::ContactModel(Dictionary const& contactProperties, Real spacing, Real thickness, std::vector<RestingSurface> const& surfaces,
                           std::span<RigidBody* const> bodies, std::vector<ContactShape> const& shapes)
    : spacing_(spacing),
      thickness_(thickness)
{
    expect(bodies.size() == shapes.size(), "one contact shape a body");
    common_ = ContactProperties::readCommon(contactProperties);
    collisionResolutionSteps_ = contactProperties.getInRangeOr("collisionResolutionSteps", 32, 20, 10000);
    for (RestingSurface const& wall : surfaces) targets_.push_back({wall.name, -1, wall.surface});
    for (std::size_t i = 0; i < bodies.size(); ++i) addBody(shapes[i], *bodies[i]);
    readPairs(contactProperties);
    addStoppers(contactProperties.subDictOrEmpty("stoppers"), bodies);
    sums_.resize(bodies.size());
    search(bodies, 0);
    checkStart(bodies);
}

void ContactModel::addBody(ContactShape const& shape, RigidBody const& body)
{
    targets_.push_back({body.name(), static_cast<int>(points_.size()), surfaceOf(shape, spacing_)});
    points_.push_back(std::make_shared<ContactPointSet>(shape, spacing_, thickness_));
    disc_.push_back(shape.radius.has_value());
    masses_.push_back(body.mass());
    Box box;
    Real reach = 0;
    auto const add = [&](Vector const& r, Real radius) {
        box.add(r - Vector::Constant(radius));
        box.add(r + Vector::Constant(radius));
        reach = std::max(reach, r.norm() + radius);
    };
    for (ContactPoint const& point : points_.back()->points()) add(point.centre, point.radius);
    for (auto const& segment : shape.outline.segments()) add(segment.a, 0);
    if (shape.skin)
        for (Vector const& r : shape.skin->points()) add(r, 0);
    broadPhase_.add(box, reach);
}

void ContactModel::addPair(Key const& key, std::size_t body, Target const& target, ContactProperties const& properties)
{
    PairLoad load{masses_[body], points_[body]->largestSide(), spacing_, thickness_, disc_[body]};
    if (target.body >= 0)
    {
        auto const other = static_cast<std::size_t>(target.body);
        load.mass = std::max(load.mass, masses_[other]);
        load.largestSide = std::min(load.largestSide, points_[other]->largestSide());
        load.disc = load.disc || disc_[other];
    }
    ContactMaterial const material = contactMaterial(properties, load, target.body < 0 ? 1 : 0.5);
    std::shared_ptr<ContactLaw const> const law = contactLaws().make(properties.law, properties.where, material);
    auto const place = static_cast<std::ptrdiff_t>(find(key));
    keys_.insert(keys_.begin() + place, key);
    pairs_.emplace(pairs_.begin() + place, ContactPair::Parts{this->target(body).name + ":" + target.name, body, points_[body], target.body,
                                                              target.surface, law, properties.maxOverlap * spacing_});
    properties_.insert(properties_.begin() + place, properties);
    materials_.insert(materials_.begin() + place, material);
}

void ContactModel::addStoppers(Dictionary const& stoppers, std::span<RigidBody* const> bodies)
{
    ContactProperties defaults = common_;
    int number = 0;
    defaults.mu = 0;
    defaults.e = 0.1;
    for (std::string const& name : stoppers.dictKeys())
    {
        Dictionary const dict = stoppers.subDict(name);
        std::string const type = dict.getWord("type", {"stopper", "latch"}, "types of stopper");
        std::size_t const body = bodyNamed(dict, bodies);
        auto const point = dict.get<Vector>("point");
        auto const normal = dict.get<Vector>("normal");
        require(normal.norm() > 0, dict.where("normal"), "normal of stopper \"" + name + "\" has no length", "any vector but zero");
        if (type == "latch")
            latches_.emplace_back(name, body, point, normal);
        else
            addPair({static_cast<int>(bodies.size()), number++}, body, {name, -1, std::make_shared<PlaneSurface>(point, normal)},
                    ContactProperties::read(dict, defaults));
    }
}

void ContactModel::checkStart(std::span<RigidBody* const> bodies) const
{
    for (ContactPair const& pair : pairs_)
    {
        Real const overlap = pair.overlapNow(bodies);
        if (overlap <= noticedOverlap * spacing_) continue;
        std::ostringstream text;
        text << "contact " << pair.name() << " overlaps by " << overlap << " m at the start, " << overlap / spacing_ << " spacings";
        require(overlap <= refusedOverlap * spacing_, {}, text.str(), "at most 0.3 spacings: move the body off the surface");
        warn(text.str());
    }
}

void ContactModel::checkOverlap(std::span<RigidBody* const> bodies) const
{
    for (std::size_t const active : active_)
    {
        ContactPair const& pair = pairs_[active];
        Real const overlap = pair.maxOverlap();
        if (overlap <= noticedOverlap * spacing_) continue;
        std::ostringstream text;
        Vector const& centre = bodies[pair.parts().body]->centre();
        text << "contact " << pair.name() << " overlaps by " << overlap / spacing_ << " spacings, centre of body at (" << centre.x() << ' '
             << centre.y() << ' ' << centre.z() << ")";
        if (!(overlap <= refusedOverlap * spacing_))
            throw CaseError(ExitCode::Solver, text.str(),
                            "at most 0.3 spacings: lower maxOverlap or raise impactSpeed in contactProperties");
        warnSeldom(text.str(), points_.size() > fewBodies ? "overlap of contacts" : "overlap of contact " + pair.name());
    }
}

} // namespace mpsDem

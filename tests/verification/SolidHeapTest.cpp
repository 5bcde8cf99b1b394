// Many bodies: the cost of contact grows with the bodies that are near one another, not with all pairs; the order and time at which pairs
// are made and looked for does not change a bit.

#include "core/Log.h"
#include "core/State.h"
#include "support/SolidScene.h"

namespace mpsDem::test {

namespace {

constexpr Real side = 0.1;

/// Blocks in columns of five, turned a little each, falling on a floor.
std::unique_ptr<SolidScene> falling(int count)
{
    auto scene = std::make_unique<SolidScene>();
    scene->gravity = Vector(0, 0, -9.81);
    scene->spacing = 0.05;
    scene->walls = {floorMesh(10)};
    int const columns = (count + 4) / 5;
    int const row = static_cast<int>(std::ceil(std::sqrt(columns)));
    for (int i = 0; i < count; ++i)
    {
        int const column = i / 5;
        Vector const place(0.14 * (column % row) + 0.004 * (i % 3), 0.14 * (column / row) - 0.003 * (i % 2), 0.07 + 0.135 * (i % 5));
        scene->addCuboid("block" + std::to_string(i), Vector(side, side, side), 1500, place,
                         Quaternion(Eigen::AngleAxisd(0.03 * (i % 7), Vector(1, 2, i % 4).normalized())));
    }
    for (RigidBody* block : scene->pointers) block->setVelocity({0, 0, -0.3 * block->centre().z() / side}, Vector::Zero());
    scene->build("mu 0.4; e 0.2; impactSpeed 1;");
    return scene;
}

/// No block has sunk in, and none is faster than a bound [m/s].
void expectOnTheFloor(SolidScene const& scene, std::string const& after, Real bound)
{
    Real lowest = 1, fastest = 0;
    for (RigidBody const* block : scene.pointers)
    {
        lowest = std::min(lowest, block->centre().z());
        fastest = std::max(fastest, block->velocity().norm());
    }
    expectBetween("fifty blocks, lowest centre / half side", lowest / (side / 2), 0.98, 1.8);
    expectBelow("fifty blocks, fastest after " + after, fastest, bound);
}

/// Largest values over a fall.
struct Fall
{
    SolidScene& scene;
    Real scale;                  ///< Of energies [J].
    Real start = scene.energy(); ///< [J]
    Real gained = 0;             ///< Energy above that of the start, over scale.
    Real overlap = 0;            ///< [spacings]
    std::size_t contacts = 0;

    Fall(SolidScene& of, Real energy) : scene(of), scale(energy) {}

    [[nodiscard]] Real change() const { return (scene.energy() - start) / scale; }

    void run(int steps)
    {
        for (int i = 0; i < steps; ++i)
        {
            scene.step(4e-3);
            gained = std::max(gained, change());
            overlap = std::max(overlap, scene.contact->maxOverlap() / scene.spacing);
            contacts = std::max(contacts, scene.contact->contactCount());
        }
    }
};

} // namespace

TEST(SolidHeap, costGrowsWithContacts)
{
    struct Cost
    {
        Real contacts, pairs, points, boxes;
    };
    auto const cost = [](int count) {
        auto scene = falling(count);
        Cost sum{0, 0, 0, 0};
        for (int i = 0; i < 20; ++i)
        {
            scene->step(2e-3);
            ContactModel::Work const work = scene->contact->work();
            sum.contacts += static_cast<Real>(scene->contact->contactCount());
            sum.pairs += static_cast<Real>(work.pairs);
            sum.points += static_cast<Real>(work.points);
            sum.boxes += static_cast<Real>(work.boxes);
        }
        EXPECT_LT(scene->contact->pairs().size(), static_cast<std::size_t>(30 * count)); // not count^2
        return sum;
    };
    Cost const few = cost(50), more = cost(100), many = cost(200);
    expectBetween("falling blocks, contacts of 100 / 50", more.contacts / few.contacts, 1.5, 2.5);
    for (auto const& [name, part] : {std::pair("pairs", &Cost::pairs), std::pair("points", &Cost::points)})
    {
        expectBetween(std::string("falling blocks, ") + name + " per contact, 100 / 50",
                      (more.*part / more.contacts) / (few.*part / few.contacts), 0.7, 1.3);
        expectBetween(std::string("falling blocks, ") + name + " per contact, 200 / 50",
                      (many.*part / many.contacts) / (few.*part / few.contacts), 0.7, 1.3);
    }
    expectBelow("falling blocks, comparisons of boxes per fluid step and block, 200", many.boxes / 20 / 200, 100);
}

// Fifty blocks fall on the floor and on one another: no energy from nowhere, none lost without heat, nothing sinks in. The overlap is what the
// stiffness for impactSpeed 1 allows at 2.5 m/s: 0.055 spacings.
TEST(SolidHeap, fiftyBlocksFall)
{
    muteLog(true);
    auto scene = falling(50);
    Fall fall(*scene, 50 * 1.5 * 9.81 * 0.3 + scene->kineticEnergy());
    fall.run(50);
    muteLog(false);
    EXPECT_GT(fall.contacts, 500u);
    expectBelow("fifty blocks, largest gain of energy, relative", fall.gained, 1e-3);
    expectBelow("fifty blocks, energy budget, relative", fall.change(), 1e-2);
    expectBelow("fifty blocks, largest overlap / spacing", fall.overlap, 0.06);
    expectOnTheFloor(*scene, "0.2 s [m/s]; 2.5 before", 1);
}

// Overlap in the first 0.2 s 0.055 spacings with impactSpeed 1, 0.041 with 2.5, 0.023 with 5, in 150, 397, 766 sub-steps a fluid step and 3.0, 8.5,
// 17.4 s of processor time; 10 is refused (more than 2000 sub-steps). Until the heap lies still, with 1: 0.093.
TEST(SolidHeap, DISABLED_fiftyBlocksSinkInByAHundredth)
{
    muteLog(true);
    auto scene = falling(50);
    Fall fall(*scene, 1);
    fall.run(50);
    muteLog(false);
    expectBelow("fifty blocks, largest overlap / spacing", fall.overlap, 0.01);
}

// Fifty blocks fall, and lie still on one another in the end, without energy from nowhere.
TEST(SolidHeapGate, fiftyBlocksComeToRest)
{
    auto scene = falling(50);
    Fall fall(*scene, 50 * 1.5 * 9.81 * 0.25);
    fall.run(400);
    expectBelow("fifty blocks, largest gain of energy / (weight x mean height)", fall.gained, 1e-3);
    expectBelow("fifty blocks, largest overlap / spacing", fall.overlap, 0.1); // see fiftyBlocksSinkInByAHundredth
    expectOnTheFloor(*scene, "1.6 s [m/s]", 0.03);
}

// Saved in the fall, loaded into a new scene in which other pairs exist, and undone and repeated: all go on bit by bit.
TEST(SolidHeap, goesOnBitwiseAfterLoadAndRestore)
{
    auto whole = falling(20);
    for (int i = 0; i < 36; ++i) whole->step(2e-3);
    ASSERT_GT(whole->contact->contactCount(), 0u);
    State state;
    for (RigidBody const* body : whole->pointers) body->save(state);
    whole->contact->save(state);
    auto again = falling(20);
    for (RigidBody* body : again->pointers) body->load(state);
    again->contact->load(state);
    again->time = whole->time;
    auto const same = [&] {
        for (std::size_t i = 0; i < 20; ++i)
        {
            EXPECT_EQ(whole->pointers[i]->centre(), again->pointers[i]->centre()) << i;
            EXPECT_EQ(whole->pointers[i]->angularVelocity(), again->pointers[i]->angularVelocity()) << i;
        }
        EXPECT_EQ(whole->contact->dissipatedEnergy(), again->contact->dissipatedEnergy());
        EXPECT_EQ(whole->contact->elasticEnergy(), again->contact->elasticEnergy());
    };
    same();
    ContactModel::History history;
    again->contact->copyTo(history);
    std::vector<RigidBody::Snapshot> snapshots;
    for (RigidBody const* body : again->pointers) snapshots.push_back(body->snapshot());
    Real const time = again->time;
    for (int i = 0; i < 10; ++i) again->step(3e-3); // makes pairs that the history does not know
    again->contact->restore(history);
    for (std::size_t i = 0; i < 20; ++i) again->pointers[i]->restore(snapshots[i]);
    again->time = time;
    for (int i = 0; i < 15; ++i)
    {
        whole->step(2e-3);
        again->step(2e-3);
    }
    same();
}

} // namespace mpsDem::test

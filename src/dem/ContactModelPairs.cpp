#include <algorithm>

#include "dem/ContactModel.h"

namespace mpsDem {

std::size_t ContactModel::find(Key const& key) const
{
    return static_cast<std::size_t>(std::lower_bound(keys_.begin(), keys_.end(), key) - keys_.begin());
}

bool ContactModel::betweenBodies(Key const& key) const
{
    std::size_t const surfaces = targets_.size() - points_.size();
    return static_cast<std::size_t>(key.first) < points_.size() && static_cast<std::size_t>(key.second) >= surfaces;
}

void ContactModel::readPairs(Dictionary const& contactProperties)
{
    std::size_t const surfaces = targets_.size() - points_.size();
    bool const named = contactProperties.found("pairs");
    for (std::size_t i = 0; i < points_.size(); ++i)
        for (std::size_t k = 0; k < targets_.size(); ++k)
        {
            if (k >= surfaces && (k - surfaces <= i || !named)) continue;
            auto const properties = ContactProperties::readPair(contactProperties, common_, target(i).name, targets_[k].name);
            Key const key(static_cast<int>(i), static_cast<int>(k));
            if (k < surfaces)
                addPair(key, i, targets_[k], properties);
            else
                named_.emplace(Key(static_cast<int>(i), static_cast<int>(k - surfaces)), properties);
        }
    if (points_.size() > fewBodies) return;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i)
        for (int k = 0; k < static_cast<int>(points_.size()); ++k)
            if (i != k) addBodyPair(i, k);
}

void ContactModel::addBodyPair(int first, int second)
{
    std::size_t const surfaces = targets_.size() - points_.size();
    Key const key(first, static_cast<int>(surfaces) + second);
    std::size_t const place = find(key);
    if (place < keys_.size() && keys_[place] == key) return;
    auto const properties = named_.find(std::minmax(first, second));
    addPair(key, static_cast<std::size_t>(first), target(static_cast<std::size_t>(second)),
            properties == named_.end() ? common_ : properties->second);
}

void ContactModel::search(std::span<RigidBody* const> bodies, Real dt)
{
    searchTime_ = dt;
    searched_ = true;
    margins_.clear();
    for (std::size_t i = 0; i < bodies.size(); ++i) margins_.push_back(mayTouch + speed(*bodies[i], i) * dt + 9.81 * dt * dt);
    broadPhase_.update(bodies, margins_);
    for (auto const& [a, b] : broadPhase_.pairs())
    {
        addBodyPair(a, b);
        addBodyPair(b, a);
    }
    for (std::size_t k = 0; k < pairs_.size(); ++k)
        if (betweenBodies(keys_[k])) pairs_[k].watchNothing();
    auto const watch = [&](int first, int second) {
        int const surfaces = static_cast<int>(targets_.size() - points_.size());
        Real const reach = margins_[static_cast<std::size_t>(first)] + margins_[static_cast<std::size_t>(second)];
        pairs_[find({first, surfaces + second})].watch(bodies, reach);
    };
    for (auto const& [a, b] : broadPhase_.pairs())
    {
        watch(a, b);
        watch(b, a);
    }
    active_.clear();
    for (std::size_t k = 0; k < pairs_.size(); ++k)
    {
        if (!betweenBodies(keys_[k])) pairs_[k].watch(bodies, margins_[pairs_[k].parts().body]);
        if (!pairs_[k].watched().empty() || !pairs_[k].contacts().empty()) active_.push_back(k);
    }
}

ContactModel::Work ContactModel::work() const
{
    Work work{broadPhase_.comparisons(), active_.size(), 0};
    for (std::size_t const k : active_) work.points += pairs_[k].watched().size();
    return work;
}

Real ContactModel::latchedEnergy() const
{
    Real sum = 0;
    for (Latch const& latch : latches_) sum += latch.energy();
    return sum;
}

void ContactModel::save(State& state) const
{
    State::Integers keys;
    for (std::size_t k = 0; k < pairs_.size(); ++k)
    {
        pairs_[k].save(state);
        if (betweenBodies(keys_[k])) keys.insert(keys.end(), {keys_[k].first, pairs_[k].parts().other});
    }
    state.set("contact/bodyPairs", std::span<std::int64_t const>(keys));
    for (Latch const& latch : latches_) latch.save(state);
    Real const energy[] = {dissipation_.normal, dissipation_.tangential};
    state.set("contact/dissipation", std::span<Real const>(energy));
    Real const step[] = {lastStep_};
    state.set("contact/lastStep", std::span<Real const>(step));
}

void ContactModel::load(State const& state)
{
    State::Integers const& saved = state.integers("contact/bodyPairs");
    int const count = static_cast<int>(points_.size());
    for (std::size_t k = 0; k + 1 < saved.size(); k += 2)
    {
        bool const known = std::min(saved[k], saved[k + 1]) >= 0 && std::max(saved[k], saved[k + 1]) < count && saved[k] != saved[k + 1];
        if (!known) throw CaseError(ExitCode::InputOutput, "contact/bodyPairs names a body that is not there", "numbers of bodies");
        addBodyPair(static_cast<int>(saved[k]), static_cast<int>(saved[k + 1]));
    }
    for (std::size_t k = 0; k < pairs_.size(); ++k)
        if (betweenBodies(keys_[k])) pairs_[k].restore({});
    for (std::size_t k = 0; k + 1 < saved.size(); k += 2)
        pairs_[find({static_cast<int>(saved[k]), static_cast<int>(saved[k + 1] + targets_.size() - points_.size())})].load(state);
    for (std::size_t k = 0; k < pairs_.size(); ++k)
        if (!betweenBodies(keys_[k])) pairs_[k].load(state);
    for (Latch& latch : latches_) latch.load(state);
    State::Reals const& energy = state.reals("contact/dissipation");
    if (energy.size() != 2) throw CaseError(ExitCode::InputOutput, "contact/dissipation has a wrong length", "2 numbers");
    dissipation_ = {energy[0], energy[1]};
    State::Reals const& step = state.reals("contact/lastStep");
    if (step.size() != 1) throw CaseError(ExitCode::InputOutput, "contact/lastStep has a wrong length", "1 number");
    lastStep_ = step[0];
    searched_ = false;
}

void ContactModel::copyTo(History& history) const
{
    history.keys = keys_;
    history.contacts.resize(pairs_.size());
    for (std::size_t k = 0; k < pairs_.size(); ++k)
    {
        history.contacts[k].reserve(pairs_[k].contacts().capacity());
        history.contacts[k] = pairs_[k].contacts();
    }
    history.latches = latches_;
    history.dissipation = dissipation_;
    history.lastStep = lastStep_;
}

void ContactModel::restore(History const& history)
{
    std::size_t old = 0; // pairs made since then had no contacts
    for (std::size_t k = 0; k < pairs_.size(); ++k)
    {
        bool const known = old < history.keys.size() && history.keys[old] == keys_[k];
        if (known)
            pairs_[k].restore(history.contacts[old++]);
        else
            pairs_[k].restore({});
    }
    latches_ = history.latches;
    dissipation_ = history.dissipation;
    lastStep_ = history.lastStep;
    searched_ = false;
}

std::size_t ContactModel::contactCount() const
{
    std::size_t count = 0;
    for (ContactPair const& pair : pairs_) count += pair.contacts().size();
    return count;
}

Real ContactModel::maxOverlap() const
{
    Real most = 0;
    for (ContactPair const& pair : pairs_) most = std::max(most, pair.maxOverlap());
    return most;
}

Real ContactModel::elasticEnergy() const
{
    Real sum = 0;
    for (ContactPair const& pair : pairs_) sum += pair.elasticEnergy();
    return sum;
}

} // namespace mpsDem

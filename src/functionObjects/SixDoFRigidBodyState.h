#pragma once

#include <vector>

#include "functionObjects/FunctionObject.h"
#include "io/TableFile.h"

namespace mpsDem {

/// `type sixDoFRigidBodyState;`: motion and loads of rigid bodies over time, one table a body, `<body>.dat`.
///
/// | columns | meaning | unit |
/// | x y z | centre of mass | m |
/// | dx dy dz | its displacement since the start | m |
/// | angle | turn since the start: 2-D about z in (-pi, pi], 3-D of the whole turn in [0, pi] | rad |
/// | q0 q1 q2 q3 | quaternion of the orientation, scalar first | - |
/// | Ux Uy Uz, omegax .. | velocity of the centre, angular velocity | m/s, rad/s |
/// | Fgravity x y z, Ffluid .., FcontactNormal .., FcontactTangential .., Frestraint .., Freaction .. | forces of the last step | N |
/// | Mgravity .. | their moments about the centre of mass | N m |
/// Contact, restraint and reaction are means over the sub-steps of the last step. The reaction is what constraints, a release time, a
/// latch or a prescribed motion had to add. The key `bodies` names those to write; default all.
class SixDoFRigidBodyState : public FunctionObject
{
public:
    SixDoFRigidBodyState(std::string const& name, Dictionary const& dict, RunContext const& context);

    void execute(Step const&) override {}
    void write(Step const& step) override;
    void report(std::ostream& os) const override;
    void save(State& state) const override;
    void load(State const& state) override;

private:
    struct Watched
    {
        RigidBody const& body;
        Vector centre; ///< At the start of the run.
        Quaternion orientation;
        TableFile table;
    };

    [[nodiscard]] Real angle(Watched const& watched) const;
    [[nodiscard]] std::string block(Watched const& watched) const;

    std::string name_;
    bool planar_;
    std::vector<Watched> watched_;
};

} // namespace mpsDem

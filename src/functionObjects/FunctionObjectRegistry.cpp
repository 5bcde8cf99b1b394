#include "functionObjects/ClosedVoids.h"
#include "functionObjects/ElevationMap.h"
#include "functionObjects/EnergyBudget.h"
#include "functionObjects/FieldMinMax.h"
#include "functionObjects/Forces.h"
#include "functionObjects/FreeSurfaceProfile.h"
#include "functionObjects/FunctionObject.h"
#include "functionObjects/InterfaceHeight.h"
#include "functionObjects/MomentumBudget.h"
#include "functionObjects/Observed.h"
#include "functionObjects/Probes.h"
#include "functionObjects/RunUp.h"
#include "functionObjects/SixDoFRigidBodyState.h"
#include "functionObjects/TimeInfo.h"

namespace mpsDem {

namespace {

template <class Object>
void add(FunctionObjectRegistry& all, std::string const& type)
{
    all.add(type, [](std::string const& name, Dictionary const& dict, RunContext const& context) -> std::unique_ptr<FunctionObject> {
        requireFileName(name, dict.where());
        return std::make_unique<Object>(name, dict, context);
    });
}

} // namespace

FunctionObjectRegistry& functionObjectRegistry()
{
    static FunctionObjectRegistry registry = [] {
        FunctionObjectRegistry all("function object", "function objects");
        add<ClosedVoids>(all, "closedVoids");
        add<ElevationMap>(all, "elevationMap");
        add<EnergyBudget>(all, "energyBudget");
        add<FieldMinMax>(all, "fieldMinMax");
        add<Forces>(all, "forces");
        add<FreeSurfaceProfile>(all, "freeSurfaceProfile");
        add<InterfaceHeight>(all, "interfaceHeight");
        add<MomentumBudget>(all, "momentumBudget");
        add<Probes>(all, "probes");
        add<RunUp>(all, "runUp");
        add<SixDoFRigidBodyState>(all, "sixDoFRigidBodyState");
        add<TimeInfo>(all, "timeInfo");
        return all;
    }();
    return registry;
}

} // namespace mpsDem

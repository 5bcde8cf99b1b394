#include "dem/ContactLaw.h"

#include "dem/HertzMindlin.h"
#include "dem/LinearSpringDashpot.h"

namespace mpsDem {

ContactLawRegistry contactLaws()
{
    ContactLawRegistry registry("contact law", "contact laws");
    registry.add("linearSpringDashpot", [](ContactMaterial const& m) { return std::make_unique<LinearSpringDashpot>(m); });
    registry.add("hertzMindlin", [](ContactMaterial const& m) { return std::make_unique<HertzMindlin>(m); });
    return registry;
}

} // namespace mpsDem

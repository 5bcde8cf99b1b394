#include "dem/ContactLaw.h"

#include "dem/HertzMindlin.h"
#include "dem/LinearSpringDashpot.h"

namespace mpsDem {

ContactLawRegistry& contactLaws()
{
    static ContactLawRegistry registry = [] {
        ContactLawRegistry all("contact law", "contact laws");
        all.add("linearSpringDashpot", [](ContactMaterial const& m) { return std::make_unique<LinearSpringDashpot>(m); });
        all.add("hertzMindlin", [](ContactMaterial const& m) { return std::make_unique<HertzMindlin>(m); });
        return all;
    }();
    return registry;
}

} // namespace mpsDem

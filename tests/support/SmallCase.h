#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "support/TemporaryFolder.h"

namespace mpsDem::test {

/// A case folder for tests: a wedge on a ramp in a small tank. Each file can be replaced.
class SmallCase
{
public:
    SmallCase()
    {
        write("system/controlDict", "endTime 1; deltaT 1e-3;");
        write("constant/particleProperties", "spacing 0.05; thickness 0.5;");
        write("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 -10 0);", "uniformDimensionedVectorField");
        write("constant/transportProperties", "nu 1e-6; rho 1000;");
        write("constant/rigidBodyProperties",
              "bodies { slide { shape { type polygon; points ((0.2 0.8 0) (0.6 0.4 0) (0.6 0.8 0)); } density 2000; } }");
        write("system/setParticlesDict", "geometry { bed { type polyline; points ((-0.2 1.2 0) (1 0 0) (2 0 0) (2 1.2 0)); } }\n"
                                         "regions ( boxToParticle { box (-0.2 0 0) (2 1 0); } );\n");
    }

    [[nodiscard]] std::filesystem::path root() const { return folder_.path(); }

    /// Replaces a dictionary; the header is put in front (three lines).
    void write(std::string const& file, std::string const& content, std::string const& headerClass = "dictionary") const
    {
        std::filesystem::create_directories((root() / file).parent_path());
        std::ofstream out(root() / file);
        out << "FoamFile { version 2.0; format ascii; class " << headerClass << "; object o; }\n\n\n" << content << '\n';
    }

    void remove(std::string const& file) const { std::filesystem::remove(root() / file); }

private:
    TemporaryFolder folder_;
};

} // namespace mpsDem::test

# The packages that mpsDem stands on. etc/tools/packages.txt names them as Debian does.

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(muparser REQUIRED)
find_package(Boost 1.74 REQUIRED COMPONENTS program_options)
find_package(VTK 9.1 REQUIRED COMPONENTS CommonCore CommonDataModel FiltersCore IOCore IOXML)
find_package(TrilinosMpsDem REQUIRED)

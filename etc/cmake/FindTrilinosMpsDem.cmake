# Makes the target mpsDem::trilinos: MueLu, Belos, Ifpack2 and Tpetra with MPI.
#
# From Trilinos 14 on each package exports <Package>::all_libs. Debian's Trilinos 13.2 does not, and its own package files ask for
# some twenty further development packages; headers and libraries are then looked up by name, which needs only those that are used.

# One header of Trilinos 13 declares a constructor in a way that C++20 forbids. A corrected copy in the build folder is included before
# everything else by the files that use Trilinos; the header's own include guard then keeps the original out.
function(makeTrilinosReadable)
  set(header "Teuchos_StandardParameterEntryValidators.hpp")
  file(READ "${TRILINOS_INCLUDE_DIR}/${header}" text)
  string(REPLACE "AbstractArrayValidator<ValidatorType, EntryType>();" "AbstractArrayValidator();" corrected "${text}")
  if(NOT corrected STREQUAL text)
    set(copy "${PROJECT_BINARY_DIR}/trilinos13/${header}")
    file(CONFIGURE OUTPUT "${copy}" CONTENT "#pragma GCC system_header\n@corrected@" @ONLY)
    set_property(GLOBAL PROPERTY mpsDemTrilinosOptions -include "${copy}")
  endif()
endfunction()

find_package(MPI REQUIRED COMPONENTS CXX)
add_library(mpsDem_trilinos INTERFACE)
add_library(mpsDem::trilinos ALIAS mpsDem_trilinos)

find_package(Trilinos 14 QUIET COMPONENTS Tpetra Belos Ifpack2 MueLu)
if(TARGET MueLu::all_libs)
  target_link_libraries(mpsDem_trilinos INTERFACE MueLu::all_libs Belos::all_libs Ifpack2::all_libs Tpetra::all_libs)
  set(TrilinosMpsDem_FOUND TRUE)
else()
  find_path(TRILINOS_INCLUDE_DIR MueLu_CreateTpetraPreconditioner.hpp PATH_SUFFIXES trilinos)
  set(trilinosVariables TRILINOS_INCLUDE_DIR)
  foreach(name IN ITEMS
      muelu-interface muelu ifpack2 belostpetra belos xpetra-sup xpetra tpetra kokkoskernels
      teuchoskokkoscompat teuchosnumerics teuchoscomm teuchosparameterlist teuchoscore kokkoscore)
    find_library(TRILINOS_${name} NAMES trilinos_${name} ${name})
    list(APPEND trilinosVariables TRILINOS_${name})
  endforeach()
  mark_as_advanced(${trilinosVariables})

  include(FindPackageHandleStandardArgs)
  find_package_handle_standard_args(TrilinosMpsDem REQUIRED_VARS ${trilinosVariables}
    REASON_FAILURE_MESSAGE "Allwmake installs the packages (etc/tools/packages.txt)")
  if(TrilinosMpsDem_FOUND)
    target_include_directories(mpsDem_trilinos SYSTEM INTERFACE "${TRILINOS_INCLUDE_DIR}")
    foreach(variable IN LISTS trilinosVariables)
      if(NOT variable STREQUAL "TRILINOS_INCLUDE_DIR")
        target_link_libraries(mpsDem_trilinos INTERFACE "${${variable}}")
      endif()
    endforeach()
    makeTrilinosReadable()
  endif()
endif()
target_link_libraries(mpsDem_trilinos INTERFACE MPI::MPI_CXX)

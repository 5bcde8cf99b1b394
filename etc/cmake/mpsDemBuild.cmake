# How everything of mpsDem is compiled: build type, warnings, places of the results, and the function that makes a library.

get_property(isMultiConfig GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if(NOT isMultiConfig AND NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, RelWithDebInfo or Debug" FORCE)
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# build/bin and build/lib look like an installed prefix. Run paths are relative, so that either may be moved.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/lib")
set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)
set(CMAKE_INSTALL_RPATH "$ORIGIN/../lib;$ORIGIN")
set(CMAKE_INSTALL_RPATH_USE_LINK_PATH ON)

# A library that uses a symbol of one it does not link is refused; one that is linked and not used is not loaded.
set(CMAKE_SHARED_LINKER_FLAGS "${CMAKE_SHARED_LINKER_FLAGS} -Wl,--as-needed")
set(CMAKE_EXE_LINKER_FLAGS "${CMAKE_EXE_LINKER_FLAGS} -Wl,--as-needed")
if(NOT MPSDEM_SANITIZE)
  set(CMAKE_SHARED_LINKER_FLAGS "${CMAKE_SHARED_LINKER_FLAGS} -Wl,--no-undefined")
endif()

# Programs are compiled as position-independent executables: theirs are headers of their own, worth it where there are many files.
function(mpsDemPrecompile target)
  get_target_property(type ${target} TYPE)
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources files)
  if(NOT MPSDEM_PRECOMPILED OR (type STREQUAL "EXECUTABLE" AND files LESS 5))
    return()
  elseif(type STREQUAL "EXECUTABLE" OR target STREQUAL "mpsDemPrecompiled")
    target_precompile_headers(${target} PRIVATE "${PROJECT_SOURCE_DIR}/etc/cmake/precompiled.h")
  else()
    target_precompile_headers(${target} REUSE_FROM mpsDemPrecompiled)
  endif()
endfunction()

# Warnings and code generation of one target. None of these flags changes a floating-point result, MPSDEM_NATIVE excepted.
function(mpsDemCompileOptions target)
  target_compile_features(${target} PRIVATE cxx_std_20)
  target_compile_definitions(${target} PRIVATE MPSDEM_VERSION="${PROJECT_VERSION}")
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wshadow -Wpedantic -Wconversion -Wno-sign-conversion
    -fno-math-errno
    $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-maybe-uninitialized>" # false alarms of g++ 12 at -O3 inside std::string
    "$<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${MPSDEM_PRECOMPILED}>>:-Wno-stringop-overflow;-Wno-array-bounds>" # the same, precompiled
    $<$<BOOL:${MPSDEM_WERROR}>:-Werror>
    $<$<BOOL:${MPSDEM_NATIVE}>:-march=native>)
  if(MPSDEM_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=address,undefined)
  endif()
  mpsDemPrecompile(${target})
endfunction()

# The headers of every file, compiled once for the libraries (position-independent code) and once for each program of tests.
if(MPSDEM_PRECOMPILED)
  file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/precompiled.cpp" CONTENT "// Compiled for its headers.\n" @ONLY)
  add_library(mpsDemPrecompiled OBJECT EXCLUDE_FROM_ALL "${PROJECT_BINARY_DIR}/precompiled.cpp")
  mpsDemCompileOptions(mpsDemPrecompiled)
  target_link_libraries(mpsDemPrecompiled PRIVATE Eigen3::Eigen)
endif()

# mpsDemLibrary(<folder> [USES <library>...] [PACKAGES <target>...])
#
# Makes the target mpsDem<Folder> (alias mpsDem::<folder>) from src/<folder>: a shared library, or an interface where the folder
# holds headers only. USES are the libraries of this project whose headers it may include; they must have been made before it, so
# the graph has no cycle. PACKAGES stay hidden in its translation units.
function(mpsDemLibrary folder)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;PACKAGES")
  string(SUBSTRING ${folder} 0 1 first)
  string(SUBSTRING ${folder} 1 -1 rest)
  string(TOUPPER ${first} first)
  set(target mpsDem${first}${rest})

  set(usedTargets "")
  foreach(used IN LISTS arg_USES)
    if(NOT TARGET mpsDem::${used})
      message(FATAL_ERROR "src/CMakeLists.txt: ${folder} uses ${used}, which is not known before it")
    endif()
    list(APPEND usedTargets mpsDem::${used})
  endforeach()

  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp")
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.h")
  if(sources)
    add_library(${target} SHARED ${sources} ${headers})
    set(scope PUBLIC)
    mpsDemCompileOptions(${target})
    foreach(package IN LISTS arg_PACKAGES)
      target_link_libraries(${target} PRIVATE ${package})
    endforeach()
    set_target_properties(${target} PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(mpsDem::${folder} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${folder})
  target_compile_features(${target} ${scope} cxx_std_20)
  target_include_directories(${target} ${scope}
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>" "$<INSTALL_INTERFACE:include/mpsDem>")
  target_link_libraries(${target} ${scope} ${usedTargets})

  install(TARGETS ${target} EXPORT mpsDemTargets LIBRARY DESTINATION lib ARCHIVE DESTINATION lib RUNTIME DESTINATION bin)
  install(DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/" DESTINATION include/mpsDem/${folder} FILES_MATCHING PATTERN "*.h")
endfunction()

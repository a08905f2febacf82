# Flags that every target of the project shares, and the two ways to add code: a room of the core
# and a test.

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 99)
set(CMAKE_C_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_C_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
    set(CMAKE_BUILD_TYPE Release)
endif()

find_program(MIEN_CCACHE ccache)
if(MIEN_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # Precompiled headers are cached only with these two slacknesses and -fpch-preprocess. Depend mode: a header
    # built over its predecessor would be preprocessed through that predecessor and the old one come back.
    set(CMAKE_CXX_COMPILER_LAUNCHER
        ${CMAKE_COMMAND} -E env CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros ${MIEN_CCACHE})
    set(CMAKE_C_COMPILER_LAUNCHER ${MIEN_CCACHE})
endif()

add_library(mien_flags INTERFACE)
# Eigen keeps the blocks of a product on the stack up to this size, two at a time; its 128 kB end a thread of 256 kB.
target_compile_definitions(mien_flags INTERFACE EIGEN_STACK_ALLOCATION_LIMIT=65536)
# A fit spends its time in two rooms and in loops of others (mien_compile_hot), which are compiled at -O3; at -O2 the
# rest is a sixth smaller and sooner compiled, and fits are not slower to be seen (tests/bench/README.md).
string(REPLACE "-O3" "-O2" CMAKE_CXX_FLAGS_RELEASE "${CMAKE_CXX_FLAGS_RELEASE}")
set(mien_hot_rooms spatial registration)
# Lines for debuggers, and with them the names of inner functions in the library (abi/CMakeLists.txt).
string(REGEX MATCH "(^| )-g" mien_release_has_lines "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE}")
if(mien_release_has_lines)
    set(mien_release_has_lines ON)
endif()
# The same bits from every compiler that fuses multiplications by default (abi/README.md).
target_compile_options(mien_flags INTERFACE
    -Wall -Wextra -Wshadow -ffp-contract=off $<$<CXX_COMPILER_ID:GNU>:-Wno-psabi -Wno-maybe-uninitialized>
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-gnu-unique -fpch-preprocess>
    # Containers give back blocks with their size, as GCC does, for the count of memory (abi/memory_count.cpp).
    $<$<COMPILE_LANG_AND_ID:CXX,Clang,AppleClang>:-fsized-deallocation>)
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Joined files hide from GCC that a class stands in a source file of its own.
    target_compile_options(mien_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wno-subobject-linkage>)
    # Twelve files at a time fill the compiler's heap: collecting garbage less often saves a twentieth of its time, for
    # 200 MB more.
    target_compile_options(mien_flags INTERFACE
        $<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-expand=300> $<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-heapsize=2000000>)
endif()
if(MIEN_WERROR)
    target_compile_options(mien_flags INTERFACE -Werror)
endif()
# Guards against what a bug could be used for (SECURITY.md); a sanitizer does its own.
if(MIEN_HARDEN AND UNIX AND NOT APPLE AND NOT MIEN_SANITIZE)
    target_compile_options(mien_flags INTERFACE -fstack-protector-strong
        $<$<CONFIG:Release,RelWithDebInfo,MinSizeRel>:-U_FORTIFY_SOURCE$<SEMICOLON>-D_FORTIFY_SOURCE=2>)
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
        target_compile_options(mien_flags INTERFACE -fcf-protection=full)
    elseif(CMAKE_SYSTEM_PROCESSOR STREQUAL "aarch64")
        target_compile_options(mien_flags INTERFACE -mbranch-protection=standard)
    endif()
    add_link_options(LINKER:-z,relro LINKER:-z,now LINKER:-z,noexecstack)
endif()
# The library and the command: a machine that has the C library has all they need.
if(MIEN_SELF_CONTAINED AND WIN32)
    add_link_options(-static)
elseif(MIEN_SELF_CONTAINED)
    add_link_options(-static-libgcc -static-libstdc++)
    include(CheckSymbolExists)
    check_symbol_exists(__GLIBC__ features.h MIEN_GLIBC)
    if(MIEN_GLIBC)
        add_library(mien_glibc OBJECT ${PROJECT_SOURCE_DIR}/cmake/glibc_2_28.c)
        target_compile_options(mien_glibc PRIVATE -fno-builtin -ffunction-sections)
        target_link_libraries(mien_glibc PRIVATE mien_flags)
    endif()
endif()
# mien_ship(TARGET): what goes into the prebuilt archives, which run with an older C library than the compiler's.
function(mien_ship target)
    if(TARGET mien_glibc)
        target_sources(${target} PRIVATE $<TARGET_OBJECTS:mien_glibc>)
        target_link_options(${target} PRIVATE -pthread)  # a library of its own before 2.34, behind the C++ library's
    endif()
endfunction()
if(MIEN_SANITIZE)
    add_compile_options(-fsanitize=${MIEN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
    add_link_options(-fsanitize=${MIEN_SANITIZE})
endif()

# What nearly every file of the core includes, and the decompositions that are compiled once. No absolute path: the
# precompiled header is then the same in every checkout, and so are the compiler cache's keys.
set(mien_common_headers <Eigen/Dense> <base/decompositions.hpp>
    <string> <vector> <functional> <memory> <map>)

# mien_compile_fast(TARGET): a program in which the compiler's time counts for more than its own. Unit tests link the core
# statically, so their copies of inline functions may take the place of the core's: they run as fast (measured), and
# the bits are the same, as the core compiles its products and decompositions once.
function(mien_compile_fast target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# mien_compile_hot(TARGET sources...): loops of a room that is not hot as a whole, without its precompiled header.
function(mien_compile_hot target)
    set_source_files_properties(${ARGN} TARGET_DIRECTORY ${target} PROPERTIES
        SKIP_PRECOMPILE_HEADERS ON SKIP_UNITY_BUILD_INCLUSION ON)
    set_property(SOURCE ${ARGN} TARGET_DIRECTORY ${target} APPEND PROPERTY COMPILE_OPTIONS $<$<CONFIG:Release>:-O3>)
endfunction()

# mien_room(NAME room ...): the static library mien_NAME from src/NAME/*.cpp, on top of the rooms given.
function(mien_room name)
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${name}/*.cpp)
    add_library(mien_${name} STATIC ${sources} ${PROJECT_SOURCE_DIR}/src/base/types.hpp)
    set_target_properties(mien_${name} PROPERTIES LINKER_LANGUAGE CXX)
    target_link_libraries(mien_${name} PRIVATE mien_flags)
    if(name IN_LIST mien_hot_rooms)
        target_compile_options(mien_${name} PRIVATE $<$<CONFIG:Release>:-O3>)
    endif()
    # GCC takes the level of optimisation from the precompiled header.
    if(name STREQUAL "base" OR name IN_LIST mien_hot_rooms)
        target_precompile_headers(mien_${name} PRIVATE ${mien_common_headers})
    else()
        target_precompile_headers(mien_${name} REUSE_FROM mien_base)
    endif()
    target_include_directories(mien_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
    foreach(room ${ARGN})
        target_link_libraries(mien_${name} PUBLIC mien_${room})
    endforeach()
endfunction()

# mien_unit_test(NAME libraries...): the GoogleTest program test_NAME from tests/unit/NAME/*.cpp.
function(mien_unit_test name)
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/unit/${name}/*.cpp)
    if(NOT sources)
        return()
    endif()
    add_executable(test_${name} ${sources})
    target_link_libraries(test_${name} PRIVATE mien_flags ${ARGN} GTest::gtest GTest::gtest_main)
    target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
    if(name STREQUAL "base")
        target_precompile_headers(test_base PRIVATE ${mien_common_headers} <gtest/gtest.h>)
    else()
        target_precompile_headers(test_${name} REUSE_FROM test_base)
    endif()
    # MIEN_SHARED_DATA: real and simulated scans that are not part of the project; tests that need them skip where
    # the folder is absent. Only the files that name it (or MIEN_SOURCE_DIR) are told, at configuration: the others'
    # command lines are the same in every checkout, so that the compiler's cache knows them.
    foreach(source ${sources})
        file(STRINGS ${source} asks_for_paths REGEX "MIEN_(SHARED_DATA|SOURCE_DIR)" LIMIT_COUNT 1)
        if(asks_for_paths)
            set_property(SOURCE ${source} APPEND PROPERTY COMPILE_DEFINITIONS
                MIEN_SHARED_DATA="${PROJECT_SOURCE_DIR}/../shared/data" MIEN_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
        endif()
    endforeach()
    mien_compile_fast(test_${name})
    add_test(NAME unit_${name} COMMAND test_${name})
endfunction()

# One function per kind of target, so that every module is built by the same rules.
include_guard(GLOBAL)
include(CMakeParseArguments)

# Warnings are errors, the language level is the same everywhere.
add_library(agv_build_rules INTERFACE)
target_compile_features(agv_build_rules INTERFACE cxx_std_23)
target_compile_options(agv_build_rules INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wnon-virtual-dtor -Woverloaded-virtual -Werror)
# g++ 12 at -O2 and -O3 reports false positives of these from inside the headers of Eigen 3.4 and, restrict, of its
# own std::string (GCC bug 105329).
target_compile_options(agv_build_rules INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-array-bounds -Wno-stringop-overflow -Wno-restrict>)
# libstdc++ 12's own std::stable_sort uses a function it calls deprecated; clang reports it at our call.
target_compile_options(agv_build_rules INTERFACE $<$<CXX_COMPILER_ID:Clang>:-Wno-deprecated-declarations>)
if(AGV_SANITIZE)
    list(JOIN AGV_SANITIZE "," agv_sanitizers)
    target_compile_options(agv_build_rules INTERFACE -fsanitize=${agv_sanitizers} -fno-omit-frame-pointer)
    target_link_options(agv_build_rules INTERFACE -fsanitize=${agv_sanitizers})
    if("undefined" IN_LIST AGV_SANITIZE)
        target_compile_options(agv_build_rules INTERFACE -fno-sanitize-recover=undefined)
    endif()
endif()
if(AGV_FUZZ)
    target_compile_options(agv_build_rules INTERFACE -fsanitize=fuzzer-no-link)
endif()

# agv_module(NAME SOURCES ... [USES module ...] [LIBRARIES target ...] [PRIVATE_LIBRARIES target ...] [QT])
# A module is a static library agv_NAME; its headers are included as "NAME/header.h". Without QT no Qt
# include directory reaches it and moc does not run.
function(agv_module name)
    cmake_parse_arguments(PARSE_ARGV 1 ARG "QT" "" "SOURCES;USES;LIBRARIES;PRIVATE_LIBRARIES")
    add_library(agv_${name} STATIC ${ARG_SOURCES})
    # Names in the unnamed namespaces of a module are its own: the presets release, core-only and asan compile its
    # sources in a few batches, because reading the headers of Qt, Eigen and the standard library takes most of the
    # time.
    set_target_properties(agv_${name} PROPERTIES UNITY_BUILD ${AGV_UNITY} UNITY_BUILD_BATCH_SIZE 10)
    add_library(agv::${name} ALIAS agv_${name})
    target_include_directories(agv_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
    list(TRANSFORM ARG_USES PREPEND agv_ OUTPUT_VARIABLE used)
    target_link_libraries(agv_${name} PUBLIC ${used} ${ARG_LIBRARIES}
        PRIVATE agv_build_rules ${ARG_PRIVATE_LIBRARIES})
    if(ARG_QT)
        set_target_properties(agv_${name} PROPERTIES AUTOMOC ON AUTOUIC ON AUTORCC ON
            AUTOUIC_SEARCH_PATHS ${PROJECT_SOURCE_DIR}/ui)
    endif()
endfunction()

# For sources that use the macros of Qt Test: those of Qt 6.8 convert a time to int in the test's own line. To be linked
# after agv_build_rules.
add_library(agv_qt_test_rules INTERFACE)
target_compile_options(agv_qt_test_rules INTERFACE -Wno-conversion)

# agv_test_rules(TARGET USES LIBRARIES): what every test program and library of test fixtures is built with.
function(agv_test_rules target uses libraries)
    target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/tests)
    list(TRANSFORM uses PREPEND agv_)
    target_link_libraries(${target} PUBLIC ${uses} ${libraries} PRIVATE agv_build_rules)
    # The code under test is optimised; optimising the tests themselves would double the time to build them.
    target_compile_options(${target} PRIVATE $<IF:$<BOOL:${AGV_SANITIZE}>,-O0,$<$<CONFIG:Release>:-O1>>)
    target_compile_definitions(${target} PRIVATE
        AGV_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data" AGV_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
        AGV_RECORDINGS="${PROJECT_SOURCE_DIR}/../shared/data")
endfunction()

# agv_test_library(NAME SOURCES ... USES module ... [LIBRARIES target ...]): fixtures that several Qt tests share,
# compiled once; linked as agv_NAME.
function(agv_test_library name)
    cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;USES;LIBRARIES")
    if(NOT AGV_TESTS)
        return()
    endif()
    add_library(agv_${name} STATIC ${ARG_SOURCES})
    set_target_properties(agv_${name} PROPERTIES AUTOMOC ON)
    agv_test_rules(agv_${name} "${ARG_USES}" "${ARG_LIBRARIES}")
    target_link_libraries(agv_${name} PRIVATE agv_qt_test_rules)
endfunction()

# agv_test(NAME SOURCES ... USES module ... [LIBRARIES target ...] [QT])
# Without QT: GoogleTest, each TEST is its own ctest entry. With QT: one Qt Test program with its own main
# (QTEST_MAIN or QTEST_GUILESS_MAIN), run on the offscreen platform.
function(agv_test name)
    cmake_parse_arguments(PARSE_ARGV 1 ARG "QT" "" "SOURCES;USES;LIBRARIES")
    if(NOT AGV_TESTS)
        return()
    endif()
    add_executable(test_${name} ${ARG_SOURCES})
    set_target_properties(test_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/test-programs)
    agv_test_rules(test_${name} "${ARG_USES}" "${ARG_LIBRARIES}")
    if(ARG_QT)
        # Only here: the Qt-free tests compile the same in every preset, so that a compiler cache serves them all.
        target_compile_definitions(test_${name} PRIVATE AGV_PROGRAM="${CMAKE_BINARY_DIR}/bin/agv-console")
        set_target_properties(test_${name} PROPERTIES AUTOMOC ON)
        target_link_libraries(test_${name} PRIVATE Qt6::Test agv_qt_test_rules)
        add_test(NAME ${name} COMMAND test_${name})
        set_tests_properties(${name} PROPERTIES ENVIRONMENT "QT_QPA_PLATFORM=offscreen;LANG=C.UTF-8")
    else()
        target_link_libraries(test_${name} PRIVATE GTest::gtest_main)
        # In batches, as the modules: the headers of GoogleTest and Eigen are most of the work. The fixtures are
        # in the unnamed namespaces of files that become one here, which g++ warns about.
        set_target_properties(test_${name} PROPERTIES UNITY_BUILD ${AGV_UNITY} UNITY_BUILD_BATCH_SIZE 8)
        target_compile_options(test_${name} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
        gtest_discover_tests(test_${name} TEST_PREFIX "${name}." DISCOVERY_TIMEOUT 60)
    endif()
endfunction()

# agv_benchmark(NAME SOURCES ... USES module ...): built by the target benchmarks, never run by ctest.
function(agv_benchmark name)
    cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;USES;LIBRARIES")
    if(NOT AGV_TESTS)
        return()
    endif()
    add_executable(bench_${name} EXCLUDE_FROM_ALL ${ARG_SOURCES})
    if(NOT TARGET benchmarks)
        add_custom_target(benchmarks)
    endif()
    add_dependencies(benchmarks bench_${name})
    target_include_directories(bench_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    list(TRANSFORM ARG_USES PREPEND agv_ OUTPUT_VARIABLE used)
    target_link_libraries(bench_${name} PRIVATE ${used} ${ARG_LIBRARIES} agv_build_rules)
    target_compile_definitions(bench_${name} PRIVATE AGV_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data")
    set_target_properties(bench_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bench)
endfunction()

# agv_fuzzer(NAME SOURCE USES module ...): a fuzz target over the corpus tests/fuzz/corpus/NAME.
# Preset fuzz: a libFuzzer program that ctest runs for 15 s; a crash, leak, undefined behaviour or violated
# property fails the test and leaves its input beside the build. Elsewhere: the corpus alone is replayed.
function(agv_fuzzer name source)
    cmake_parse_arguments(PARSE_ARGV 2 ARG "" "" "USES")
    if(NOT AGV_TESTS)
        return()
    endif()
    set(corpus ${PROJECT_SOURCE_DIR}/tests/fuzz/corpus/${name})
    add_executable(fuzz_${name} ${source})
    set_target_properties(fuzz_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/fuzz)
    target_include_directories(fuzz_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
    list(TRANSFORM ARG_USES PREPEND agv_ OUTPUT_VARIABLE used)
    target_link_libraries(fuzz_${name} PRIVATE ${used} agv_build_rules)
    if(NOT AGV_FUZZ)
        target_sources(fuzz_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests/fuzz/replay_main.cpp)
        add_test(NAME fuzz_corpus.${name} COMMAND fuzz_${name} ${corpus})
        return()
    endif()
    target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
    set(found ${CMAKE_BINARY_DIR}/corpus/${name})
    file(MAKE_DIRECTORY ${found})
    set(dictionary ${PROJECT_SOURCE_DIR}/tests/fuzz/dictionaries/${name}.dict)
    set(options -max_total_time=15 -timeout=10 -rss_limit_mb=1024 -print_final_stats=1
        -artifact_prefix=${CMAKE_BINARY_DIR}/fuzz/${name}-)
    if(EXISTS ${dictionary})
        list(APPEND options -dict=${dictionary})
    endif()
    add_test(NAME fuzz.${name} COMMAND fuzz_${name} ${options} ${found} ${corpus})
endfunction()

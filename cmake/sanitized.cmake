# The program, the tests and the corpora with a library that is compiled for a sanitizer: `make sanitize`, `make races`.
# Only the library is compiled again; the objects that call it are those of the ordinary build. The library's objects
# come first on the linker's line, so that the program uses their instances of templates. CTest runs these tests only
# if their configuration and label are given.
function(add_sanitized suffix)
    set(options -O1 -g1 -UNDEBUG -D_GLIBCXX_ASSERTIONS -fno-omit-frame-pointer ${ARGN})
    add_ripstop_library(ripstop-${suffix})
    target_compile_options(ripstop-${suffix} PRIVATE ${options})
    # Under AddressSanitizer Eigen aligns memory by its own method, and objects of the ordinary build could not free it.
    target_compile_definitions(ripstop-${suffix} PRIVATE EIGEN_MALLOC_ALREADY_ALIGNED=1)
    set(names "")
    foreach(user ripstop-program ripstop-tests fuzz-replay)
        set(name ${user}-${suffix})
        set(objects $<TARGET_OBJECTS:ripstop-${suffix}> $<TARGET_OBJECTS:${user}>)
        if(user STREQUAL ripstop-tests)
            list(APPEND objects $<TARGET_OBJECTS:ripstop-test-support>)
        endif()
        add_executable(${name} EXCLUDE_FROM_ALL ${objects})
        get_target_property(libraries ${user} LINK_LIBRARIES)
        list(REMOVE_ITEM libraries ripstop ripstop-test-support)
        set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
        target_link_options(${name} PRIVATE ${ARGN})
        target_link_libraries(${name} PRIVATE ripstop-${suffix} ${libraries})
        list(APPEND names ${name})
    endforeach()
    set_target_properties(ripstop-${suffix} PROPERTIES EXCLUDE_FROM_ALL ON)
    add_custom_target(${suffix} DEPENDS ${names})
endfunction()

# A test of a sanitized build: add_sanitized_test(SUFFIX NAME COMMAND…).
function(add_sanitized_test suffix name)
    add_test(NAME ${name} COMMAND ${ARGN} CONFIGURATIONS ${suffix})
    set_tests_properties(${name} PROPERTIES LABELS ${suffix} TIMEOUT 1800
        ENVIRONMENT "RIPSTOP_TESTED_PROGRAM=$<TARGET_FILE:ripstop-program-${suffix}>")
endfunction()

# Four checks are left out, because they take a third of the compile time. AddressSanitizer finds what null and
# object-size find, x86 loads unaligned numbers, and vptr only checks classes with virtual functions.
add_sanitized(sanitized -fsanitize=address,undefined -fno-sanitize=null,object-size,alignment,vptr
              -fno-sanitize-recover=all)
add_sanitized(races -fsanitize=thread)
file(GLOB fuzz_targets CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/fuzz/*_fuzz.cpp)
foreach(target_source IN LISTS fuzz_targets)
    get_filename_component(corpus ${target_source} NAME_WE)
    string(REPLACE "_fuzz" "" corpus ${corpus})
    add_sanitized_test(sanitized Sanitized.FuzzCorpus.${corpus}
        fuzz-replay-sanitized ${corpus} ${CMAKE_SOURCE_DIR}/fuzz/corpus/${corpus})
endforeach()
# The suites of tests/cli run the program, which loads slowly: they have a label of their own, by which .ci/run leaves
# them to `make sanitize`.
file(GLOB command_sources CONFIGURE_DEPENDS tests/cli/*_test.cpp)
set(command_suites "")
foreach(command_source IN LISTS command_sources)
    file(STRINGS ${command_source} lines REGEX "^TEST[_FP]*\\(")
    foreach(line IN LISTS lines)
        string(REGEX REPLACE "^TEST[_FP]*\\(([A-Za-z0-9]+),.*" "\\1" suite "${line}")
        list(APPEND command_suites ${suite}.* */${suite}.*)
    endforeach()
endforeach()
list(REMOVE_DUPLICATES command_suites)
list(JOIN command_suites : command_suites)
# In shards, so that tests of a suite share what they build and two processors end together.
foreach(shard RANGE 3)
    add_sanitized_test(sanitized Sanitized.Tests${shard} ripstop-tests-sanitized --gtest_filter=-${command_suites})
    add_sanitized_test(sanitized Sanitized.Commands${shard} ripstop-tests-sanitized --gtest_filter=${command_suites})
    set_property(TEST Sanitized.Tests${shard} Sanitized.Commands${shard} APPEND PROPERTY ENVIRONMENT
                 GTEST_TOTAL_SHARDS=4 GTEST_SHARD_INDEX=${shard})
    set_property(TEST Sanitized.Commands${shard} APPEND PROPERTY LABELS commands)
endforeach()
# Tests of several threads have the word in their names.
add_sanitized_test(races Races.Tests ripstop-tests-races --gtest_filter=*Thread*)
